//! Refused: the names that are to be avoided, all of them.

use super::reported;

/// Words that some compiler takes for its own, in whatever case.
const AVOIDED: &str = "
    en eno step action on task from transition dt tod time f_edge r_edge read_only ref null nan this super jmp public private
    final abstract internal abs min max limit sel mux sqrt exp log add sub mul div eq gt move len left mid find insert shl tp rs
    sr ctu sema trunc pid ramp integral derivative hysteresis rtc ln sin cos tan asin acos atan expt ge le lt ne shr rol ror
    right concat delete replace ton tof r_trig f_trig ctd ctud program function function_block var type struct array of
    if then else elsif case for to by do while repeat until exit return continue and or xor not mod true false bool byte word
    dword lword sint int dint lint usint uint udint ulint real lreal string wstring date int_to_real lreal_to_dint";

#[test]
fn each_is_refused_as_a_variable() {
    for name in AVOIDED.split_ascii_whitespace().flat_map(|name| [name.to_owned(), name.to_ascii_uppercase()]) {
        let said = reported("declared", &format!("VAR\n    {name} : BOOL;\nEND_VAR"));
        assert!(!said.is_empty(), "{name}");
        assert!(said.iter().all(|said| said.starts_with("6:5: found the name ")), "{name}: {said:?}");
    }
}

#[test]
fn names_that_only_look_like_them_are_taken() {
    for name in
        ["on_time", "gate", "mode", "limits", "stage0_filter0_section0_s1", "x_to_y", "_x", "value", "real_part"]
    {
        assert_eq!(reported("declared", &format!("VAR\n    {name} : BOOL;\nEND_VAR")), [""; 0], "{name}");
    }
}
