//! Words that some implementation of Structured Text keeps for itself, which no variable of a block has for a name; and the
//! names of a block's signals.

use crate::target::names::Names;
use compiler::program::{Program, Variable};
use std::collections::BTreeSet;
use std::sync::LazyLock;

/// Keywords of the standard's editions and of its dialects, standard functions and blocks, and words that a block uses.
const RESERVED: &str = "
    abstract abs acos action actions adr and any any_bit any_date any_int any_num any_real array asin at atan atan2 begin
    bitadr bool by byte cal calc calcn case char class concat configuration const constant continue cos ctd ctu ctud
    data_block date date_and_time delete derivative dint div do dt dword else elsif en end_action end_case end_class
    end_configuration end_for end_function end_function_block end_if end_interface end_method end_namespace end_program
    end_property end_repeat end_resource end_step end_struct end_transition end_type end_union end_var end_while enable eno eq
    error errorid busy exit exp expt extends f_edge f_trig false final find for from function function_block ge goto gt
    hysteresis if implements in initial_step insert int integral interface internal interval jmp jmpc jmpcn label ldate
    ldt le left len limit lint ln log lower_bound lreal lt ltime ltod lword max method mid min mod move mul mux namespace nan
    ne non_retain not null of on or or_else override persistent pid pointer priority private program property protected
    public r_edge r_trig ramp read_only read_write real ref reference region repeat replace resource ret retain return
    right rol ror rs rtc sel sema shl shr sin single sint sizeof sqrt sr st step string struct sub super tan task then this
    time tod time_of_day to tof ton tp transition true trunc type udint uint ulint union until upper_bound usint using valid var
    var_access var_config var_external var_global var_in_out var_input var_inst var_output var_stat var_temp vartype wchar
    while with word wstring xor xorn add sub
";

/// Whether some implementation keeps the word for itself, in whatever case.
#[must_use]
pub fn is_reserved(name: &str) -> bool {
    static WORDS: LazyLock<BTreeSet<&str>> = LazyLock::new(|| RESERVED.split_ascii_whitespace().collect());
    WORDS.contains(name.to_ascii_lowercase().as_str())
}

/// Signals that TwinCAT's blocks have beside the block's own; their names are reserved words for everything else.
const PLCOPEN: [&str; 5] = ["Enable", "Valid", "Busy", "Error", "ErrorID"];

/// The names of the inputs and of the outputs, taken before all others.
#[must_use]
pub fn signals(program: &Program, names: &mut Names) -> [Vec<String>; 2] {
    [&program.inputs, &program.outputs].map(|variables| {
        let name = |variable: &Variable| match variable.path.as_str() {
            path if PLCOPEN.contains(&path) => path.to_owned(),
            path => names.take(path),
        };
        variables.iter().map(name).collect()
    })
}
