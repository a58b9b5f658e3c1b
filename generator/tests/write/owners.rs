//! What is not as axgen made it needs `--force`.

use crate::{content, generated, pair, write};
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
