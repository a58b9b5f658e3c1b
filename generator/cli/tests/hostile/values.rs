//! Values of another type, without their unit, out of their range, or no values at all.

use super::row::{IPC, axis, set};

rows! {
    a_cycle_time_that_is_a_number: "a cycle time that is a number" => |folder| set(folder, "cycle_time = 1\n[axis.X]\n");
    no_unit: "a cycle time without its unit" => |folder| set(folder, "cycle_time = \"1\"\n[axis.X]\n");
    another_unit: "a cycle time in minutes" => |folder| set(folder, "cycle_time = \"1min\"\n[axis.X]\n");
    no_time: "a cycle time of 0" => |folder| set(folder, "cycle_time = \"0ms\"\n[axis.X]\n");
    a_negative_time: "a negative cycle time" => |folder| set(folder, "cycle_time = \"-1ms\"\n[axis.X]\n");
    a_long_time: "a cycle time of 10^400 s" => |folder| set(folder, format!("cycle_time = \"1{}s\"\n[axis.X]\n", "0".repeat(400)));
    parts_of_nanoseconds: "a cycle time with a part of a nanosecond" => |folder| set(folder, "cycle_time = \"0.5ns\"\n[axis.X]\n");
    a_time_with_an_exponent: "a cycle time with an exponent" => |folder| set(folder, "cycle_time = \"1e-3s\"\n[axis.X]\n");
    a_time_that_is_nan: "a cycle time that is not a number" => |folder| set(folder, "cycle_time = \"nan ms\"\n[axis.X]\n");
    a_number_in_quotes: "a number in quotes" => |folder| axis(folder, &format!("{IPC}.v_add_max_fact = \"1000\""));
    a_number_that_is_a_table: "a number that is a table" => |folder| axis(folder, &format!("{IPC}.v_add_max_fact = {{}}"));
    a_date: "a number that is a date" => |folder| axis(folder, &format!("{IPC}.v_add_max_fact = 1979-05-27"));
    a_word_that_is_an_array: "a word that is an array" => |folder| axis(folder, &format!("{IPC}.enable = [\"ON\"]"));
    an_unknown_word: "an unknown word" => |folder| axis(folder, &format!("{IPC}.enable = \"MAYBE\""));
    a_word_with_control_characters: "a word with a line end, NUL and an escape sequence" => |folder| {
        axis(folder, &format!("{IPC}.enable = \"O\\nN\\u0000\\u001B[31m\""))
    };
    not_a_number: "a frequency that is not a number" => |folder| f0(folder, "nan");
    infinity: "a frequency that is infinite" => |folder| f0(folder, "inf");
    minus_infinity: "a frequency that is minus infinity" => |folder| f0(folder, "-inf");
    a_huge_number: "a frequency of 1e999" => |folder| f0(folder, "1e999");
    the_largest_number: "a frequency of 1.7976931348623157e308" => |folder| f0(folder, "1.7976931348623157e308");
    a_subnormal_number: "a frequency of 5e-324" => |folder| f0(folder, "5e-324");
    minus_zero: "a frequency of -0.0" => |folder| f0(folder, "-0.0");
    a_number_of_many_digits: "a frequency of 100,000 digits" => |folder| f0(folder, &format!("{}.0", "9".repeat(100_000)));
    an_integer_beyond_64_bits: "a whole number of 2^64" => |folder| axis(folder, "gear = 18446744073709551616");
    the_smallest_integer: "a whole number of -2^63" => |folder| axis(folder, "gear = -9223372036854775808");
    a_part_of_a_whole_number: "a whole number with a fraction" => |folder| axis(folder, "gear = 1.5");
    hexadecimal_beyond_64_bits: "a hexadecimal number of 17 digits" => |folder| axis(folder, "gear = 0xFFFFFFFFFFFFFFFFF");
    hexadecimal_without_digits: "a hexadecimal number without digits" => |folder| axis(folder, "gear = 0x");
    an_index_out_of_range: "a gear step that does not exist" => |folder| axis(folder, "gear = 16");
    above_the_sampling_limit: "a frequency above the limit of the cycle time" => |folder| f0(folder, "499.9");
    two_dampings: "two values for one damping" => |folder| {
        axis(folder, &format!("{IPC}.stage = [{{ mode = \"INDIRECT\", osc_damping = 0.5, \
            filter = [{{ order = 1, fg_f0 = 11.0, q_factor = 2.0, damping = 0.6 }}] }}]"))
    };
}

/// An axis with a DIRECT stage of that frequency.
fn f0(folder: &std::path::Path, f0: &str) -> Vec<String> {
    let filter = format!("filter = [{{ order = 1, fg_f0 = {f0}, q_factor = 10.0 }}]");
    axis(folder, &format!("{IPC}.v_add_max_fact = 1000\n{IPC}.stage = [{{ mode = \"DIRECT\", {filter} }}]"))
}
