//! The stimulus, cycle by cycle, and what has to be seen in each: written by hand from docs/twincat.md, not computed.

use super::project::Project;
use super::world::OPERATES;

/// One cycle.
#[derive(Clone, Debug)]
pub struct Row {
    pub enable: bool,
    pub acknowledge: bool,
    pub mode: i32,
    pub feed_torque: bool,
    /// mm/s; a NaN is a lost telegram
    pub velocity: f64,
    /// mm/s^2
    pub acceleration: f64,
    pub not_moving: bool,
    pub homing: bool,
    /// the NC's position control is open
    pub open: bool,
    /// another status word than the drive's own
    pub drive: Option<u32>,
    /// the NC's error from now on
    pub nc_error: Option<u32>,
    /// of the task, in 100 ns
    pub cycle: u32,
    /// what has to be seen
    pub state: i32,
    pub error: u32,
    /// whether the acceleration goes out
    pub feeds: bool,
}

/// The stimulus while it is written.
struct Script {
    rows: Vec<Row>,
    now: Row,
    /// of the axis, without the vibration [mm/s]
    speed: f64,
    vibration: f64,
}

impl Script {
    fn new() -> Self {
        let now = Row {
            enable: false,
            acknowledge: false,
            mode: 1,
            feed_torque: true,
            velocity: 0.0,
            acceleration: 0.0,
            not_moving: true,
            homing: false,
            open: false,
            drive: None,
            nc_error: None,
            cycle: 10_000,
            state: 0,
            error: 0,
            feeds: false,
        };
        Self { rows: Vec::new(), now, speed: 0.0, vibration: 0.0 }
    }

    /// So many cycles with a state and an error.
    fn go(&mut self, cycles: usize, state: i32, error: u32) {
        for _ in 0..cycles {
            let turn = std::f64::consts::TAU * 0.053 * self.rows.len() as f64;
            self.speed += self.now.acceleration * 0.001;
            let velocity = self.speed + self.vibration * turn.sin();
            self.rows.push(Row { velocity, state, error, ..self.now.clone() });
        }
        self.now.nc_error = None;
    }

    /// Enables the axis: the drive needs a few cycles until the block may act.
    fn power(&mut self) {
        self.now.enable = true;
        self.go(OPERATES, 3, 0);
    }

    fn off(&mut self, cycles: usize) {
        (self.now.enable, self.now.feeds) = (false, false);
        self.go(cycles, 2, 0);
    }

    /// Moves with a vibration, at a constant acceleration of the interpolator.
    fn accelerate(&mut self, acceleration: f64, vibration: f64) {
        (self.now.acceleration, self.now.not_moving, self.vibration) = (acceleration, false, vibration);
    }

    fn stand(&mut self) {
        (self.now.acceleration, self.now.not_moving, self.vibration, self.speed) = (0.0, true, 0.0, 0.0);
    }

    /// A button that is pressed for two cycles.
    fn press(&mut self, state: i32, error: u32) {
        self.now.acknowledge = true;
        self.go(2, state, error);
        self.now.acknowledge = false;
    }

    fn bad(&mut self, state: i32, error: u32) {
        self.go(1, state, error);
        self.rows.last_mut().unwrap().velocity = f64::NAN;
    }
}

/// Drive off, enabled, moving, tripped, reset, enabled, and what else happens in the life of an axis.
pub fn script(project: &Project) -> Vec<Row> {
    let mut s = Script::new();
    start(&mut s, project.tested());
    modes(&mut s);
    bad_samples(&mut s);
    axis_trips(&mut s);
    wrong_cycle(&mut s);
    s.rows
}

/// The axis has power before the self-test is done, and moves: the block takes over without a jump; the torque waits for a standstill.
fn start(s: &mut Script, tested: usize) {
    s.go(50, 0, 0);
    s.now.nc_error = Some(0x4650);
    s.go(5, 6, 902);
    s.now.acknowledge = true;
    s.go(3, 6, 902);
    s.go(2, 0, 0);
    s.now.acknowledge = false;
    s.now.enable = true;
    s.accelerate(300.0, 3.0);
    s.go(tested - 60, 0, 0);
    s.go(100, 4, 0);
    s.now.acceleration = 0.0;
    s.go(300, 4, 0);
    s.stand();
    s.now.feeds = true;
    s.go(100, 4, 0);
    s.accelerate(900.0, 5.0);
    s.go(200, 4, 0);
    s.accelerate(-900.0, 5.0);
    s.go(200, 4, 0);
    // More than the limit: 25 mm/s.
    s.accelerate(0.0, 60.0);
    s.go(300, 4, 0);
    s.off(30);
    s.stand();
    s.off(20);
    s.power();
    s.now.feeds = true;
    s.go(20, 4, 0);
}

/// DRYRUN, OFF, a mode that is none; no torque wanted; homing; a position control that the NC opens.
fn modes(s: &mut Script) {
    s.accelerate(200.0, 4.0);
    s.go(250, 4, 0);
    s.now.mode = 2;
    s.go(150, 4, 0);
    s.now.mode = 0;
    s.go(20, 4, 0);
    s.now.mode = 1;
    s.now.feed_torque = false; // while it moves: nothing changes yet
    s.go(150, 4, 0);
    s.now.mode = 7;
    s.now.feeds = false;
    s.go(10, 5, 2);
    s.now.mode = 1;
    s.go(10, 5, 2);
    s.press(4, 0);
    s.go(150, 4, 0);
    s.now.homing = true;
    s.go(20, 4, 0);
    s.now.homing = false;
    s.go(150, 4, 0);
    s.now.open = true;
    s.go(10, 3, 0);
    s.now.open = false;
    s.go(150, 4, 0);
    s.stand();
    s.go(20, 4, 0);
    s.now.feed_torque = true;
    s.now.feeds = true;
    s.accelerate(400.0, 4.0);
    s.now.not_moving = true;
    s.go(1, 4, 0);
    s.now.not_moving = false;
    s.go(150, 4, 0);
}

/// Two lost telegrams are ridden through, a third one trips; a button that is held down ends nothing; a bad acceleration trips too.
fn bad_samples(s: &mut Script) {
    s.bad(4, 0);
    s.bad(4, 0);
    s.go(100, 4, 0);
    s.now.acknowledge = true;
    s.go(20, 4, 0);
    s.bad(4, 0);
    s.bad(4, 0);
    s.now.feeds = false;
    s.bad(5, 12);
    s.go(30, 5, 12);
    s.now.acknowledge = false;
    s.go(10, 5, 12);
    s.press(4, 0);
    s.go(150, 4, 0);
    s.stand();
    s.now.feeds = true;
    s.go(20, 4, 0);
    s.now.feeds = false;
    s.go(1, 5, 15);
    s.rows.last_mut().unwrap().acceleration = 1.0e13;
    s.go(20, 5, 15);
    // The end of a trip needs no standstill; the torque does.
    s.accelerate(100.0, 4.0);
    s.press(4, 0);
    s.go(150, 4, 0);
    s.stand();
    s.now.feeds = true;
    s.go(20, 4, 0);
}

/// A fault of the drive, with the NC's error two cycles later; a quick stop; an error of the NC while the axis is off.
fn axis_trips(s: &mut Script) {
    s.accelerate(200.0, 5.0);
    s.go(200, 4, 0);
    s.now.feeds = false;
    s.now.drive = Some(0x123F);
    s.go(2, 6, 903);
    s.now.nc_error = Some(0x4655);
    s.go(20, 6, 902);
    s.stand();
    // With Enable TRUE nothing is reset, and a button that is still down when Enable falls resets nothing.
    s.now.acknowledge = true;
    s.go(10, 6, 902);
    s.now.enable = false;
    s.go(10, 6, 902);
    s.now.acknowledge = false;
    s.go(5, 6, 902);
    // Enable in the middle of a reset stops it.
    s.now.acknowledge = true;
    s.go(2, 6, 902);
    s.now.enable = true;
    s.go(5, 6, 902);
    s.now.acknowledge = false;
    s.go(5, 6, 902);
    s.now.nc_error = Some(0x4655);
    s.now.enable = false;
    s.now.drive = None;
    s.go(5, 6, 902);
    s.now.acknowledge = true;
    s.go(3, 6, 902); // the NC takes its time
    s.now.acknowledge = false;
    s.off(10);
    s.power();
    s.now.feeds = true;
    s.go(20, 4, 0);
    s.accelerate(200.0, 5.0);
    s.go(150, 4, 0);
    s.now.drive = Some(0x1217); // quick stop active; the NC sees nothing
    s.now.feeds = false;
    s.go(20, 6, 903);
    s.now.drive = None;
    s.go(20, 6, 903);
    s.stand();
    s.now.enable = false;
    s.go(5, 6, 903);
    s.now.acknowledge = true;
    s.off(2);
    s.now.acknowledge = false;
    s.off(10);
    s.now.nc_error = Some(0x4550);
    s.go(5, 6, 902);
    // An error that goes away by itself is a trip nevertheless.
    s.now.nc_error = Some(0);
    s.go(5, 6, 902);
    s.now.nc_error = Some(0x4550);
    s.go(5, 6, 902);
    s.now.enable = true;
    s.go(20, 6, 902);
    s.now.enable = false;
    s.go(2, 6, 902);
    s.now.acknowledge = true;
    s.go(3, 6, 902);
    s.now.acknowledge = false;
    s.off(5);
    s.power();
    s.now.feeds = true;
    s.go(20, 4, 0);
}

/// A task of another cycle: refused while it acts, refused again when it is acknowledged, and at the next enabling.
fn wrong_cycle(s: &mut Script) {
    s.accelerate(200.0, 5.0);
    s.go(150, 4, 0);
    s.now.cycle = 20_000;
    s.now.feeds = false;
    s.go(10, 5, 1);
    s.press(5, 1);
    s.go(10, 5, 1);
    s.now.enable = false;
    s.stand();
    s.go(10, 5, 1);
    s.now.acknowledge = true;
    s.off(2);
    s.now.acknowledge = false;
    s.power();
    s.go(10, 5, 1);
    s.now.cycle = 10_000;
    s.go(10, 5, 1);
    s.now.acknowledge = true;
    s.now.feeds = true;
    s.go(2, 4, 0);
    s.now.acknowledge = false;
    s.accelerate(200.0, 5.0);
    s.go(200, 4, 0);
}

/// A self-test that fails: the axis moves, and nothing is ever added.
pub fn failing(project: &Project) -> Vec<Row> {
    let mut s = Script::new();
    s.go(project.tested(), 0, 0);
    s.now.enable = true;
    s.accelerate(200.0, 5.0);
    s.go(300, 1, 901);
    s.press(1, 901);
    s.go(50, 1, 901);
    s.now.enable = false;
    s.go(20, 1, 901);
    s.now.enable = true;
    s.stand();
    s.go(50, 1, 901);
    s.accelerate(200.0, 5.0);
    s.go(100, 1, 901);
    s.rows
}
