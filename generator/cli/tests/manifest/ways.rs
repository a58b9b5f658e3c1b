//! The table `ways.toml`: what happens to a folder, the run that follows, and what is said of the files that it leaves over.

/// A way from one folder to another.
pub struct Way {
    pub way: String,
    pub steps: Vec<String>,
    pub run: String,
    pub codes: [i32; 2],
    pub said: Vec<String>,
    pub whole: Vec<String>,
    pub satisfied: Vec<String>,
}

pub fn ways() -> Vec<Way> {
    let table: toml::Table = include_str!("ways.toml").parse().unwrap();
    table["way"].as_array().unwrap().iter().map(|row| way(row.as_table().unwrap())).collect()
}

fn way(row: &toml::Table) -> Way {
    let known = ["way", "steps", "run", "codes", "said", "whole", "satisfied"];
    assert!(row.keys().all(|key| known.contains(&key.as_str())), "{row:?}");
    let text = |value: &toml::Value| value.as_str().unwrap().to_owned();
    let list = |key: &str, usual: &[&str]| match row.get(key) {
        Some(list) => list.as_array().unwrap().iter().map(text).collect(),
        None => usual.iter().map(|&usual| usual.to_owned()).collect::<Vec<String>>(),
    };
    let code = |at: usize| i32::try_from(row["codes"][at].as_integer().unwrap()).unwrap();
    Way {
        way: text(&row["way"]),
        steps: list("steps", &[]),
        run: row.get("run").map_or("axes.toml".to_owned(), text),
        codes: if row.contains_key("codes") { [code(0), code(1)] } else { [1, 0] },
        said: list("said", &[]),
        whole: list("whole", &["axes.toml"]),
        satisfied: list("satisfied", &["axes.toml"]),
    }
}
