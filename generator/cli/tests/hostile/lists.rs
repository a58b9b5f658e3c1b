//! Axis lists with broken lines and values.

use super::row::{IPC, list};

rows! {
    an_equals_sign: "a list with `=`" => |folder| list(folder, format!("{IPC}.enable = ON\n"));
    no_value: "a parameter without a value" => |folder| list(folder, format!("{IPC}.enable\n"));
    two_values: "two values in a line" => |folder| list(folder, format!("{IPC}.enable ON OFF\n"));
    twice: "a parameter in two lines of a list" => |folder| list(folder, format!("{IPC}.enable ON\n{IPC}.enable ON\n"));
    twice_under_two_names: "filter.order and filter[0].order" => |folder| {
        list(folder, format!("{IPC}.stage[].filter.order 1\n{IPC}.stage[0].filter[0].order 1\n"))
    };
    a_stage_index: "stage[3] in a list" => |folder| list(folder, format!("{IPC}.stage[3].mode DIRECT\n"));
    a_huge_index: "an index of 30 digits" => |folder| list(folder, format!("{IPC}.stage[{}].mode DIRECT\n", "9".repeat(30)));
    a_negative_index: "a negative index" => |folder| list(folder, format!("{IPC}.stage[-1].mode DIRECT\n"));
    an_unclosed_index: "an unclosed index" => |folder| list(folder, format!("{IPC}.stage[0.mode DIRECT\n"));
    a_misspelt_structure: "a misspelt structure" => |folder| list(folder, "lr_param.improved_postion_control.enable ON\n");
    a_key_of_a_set: "a key of a set in a list" => |folder| list(folder, "cycle_time 1ms\n");
    a_hexadecimal_sign: "0x-1" => |folder| list(folder, format!("{IPC}.v_add_max_fact 0x-1\n"));
    a_bare_0x: "0x" => |folder| list(folder, format!("{IPC}.v_add_max_fact 0x\n"));
    hexadecimal_with_other_letters: "0x1G" => |folder| list(folder, format!("{IPC}.v_add_max_fact 0x1G\n"));
    a_hexadecimal_fraction: "0x1.8p3" => |folder| list(folder, format!("{IPC}.v_add_max_fact 0x1.8p3\n"));
    two_signs: "+-1" => |folder| list(folder, format!("{IPC}.v_add_max_fact +-1\n"));
    a_number_beyond_64_bits: "a number of 10^30" => |folder| list(folder, format!("{IPC}.v_add_max_fact 1{}\n", "0".repeat(30)));
    a_word_for_infinity: "`inf` in a list" => |folder| stage(folder, "inf");
    a_word_for_nan: "`NaN` in a list" => |folder| stage(folder, "NaN");
    a_decimal_comma: "a decimal comma" => |folder| stage(folder, "53,5");
    digits_of_another_script: "digits of another script" => |folder| stage(folder, "\u{665}\u{663}");
    a_set_in_a_list: "a set with the name of a list" => |folder| list(folder, "[axis.X]\nlist = \"x.lis\"\n");
    a_long_way_from_a_list: "a program's source with the name of a list" => |folder| list(folder, "int main(void) {\n".repeat(100));
    no_cycle_time: "a list without a cycle time" => |folder| {
        list(folder, format!("{IPC}.enable ON\n"));
        vec!["x.lis".to_owned()]
    };
}

fn stage(folder: &std::path::Path, f0: &str) -> Vec<String> {
    list(folder, format!("{IPC}.stage[0].mode DIRECT\n{IPC}.stage[0].filter.fg_f0 {f0}\n"))
}
