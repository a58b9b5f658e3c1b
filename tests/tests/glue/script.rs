//! What an axis meets, cycle by cycle, while a life is written: its row, the motion, the NC's filter.

use std::str::FromStr;

const OPERATES: u32 = 0x1237;
const SWITCHED_ON: u32 = 0x0233;
/// Status words of a drive.
const DRIVE: [(&str, u32); 3] = [("OPERATES", OPERATES), ("FAULT", 0x123F), ("QUICK_STOP", 0x1217)];

/// One cycle of an axis.
#[derive(Clone, Debug)]
pub struct Row {
    /// what the NC says
    pub operational: bool,
    pub closed: bool,
    pub not_moving: bool,
    pub homing: bool,
    pub nc_error: u32,
    /// the override [0.0001 %]
    pub percentage: u32,
    /// the actual velocity after the NC's filter [mm/s]; a NaN is a lost telegram
    pub velocity: f64,
    /// the motor's [mm/s]
    pub motor: f64,
    pub set_velocity: f64,
    /// of the set value [mm/s^2]
    pub acceleration: f64,
    /// the status word of the drive
    pub drive: u32,
    /// what is asked for
    pub mode: i32,
    pub stop: bool,
    pub setup: bool,
    pub hold: bool,
    pub brake_closed: bool,
    pub feed_torque: bool,
    pub weight: i32,
    pub acknowledge: bool,
    /// the cycle of the task [100 ns], and how many calls are missing before this one; the same for both axes
    pub cycle: u32,
    pub missing: u32,
    /// what has to be seen
    pub state: i32,
    pub error: u32,
    /// whether the acceleration goes out
    pub feeds: bool,
}

/// A life while it is written.
pub struct Script {
    rows: Vec<Row>,
    now: Row,
    filter_cycles: f64,
    /// of the vibration [cycles]
    period: f64,
    /// of the motor [mm/s]
    vibration: f64,
}

impl Script {
    /// An axis that is off, and stands.
    pub fn new(filter_cycles: f64, period: f64) -> Self {
        let now = Row {
            operational: false,
            closed: false,
            not_moving: true,
            homing: false,
            nc_error: 0,
            percentage: 1_000_000,
            velocity: 0.0,
            motor: 0.0,
            set_velocity: 0.0,
            acceleration: 0.0,
            drive: SWITCHED_ON,
            mode: 1,
            stop: false,
            setup: false,
            hold: false,
            brake_closed: false,
            feed_torque: true,
            weight: 0,
            acknowledge: false,
            cycle: 10_000,
            missing: 0,
            state: 0,
            error: 0,
            feeds: false,
        };
        Self { rows: Vec::new(), now, filter_cycles, period, vibration: 0.0 }
    }

    /// A section of `lives.txt`, whose marks are cycles.
    pub fn read(mut self, section: &str, marks: &[(&str, usize)]) -> Vec<Row> {
        let text = include_str!("lives.txt").split(&format!("\n== {section}\n")).nth(1).unwrap();
        let lines = text.split("\n== ").next().unwrap().lines().map(|line| line.split('#').next().unwrap().trim());
        lines.filter(|line| !line.is_empty()).for_each(|line| self.line(line, marks));
        self.rows
    }

    fn line(&mut self, line: &str, marks: &[(&str, usize)]) {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words[..] {
            [field, "=", value] => set(&mut self.now, field, value),
            ["last", field, "=", value] => set(self.rows.last_mut().unwrap(), field, value),
            ["go", cycles, state] => self.see(of(cycles), of(state), 0),
            ["go", cycles, state, error] => self.see(of(cycles), of(state), of(error)),
            ["until", mark, state] => {
                let (_, end) = marks.iter().find(|(known, _)| *known == mark).unwrap();
                self.see(end - self.rows.len(), of(state), 0);
            }
            ["power", is_on] => self.power(is_on == "on"),
            ["accelerate", acceleration, vibration] => self.accelerate(of(acceleration), of(vibration)),
            ["halt"] => self.halt(),
            ["stand"] => self.stand(),
            ["press", state, error] => self.press(of(state), of(error)),
            ["bad", state] => self.bad(of(state)),
            _ => panic!("{line}"),
        }
    }

    /// These cycles have a state and an error.
    fn see(&mut self, cycles: usize, state: i32, error: u32) {
        for _ in 0..cycles {
            let turn = std::f64::consts::TAU / self.period * self.rows.len() as f64;
            if !self.now.not_moving {
                self.now.set_velocity += self.now.acceleration * 0.001;
            }
            self.now.motor = self.now.set_velocity + self.vibration * turn.sin();
            self.now.velocity += (self.now.motor - self.now.velocity) / (1.0 + self.filter_cycles);
            self.rows.push(Row { state, error, ..self.now.clone() });
            self.now.missing = 0;
        }
    }

    /// The program of the machine has given power, or taken it.
    fn power(&mut self, is_on: bool) {
        (self.now.operational, self.now.closed) = (is_on, is_on);
        self.now.drive = if is_on { OPERATES } else { SWITCHED_ON };
        if !is_on {
            self.now.feeds = false;
        }
    }

    /// Moves with a vibration, at a constant acceleration of the set value.
    fn accelerate(&mut self, acceleration: f64, vibration: f64) {
        (self.now.acceleration, self.now.not_moving, self.vibration) = (acceleration, false, vibration);
    }

    /// The set value is at rest in the middle of a job; the structure goes on ringing.
    fn halt(&mut self) {
        (self.now.acceleration, self.now.set_velocity) = (0.0, 0.0);
    }

    /// Stands, without a job.
    fn stand(&mut self) {
        self.halt();
        (self.now.not_moving, self.vibration) = (true, 0.0);
    }

    /// A button that is pressed for two cycles.
    fn press(&mut self, state: i32, error: u32) {
        self.now.acknowledge = true;
        self.see(2, state, error);
        self.now.acknowledge = false;
    }

    /// A lost telegram.
    fn bad(&mut self, state: i32) {
        self.see(1, state, 0);
        self.rows.last_mut().unwrap().velocity = f64::NAN;
    }
}

fn of<T: FromStr>(text: &str) -> T {
    text.parse().unwrap_or_else(|_| panic!("{text}"))
}

fn set(row: &mut Row, field: &str, value: &str) {
    match field {
        "operational" => row.operational = of(value),
        "closed" => row.closed = of(value),
        "homing" => row.homing = of(value),
        "nc_error" => row.nc_error = of(value),
        "percentage" => row.percentage = of(value),
        "acceleration" => row.acceleration = of(value),
        "drive" => row.drive = DRIVE.iter().find(|(name, _)| *name == value).unwrap().1,
        "mode" => row.mode = of(value),
        "stop" => row.stop = of(value),
        "setup" => row.setup = of(value),
        "hold" => row.hold = of(value),
        "brake_closed" => row.brake_closed = of(value),
        "feed_torque" => row.feed_torque = of(value),
        "weight" => row.weight = of(value),
        "acknowledge" => row.acknowledge = of(value),
        "cycle" => row.cycle = of(value),
        "missing" => row.missing = of(value),
        "feeds" => row.feeds = of(value),
        _ => panic!("{field}"),
    }
}
