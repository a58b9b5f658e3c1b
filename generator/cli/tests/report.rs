//! `axgen report`: the page is well-formed, has no script, shows what `check`, `analyze` and `verify` print, and its lines are
//! those of the emitted files.

use crate::{EXAMPLES, axgen, words};
use commands::plan::Plan;
use generator::config::{self, ListOptions};
use generator::target::TARGETS;
use generator::{manifest, pipeline};
use roxmltree::{Document, Node, ParsingOptions};
use std::{collections::BTreeSet, fs, path::Path};

/// The most bytes of a report, for each axis.
const MOST: usize = 1_000_000;

fn page(folder: impl AsRef<Path>, arguments: &[&str]) -> String {
    let run = axgen(folder, &[&["report"], arguments].concat());
    assert_eq!(run.code, 0, "{}", run.err);
    run.out
}

/// The page as a document: stricter than a browser, which would repair it.
fn parsed(page: &str, check: impl FnOnce(&Document<'_>)) {
    let closed: String = page
        .split_inclusive('\n')
        .map(|line| if line.starts_with("<meta ") { line.replace(">\n", "/>\n") } else { line.to_owned() })
        .collect();
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    check(&Document::parse_with_options(&closed, options).unwrap_or_else(|error| panic!("{error}\n{closed}")));
}

/// The elements of a page, each with its attributes: none of them can run or load anything.
const ELEMENTS: &str = "html head meta title style body main h1 h2 h3 p table caption thead tbody tr th td svg text line \
                        polyline circle";
const ATTRIBUTES: &str = "lang charset http-equiv content name id scope role viewBox width height x y x1 x2 y1 y2 cx cy r fill stroke \
                          stroke-width stroke-opacity stroke-dasharray stroke-linejoin points text-anchor font-family \
                          font-size font-weight";

/// What every page has, whatever its set holds.
fn assert_sound(page: &str) {
    parsed(page, |document| {
        let mut ids = BTreeSet::new();
        for node in document.descendants().filter(Node::is_element) {
            let name = node.tag_name().name();
            assert!(ELEMENTS.split_whitespace().any(|known| known == name), "{name}");
            for attribute in node.attributes() {
                let known = ATTRIBUTES.split_whitespace().any(|known| known == attribute.name());
                assert!(known, "{name} {}", attribute.name());
                assert!(attribute.name() != "id" || ids.insert(attribute.value()), "{} twice", attribute.value());
            }
        }
        let policy = document.descendants().find(|node| node.has_attribute("http-equiv")).unwrap();
        assert_eq!(policy.attribute("http-equiv"), Some("Content-Security-Policy"));
        let content = "default-src 'none'; style-src 'unsafe-inline'; img-src data:";
        assert_eq!(policy.attribute("content"), Some(content));
        for table in document.descendants().filter(|node| node.has_tag_name("table")) {
            let cells = |row: Node<'_, '_>| row.children().filter(Node::is_element).count();
            let rows: Vec<usize> = table.descendants().filter(|node| node.has_tag_name("tr")).map(cells).collect();
            assert!(rows.len() > 1 && rows.iter().all(|cells| *cells == rows[0]), "{rows:?}");
        }
    });
}

fn rows(page: &str, name: &str) -> Vec<Vec<String>> {
    let mut found = Vec::new();
    parsed(page, |document| {
        let is_it = |table: &Node<'_, '_>| {
            table.has_tag_name("table")
                && table.children().any(|of| of.has_tag_name("caption") && of.text() == Some(name))
        };
        for table in document.descendants().filter(is_it) {
            let body = table.descendants().find(|node| node.has_tag_name("tbody")).unwrap();
            let cell = |cell: Node<'_, '_>| cell.text().unwrap_or_default().to_owned();
            let row = |row: Node<'_, '_>| row.children().filter(Node::is_element).map(cell).collect();
            found.extend(body.children().filter(Node::is_element).map(row));
        }
    });
    assert!(!found.is_empty(), "no table {name}");
    found
}

/// Whether a line has all cells of a row, in their order.
fn shows(line: &str, row: &[String]) -> bool {
    let mut rest = line;
    row.iter().all(|cell| {
        rest.split_once(cell.as_str()).is_some_and(|(_, after)| {
            rest = after;
            true
        })
    })
}

#[test]
fn a_report_shows_what_check_and_analyze_print() {
    for (set, axes) in [("machine.toml", 3), ("feedforward.toml", 5), ("rack-and-pinion.toml", 1)] {
        let page = page(EXAMPLES, &[set]);
        assert_sound(&page);
        assert!(page.len() < axes * MOST, "{set}: {}", page.len());
        let checked = axgen(EXAMPLES, &["check", set]).out;
        for row in rows(&page, "Stages") {
            assert!(checked.lines().any(|line| shows(line, &row)), "{set}: {row:?}\n{checked}");
        }
        let analyzed = axgen(EXAMPLES, &["analyze", set]).out;
        for row in rows(&page, "Margins") {
            assert!(analyzed.lines().any(|line| shows(line, &row)), "{set}: {row:?}\n{analyzed}");
        }
        for row in rows(&page, "Stages in the loop") {
            assert!(analyzed.lines().any(|line| shows(line, &row[1..])), "{set}: {row:?}\n{analyzed}");
        }
    }
}

#[test]
fn a_report_verifies_every_block_and_is_the_same_twice() {
    let first = page(EXAMPLES, &["machine.toml", "--samples", "2000"]);
    assert_eq!(first, page(EXAMPLES, &["machine.toml", "--samples", "2000"]));
    let rows = rows(&first, "Verification");
    assert_eq!(rows.len(), 3 * 6, "3 axes, 6 engines without a compiler");
    assert!(rows.iter().all(|row| row[2] == "2000" && row[3] == "0" && row[5].is_empty()), "{rows:?}");
    assert!(
        rows.chunks(6).all(|block| block.iter().all(|row| row[4].len() == 32 && row[4] == block[0][4])),
        "{rows:?}"
    );
}

#[test]
fn a_coefficient_stands_in_the_lines_that_a_report_names() {
    let folder = tempfile::tempdir().unwrap();
    let targets = ["c", "rust", "st", "twincat", "codesys", "scl"].map(|target| ["--target", target]).concat();
    let out = folder.path().to_str().unwrap();
    let run = axgen(EXAMPLES, &[&["generate", "machine.toml", "--out", out], targets.as_slice()].concat());
    assert_eq!(run.code, 0, "{}", run.err);
    let page = page(EXAMPLES, &[&["machine.toml", "--samples", "10"], targets.as_slice()].concat());
    let (mut lines, mut without) = (0, Vec::new());
    for row in rows(&page, "Coefficients") {
        let name = row[1].replace(['[', ']'], "").replace('.', "_").to_lowercase();
        let files: BTreeSet<&str> = row[5].split("; ").filter_map(|file| Some(file.split_once(": ")?.0)).collect();
        for file in row[5].split("; ").filter(|file| !file.is_empty()) {
            let (file, numbers) = file.split_once(": ").unwrap();
            let text = fs::read_to_string(folder.path().join(file)).unwrap();
            let text: Vec<&str> = text.lines().collect();
            for number in numbers.split(", ") {
                let line = text[number.parse::<usize>().unwrap() - 1];
                assert!(line.to_lowercase().contains(&name), "{file}:{number}: {line}, not {name}");
                lines += 1;
            }
        }
        // A target that writes a value under no name, or keeps it in the set, has no line.
        if files.len() < 6 {
            without.push(format!("{} {}", row[1], files.len()));
        }
        assert!(!row[4].is_empty() || !row[1].contains("bandpass"), "{row:?} depends on nothing");
    }
    assert!(lines > 300 && without.is_empty(), "{lines} lines; not in all files: {without:?}");
    let digests = rows(&page, "Files");
    for row in &digests {
        let found = generator::digest::digest(&fs::read(folder.path().join(&row[0])).unwrap());
        assert_eq!(found, row[1], "{}", row[0]);
    }
}

#[test]
fn a_parameter_leads_to_the_coefficients_that_depend_on_it() {
    let page = page(EXAMPLES, &["machine.toml", "--axis", "X", "--samples", "10"]);
    let rows = rows(&page, "Parameters");
    let of = |path: &str| {
        let row = rows.iter().find(|row| row[1].ends_with(path)).unwrap_or_else(|| panic!("{path}"));
        [row[0].as_str(), &row[2], &row[4], &row[5]]
    };
    let bandpass =
        "stage[0].filter[0].bandpass[0].b2, stage[0].filter[0].bandpass[0].a1, stage[0].filter[0].bandpass[0].a2";
    assert_eq!(of("stage[0].filter[0].fg_f0"), ["P-AXIS-00751", "53", "rack-and-pinion.lis:20", bandpass]);
    assert_eq!(of("stage[0].filter[0].prototype")[2], "default");
    assert_eq!(of("fade"), ["-", "200ms", "machine.toml:8", "fade_cycles, fade_step"]);
    assert!(of("stage[1].osc_damping")[3].contains("stage[1].oscillation.a1"), "given by its predecessor");
    assert_eq!(of("real")[3], "", "another real type is another block");
}

#[test]
fn nothing_from_a_file_is_markup() {
    let folder = tempfile::tempdir().unwrap();
    let name = "<script>alert(1)<!--&\"'.lis";
    let list = fs::read_to_string(Path::new(EXAMPLES).join("rack-and-pinion.lis")).unwrap();
    fs::write(folder.path().join(name), list).unwrap();
    fs::write(folder.path().join("moves.csv"), "t,<b>v_motor</b>\n0,1\n").unwrap();
    let page = page(folder.path(), &[name, "--cycle-time", "1ms", "--name", "X", "--samples", "10"]);
    assert_sound(&page);
    assert!(rows(&page, "Parameters").iter().any(|row| row[4].starts_with(name)), "the name is shown as text");
    let run = axgen(
        folder.path(),
        &["report", name, "--cycle-time", "1ms", "--name", "X", "--samples", "10", "--recording", "moves.csv"],
    );
    assert!(run.out.is_empty() || !run.out.contains("<b>"), "{}", run.out);
}

/// A set with an excitation, for recordings of the demonstration plant, and a stage that is not yet ON.
const RECORDED: &str = "cycle_time = \"1ms\"\n[axis.X]\nkopf.achs_nr = 1\nexcitation = { amplitude = 5000 }\n\
    getriebe = [{ dynamik.vb_max = 530000, kv = 2000 }]\n\
    [axis.X.lr_param.improved_position_control]\nenable = \"DRYRUN\"\nv_add_max_fact = 100\n\
    [[axis.X.lr_param.improved_position_control.stage]]\nmode = \"DIRECT\"\nweight_fact_num = 100\nweight_fact_denom = 100\n\
    filter = [{ order = 1, fg_f0 = 53.0, q_factor = 10.0 }]\n";

#[test]
fn a_recording_is_shown_with_and_without_the_stages() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("x.toml"), RECORDED).unwrap();
    let simulate = "simulate x.toml --plant demonstration --moves m.csv --excited e.csv --speed 20mm/s";
    let (code, _, err) = words(folder.path(), simulate);
    assert!(code < 2, "{err}");
    let recordings = ["--recording", "m.csv", "--excited", "e.csv"];
    let page = page(folder.path(), &[&["x.toml", "--samples", "10"], recordings.as_slice()].concat());
    assert_sound(&page);
    let number = |value: &serde_json::Value| format!("{:.4}", value.as_f64().unwrap());
    let measured = axgen(folder.path(), &["measure", "m.csv", "--excited", "e.csv", "--json"]).json();
    let vibrations = measured["vibrations"].as_array().unwrap();
    let found: Vec<String> = rows(&page, "Vibrations, as recorded").into_iter().map(|row| row[2].clone()).collect();
    assert_eq!(found, vibrations.iter().map(|of| number(&of["hz"])).collect::<Vec<_>>());
    let tune = [&["tune", "x.toml", "--stage", "set", "--json"], recordings.as_slice()].concat();
    let tuned = axgen(folder.path(), &tune).json();
    let residuals = tuned["proposals"][0]["residuals"].as_array().unwrap();
    let wanted: Vec<_> = residuals.iter().map(|of| vec![number(&of["hz"]), number(&of["ratio"])]).collect();
    assert_eq!(rows(&page, "Vibrations, with the stages"), wanted);
    assert!(page.contains("as recorded") && page.contains("with the stages") && page.len() < MOST, "{}", page.len());
}

/// What the library makes for a page is what the command writes into an empty folder, file by file.
#[test]
fn a_folder_of_the_library_is_that_of_the_command() {
    for set in ["machine.toml", "feedforward.toml", "rack-and-pinion.toml"] {
        let folder = tempfile::tempdir().unwrap();
        let targets = TARGETS.map(|target| ["--target", target.name]).concat();
        let out = folder.path().to_str().unwrap();
        let run = axgen(EXAMPLES, &[&["generate", set, "--out", out], targets.as_slice()].concat());
        assert_eq!(run.code, 0, "{}", run.err);
        let path = Path::new(EXAMPLES).join(set);
        let read = pipeline::read_with(&path, &ListOptions::default(), &config::load).0.unwrap();
        let files = Plan::whole(&read, &TARGETS).folder(&manifest::set_name(&path));
        for file in &files {
            assert_eq!(fs::read_to_string(folder.path().join(&file.name)).unwrap(), file.text, "{}", file.name);
        }
        let manifest = fs::read_to_string(folder.path().join(manifest::NAME)).unwrap();
        let listed = manifest.lines().filter(|line| !line.starts_with('#')).count();
        assert_eq!(files.len(), listed + 1, "{set}: all files, and the manifest");
    }
}
