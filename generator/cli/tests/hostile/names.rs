//! Axis names that would end comments, texts or folders where they came through.

use super::row::{list, set};
use std::path::Path;

rows! {
    an_empty_name: "an axis with an empty name" => |folder| named(folder, "");
    a_quote: "an axis `\"`" => |folder| named(folder, "\\\"");
    a_line_end: "an axis with a line end in its name" => |folder| named(folder, "X\\nint main;");
    a_nul: "an axis with NUL in its name" => |folder| named(folder, "X\\u0000");
    an_end_of_a_c_comment: "an axis `*/`" => |folder| named(folder, "X*/");
    an_end_of_an_st_comment: "an axis `*)`" => |folder| named(folder, "X*)");
    an_end_of_cdata: "an axis `]]>`" => |folder| named(folder, "X]]>");
    a_tag: "an axis `<X>`" => |folder| named(folder, "<X>");
    an_entity: "an axis `&lt;`" => |folder| named(folder, "&lt;");
    a_way_up: "an axis `../X`" => |folder| named(folder, "../X");
    an_absolute_path: "an axis `/X`" => |folder| named(folder, "/X");
    a_backslash: "an axis `..\\X`" => |folder| named(folder, "..\\\\X");
    a_command: "an axis `$(touch out)`" => |folder| named(folder, "$(touch out)");
    a_macro: "an axis `#define X`" => |folder| named(folder, "#define X");
    a_continued_line: "an axis that ends in a backslash" => |folder| named(folder, "X\\\\");
    a_trigraph: "an axis `??/`" => |folder| named(folder, "??/");
    a_blank: "an axis with a blank in its name" => |folder| named(folder, "X Y");
    a_digit: "an axis `1X`" => |folder| named(folder, "1X");
    two_underscores: "an axis with two underscores in a row" => |folder| named(folder, "X__Y");
    too_long: "an axis name of 33 letters" => |folder| named(folder, &"X".repeat(33));
    much_too_long: "an axis name of 1,000,000 letters" => |folder| named(folder, &"X".repeat(1_000_000));
    beyond_ascii: "an axis `Ä`" => |folder| named(folder, "\u{c4}");
    right_to_left: "an axis with the mark that turns the direction of writing" => |folder| named(folder, "X\u{202e}Y");
    differing_in_case: "axes `x` and `X`" => |folder| set(folder, "cycle_time = \"1ms\"\n[axis.x]\n[axis.X]\n");
    of_an_option: "`--name '*/'`" => |folder| {
        let mut arguments = list(folder, "");
        arguments.extend(["--name", "*/"].map(str::to_owned));
        arguments
    };
    of_a_file: "a list whose file name has no letter of a name" => |folder| {
        std::fs::write(folder.join("$.lis"), "").unwrap();
        ["$.lis", "--cycle-time", "1ms"].map(str::to_owned).to_vec()
    };
}

fn named(folder: &Path, name: &str) -> Vec<String> {
    set(folder, format!("cycle_time = \"1ms\"\n[axis.\"{name}\"]\n"))
}
