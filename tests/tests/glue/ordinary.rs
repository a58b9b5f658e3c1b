//! The life of the axis X, and what has to be seen in each cycle: written by hand from docs/twincat.md, not computed.

use super::script::{FAULT, OPERATES, QUICK_STOP, Row, Script};

pub fn ordinary(tested: usize) -> Vec<Row> {
    let mut s = Script::new(0.0, 1000.0 / 53.0);
    start(&mut s, tested);
    modes(&mut s);
    stops(&mut s);
    pauses(&mut s);
    no_position_control(&mut s);
    bad_samples(&mut s);
    s.rows
}

/// The axis has power before the self-test is done, and moves: the block takes over without a jump; the torque waits
/// for a standstill.
fn start(s: &mut Script, tested: usize) {
    s.go(50, 0);
    s.power(true);
    s.go(20, 0);
    s.accelerate(300.0, 3.0);
    s.press(0, 0);
    s.go(tested - 72, 0);
    s.go(100, 4);
    s.now.acceleration = 0.0;
    s.go(200, 4);
    s.stand();
    s.now.feeds = true;
    s.go(100, 4);
    s.accelerate(900.0, 5.0);
    s.go(200, 4);
    s.accelerate(-900.0, 5.0);
    s.go(200, 4);
    // More than the limit: 25 mm/s.
    s.accelerate(0.0, 60.0);
    s.go(200, 4);
    s.stand();
    s.go(20, 4);
}

/// DRYRUN, OFF, a mode that is none; a torque that is wanted no longer.
fn modes(s: &mut Script) {
    s.accelerate(200.0, 4.0);
    s.go(200, 4);
    s.now.mode = 2;
    s.go(120, 4);
    s.now.mode = 1;
    s.go(120, 4);
    s.now.mode = 0;
    s.go(20, 4);
    s.now.mode = 1;
    s.now.feed_torque = false; // while it moves: nothing changes yet
    s.go(150, 4);
    // The block reports it in this cycle, and adds nothing; it is a trip in the next one.
    s.now.mode = 7;
    s.go(1, 4);
    s.now.feeds = false;
    s.see(10, 5, 2);
    s.press(5, 2); // it is wrong still
    s.now.mode = 1;
    s.see(10, 5, 2);
    s.press(4, 0);
    s.go(150, 4);
    s.stand();
    s.go(5, 4);
    s.now.feed_torque = true;
    s.now.feeds = true;
    s.go(5, 4);
    s.accelerate(400.0, 4.0);
    s.go(150, 4);
}

/// `stop` in the middle of a motion, and while the axis is homed: at once, and from 0 again.
fn stops(s: &mut Script) {
    s.now.stop = true;
    s.now.feeds = false;
    s.go(30, 3);
    s.now.stop = false;
    s.go(150, 4);
    s.now.homing = true;
    s.go(20, 3);
    s.now.homing = false;
    s.go(150, 4);
    // With stop, then OFF, and without stop, nothing comes back: section 6 of the commissioning page.
    s.now.stop = true;
    s.go(1, 3);
    s.now.mode = 0;
    s.go(10, 3);
    s.now.stop = false;
    s.go(120, 4);
    s.now.mode = 1;
    s.stand();
    s.now.feeds = true;
    s.go(50, 4);
}

/// Setup, feed hold, override: each by the fade.
fn pauses(s: &mut Script) {
    s.accelerate(200.0, 4.0);
    s.go(200, 4);
    s.now.setup = true;
    s.go(130, 6);
    s.stand();
    s.now.feeds = false;
    s.go(20, 6);
    s.accelerate(100.0, 4.0);
    s.go(20, 6);
    s.now.setup = false;
    s.go(150, 4);
    s.stand();
    s.now.feeds = true;
    s.go(20, 4);
    // Feed hold: the way to the standstill is damped, and what rings there fades out.
    s.accelerate(300.0, 4.0);
    s.go(200, 4);
    s.now.hold = true;
    s.accelerate(-300.0, 6.0);
    s.go(190, 4);
    s.halt();
    s.go(130, 6);
    s.now.hold = false;
    s.accelerate(300.0, 4.0);
    s.go(200, 4);
    // The override: half of it is a slower axis, and 0 % a feed hold.
    s.now.percentage = 500_000;
    s.accelerate(-150.0, 6.0);
    s.go(150, 4);
    s.halt();
    s.go(20, 4);
    s.accelerate(150.0, 3.0);
    s.go(100, 4);
    s.now.percentage = 0;
    s.accelerate(-150.0, 6.0);
    s.go(90, 4);
    s.halt();
    s.go(60, 6);
    // Before it has faded out.
    s.now.percentage = 1_000_000;
    s.accelerate(300.0, 4.0);
    s.go(150, 4);
    // DRYRUN and OFF are what they are in a pause, too.
    s.now.setup = true;
    s.now.mode = 2;
    s.go(20, 6);
    s.now.mode = 0;
    s.go(20, 6);
    s.now.setup = false;
    s.now.mode = 1;
    s.go(120, 4);
    s.stand();
    s.go(20, 4);
}

/// Each of the signals that say whether anything controls the axis. Nothing of it is latched here: the machine's own
/// program does that.
fn no_position_control(s: &mut Script) {
    let none: [fn(&mut Row); 6] = [
        |row| row.operational = false,
        |row| row.closed = false,
        |row| row.nc_error = 0x4655,
        |row| row.drive = FAULT,
        |row| row.drive = QUICK_STOP,
        |row| row.brake_closed = true,
    ];
    for change in none {
        s.accelerate(100.0, 5.0);
        s.go(60, 4);
        let before = s.now.clone();
        change(&mut s.now);
        s.now.feeds = false;
        s.go(5, 2);
        (s.now.operational, s.now.closed, s.now.nc_error) = (before.operational, before.closed, before.nc_error);
        (s.now.drive, s.now.brake_closed) = (OPERATES, before.brake_closed);
        s.go(60, 4);
        s.stand();
        s.now.feeds = true;
        s.go(5, 4);
    }
    // Lost telegrams while the axis is off are no trip, not even the last one before it has power.
    s.power(false);
    s.go(20, 2);
    s.bad(2);
    s.bad(2);
    s.bad(2);
    s.bad(2);
    s.power(true);
    s.now.feeds = true;
    s.go(20, 4);
}

/// Two lost telegrams are ridden through, a third one trips; a button that is held down ends nothing; a bad
/// acceleration trips too.
fn bad_samples(s: &mut Script) {
    s.accelerate(200.0, 5.0);
    s.go(120, 4);
    s.bad(4);
    s.bad(4);
    s.go(100, 4);
    s.now.acknowledge = true;
    s.go(20, 4);
    s.bad(4);
    s.bad(4);
    s.bad(4);
    s.now.feeds = false;
    s.see(30, 5, 12);
    s.now.acknowledge = false;
    s.see(10, 5, 12);
    s.press(4, 0);
    s.go(150, 4);
    s.stand();
    s.now.feeds = true;
    s.go(20, 4);
    // A bad acceleration takes only the torque with it; v_add fades out.
    s.accelerate(0.0, 5.0);
    s.go(150, 4);
    s.go(1, 4);
    s.last().acceleration = 1.0e13;
    s.now.feeds = false;
    s.see(130, 5, 15);
    // A trip lasts while the axis is off.
    s.power(false);
    s.see(20, 5, 15);
    s.press(2, 0);
    s.go(10, 2);
    s.stand();
    s.power(true);
    s.now.feeds = true;
    s.go(20, 4);
}
