//! Paths as other machines have them: with blanks and letters beyond ASCII, long ones, names that a shared folder would have. No Windows is
//! needed for it.

use super::axgen;
use crate::ROOT;
use std::fs;

/// A set and its list in such a folder, written into another one: the files are those of plain paths, and messages name the paths.
#[test]
fn paths_with_blanks_and_long_paths() {
    let long = ["deep folder ".repeat(16), "Maschinen für Öl & Späne".to_owned(), "//server/share/axes".to_owned()];
    for name in long {
        let folder = tempfile::tempdir().unwrap();
        let inside = folder.path().join(name.trim_start_matches('/'));
        fs::create_dir_all(inside.join("lists of X")).unwrap();
        fs::copy(format!("{ROOT}/examples/pipeline/lists/x.lis"), inside.join("lists of X/x axis.lis")).unwrap();
        let set = "cycle_time = \"1ms\"\n[axis.X]\nlist = \"lists of X/x axis.lis\"\n";
        fs::write(inside.join("my set.toml"), set).unwrap();
        let path = |file: &str| inside.join(file).display().to_string();

        let out = path("out put");
        let (code, said, err) = axgen(folder.path(), &["generate", &path("my set.toml"), "--out", &out]);
        assert_eq!((code, err.as_str()), (0, ""), "{said}");
        assert!(said.contains(&format!("{out}/axis_x_ipc.c\n")), "{said}");
        let (_, plain, _) = axgen(&inside, &["generate", "my set.toml", "--out", "plain"]);
        assert!(plain.contains("\nplain/axis_x_ipc.c\n"), "{plain}");
        for file in ["axis_x_ipc.h", "axis_x_ipc.c", "axis_x_ipc.st"] {
            assert_eq!(
                fs::read(inside.join("out put").join(file)).unwrap(),
                fs::read(inside.join("plain").join(file)).unwrap()
            );
        }
        let (code, said, err) = axgen(folder.path(), &["verify", &path("my set.toml"), "--samples", "500"]);
        assert_eq!((code, err.as_str()), (0, ""), "{said}");

        let list = path("lists of X/x axis.lis");
        let wrong = fs::read_to_string(&list).unwrap().replace("fg_f0", "fg_fo");
        fs::write(&list, wrong).unwrap();
        let (code, _, err) = axgen(folder.path(), &["check", &path("my set.toml")]);
        assert_eq!(code, 2);
        assert!(err.starts_with(&format!("{list}:")) && err.contains("write instead"), "{err}");
    }
}
