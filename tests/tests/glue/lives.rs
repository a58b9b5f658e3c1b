//! The lives of both axes side by side: as many rows of the one as of the other, and one task.

use super::project::Project;
use super::script::{Row, Script};

/// The axis X, with its vibration of 53 Hz.
fn x(section: &str, marks: &[(&str, usize)]) -> Vec<Row> {
    Script::new(0.0, 1000.0 / 53.0).read(section, marks)
}

/// The axis Z, whose velocity the NC filters, with its vibration of 31 Hz.
fn z(section: &str, marks: &[(&str, usize)]) -> Vec<Row> {
    Script::new(4.0, 1000.0 / 31.0).read(section, marks)
}

/// From which cycle on each axis is tested.
fn tested(project: &Project) -> [usize; 2] {
    project.axes.each_ref().map(|axis| axis.tested())
}

/// The rows of both axes, as many of the one as of the other.
pub fn lives(project: &Project) -> [Vec<Row>; 2] {
    let [of_x, of_z] = tested(project);
    of_equal_length([x("ordinary", &[("tested", of_x)]), z("gravity", &[("tested", of_z)])])
}

/// The lives where a self-test of the axis X fails; the axis Z does not mind.
pub fn failing(project: &Project) -> [Vec<Row>; 2] {
    let [of_x, of_z] = tested(project);
    of_equal_length([x("failing", &[("tested", of_x)]), z("gravity", &[("tested", of_z)])])
}

/// The task of another cycle, and calls that are missing.
pub fn task(project: &Project) -> [Vec<Row>; 2] {
    let [of_x, of_z] = tested(project);
    let both = ("both", of_x.max(of_z) + 10);
    of_equal_length([x("task", &[("tested", of_x), both]), z("task", &[("tested", of_z), both])])
}

/// The shorter life goes on as it ended.
fn of_equal_length(mut lives: [Vec<Row>; 2]) -> [Vec<Row>; 2] {
    let longest = lives.iter().map(Vec::len).max().unwrap();
    for life in &mut lives {
        let last = life.last().unwrap().clone();
        life.resize(longest, last);
    }
    // The task is one: its calls are those of the axis X.
    let task: Vec<(u32, u32)> = lives[0].iter().map(|row| (row.cycle, row.missing)).collect();
    for (row, task) in lives[1].iter_mut().zip(task) {
        (row.cycle, row.missing) = task;
    }
    lives
}
