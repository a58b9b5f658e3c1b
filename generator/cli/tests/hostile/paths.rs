//! Files that are not there, or are none; ways out of the folder.

use super::row::{axis, set};
use std::{fs, os::unix::fs::symlink, path::Path, process::Command};

rows! {
    a_missing_set: "a set that is not there" => |_| vec!["set.toml".to_owned()];
    a_set_that_is_a_folder: "a set that is a folder" => |folder| {
        fs::create_dir(folder.join("set.toml")).unwrap();
        vec!["set.toml".to_owned()]
    };
    a_set_below_a_file: "a set below a file" => |folder| {
        set(folder, "");
        vec!["set.toml/set.toml".to_owned()]
    };
    a_set_that_is_a_pipe: "a set that is a pipe (FIFO)" => |folder| pipe(folder, "set.toml", vec!["set.toml".to_owned()]);
    a_set_that_is_a_device: "the device /dev/zero as a list" => |_| device("/dev/zero");
    a_random_device: "the device /dev/urandom as a list" => |_| device("/dev/urandom");
    a_link_to_itself: "a set that is a link to itself" => |folder| {
        symlink("set.toml", folder.join("set.toml")).unwrap();
        vec!["set.toml".to_owned()]
    };
    a_dangling_link: "a set that is a link to nothing" => |folder| {
        symlink("nothing", folder.join("set.toml")).unwrap();
        vec!["set.toml".to_owned()]
    };
    a_name_too_long: "a set whose name has 5,000 letters" => |_| vec!["x".repeat(5000)];
    a_name_with_an_escape: "a list whose file name has an escape sequence" => |folder| {
        fs::write(folder.join("x\u{1b}[2J\n.lis"), "?\n").unwrap();
        ["x\u{1b}[2J\n.lis", "--cycle-time", "1ms", "--name", "X"].map(str::to_owned).to_vec()
    };
    no_list: "a list that is not there" => |folder| axis(folder, "list = \"x.lis\"");
    an_empty_name: "a list without a name" => |folder| axis(folder, "list = \"\"");
    a_list_that_is_a_number: "a list that is a number" => |folder| axis(folder, "list = 1");
    a_list_that_is_a_folder: "a list that is a folder" => |folder| axis(folder, "list = \".\"");
    a_list_that_is_a_pipe: "a list that is a pipe (FIFO)" => |folder| {
        let arguments = axis(folder, "list = \"x.lis\"");
        pipe(folder, "x.lis", arguments)
    };
    a_list_that_is_a_device: "the device /dev/zero as a set's list" => |folder| axis(folder, "list = \"/dev/zero\"");
    a_set_that_names_itself: "a set that names itself as its list" => |folder| axis(folder, "list = \"set.toml\"");
    sets_that_name_each_other: "two sets that name each other as their lists" => |folder| {
        fs::write(folder.join("other.toml"), "cycle_time = \"1ms\"\n[axis.X]\nlist = \"set.toml\"\n").unwrap();
        axis(folder, "list = \"other.toml\"")
    };
    a_way_up: "`list = \"../../etc/passwd\"`" => |folder| {
        fs::create_dir_all(folder.join("a/b")).unwrap();
        fs::create_dir(folder.join("etc")).unwrap();
        fs::write(folder.join("etc/passwd"), "root:x:0:0:root:/root:/bin/sh\n").unwrap();
        fs::write(folder.join("a/b/set.toml"), "cycle_time = \"1ms\"\n[axis.X]\nlist = \"../../etc/passwd\"\n").unwrap();
        vec!["a/b/set.toml".to_owned()]
    };
    an_absolute_path: "`list = \"/dev/null/x.lis\"`, an absolute path" => |folder| axis(folder, "list = \"/dev/null/x.lis\"");
    nul_in_a_name: "a list with NUL in its name" => |folder| axis(folder, "list = \"x\\u0000.lis\"");
    a_command: "`list = \"$(touch out)\"`" => |folder| axis(folder, "list = \"$(touch out)\"");
    an_option: "`list = \"--out\"`" => |folder| axis(folder, "list = \"--out\"");
    an_address: "`list = \"http://localhost/x.lis\"`" => |folder| axis(folder, "list = \"http://localhost/x.lis\"");
}

fn device(path: &str) -> Vec<String> {
    [path, "--cycle-time", "1ms"].map(str::to_owned).to_vec()
}

fn pipe(folder: &Path, name: &str, arguments: Vec<String>) -> Vec<String> {
    assert!(Command::new("mkfifo").arg(folder.join(name)).status().unwrap().success());
    arguments
}
