//! Projects of TwinCAT (`.xti`, `.tsproj`): the lists in them are read, and only they are written.

use super::{File, IPC, VALID, canonical, exported, read, read_named, round_trip};
use generator::config::ListOptions;
use generator::import_export;
use std::path::Path;

fn axis(name: &str, list: &str) -> String {
    format!(
        "    <TreeItem>\r\n      <ItemName>{name}</ItemName>\r\n      <AxisDef>\r\n        <AchsMds><![CDATA[{list}]]></AchsMds>\r\n        \
         <Text>a &lt; b</Text>\r\n      </AxisDef>\r\n    </TreeItem>\r\n"
    )
}

fn project(axes: &[String]) -> String {
    format!(
        "\u{feff}<?xml version=\"1.0\" encoding=\"utf-8\"?>\r\n<TcSmItem>\r\n  <Name>\u{e4}</Name>\r\n  <SdaMds><![CDATA[gruppe[0].x 1]]></SdaMds>\r\n{}</TcSmItem>\r\n",
        axes.concat()
    )
}

#[test]
fn one_axis_comes_back_to_the_byte() {
    for list in
        [VALID.to_owned(), format!("{VALID}Ende\n"), VALID.replace('\n', "\r\n"), format!("\n# \u{e4}\n{VALID}")]
    {
        let xti = project(&[axis("Axis 1", &list)]);
        assert_eq!(canonical(("x.xti", xti.as_bytes())), canonical(("x.lis", VALID.as_bytes())));
        let set = round_trip(("x.xti", xti.as_bytes()));
        let changed = set.replace("\"DRYRUN\"", "\"OFF\"");
        let expected = xti.replace("DRYRUN", "OFF");
        assert_eq!(String::from_utf8(exported(&[("set.toml", changed.as_bytes())])).unwrap(), expected);
    }
}

#[test]
fn in_utf_16_and_latin_1_too() {
    let xti = project(&[axis("Axis 1", &format!("# \u{e4}\n{VALID}"))]);
    let utf_16: Vec<u8> = xti.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let latin_1: Vec<u8> = xti.chars().skip(1).map(|letter| u8::try_from(letter).unwrap()).collect();
    for bytes in [utf_16, latin_1] {
        let set = round_trip(("x.xti", &bytes));
        assert!(set.contains("encoding = "), "{set}");
    }
}

#[test]
fn every_axis_of_a_project_is_read() {
    let second =
        VALID.replace("kopf.achs_nr                1", "kopf.achs_nr                2").replace(" 53\n", " 11\n");
    let project = project(&[axis("Axis 1", VALID), axis("Y-Achse", &second)]);
    let (set, report) = read(&[("m.tsproj", project.as_bytes())]);
    let set = set.unwrap_or_else(|| panic!("{report}"));
    let names: Vec<&str> = set.axes.iter().map(|of| of.axis.name.as_str()).collect();
    assert_eq!((names, report.to_string().as_str()), (vec!["Axis_1", "Y_Achse"], ""));
    let (set, _) = read_named(&[("m.tsproj", project.as_bytes())], Some("Y_Achse"));
    assert_eq!(set.unwrap().axes.len(), 1);
    let (_, report) = read_named(&[("m.tsproj", project.as_bytes())], Some("Z"));
    assert_eq!(
        report.to_string(),
        "m.tsproj: error[AX005]: the project has several axes, and none is called `Z`\n    \
         allowed: the name of one of them: Axis_1, Y_Achse\n"
    );
}

/// An axis of a set takes the list of its name, and an export changes that alone.
#[test]
fn a_set_names_a_project() {
    let second = VALID.replace("kopf.achs_nr                1", "kopf.achs_nr                2");
    let project = project(&[axis("X", VALID), axis("Y", &format!("{second}Ende\r\n"))]);
    let set = format!(
        "cycle_time = \"1ms\"\n[axis.Y]\nlist = \"m.tsproj\"\n{IPC}enable = \"OFF\"\ngetriebe = [{{ kv = 7 }}]\n"
    );
    let files: [File<'_>; 2] = [("set.toml", set.as_bytes()), ("m.tsproj", project.as_bytes())];
    let list = String::from_utf8(exported(&files)).unwrap();
    let (before, after) = project.split_at(project.rfind("kopf.achs_nr").unwrap());
    let after =
        after.replace("DRYRUN", "OFF").replace("Ende\r\n", "# Not in the list so far:\ngetriebe[0].kv 7\nEnde\r\n");
    assert_eq!(list, format!("{before}{after}"));
    assert_eq!(exported(&[("m.tsproj", project.as_bytes())]), project.as_bytes(), "as it is");
}

#[test]
fn places_are_those_of_the_file() {
    let project = project(&[axis("X", &VALID.replace("DIRECT", "DIRRECT"))]);
    let said = read(&[("x.xti", project.as_bytes())]).1.to_string();
    let line = project.lines().position(|line| line.contains("DIRRECT")).unwrap() + 1;
    assert!(said.starts_with(&format!("x.xti:{line}:63: error[AX202]")), "{said}");
}

#[test]
fn xml_without_a_list() {
    for (content, found) in [
        (
            "<?xml version=\"1.0\"?><a/>",
            "x.xti: error[AX116]: the file is XML, and no element AchsMds of it holds an axis list",
        ),
        (
            "<a><AchsMds></AchsMds></a>",
            "x.xti: error[AX116]: the file is XML, and no element AchsMds of it holds an axis list",
        ),
        ("<a><b></a>", "x.xti:1:7: error[AX116]: the file is broken XML: expected 'b' tag, not 'a' at 1:7"),
        (
            "<a><AchsMds>kopf.achs_nr 1</AchsMds></a>",
            "x.xti:1:4: error[AX116]: the element AchsMds has its list in another form than one CDATA",
        ),
        (
            "<a><AchsMds><![CDATA[a]]><![CDATA[b]]></AchsMds></a>",
            "x.xti:1:4: error[AX116]: the element AchsMds has its list in another form than one CDATA",
        ),
    ] {
        let said = read(&[("x.xti", content.as_bytes())]).1.to_string();
        assert_eq!(said.lines().next().unwrap(), found);
    }
    let two = project(&[axis("X", VALID), axis("x", VALID)]);
    let said = read(&[("m.tsproj", two.as_bytes())]).1.to_string();
    let twice = "error[AX007]: the project has two axes `x`; the first is in line ";
    assert!(said.contains(twice), "{said}");
    for (name, code) in [(None, "AX005"), (Some("x"), twice)] {
        let options = ListOptions { name: name.map(str::to_owned), ..ListOptions::default() };
        let (set, report) = import_export::import(Path::new("m.tsproj"), &options, &|_| Ok(two.clone().into_bytes()));
        assert!(set.is_none() && report.to_string().contains(code), "{report}");
    }
}

/// Each is refused at once, and for what it is.
#[test]
fn xml_that_would_cost_more_than_it_weighs() {
    let many = |count: usize, one: &dyn Fn(usize) -> String| (0..count).map(one).collect::<String>();
    let name_spaces = many(4000, &|at| format!("<a xmlns:n{at}=\"u\">")) + &"</a>".repeat(4000);
    let attributes = format!("<a{}/>", many(100_000, &|at| format!(" b{at} = '>'")));
    let comment = format!("<!-- {attributes} --><a><![CDATA[{attributes}]]></a>");
    for (content, found) in [
        ("<a>".repeat(200_000), "broken XML"),
        (format!("<!DOCTYPE a [<!ENTITY b \"{}\">]><a>&b;</a>", "c".repeat(1000)), "XML with DTD detected"),
        ("<!DOCTYPE a><a/>".to_owned(), "XML with DTD detected"),
        (name_spaces, "4000 declarations of name spaces, more than the 200"),
        (attributes, "100000 attributes in one element, more than the 1000"),
        (comment, "no element AchsMds"),
        ("<a ".to_owned() + &"=".repeat(100_000), "attributes in one element"),
        ("<a".to_owned() + &" xmlns:b  =  \"u\"".repeat(300) + "/>", "300 declarations of name spaces"),
    ] {
        let begin = std::time::Instant::now();
        let (set, report) = read(&[("x.xti", content.as_bytes())]);
        let said = report.to_string();
        assert!(set.is_none() && said.contains("AX116") && said.contains(found), "{found}: {said:.300}");
        assert!(begin.elapsed().as_secs() < 5, "{found}");
    }
}
