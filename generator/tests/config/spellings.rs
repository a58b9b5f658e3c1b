//! No spelling stands for two things: not for two parameters, and not for two words of one parameter.

use generator::parameters::Name;
use generator::parameters::words::{
    AddJerk, AxisType, Boolean, DirectSource, DriveType, Enable, FeedforwardWord, FilterType, LineEnd, ListEncoding,
    Motor, OperationMode, ProcessDatum, Prototype, RealType, StageMode, TargetName, Tunable, Width, Words,
};
use std::collections::BTreeSet;

/// A path as it is looked for: with `[]` for an index; whatever its case, so that a message can name what is alike.
fn plain(path: &str) -> String {
    let outside: Vec<&str> = path.split(['[', ']']).step_by(2).collect();
    outside.join("[]").to_ascii_lowercase()
}

#[test]
fn paths_aliases_misprints_and_ids_belong_to_one_parameter() {
    let mut seen = BTreeSet::new();
    for parameter in Name::ALL.map(Name::parameter) {
        let others = parameter.aliases.iter().chain(parameter.misprints);
        let paths = others.chain([&parameter.path]).map(|path| plain(path));
        for spelling in paths.chain(parameter.id.map(str::to_ascii_lowercase)) {
            assert!(seen.insert(spelling.clone()), "{spelling} twice, the second time for {}", parameter.path);
        }
    }
    assert!(seen.len() > Name::ALL.len());
}

#[test]
fn spellings_and_numbers_belong_to_one_word() {
    fn of_one_word<T: Words>() {
        let mut seen = BTreeSet::new();
        for word in T::WORDS {
            let names = word.also.iter().chain([&word.name]).map(|name| name.to_ascii_lowercase());
            for spelling in names.chain(word.number.map(|number| number.to_string())) {
                assert!(seen.insert(spelling.clone()), "{spelling} twice, the second time for {}", word.name);
            }
        }
    }
    of_one_word::<AddJerk>();
    of_one_word::<AxisType>();
    of_one_word::<Boolean>();
    of_one_word::<DirectSource>();
    of_one_word::<DriveType>();
    of_one_word::<Enable>();
    of_one_word::<FeedforwardWord>();
    of_one_word::<FilterType>();
    of_one_word::<LineEnd>();
    of_one_word::<ListEncoding>();
    of_one_word::<Motor>();
    of_one_word::<OperationMode>();
    of_one_word::<ProcessDatum>();
    of_one_word::<Prototype>();
    of_one_word::<RealType>();
    of_one_word::<StageMode>();
    of_one_word::<TargetName>();
    of_one_word::<Tunable>();
    of_one_word::<Width>();
}
