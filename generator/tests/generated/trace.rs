//! What depends on each parameter: its coefficients, and the words of the semantic diff.

use crate::{from_disk, options_of, shipped};
use generator::config::load;
use generator::diff::lines;
use generator::trace::{Traced, parameters};
use std::path::Path;

/// No change of a coefficient is without words: of each shipped axis, with each other value of each parameter.
#[test]
fn the_diff_has_words_for_every_parameter() {
    let (mut versions, mut hidden) = (0, Vec::new());
    for file in shipped(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..")) {
        let set = from_disk(&file);
        for of in &set.axes {
            let traced =
                parameters(&file, &options_of(&file), &load, &of.axis.name).unwrap_or_else(|report| panic!("{report}"));
            for (Traced { path, coefficients, .. }, version) in
                traced.iter().flat_map(|traced| traced.versions.iter().map(move |version| (traced, version)))
            {
                let (lines, _) = lines(std::slice::from_ref(of), std::slice::from_ref(version));
                // The path resolution has the increments in both its terms: they cancel out.
                let is_same = path == "getriebe[0].incr_per_rev";
                let is_hidden =
                    |line: &String| line.contains(": coefficient ") || line.contains("their rounding") && !is_same;
                hidden.extend(lines.iter().any(is_hidden).then(|| format!("{} {path}: {lines:?}", file.display())));
                versions += usize::from(!coefficients.is_empty());
            }
        }
    }
    assert!(hidden.is_empty(), "{}", hidden.join("\n"));
    assert!(versions > 1000, "{versions}");
}
