//! Mistakes as people make them at a machine: each is said with its place, its cause and what to write instead; none passes in silence.

use super::{File, IPC, VALID, assert_transcript, read};

/// A valid list in which one text is another.
fn list(from: &str, to: &str) -> (&'static str, Vec<u8>) {
    let list = VALID.replace(from, to);
    assert_ne!(list, VALID, "{from} is there");
    ("x.lis", list.into_bytes())
}

/// The same with more lines.
fn more(lines: &str) -> (&'static str, Vec<u8>) {
    ("x.lis", format!("{VALID}{}\n", lines.replace("ipc.", IPC)).into_bytes())
}

/// A set of one axis with a valid stage and these lines.
fn set(lines: &str) -> (&'static str, Vec<u8>) {
    let valid = "ipc.enable = \"DRYRUN\"\nipc.v_add_max_fact = 100\ngetriebe = [{ dynamik.vb_max = 530000 }]\n\
                 ipc.stage = [{ mode = \"DIRECT\", filter = [{ order = 1, fg_f0 = 53.0, q_factor = 10.0 }] }]\n";
    let text = format!("cycle_time = \"1ms\"\n[axis.X]\n{valid}{lines}\n").replace("ipc.", IPC);
    ("set.toml", text.into_bytes())
}

fn whole_set(text: &str) -> (&'static str, Vec<u8>) {
    ("set.toml", text.replace("ipc.", IPC).into_bytes())
}

/// The class of a mistake, what it is, the file.
type Mistake = (&'static str, &'static str, (&'static str, Vec<u8>));

fn mistakes() -> Vec<Mistake> {
    let stage = |from: &str, to: &str| {
        let (name, bytes) = set("");
        let text = String::from_utf8(bytes).unwrap();
        assert!(text.contains(from), "{from}");
        (name, text.replace(from, to).into_bytes())
    };
    vec![
        // units
        ("units", "the largest velocity in mm/s", list(" 530000", " 530")),
        ("units", "the largest velocity in m/min", list(" 530000", " 31.8")),
        ("units", "the limit in per cent with its sign", list("fact             100", "fact             10%")),
        ("units", "a frequency with its unit", list(" 53\n", " 53Hz\n")),
        ("units", "a frequency with its unit behind a blank", list(" 53\n", " 53 Hz\n")),
        ("units", "a frequency in kHz", list(" 53\n", " 0.053 kHz\n")),
        ("units", "a cycle time in seconds", whole_set("cycle_time = 0.001\n[axis.X]\nlist = \"x.lis\"\n")),
        ("units", "a cycle time without quotes", whole_set("cycle_time = 1ms\n[axis.X]\nlist = \"x.lis\"\n")),
        ("units", "a weight in per cent", list("denom 100", "denom 1")),
        ("units", "Kv in 1/s instead of 0.01/s", more("getriebe[0].kv 20.5")),
        ("units", "a delay in ms", more("vorsteuer.velocity_delay_time 0.15")),
        // separators
        ("separators", "a decimal comma in a list", list(" 53\n", " 53,5\n")),
        ("separators", "a decimal comma in a set", stage("fg_f0 = 53.0", "fg_f0 = 53,0")),
        ("separators", "groups of digits with blanks", list(" 530000", " 530 000")),
        ("separators", "groups of digits with points", list(" 530000", " 530.000")),
        ("separators", "groups of digits with apostrophes", list(" 530000", " 530'000")),
        ("separators", "an equals sign in a list", list("enable                     DRYRUN", "enable = DRYRUN")),
        ("separators", "an equals sign without blanks", list("enable                     DRYRUN", "enable=DRYRUN")),
        ("separators", "a colon in a list", list("enable                     DRYRUN", "enable: DRYRUN")),
        ("separators", "no equals sign in a set", set("gear 0")),
        ("separators", "a colon in a set", set("gear: 0")),
        ("separators", "a semicolon at the end in a set", set("gear = 0;")),
        ("separators", "a comma behind a value of a list", list(" 53\n", " 53,\n")),
        // keywords of another language
        ("languages", "True of Python", stage("enable = \"DRYRUN\"", "enable = True")),
        ("languages", "yes of YAML", stage("enable = \"DRYRUN\"", "enable = yes")),
        ("languages", "a word without quotes", stage("mode = \"DIRECT\"", "mode = DIRECT")),
        ("languages", "an assignment of Structured Text", set("gear := 0")),
        (
            "languages",
            "a hexadecimal number of Structured Text in a list",
            list("fact             100", "fact             16#64"),
        ),
        ("languages", "a hexadecimal number of Structured Text in a set", set("gear = 16#0")),
        ("languages", "a comment of C in a set", set("// gear 0")),
        ("languages", "a comment of Structured Text in a set", set("(* gear *)")),
        ("languages", "a float of C", list(" 53\n", " 53.0f\n")),
        ("languages", "a German word", list("DIRECT", "DIREKT")),
        ("languages", "EIN for ON", list("DRYRUN", "EIN")),
        ("languages", "JSON named as a set", whole_set("{ \"cycle_time\": \"1ms\" }\n")),
        ("languages", "a section of an INI file", list("kopf.achs_nr", "[axis]\nkopf.achs_nr")),
        // encodings
        (
            "encodings",
            "a no-break space between path and value",
            list("enable                     DRYRUN", "enable\u{a0}DRYRUN"),
        ),
        ("encodings", "a typographic minus", more("kopf.mds_ident 1\nipc.stage[1].filter.fg_f0 \u{2212}53")),
        ("encodings", "typographic quotes in a set", stage("\"DRYRUN\"", "\u{201e}DRYRUN\u{201c}")),
        ("encodings", "UTF-16 without its mark", ("x.lis", VALID.encode_utf16().flat_map(u16::to_le_bytes).collect())),
        (
            "encodings",
            "a set in UTF-16",
            ("set.toml", "\u{feff}cycle_time".encode_utf16().flat_map(u16::to_le_bytes).collect()),
        ),
        // kinds of file
        ("kinds", "an empty list", ("x.lis", Vec::new())),
        ("kinds", "an NC program", ("x.lis", b"%main\nN10 G135\nM30\n".to_vec())),
        ("kinds", "a channel list", ("x.lis", b"gruppe[0].achs_anzahl 3\n".to_vec())),
        ("kinds", "a set named as a list", ("x.lis", set("").1)),
        ("kinds", "a list named as a set", whole_set(VALID)),
        ("kinds", "a project without an axis", ("x.xti", b"<?xml version=\"1.0\"?><TcSmItem/>".to_vec())),
        ("kinds", "a spreadsheet's table", ("x.lis", b"path;value\nfg_f0;53\n".to_vec())),
        // paths
        ("paths", "a capital I for an l", list("filter.fg_f0", "fiIter.fg_f0")),
        ("paths", "a letter missing", list("q_factor", "q_facto")),
        ("paths", "the name alone", list(&format!("{IPC}enable"), "enable")),
        ("paths", "without lr_param", list(&format!("{IPC}enable"), "improved_position_control.enable")),
        ("paths", "a point for an index", list("stage[0].mode", "stage.0.mode")),
        ("paths", "a parenthesis for an index", list("stage[0].mode", "stage(0).mode")),
        ("paths", "a stage that is not there", list("stage[0].mode", "stage[3].mode")),
        ("paths", "a gear step without its index", list("getriebe[0].dynamik", "getriebe.dynamik")),
        ("paths", "a filter that is not there", list("filter.order", "filter[2].order")),
        ("paths", "the same parameter twice", more("ipc.stage[0].filter[0].fg_f0 11")),
        ("paths", "an index in a set", set("ipc.stage[1].mode = \"DIRECT\"")),
        ("paths", "a path of Windows in a set", set("list = \"C:\\lists\\x.lis\"")),
        ("paths", "a file that is not there", set("list = \"lists/x.lis\"")),
        // copies from a PDF
        ("copies", "blanks for underscores", list("weight_fact_denom 100", "weight fact denom 100")),
        ("copies", "a value in the next line", list(" 53\n", "\n      53\n")),
        ("copies", "a wrapped comment", list(" 53\n", " 53 # the vibration\n        of the bridge\n")),
        ("copies", "a misprint of the manual", more("ipc.stage[1]osc_damping 0.5")),
        ("copies", "another misprint", more("antr.v_time_bae 0")),
        ("copies", "a name broken at its hyphen", more("antr.ser- cos.op_mode_for_ve- locity_control 1")),
        ("copies", "a name broken in a table", more("antr.sai_op_mode_cha nge.v_velocity_con- trol_on 1200000")),
        ("copies", "a hyphen that a manual has in a name", more("antr.can-open.cyclic_velocity_op_mode 9")),
        (
            "copies",
            "a soft hyphen in a path",
            list("improved_position_control.enable", "improved_posi\u{ad}tion_control.enable"),
        ),
        ("copies", "a footnote mark behind a value", list(" 53\n", " 53\u{b9}\n")),
        ("copies", "a range instead of a value", list(" 53\n", " 50..60\n")),
        // ids instead of paths
        ("ids", "an id for a path in a list", list(&format!("{IPC}enable"), "P-AXIS-00758")),
        ("ids", "an id for a key in a set", set("P-AXIS-00758 = \"ON\"")),
        // comments
        ("comments", "a block comment over lines", ("x.lis", format!("/*\n{VALID}*/\n").into_bytes())),
        ("comments", "a value behind a comment", list(&format!("{IPC}enable "), &format!("/* start */ {IPC}enable "))),
        ("comments", "a comment without a sign", list("kopf.achs_nr", "Axis X, bridge:\nkopf.achs_nr")),
        ("comments", "a comment of TOML's own sign in a value", stage("\"DRYRUN\"", "#DRYRUN")),
        // what is missing, or too much
        ("values", "no value", list(" 53\n", "\n")),
        ("values", "two values", list(" 53\n", " 53 54\n")),
        ("values", "a mode by a word of another parameter", list("DIRECT", "ON")),
        ("values", "a string without its end", stage("\"DRYRUN\"", "\"DRYRUN")),
        ("values", "a number that ends with a point", stage("53.0", "53.")),
        ("values", "a parameter behind the end", more("Ende\ngetriebe[0].kv 1000")),
        ("values", "a word of an NC program", more("G136 X80")),
        ("values", "the first weight only", list(&format!("{IPC}stage[0].weight_fact_denom 100\n"), "")),
    ]
}

#[test]
fn none_passes_in_silence() {
    let mistakes = mistakes();
    assert!(mistakes.len() >= 82, "{}", mistakes.len());
    let mut transcript = String::new();
    for (class, what, (name, bytes)) in &mistakes {
        let files: [File<'_>; 2] = [(name, bytes), ("x.lis", VALID.as_bytes())];
        let (_, report) = read(&files);
        assert!(!report.diagnostics.is_empty(), "{what}: nothing is said");
        assert!(report.diagnostics.len() <= 2, "{what}: one mistake\n{report}");
        for said in &report.diagnostics {
            assert!(
                said.instead.is_some() || !said.allowed.as_deref().unwrap_or_default().is_empty(),
                "{what}: {said}"
            );
        }
        transcript += &format!("== {class}: {what}\n{report}");
    }
    assert_transcript("mistakes.txt", &transcript);
}
