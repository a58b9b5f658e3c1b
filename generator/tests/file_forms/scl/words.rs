//! Words of SCL that are no names: keywords, types, and the instructions that are keywords.

const KEYWORDS: &str = "
    action and any array at author begin block_db block_fb block_fc block_sdb bool by byte case char const constant continue
    counter data_block date date_and_time db_any dint div do dt dtl dword else elsif en end_action end_case end_const
    end_data_block end_for end_function end_function_block end_if end_label end_namespace end_organization_block end_region
    end_repeat end_struct end_type end_var end_while eno exit extern external false family for function function_block goto
    hw_any if instance int internal know_how_protect label ldt lint lreal ltime ltod lword mod name namespace nil
    non_retain not null of ok ok_flag or organization_block override pointer private program protected public read_only real
    ref ref_to region repeat retain return s5time sint string struct then this time time_of_day timer title to tod true
    type udint uint ulint unlinked until usint var var_external var_global var_in_out var_input var_output var_static var_temp
    variant version void wchar while with word wstring xor
";

const INSTRUCTIONS: &str = "
    abs acos asin atan atan2 attach blkmov ceil concat cos ctd ctu ctud deco delete demux dis_airt en_airt enco exp expt f_trig
    fill fill_blk find floor frac get_error get_err_id geterrorid insert is_array left len limit ln log max max_len mid min
    move move_blk move_blk_variant mux neg norm_x peek peek_bool poke poke_blk r_trig rd_loc_t rd_sys_t replace right rol ror
    round runtime s_move scale scale_x scatter sel serialize shl shr sin sqr sqrt stp strg_val swap t_add t_comp t_conv t_diff
    t_sub tan tof ton tonr tp trunc typeof typeofelements uble umove umove_blk ufill_blk val_strg variantget variantput wait
    wr_sys_t
";

/// Whether the word is no name, in whatever case.
pub fn is_reserved(word: &str) -> bool {
    let word = word.to_ascii_lowercase();
    let is_conversion = word.split_once("_to_").is_some_and(|(from, to)| is_type(from) && is_type(to));
    is_conversion
        || KEYWORDS.split_ascii_whitespace().chain(INSTRUCTIONS.split_ascii_whitespace()).any(|known| known == word)
}

fn is_type(word: &str) -> bool {
    [
        "bool", "byte", "word", "dword", "lword", "sint", "int", "dint", "lint", "usint", "uint", "udint", "ulint",
        "real", "lreal",
    ]
    .contains(&word)
}
