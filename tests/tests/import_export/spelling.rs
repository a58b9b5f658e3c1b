//! How values are spelled: a list's spelling stays in the set, and a set's in the list, wherever both allow it.

use super::{IPC, exported_text, imported};

#[test]
fn lists_to_sets() {
    for (path, text, toml) in [
        ("stage[0].filter.fg_f0", "53", "53"),
        ("stage[0].filter.fg_f0", "53.50", "53.50"),
        ("stage[0].filter.fg_f0", "5.3e1", "5.3e1"),
        ("stage[0].filter.fg_f0", ".5", "0.5"),
        ("stage[0].filter.fg_f0", "5.", "5"),
        ("stage[0].filter.fg_f0", "0x10", "0x10"),
        ("stage[0].filter.fg_f0", "99999999999999999999", "1e20"),
        ("stage[0].filter.order", "007", "7"),
        ("stage[0].filter.order", "0X2", "2"),
        ("stage[0].filter.order", "0x2", "0x2"),
        ("stage[0].filter.order", "+2", "+2"),
        ("enable", "TRUE", "\"TRUE\""),
        ("enable", "1", "1"),
        ("enable", "01", "\"01\""),
        ("stage[0].mode", "NOT_active", "\"NOT_active\""),
    ] {
        let set = imported(format!("{IPC}{path} {text}"));
        let key = path.rsplit('.').next().unwrap();
        let is_there = |end: &str| set.contains(&format!("{key} = {toml}{end}"));
        assert!(is_there("\n") || is_there(" }"), "{path} {text}\n{set}");
    }
}

#[test]
fn sets_to_lists() {
    for (key, toml, text) in [
        ("stage = [{ filter = [{ KEY, order = 1 }] }]", "fg_f0 = 53.50", "fg_f0 53.50"),
        ("stage = [{ filter = [{ KEY }] }]", "fg_f0 = 5_3", "fg_f0 53"),
        ("stage = [{ filter = [{ KEY }] }]", "order = 0b11", "order 3"),
        ("KEY", "enable = true", "enable TRUE"),
        ("KEY", "enable = \"On\" # c", "enable On"),
        ("KEY", "enable = \"\\u004FN\"", "enable ON"),
        ("KEY", "enable = '''ON'''", "enable ON"),
    ] {
        let set =
            format!("cycle_time = \"1ms\"\n[axis.X.{}]\n{}\n", IPC.trim_end_matches('.'), key.replace("KEY", toml));
        let list = exported_text(&set);
        assert!(list.contains(&format!("{text}\n")), "{toml}\n{list}");
    }
    for (toml, text) in [("0.1 s", "100ms"), ("0.1s", "0.1s")] {
        let list = exported_text(&format!("cycle_time = \"1ms\"\n[axis.X]\nfade = \"{toml}\"\n"));
        assert!(list.contains(&format!("# axgen: fade {text}\n")), "{list}");
    }
}
