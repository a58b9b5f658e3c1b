//! The life of the axis Z, and what has to be seen in each cycle: written by hand from docs/twincat.md, not computed.

use super::script::{Row, Script};

/// A gravity axis: its weight goes out always, and nothing else while the brake holds it. Its drive counts the other
/// way round, and the NC filters its velocity.
pub fn gravity(tested: usize) -> Vec<Row> {
    let mut s = Script::new(4.0, 1000.0 / 31.0);
    s.now.weight = 185;
    s.now.brake_closed = true;
    s.go(40, 0);
    s.power(true);
    s.go(tested - 40, 0);
    s.go(30, 2);
    s.now.brake_closed = false;
    s.now.feeds = true;
    s.go(50, 4);
    s.accelerate(500.0, 3.0);
    s.go(200, 4);
    s.accelerate(-500.0, 3.0);
    s.go(400, 4);
    // The workpiece is taken off.
    s.now.weight = 120;
    s.accelerate(500.0, 3.0);
    s.go(200, 4);
    // Lost telegrams: what the filter holds back goes on as it was.
    s.bad(4);
    s.go(50, 4);
    s.bad(4);
    s.bad(4);
    s.go(100, 4);
    // Feed hold in the air: the weight stays.
    s.now.hold = true;
    s.halt();
    s.go(130, 6);
    s.now.hold = false;
    s.go(120, 4);
    brake(&mut s);
    ranges(&mut s);
    s.rows
}

/// The brake falls in while the axis moves, and the drive has power still.
fn brake(s: &mut Script) {
    s.accelerate(-300.0, 6.0);
    s.go(150, 4);
    s.now.brake_closed = true;
    s.now.feeds = false;
    s.go(30, 2);
    s.stand();
    s.power(false);
    s.go(30, 2);
    s.power(true);
    s.go(10, 2);
    s.now.brake_closed = false;
    s.now.feeds = true;
    s.go(20, 4);
}

/// What the drive cannot take is held at the ends of its range.
fn ranges(s: &mut Script) {
    s.now.weight = 32_700;
    s.accelerate(3000.0, 3.0);
    s.go(60, 4);
    s.now.weight = -32_768;
    s.accelerate(-3000.0, 3.0);
    s.go(60, 4);
    s.now.weight = 185;
    s.accelerate(0.0, 3.0);
    s.go(20, 4);
    s.go(1, 4);
    s.last().acceleration = f64::NAN;
    s.now.feeds = false;
    s.see(10, 5, 15);
    s.press(4, 0);
    // More than the limit: 12.5 mm/s.
    s.accelerate(0.0, 40.0);
    s.go(150, 4);
    s.now.stop = true;
    s.now.feeds = false;
    s.go(20, 3);
    s.now.stop = false;
    s.go(150, 4);
    s.stand();
    s.now.feeds = true;
    s.go(200, 4);
}
