//! Bytes that are no text, or a text of another encoding.

use super::row::{IPC, list, set};

const SET: &str = "cycle_time = \"1ms\"\n[axis.X]\n";

rows! {
    utf_16_with_a_mark: "a set in UTF-16 with its mark" => |folder| set(folder, utf_16(SET, true));
    utf_16_without_a_mark: "a set in UTF-16 without a mark" => |folder| set(folder, utf_16(SET, false));
    latin_1: "a set with a comment in Latin-1" => |folder| set(folder, b"# \xE4\ncycle_time = \"1ms\"\n[axis.X]\n");
    overlong: "a set with an overlong `/` (C0 AF)" => |folder| set(folder, b"cycle_time = \"1ms\"\n[axis.\"\xC0\xAF\"]\n");
    nul_in_a_set: "a NUL byte in a set" => |folder| set(folder, "cycle_time = \"1ms\"\n\0[axis.X]\n");
    two_marks: "two byte order marks before a set" => |folder| set(folder, format!("\u{feff}\u{feff}{SET}"));
    cr_only_set: "a set whose lines end in CR alone" => |folder| set(folder, SET.replace('\n', "\r"));
    binary_set: "every byte value, 4 KiB, as a set" => |folder| set(folder, binary());
    binary_list: "every byte value, 4 KiB, as a list" => |folder| list(folder, binary());
    list_in_utf_16: "a list in UTF-16" => |folder| list(folder, utf_16(&format!("{IPC}.enable ON\n"), true));
    nul_in_a_list: "a NUL byte in a list" => |folder| list(folder, format!("{IPC}.enable O\0N\n"));
    cr_only_list: "a list whose lines end in CR alone" => |folder| list(folder, format!("{IPC}.enable ON\r{IPC}.v_add_max_fact 1\r"));
    mark_within: "a byte order mark within a list" => |folder| list(folder, format!("{IPC}.enable ON\n\u{feff}{IPC}.v_add_max_fact 1\n"));
    letter: "a letter beyond ASCII in a list's path" => |folder| list(folder, "a\u{e4} 1\n");
    form_feed: "a form feed in a list" => |folder| list(folder, format!("\u{c}{IPC}.enable ON\n"));
    executable: "a program as a list" => |folder| list(folder, std::fs::read("/bin/sh").unwrap());
}

fn utf_16(text: &str, mark: bool) -> Vec<u8> {
    mark.then_some(0xFEFF).into_iter().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect()
}

fn binary() -> Vec<u8> {
    (0..4096).map(|n: u32| (n * 167 % 256).to_le_bytes()[0]).collect()
}
