//! The lives of both axes side by side: as many rows of the one as of the other, and one task.

use super::gravity::gravity;
use super::ordinary::ordinary;
use super::project::Project;
use super::script::{Row, Script};

/// The rows of both axes, as many of the one as of the other.
pub fn lives(project: &Project) -> [Vec<Row>; 2] {
    let [x, z] = project.axes.each_ref().map(|axis| axis.tested());
    of_equal_length([ordinary(x), gravity(z)])
}

/// The lives where a self-test of the axis X fails: it has power and moves, and nothing is ever added; the axis Z
/// does not mind.
pub fn failing(project: &Project) -> [Vec<Row>; 2] {
    let [x, z] = project.axes.each_ref().map(|axis| axis.tested());
    let mut s = Script::new(0.0, 1000.0 / 53.0);
    s.go(x, 0);
    s.power(true);
    s.accelerate(200.0, 5.0);
    s.go(300, 1);
    s.press(1, 0);
    s.stand();
    s.go(50, 1);
    of_equal_length([s.rows, gravity(z)])
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

/// The task of another cycle, and calls that are missing: both axes move, and see the same.
pub fn task(project: &Project) -> [Vec<Row>; 2] {
    let [x, z] = project.axes.each_ref().map(|axis| axis.tested());
    let later = x.max(z);
    let life = |tested: usize, filter: f64, period: f64| {
        let mut s = Script::new(filter, period);
        s.now.feed_torque = false;
        s.go(tested, 0);
        s.power(true);
        s.go(later + 10 - tested, 4);
        s.accelerate(100.0, 4.0);
        s.go(200, 4);
        // One missing call is tolerated.
        s.now.missing = 1;
        s.go(100, 4);
        // After a pause, say of a breakpoint, the block starts anew.
        s.now.missing = 80;
        s.go(150, 4);
        // Two pauses in a row are a wrong rate.
        s.now.missing = 5;
        s.go(1, 4);
        s.now.missing = 5;
        s.go(1, 4);
        s.see(40, 5, 9);
        s.press(4, 0);
        s.go(150, 4);
        s.now.cycle = 20_000;
        s.go(1, 4);
        s.see(10, 5, 1);
        s.press(5, 1);
        s.now.cycle = 10_000;
        s.see(10, 5, 1);
        s.press(4, 0);
        s.go(150, 4);
        s.rows
    };
    of_equal_length([life(x, 0.0, 1000.0 / 53.0), life(z, 4.0, 1000.0 / 31.0)])
}
