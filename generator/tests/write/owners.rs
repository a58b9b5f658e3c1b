//! What is not as axgen made it needs `--force`.

use super::{content, generated, pair, write};
use generator::digest::is_text;
use generator::write::{Owner, Refusal, owner};
use std::fs;

#[test]
fn whose_a_file_is() {
    let text = generated("x.c", "int a;").text;
    assert_eq!(owner(text.as_bytes()), Owner::Generated);
    assert_eq!(owner(text.replace('\n', "\r\n").as_bytes()), Owner::Generated, "other line ends are no edit");
    assert_eq!(owner(b""), Owner::Generated, "a crash of the host may leave it so");
    assert_eq!(owner(text.replace("int", "long").as_bytes()), Owner::Edited);
    assert_eq!(owner(b"a file of another tool"), Owner::Other);
    assert_eq!(owner(b"\xFF\xFE\0"), Owner::Other);
    let without_checksum: String = text.lines().filter(|line| !line.contains("checksum")).collect();
    assert_eq!(owner(without_checksum.as_bytes()), Owner::Other);
}

/// An editor saved it in Latin-1.
#[test]
fn an_edit_that_is_no_utf_8_is_an_edit() {
    let mut bytes = generated("x.c", "int a;").text.into_bytes();
    bytes.extend(b"/* l\xE4uft */\n");
    assert_eq!(owner(&bytes), Owner::Edited);
}

#[test]
fn what_was_edited_or_made_by_others_needs_force() {
    let folder = tempfile::tempdir().unwrap();
    let edited = generated("x.c", "int a;").text.replace("int", "long");
    fs::write(folder.path().join("x.c"), &edited).unwrap();
    fs::write(folder.path().join("y.c"), "mine").unwrap();
    let files = ["x.c", "y.c", "z.c"].map(|name| generated(name, "int b;"));
    let refused = write(folder.path(), &files, false).unwrap_err();
    let [x, y] = ["x.c", "y.c"].map(|name| folder.path().join(name));
    assert_eq!(
        refused.report().to_string().trim_end(),
        format!(
            "{}: error[AX013]: was changed by hand after it had been generated; nothing was written\n    \
             write instead: the change in what the file is made from; or overwrite it with --force\n\
             {}: error[AX014]: was not generated, or its line `checksum` was taken out; nothing was written\n    \
             write instead: the change in what the file is made from; or overwrite it with --force",
            x.display(),
            y.display()
        )
    );
    let Refusal::Edited(paths) = refused else { panic!("{refused:?}") };
    assert_eq!(paths, [(x, Owner::Edited), (y, Owner::Other)]);
    assert_eq!(content(folder.path()), [pair("x.c", &edited), pair("y.c", "mine")]);
    write(folder.path(), &files, true).unwrap();
    assert_eq!(content(folder.path()), files.map(|file| (file.name, file.text)));
}

/// An object of TwinCAT as a generator would make it.
fn object() -> String {
    let body = "<TcPlcObject Version=\"1.1.0.1\">\n  <POU Name=\"FB\" Id=\"{1}\">\n    <ST><![CDATA[x := 1;]]></ST>\n  </POU>\n</TcPlcObject>";
    generated("FB.TcPOU", body).text
}

/// What its development environment adds when it saves is not an edit; whatever else differs is.
#[test]
fn what_twincat_saves() {
    let ids = "    <LineIds Name=\"FB\">\n      <LineId Id=\"3\" Count=\"1\" />\n    </LineIds>\n";
    let with_ids = |text: &str| text.replace("  </POU>", &format!("{ids}  </POU>"));
    let version =
        |text: &str| text.replace("Version=\"1.1.0.1\"", "Version=\"1.1.0.1\" ProductVersion=\"3.1.4024.53\"");
    let saved = version(&with_ids(&object())).trim_end().replace('\n', "\r\n");
    for text in [object(), with_ids(&object()), version(&object()), object().trim_end().to_owned(), saved.clone()] {
        assert_eq!(owner(text.as_bytes()), Owner::Generated, "{text}");
        assert!(is_text(text.as_bytes(), &object()), "{text}");
    }
    for (from, to) in [
        ("x := 1;", "x := 2;"),
        ("x := 1;", "x := 1;\r\n<LineIds Name=\"FB\"></LineIds>"),
        ("Id=\"{1}\"", "Id=\"{2}\""),
        ("Version=\"1.1.0.1\"", "Version=\"1.2.0.0\""),
        ("</LineIds>", "</LineIds><Folder/>"),
        (" ProductVersion=", " Product="),
    ] {
        assert!(saved.contains(from));
        let text = saved.replacen(from, to, 1);
        assert_eq!(owner(text.as_bytes()), Owner::Edited, "{text}");
        assert!(!is_text(text.as_bytes(), &object()), "{text}");
    }
}
