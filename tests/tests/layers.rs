//! The layers that ARCHITECTURE.md states, held against the `use` lines of the crates: which module may use which, and that no
//! modules use each other in a circle. What a function does with its paths is not looked at. And that each file of tests is run.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// A module, by its path within its crate: `blocks::ipc::design`; the root is empty.
type Module = String;

/// The folders of the crates' sources, by the names that `use` lines give them.
const CRATES: [(&str, &str); 10] = [
    ("portable", "reference/portable/src"),
    ("reference", "reference/src"),
    ("compiler", "generator/compiler/src"),
    ("identification", "generator/identification/src"),
    ("generator", "generator/src"),
    ("st", "golden/st/src"),
    ("nc", "golden/nc/src"),
    ("machine", "golden/machine/src"),
    ("golden", "golden/src"),
    ("commands", "generator/commands/src"),
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// All modules of a crate, each with its file.
fn modules(folder: &Path, module: &str, found: &mut BTreeMap<Module, PathBuf>) {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    for path in entries.map(|entry| entry.unwrap().path()) {
        let stem = path.file_stem().unwrap().to_string_lossy().into_owned();
        let inner = if module.is_empty() { stem.clone() } else { format!("{module}::{stem}") };
        match path.extension() {
            _ if path.is_dir() => modules(&path, &inner, found),
            Some(extension) if extension == "rs" && ["lib", "mod"].contains(&stem.as_str()) => {
                found.insert(module.to_owned(), path);
            }
            Some(extension) if extension == "rs" && stem != "main" => {
                found.insert(inner, path);
            }
            _ => {}
        }
    }
}

/// The paths of a `use` line, each in its parts.
fn paths(tree: &syn::UseTree, before: &[String], found: &mut Vec<Vec<String>>) {
    let with = |name: &syn::Ident| [before, &[name.to_string()]].concat();
    match tree {
        syn::UseTree::Path(path) => paths(&path.tree, &with(&path.ident), found),
        syn::UseTree::Name(name) => found.push(with(&name.ident)),
        syn::UseTree::Rename(rename) => found.push(with(&rename.ident)),
        syn::UseTree::Glob(_) => found.push(before.to_vec()),
        syn::UseTree::Group(group) => group.items.iter().for_each(|item| paths(item, before, found)),
    }
}

/// What a file uses outside of its tests. A facade that only hands on what its own parts hold does not use them.
fn uses(file: &Path, module: &str) -> Vec<Vec<String>> {
    let text = fs::read_to_string(file).unwrap();
    let syntax = syn::parse_file(&text).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    let mut found = Vec::new();
    for item in syntax.items {
        if let syn::Item::Use(line) = item {
            let mut of_line = Vec::new();
            paths(&line.tree, &[], &mut of_line);
            let hands_on = !matches!(line.vis, syn::Visibility::Inherited);
            let is_own = |path: &Vec<String>| !["crate", "super"].contains(&path[0].as_str());
            found.extend(
                of_line.into_iter().filter(|path| !(hands_on && is_own(path))).map(|path| absolute(path, module)),
            );
        }
    }
    found
}

/// A path from the crate's root, or from another crate.
fn absolute(path: Vec<String>, module: &str) -> Vec<String> {
    let mut base: Vec<String> = module.split("::").filter(|part| !part.is_empty()).map(str::to_owned).collect();
    let mut rest = path.as_slice();
    if rest[0] == "self" || rest[0] == "super" {
        while let Some(first) = rest.first().filter(|part| *part == "super" || *part == "self") {
            if first == "super" {
                base.pop();
            }
            rest = &rest[1..];
        }
        return [&["crate".to_owned()], base.as_slice(), rest].concat();
    }
    path
}

/// The module that a path leads to: the longest part of it that is one.
fn target(path: &[String], known: &BTreeMap<Module, PathBuf>) -> Option<Module> {
    let parts = path.strip_prefix(&["crate".to_owned()])?;
    (0..=parts.len()).rev().map(|length| parts[..length].join("::")).find(|module| known.contains_key(module))
}

/// Which modules of a crate use which others of it.
fn graph(folder: &str) -> BTreeMap<Module, BTreeSet<Module>> {
    let mut known = BTreeMap::new();
    modules(&root().join(folder), "", &mut known);
    let of = |(module, file): (&Module, &PathBuf)| {
        let first = |path: &[String]| path.first().is_some_and(|part| known.contains_key(part));
        let paths = uses(file, module).into_iter().map(|path| match path[0].as_str() {
            // In the root a module is named as it is.
            _ if module.is_empty() && first(&path) => [vec!["crate".to_owned()], path].concat(),
            _ if known.contains_key(&format!("{module}::{}", path[0])) => {
                [vec!["crate".to_owned()], module.split("::").map(str::to_owned).collect(), path].concat()
            }
            _ => path,
        });
        let used = paths.filter_map(|path| target(&path, &known)).filter(|used| used != module).collect();
        (module.clone(), used)
    };
    known.iter().map(of).collect()
}

/// A circle that a module is in, if it is in one.
fn circle(start: &Module, graph: &BTreeMap<Module, BTreeSet<Module>>) -> Option<Vec<Module>> {
    let mut ways = vec![vec![start.clone()]];
    let mut seen = BTreeSet::new();
    while let Some(way) = ways.pop() {
        for next in &graph[&way[way.len() - 1]] {
            let longer = [way.as_slice(), std::slice::from_ref(next)].concat();
            if next == start {
                return Some(longer);
            }
            if seen.insert(next.clone()) {
                ways.push(longer);
            }
        }
    }
    None
}

#[test]
fn no_modules_use_each_other_in_a_circle() {
    for (name, folder) in CRATES {
        let graph = graph(folder);
        let circles: BTreeSet<String> =
            graph.keys().filter_map(|module| circle(module, &graph)).map(|way| way.join(" -> ")).collect();
        assert!(circles.is_empty(), "{name}: {circles:#?}");
    }
}

/// The block `layers` of ARCHITECTURE.md: a crate, then its modules from the lowest to the highest.
fn stated() -> BTreeMap<String, Vec<String>> {
    let text = fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let block = text.split("```layers\n").nth(1).expect("ARCHITECTURE.md has a block `layers`");
    let block = block.split("```").next().unwrap();
    let line = |line: &str| {
        let (name, modules) = line.split_once(':').expect("a crate, a colon, its modules");
        (name.trim().to_owned(), modules.split_whitespace().map(str::to_owned).collect())
    };
    block.lines().filter(|line| !line.is_empty()).map(line).collect()
}

#[test]
fn a_module_uses_only_those_below_it() {
    let stated = stated();
    for (name, folder) in CRATES {
        let graph = graph(folder);
        let top = |module: &Module| module.split("::").next().unwrap_or("").to_owned();
        let order = &stated.get(name).unwrap_or_else(|| panic!("ARCHITECTURE.md does not state the layers of {name}"));
        let place = |module: &Module| {
            let found = order.iter().position(|known| *known == top(module));
            found.unwrap_or_else(|| panic!("{name}: ARCHITECTURE.md does not place {}", top(module)))
        };
        for (module, used) in graph.iter().filter(|(module, _)| !module.is_empty()) {
            for used in used.iter().filter(|used| !used.is_empty() && top(used) != top(module)) {
                assert!(place(used) < place(module), "{name}: {module} uses {used}, which is not below it");
            }
        }
    }
}

/// Crates use those before them only.
#[test]
fn crates_are_layers_too() {
    let stated = stated();
    let order = &stated["crates"];
    for (name, folder) in CRATES {
        let mut known = BTreeMap::new();
        modules(&root().join(folder), "", &mut known);
        let at = |name: &str| order.iter().position(|known| known == name);
        let own = at(name).unwrap_or_else(|| panic!("ARCHITECTURE.md does not place the crate {name}"));
        for (module, file) in &known {
            for path in uses(file, module) {
                let is_module = known.contains_key(&path[0]) || known.contains_key(&format!("{module}::{}", path[0]));
                if let Some(used) = at(&path[0]).filter(|_| !is_module) {
                    assert!(used < own || path[0] == name, "{name}: {module} uses the crate {}", path[0]);
                }
            }
        }
    }
}

/// Examples in documents would be compiled as programs of their own, crate by crate, and no manifest asks for that (`doctest
/// = false`): what stands in a fence is `text`.
#[test]
fn documents_in_the_source_hold_no_program() {
    let mut fences = 0;
    let others = ["generator/stability/src", "reference/portable/macro/src", "tests/inside/src", "tests/src"];
    for folder in CRATES.map(|(_, folder)| folder).into_iter().chain(others) {
        let mut files = BTreeMap::new();
        modules(&root().join(folder), "", &mut files);
        for path in files.values() {
            let text = fs::read_to_string(path).unwrap();
            let lines = text
                .lines()
                .map(str::trim_start)
                .filter(|line| line.starts_with("//! ```") || line.starts_with("/// ```"));
            for (number, line) in lines.enumerate() {
                let wanted = if number.is_multiple_of(2) { "```text" } else { "```" };
                assert_eq!(&line[4..], wanted, "{}", path.display());
                fences += 1;
            }
        }
    }
    assert!(fences > 100, "{fences}");
}

/// Cargo does not look for tests of these crates: a file that `main.rs` does not name would not be run.
#[test]
fn every_file_of_tests_is_a_module() {
    for (folder, programs) in [("generator/tests", &["main", "memory"][..]), ("generator/cli/tests", &["main"])] {
        let folder = root().join(folder);
        let main = fs::read_to_string(folder.join("main.rs")).unwrap();
        for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            let name = path.file_stem().unwrap().to_str().unwrap();
            let is_module = path.join("mod.rs").exists() || path.extension().is_some_and(|end| end == "rs");
            assert!(!is_module || programs.contains(&name) || main.contains(&format!("mod {name};\n")), "{name}");
        }
    }
}
