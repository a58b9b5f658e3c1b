//! Reading TOML sets.

use super::{assert_said, read_set};

#[test]
fn no_utf8() {
    let (_, report) = read_set(b"# \xC3\xA4\n# \xE4\n");
    assert_said(&report.to_string(), &["set.toml:2:3: error[AX003]: not UTF-8", "    allowed: a TOML file is UTF-8"]);
}

#[test]
fn axes_keep_the_order_of_the_file() {
    let (set, _) = read_set("targets = [\"ST\", \"C\"]\ncycle_time = \"62.5us\"\n[axis.Z]\n[axis.A]\n[axis.m]\n");
    let set = set.unwrap();
    assert_eq!(set.targets, ["st", "c"]);
    let names: Vec<_> = set.axes.iter().map(|of| (of.axis.name.as_str(), of.axis.cycle_time_ns)).collect();
    assert_eq!(names, [("Z", 62_500), ("A", 62_500), ("m", 62_500)]);
}
