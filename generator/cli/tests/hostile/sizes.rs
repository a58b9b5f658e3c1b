//! Input that is large, long or deep.

use super::row::{IPC, axis, list, set};
use std::{fs::File, path::Path};

rows! {
    a_set_of_100_mb: "a set of 100 MB" => |folder| sparse(folder, "set.toml", 100_000_000, &[]);
    a_list_of_100_mb: "a list of 100 MB" => |folder| sparse(folder, "x.lis", 100_000_000, &["--cycle-time", "1ms"]);
    a_list_of_a_terabyte: "a list of 1 TB" => |folder| sparse(folder, "x.lis", 1_000_000_000_000, &["--cycle-time", "1ms"]);
    a_list_of_nul: "60 MB of NUL bytes as a list" => |folder| sparse(folder, "x.lis", 60_000_000, &["--cycle-time", "1ms"]);
    a_set_that_names_a_large_list: "a set whose list has 100 MB" => |folder| {
        sparse(folder, "x.lis", 100_000_000, &[]);
        axis(folder, "list = \"x.lis\"")
    };
    deep_arrays: "arrays 100,000 deep" => |folder| set(folder, format!("x = {}{}", "[".repeat(100_000), "]".repeat(100_000)));
    deep_tables: "tables 100,000 deep" => |folder| {
        set(folder, format!("x = {}1{}", "{ a = ".repeat(100_000), " }".repeat(100_000)))
    };
    deep_keys: "a key of 100,000 parts" => |folder| set(folder, format!("{}a = 1", "a.".repeat(100_000)));
    deep_headers: "a table's header of 100,000 parts" => |folder| set(folder, format!("[{}a]\n", "a.".repeat(100_000)));
    open_brackets: "1,000,000 open brackets" => |folder| set(folder, "[".repeat(1_000_000));
    deep_stages: "stages within stages, 50 deep" => |folder| {
        axis(folder, &format!("{IPC}.stage = {}1{}", "[{ stage = ".repeat(50), " }]".repeat(50)))
    };
    a_long_line: "a list's line of 10 MB" => |folder| list(folder, format!("{IPC}.enable {}\n", "x".repeat(10_000_000)));
    a_long_path: "a list's path of 1 MB with 500,000 parts" => |folder| list(folder, format!("{}= 1\n", "a.".repeat(500_000)));
    many_brackets: "a path with 1,000,000 brackets" => |folder| list(folder, format!("{IPC}.stage{} 1\n", "[".repeat(1_000_000)));
    many_faults: "100,000 faults in 100,000 lines" => |folder| list(folder, format!("{IPC}.enable ON\n").repeat(100_001));
    many_faults_in_a_line: "100,000 faults in one line of 1 MB" => |folder| {
        axis(folder, &format!("getriebe = [{}]", "{ a = 1, b = 2 }, ".repeat(50_000)))
    };
    many_keys: "100,000 unknown keys" => |folder| {
        set(folder, (0..100_000).map(|n| format!("k{n} = 1\n")).collect::<String>())
    };
    many_axes: "10,000 axes, of which two differ in case only" => |folder| {
        list(folder, format!("{IPC}.enable ON\n"));
        let axes = (0..9_998).map(|n| format!("[axis.A{n}]\nlist = \"x.lis\"\n")).collect::<String>();
        set(folder, format!("cycle_time = \"1ms\"\n{axes}[axis.y]\n[axis.Y]\n"))
    };
    many_missing_lists: "10,000 axes whose lists are not there" => |folder| {
        let axes = (0..10_000).map(|n| format!("[axis.A{n}]\nlist = \"{n}.lis\"\n")).collect::<String>();
        set(folder, format!("cycle_time = \"1ms\"\n{axes}"))
    };
}

/// A file of that many NUL bytes, which takes no room.
fn sparse(folder: &Path, name: &str, bytes: u64, options: &[&str]) -> Vec<String> {
    File::create(folder.join(name)).unwrap().set_len(bytes).unwrap();
    [name].iter().chain(options).map(|argument| (*argument).to_owned()).collect()
}
