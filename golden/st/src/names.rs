//! Names that are reserved or already used by some compiler.

use super::Dialect;

/// Keywords, operators and the names of types.
const KEYWORDS: &str = "
    abstract access action and any any_bit any_char any_chars any_date any_derived any_elementary any_int any_magnitude any_num
    any_real any_string array at bool by byte case char class configuration constant continue date date_and_time dint do dt
    dword else elsif en end_action end_case end_class end_configuration end_for end_function end_function_block end_get end_if
    end_interface end_method end_namespace end_program end_property end_repeat end_resource end_set end_step end_struct
    end_transition end_type end_union end_var end_while eno exit extends f_edge false final for from function function_block get
    goto if implements initial_step int interface internal interval jmp ldate ldate_and_time ldt lint lreal ltime ltime_of_day
    ltod lword method mod namespace nan non_retain not null of on or overlap override pointer priority private program property
    protected public r_edge read_only read_write real ref ref_to repeat resource retain return set single sint step string
    struct super task then this time time_of_day to tod transition true type udint uint ulint union until using usint var
    var_access var_config var_external var_global var_in_out var_input var_output var_temp wchar while with word wstring xor";

/// Functions and blocks, of the standard and of common libraries.
const FUNCTIONS: &str = "
    abs acos add adr asin atan atan2 ceil concat cos ctd ctu ctud delete derivative div eq exp expt f_trig find floor ge gt
    hysteresis insert integral is_valid is_valid_bcd le left len limit ln log lower_bound lt max mid min move mul mux ne pid
    r_trig ramp replace right rol ror round rs rtc sel sema shl shr sin sizeof split_date split_dt split_tod sqrt sr sub tan
    tof ton tp trunc upper_bound";

/// Words reserved only in SCL: keywords and instructions.
const SCL: &str = "
    attach author begin blkmov block_db block_fb block_fc block_sdb const counter data_block db_any deco demux dis_airt dtl
    en_airt enco end_const end_data_block end_label end_organization_block end_region extern external family fill fill_blk
    frac get_err_id get_error geterrorid hw_any instance is_array know_how_protect label max_len move_blk move_blk_variant
    name neg nil norm_x ok ok_flag organization_block peek peek_bool poke poke_blk rd_loc_t rd_sys_t region runtime s5time
    s_move scale scale_x scatter serialize sqr stp strg_val swap t_add t_comp t_conv t_diff t_sub timer title tonr typeof
    typeofelements uble ufill_blk umove umove_blk unlinked val_strg var_static variant variantget variantput version void
    wait wr_sys_t";

/// Names of inputs in TwinCAT's motion library: its compiler accepts them, and no other one reads a program with that
/// library.
const LIBRARY: &str = "override";

/// The longest name that TIA accepts.
const LONGEST: usize = 125;

/// Whether a name is one of them, in any case.
pub(crate) fn taken(name: &str) -> bool {
    let lower = name.to_ascii_lowercase();
    let is = |list: &str| list.split_ascii_whitespace().any(|word| word == lower);
    is(KEYWORDS) || is(FUNCTIONS) || conversion(&lower)
}

/// Whether it is a standard function.
pub(crate) fn function(name: &str) -> bool {
    let lower = name.to_ascii_lowercase();
    FUNCTIONS.split_ascii_whitespace().any(|word| word == lower) || conversion(&lower)
}

/// Whether it is `dint_to_lreal` or a similar conversion.
fn conversion(lower: &str) -> bool {
    let ty = |name: &str| {
        let types = "bool byte char date dint dt dword int ldate ldt lint lreal ltime ltod lword real sint string time tod udint uint
            ulint usint wchar word wstring bcd";
        types.split_ascii_whitespace().any(|word| word == name)
    };
    lower.split_once("_to_").is_some_and(|(from, to)| ty(from) && ty(to))
}

/// Whether a variable of a program may have the name although it is taken.
pub(crate) fn of_library(name: &str) -> bool {
    LIBRARY.eq_ignore_ascii_case(name)
}

/// The error in a name, and what to write instead.
pub(crate) fn mistake(dialect: Dialect, name: &str) -> Option<(String, String)> {
    let found = format!("the name `{name}`");
    let is_of_scl = |word: &str| word.eq_ignore_ascii_case(name);
    let is_scl = dialect == Dialect::Scl;
    if taken(name) || is_scl && SCL.split_ascii_whitespace().any(is_of_scl) {
        Some((format!("{found}, which some compiler takes for its own"), "another name".to_owned()))
    } else if is_scl && name.len() > LONGEST {
        Some((found, format!("a name of at most {LONGEST} characters")))
    } else if name.ends_with('_') || name.contains("__") {
        Some((found, "a name without `__` and without `_` at its end".to_owned()))
    } else {
        None
    }
}
