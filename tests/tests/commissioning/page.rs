//! A commissioning page, read strictly: steps in their order, and in each step what it says. A number that nobody has taken out of a step is a mistake. No
//! machine here.

/// A table: its head, its rows.
#[derive(Clone, Debug, Default)]
pub struct Table {
    pub head: Vec<String>,
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// The column whose head is that.
    pub fn column(&self, head: &str) -> usize {
        let at = self.head.iter().position(|cell| cell == head);
        at.unwrap_or_else(|| panic!("page: no column `{head}`: {:?}", self.head))
    }

    /// A number that a cell begins with, after it the unit.
    pub fn number(&self, row: &[String], head: &str, unit: &str) -> f64 {
        let cell = &row[self.column(head)];
        let number = cell.strip_suffix(unit).unwrap_or_else(|| panic!("page: {cell} is not in {unit}")).trim();
        number.parse().unwrap_or_else(|_| panic!("page: {cell} is no number"))
    }
}

/// A step, or what a section says before its first step.
#[derive(Debug, Default)]
pub struct Step {
    /// `4.2`, of a section `4`
    pub id: String,
    /// what has not been taken out of its text
    rest: String,
    pub tables: Vec<Table>,
    pub commands: Vec<String>,
    is_done: bool,
}

impl Step {
    fn new(id: &str) -> Self {
        let mut step = Self::default();
        step.id = id.to_owned();
        step
    }

    /// It says this, word by word; `#` stands for what has been taken out.
    pub fn says(&self, text: &str) {
        assert!(self.rest.contains(text), "step {} does not say `{text}`: {}", self.id, self.rest);
    }

    /// The number between these words. It is taken out.
    pub fn number(&mut self, before: &str, after: &str) -> f64 {
        let starts = self.rest.match_indices(before).map(|(at, _)| at + before.len());
        let range = |start: usize| {
            let tail = &self.rest[start..];
            let length = tail.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(tail.len());
            let length = tail[..length].trim_end_matches('.').len();
            (length > 0 && tail[length..].starts_with(after)).then_some(start..start + length)
        };
        let range = starts.filter_map(range).next();
        let range =
            range.unwrap_or_else(|| panic!("step {} does not say `{before}NUMBER{after}`: {}", self.id, self.rest));
        let text = self.rest[range.clone()].to_owned();
        self.rest.replace_range(range, "#");
        text.parse().unwrap_or_else(|_| panic!("step {}: {text} is no number", self.id))
    }

    /// What stands in backquotes between these words.
    pub fn name(&self, before: &str, after: &str) -> String {
        let start = format!("{before}`");
        let names = self.rest.match_indices(&start).filter_map(|(at, _)| self.rest[at + start.len()..].split_once('`'));
        let name = names.filter(|(_, rest)| rest.starts_with(after)).map(|(name, _)| name.to_owned()).next();
        name.unwrap_or_else(|| panic!("step {} does not say `{before}NAME{after}`: {}", self.id, self.rest))
    }

    /// What it tells to write to inputs, in this order: `a := 1`. All of it is taken out.
    pub fn writes(&mut self) -> Vec<(String, f64)> {
        let parts: Vec<String> = self.rest.split('`').map(str::to_owned).collect();
        let mut found = Vec::new();
        for part in parts.iter().skip(1).step_by(2) {
            if let Some((input, value)) = part.split_once(" := ") {
                let number = match value {
                    "TRUE" => 1.0,
                    "FALSE" => 0.0,
                    number => number.parse().unwrap_or_else(|_| panic!("step {}: {part}", self.id)),
                };
                found.push((input.to_owned(), number));
                self.rest = self.rest.replacen(&format!("`{part}`"), "#", 1);
            }
        }
        assert!(!found.is_empty(), "step {} writes nothing: {}", self.id, self.rest);
        found
    }

    /// Nothing is left of it that somebody at a machine would have to do by a number.
    pub fn done(mut self) {
        self.is_done = true;
        // Names stand in backquotes; a step or a section is named.
        let named: String = self.rest.split('`').step_by(2).collect::<Vec<_>>().join(" ").replace("f0", "");
        let words: Vec<&str> = named.split_whitespace().collect();
        let is_number = |(at, word): (usize, &&str)| {
            let is_reference = at > 0 && ["step", "section", "Stage", "stage"].contains(&words[at - 1]);
            word.chars().any(|c| c.is_ascii_digit()) && !is_reference
        };
        let left: Vec<_> = words.iter().enumerate().filter(|(at, word)| is_number((*at, word))).collect();
        assert!(left.is_empty(), "step {}: nothing was done with {left:?}: {named}", self.id);
    }
}

impl Drop for Step {
    fn drop(&mut self) {
        assert!(self.is_done || std::thread::panicking(), "step {} was not looked at to its end", self.id);
    }
}

/// The steps of a page that have not been taken yet, from the last to the first.
pub struct Page {
    steps: Vec<Step>,
    /// the stages that its head names, in their order
    pub stages: Table,
    /// what stands before the first section
    pub head: String,
}

impl Page {
    /// Reads a page.
    pub fn read(text: &str) -> Self {
        let (head, body) = text.split_once("\n## ").unwrap_or_else(|| panic!("page: no section: {text}"));
        let mut steps = vec![Step::default()];
        let (mut is_code, mut is_table) = (false, false);
        for line in format!("## {body}").lines() {
            if line.starts_with("```") {
                is_code = !is_code;
                continue;
            }
            if let Some(id) = line.strip_prefix("## ").map(|line| line.split(' ').next().unwrap_or_default()) {
                steps.push(Step::new(id));
                continue;
            }
            let start = line.strip_prefix("**").and_then(|line| line.split_once("**"));
            if let Some((id, _)) = start {
                steps.push(Step::new(id));
            }
            let step = steps.last_mut().unwrap_or_else(|| panic!("page: {line}"));
            if is_code {
                step.commands.push(line.to_owned());
            } else if line.starts_with('|') {
                read_row(step, line, is_table);
            } else {
                step.rest.push_str(start.map_or(line, |(_, text)| text).trim());
                step.rest.push(' ');
            }
            is_table = line.starts_with('|');
        }
        steps.remove(0).is_done = true;
        steps.reverse();
        let mut stages = Step::default();
        let lines: Vec<&str> = head.lines().filter(|line| line.starts_with('|')).collect();
        lines.iter().enumerate().for_each(|(n, line)| read_row(&mut stages, line, n > 0));
        stages.is_done = true;
        let table = stages.tables.first().cloned().unwrap_or_else(|| panic!("page: no stages: {head}"));
        Self { steps, stages: table, head: head.to_owned() }
    }

    /// The next step, which must be this one.
    pub fn step(&mut self, id: &str) -> Step {
        let step = self.steps.pop().unwrap_or_else(|| panic!("page: it ends before step {id}"));
        if step.id != id {
            self.steps.iter_mut().for_each(|step| step.is_done = true);
            panic!("page: step {} stands where step {id} is expected", step.id);
        }
        step
    }

    /// What a section says before its first step, which is not to be done.
    pub fn section(&mut self, id: &str) {
        self.step(id).done();
    }

    /// No step is left.
    pub fn done(mut self) {
        let left: Vec<String> = self.steps.iter().map(|step| step.id.clone()).collect();
        self.steps.iter_mut().for_each(|step| step.is_done = true);
        assert!(left.is_empty(), "page: nobody has done {left:?}");
    }
}

fn read_row(step: &mut Step, line: &str, is_inside: bool) {
    let cells: Vec<String> = line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect();
    if !is_inside {
        step.tables.push(Table { head: cells, rows: Vec::new() });
    } else if !cells.iter().all(|cell| cell == "---") {
        step.tables.last_mut().expect("a table has a head").rows.push(cells);
    }
}
