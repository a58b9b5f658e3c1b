//! Mistakes as people make them at a machine: each is said with its place, its cause and what to write instead; none passes in silence.

use super::{File, IPC, VALID, read};
use std::cell::Cell;
use std::path::Path;

/// A set of one axis with a valid stage and these lines.
fn set(lines: &str) -> String {
    let valid = "ipc.enable = \"DRYRUN\"\nipc.v_add_max_fact = 100\ngetriebe = [{ dynamik.vb_max = 530000 }]\n\
                 ipc.stage = [{ mode = \"DIRECT\", filter = [{ order = 1, fg_f0 = 53.0, q_factor = 10.0 }] }]\n";
    format!("cycle_time = \"1ms\"\n[axis.X]\n{valid}{lines}\n").replace("ipc.", IPC)
}

/// A text in which the part before a line `=>` is replaced by the one after it.
fn changed(text: &str, change: &str) -> String {
    let (from, to) = change.split_once("\n=>\n").unwrap();
    assert!(text.contains(from), "{from}");
    text.replace(from, to)
}

/// The name of a file and its text, by the form: `list`, `stage`: a valid list, a valid set with this change; `more`, `set`: with
/// more lines; `whole list` and so on: this text, in which `VALID` and `SET` stand for a valid list and a valid set.
fn file(form: &str, text: &str) -> (&'static str, Vec<u8>) {
    let (form, is_wide) = form.strip_suffix(" in UTF-16").map_or((form, false), |form| (form, true));
    let text = text.replace("ipc.", IPC);
    let whole = || text.replace("VALID\n", VALID).replace("VALID", VALID).replace("SET", &set(""));
    let (name, text) = match form {
        "list" => ("x.lis", changed(VALID, &text)),
        "more" => ("x.lis", format!("{VALID}{text}\n")),
        "stage" => ("set.toml", changed(&set(""), &text)),
        "set" => ("set.toml", set(&text)),
        "whole list" => ("x.lis", whole()),
        "whole set" => ("set.toml", whole()),
        "whole project" => ("x.xti", whole()),
        other => panic!("no such form: {other}"),
    };
    let wide = || text.encode_utf16().flat_map(u16::to_le_bytes).collect();
    (name, if is_wide { wide() } else { text.into_bytes() })
}

#[test]
fn none_passes_in_silence() {
    let count = Cell::new(0);
    transcript::compare(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/real_files/mistakes.txt"), |form, text| {
        let (name, bytes) = file(form, text);
        let files: [File<'_>; 2] = [(name, &bytes), ("x.lis", VALID.as_bytes())];
        let (_, report) = read(&files);
        assert!((1..=2).contains(&report.diagnostics.len()), "{text}: one mistake\n{report}");
        for said in &report.diagnostics {
            let allowed = said.allowed.as_deref().unwrap_or_default();
            assert!(said.instead.is_some() || !allowed.is_empty(), "{text}: {said}");
        }
        count.set(count.get() + 1);
        report.to_string()
    });
    assert!(count.get() >= 82, "{}", count.get());
}
