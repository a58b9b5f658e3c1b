//! The document: its table is read, compared with the rows, or written.

use super::row::{Seen, see};
use super::rows;
use std::{collections::BTreeMap, fs};

const PATH: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/hostile-input.md");

/// Where the table begins.
const HEAD: &str = "| no. | the input | what is said first | exit |\n| --- | --- | --- | --- |\n";

/// Whether the document is to be written.
pub fn is_written() -> bool {
    std::env::var_os("UPDATE_EXPECT").is_some_and(|value| value == "1")
}

pub fn read() -> BTreeMap<String, Seen> {
    cells().into_iter().map(|[_, input, said, exit]| (input, Seen { said, exit: exit.parse().unwrap() })).collect()
}

fn cells() -> Vec<[String; 4]> {
    let text = fs::read_to_string(PATH).unwrap();
    let (_, table) = text.split_once(HEAD).expect("the document has its table");
    table.lines().take_while(|line| line.starts_with('|')).map(cells_of).collect()
}

fn cells_of(line: &str) -> [String; 4] {
    let line = line.strip_prefix("| ").and_then(|line| line.strip_suffix(" |")).expect("a row");
    let cells: Vec<String> = line.split(" | ").map(|cell| cell.replace("\\|", "|")).collect();
    let [number, input, said, exit] = cells.try_into().expect("four cells");
    let said = said.strip_prefix("`` ").and_then(|said| said.strip_suffix(" ``")).expect("a quotation");
    [number, input, said.to_owned(), exit]
}

fn row_of(number: usize, input: &str, seen: &Seen) -> String {
    let cell = |text: &str| text.replace('|', "\\|");
    format!("| {number} | {} | `` {} `` | {} |\n", cell(input), cell(&seen.said), seen.exit)
}

#[test]
fn the_table_has_these_rows_in_this_order() {
    let inputs: Vec<&str> = rows().map(|row| row.input).collect();
    let different: std::collections::BTreeSet<_> = inputs.iter().collect();
    assert_eq!(different.len(), inputs.len(), "two rows have one text");
    if is_written() {
        let text = fs::read_to_string(PATH).unwrap();
        let (before, rest) = text.split_once(HEAD).expect("the document has its table");
        let after: String = rest.split_inclusive('\n').skip_while(|line| line.starts_with('|')).collect();
        let table: String = rows().zip(1..).map(|(row, number)| row_of(number, row.input, &see(row))).collect();
        fs::write(PATH, format!("{before}{HEAD}{table}{after}")).unwrap();
    }
    let documented = cells();
    let numbers: Vec<&str> = documented.iter().map(|[number, ..]| number.as_str()).collect();
    assert_eq!(numbers, (1..=inputs.len()).map(|number| number.to_string()).collect::<Vec<_>>());
    assert_eq!(documented.iter().map(|[_, input, ..]| input.as_str()).collect::<Vec<_>>(), inputs);
}
