//! Mistakes as they are made at a machine, in `planted.toml`.

/// The file, what stands there, what is written instead.
pub fn planted() -> Vec<[String; 3]> {
    let files: toml::Table = include_str!("planted.toml").parse().unwrap();
    let of_file = |(file, changes): (&String, &toml::Value)| {
        let text = |change: &toml::Value, at: usize| change[at].as_str().unwrap().to_owned();
        let changes = changes.as_array().unwrap().iter();
        changes.map(|change| [file.clone(), text(change, 0), text(change, 1)]).collect::<Vec<_>>()
    };
    files.iter().flat_map(of_file).collect()
}
