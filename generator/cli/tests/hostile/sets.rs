//! Sets whose structure is wrong.

use super::row::{IPC, axis, set};

rows! {
    an_empty_set: "an empty set" => |folder| set(folder, "");
    a_set_of_comments: "a set of comments only" => |folder| set(folder, "# [axis.X]\n# cycle_time = \"1ms\"\n");
    no_axis: "a set without an axis" => |folder| set(folder, "cycle_time = \"1ms\"\n");
    no_axis_in_the_table: "a set whose table of axes is empty" => |folder| set(folder, "cycle_time = \"1ms\"\n[axis]\n");
    no_cycle_time: "a set without a cycle time" => |folder| set(folder, "[axis.X]\n");
    an_axis_that_is_a_number: "an axis that is a number" => |folder| set(folder, "cycle_time = \"1ms\"\n[axis]\nX = 1\n");
    axes_in_an_array: "axes in an array" => |folder| set(folder, "cycle_time = \"1ms\"\n[[axis]]\nname = \"X\"\n");
    a_key_twice: "a key twice" => |folder| set(folder, "cycle_time = \"1ms\"\ncycle_time = \"2ms\"\n[axis.X]\n");
    an_axis_twice: "an axis twice" => |folder| set(folder, "cycle_time = \"1ms\"\n[axis.X]\n[axis.X]\n");
    a_parameter_twice: "a parameter twice, as filter and as filter[0]" => |folder| {
        axis(folder, &format!("[[axis.X.{IPC}.stage]]\nfilter = [{{ order = 1 }}]\n\"filter[0].order\" = 2"))
    };
    a_quoted_path: "a parameter twice, once with its path in quotes" => |folder| {
        axis(folder, &format!("\"{IPC}.enable\" = \"ON\"\n{IPC}.enable = \"OFF\""))
    };
    four_stages: "four stages" => |folder| axis(folder, &format!("{IPC}.stage = [{{}}, {{}}, {{}}, {{ mode = \"DIRECT\" }}]"));
    three_filters: "three filters" => |folder| {
        axis(folder, &format!("{IPC}.stage = [{{ filter = [{{}}, {{}}, {{ order = 1 }}] }}]"))
    };
    a_stage_that_is_a_table: "stages that are a table" => |folder| axis(folder, &format!("{IPC}.stage = {{ mode = \"DIRECT\" }}"));
    a_stage_that_is_a_number: "a stage that is a number" => |folder| axis(folder, &format!("{IPC}.stage = [1]"));
    a_misspelt_key: "a misspelt parameter" => |folder| axis(folder, &format!("{IPC}.enabel = \"ON\""));
    a_key_with_an_escape: "a key with a terminal's escape sequence" => |folder| axis(folder, "\"\\u001B[2J\" = 1");
    a_key_of_the_set: "a key of the set below an axis" => |folder| axis(folder, "cycle_time = \"1ms\"");
    an_unclosed_quote: "an unclosed quote" => |folder| set(folder, "cycle_time = \"1ms\n[axis.X]\n");
    an_unclosed_text: "an unclosed text of several lines" => |folder| set(folder, "cycle_time = \"\"\"1ms\n[axis.X]\n");
    an_unclosed_bracket: "an unclosed bracket" => |folder| set(folder, "cycle_time = \"1ms\"\n[axis.X\n");
    a_bad_escape: "an escape sequence that TOML lacks" => |folder| set(folder, "cycle_time = \"\\q1ms\"\n[axis.X]\n");
    half_a_surrogate: "half of a surrogate pair" => |folder| set(folder, "cycle_time = \"\\uD800\"\n[axis.X]\n");
    an_axis_list_in_a_set: "an axis list with the name of a set" => |folder| set(folder, format!("{IPC}.enable ON\n"));
    json: "JSON with the name of a set" => |folder| set(folder, "{\"cycle_time\": \"1ms\", \"axis\": {\"X\": {}}}\n");
    an_unknown_target: "an unknown target in the set" => |folder| {
        set(folder, "cycle_time = \"1ms\"\ntargets = [\"c\", \"../c\"]\n[axis.X]\n")
    };
    a_target_twice: "a target twice" => |folder| set(folder, "cycle_time = \"1ms\"\ntargets = [\"c\", \"c\"]\n[axis.X]\n");
    an_unknown_target_of_the_command_line: "an unknown target on the command line" => |folder| {
        let mut arguments = axis(folder, "");
        arguments.extend(["--target", "c\u{1b}[2J"].map(str::to_owned));
        arguments
    };
    an_unknown_axis: "an axis on the command line that the set lacks" => |folder| {
        let mut arguments = axis(folder, "");
        arguments.extend(["--axis", "X\u{7}"].map(str::to_owned));
        arguments
    };
}
