//! A block `spindle` with a drive and an interpolator that do what they are told, unless a test says otherwise. No assertions
//! about the block's rules.

use portable::Block;
use reference::process_data;
use reference::spindle::{Coeffs, Inputs, Outputs, Spindle, SpindleState, State};

/// A speed of one rpm [0.001 deg/s].
pub const RPM: f64 = 6000.0;

/// The cycle time T [s].
pub const T: f64 = 0.002;

/// Von.
pub const V_ON: f64 = 200.0 * RPM;

/// Voff.
pub const V_OFF: f64 = 50.0 * RPM;

/// By how much the actual velocity may be above the command where BRAKE ends.
pub const V_WINDOW: f64 = V_OFF / 100.0;

/// Deceleration * T.
pub const V_STEP: f64 = 10.0 * RPM;

/// (Nd + 1) T + (1 - w) / Kv with Nd 4, w 0.5, Kv 20/s.
pub const LEAD_TIME: f64 = 0.035;

/// Largest step at the take-over [0.001 deg].
pub const WINDOW: f64 = 1000.0;

/// Cycles within which the drive displays a mode.
pub const MODE_CYCLES: u32 = 5;

/// Cycles within which the spindle has braked.
pub const BRAKE_CYCLES: u32 = 120;

pub const POSITION_MODE: i32 = 8;
pub const VELOCITY_MODE: i32 = 9;

/// What is not set by a test is what should be: the drive displays at once what it was asked for, and moves as commanded; the
/// interpolator moves on from the commands with its velocity `v`.
pub struct Bench {
    pub coeffs: Coeffs<f64>,
    pub state: State<f64>,
    pub outputs: Outputs<f64>,
    /// the inputs that are not samples, and what a test forces
    pub inputs: Inputs<f64>,
    /// velocity of the interpolator
    pub v: f64,
    /// instead of what the interpolator and the drive give
    pub x_command: Option<f64>,
    pub x_actual: Option<f64>,
    pub v_actual: Option<f64>,
    pub display: Option<i32>,
}

impl Bench {
    /// Position control in the drive.
    pub fn in_drive() -> Self {
        let coeffs = Coeffs {
            cycle_time_ns: 2_000_000,
            cycle_time: T,
            in_drive: true,
            v_velocity_control_on: V_ON,
            v_position_control_on: V_OFF,
            v_position_control_on_negative: -V_OFF,
            window: V_WINDOW,
            v_taken_up: V_OFF + V_WINDOW,
            v_step: V_STEP,
            v_largest: (180_000.0 / T).next_down(),
            v_usual_position: V_ON.next_down(),
            v_usual_velocity: f64::from(i32::MAX),
            lead_time: LEAD_TIME,
            takeover_window: WINDOW,
            mode_cycles: MODE_CYCLES,
            start_cycles: MODE_CYCLES + 2,
            brake_cycles: BRAKE_CYCLES,
            position_mode: POSITION_MODE,
            velocity_mode: VELOCITY_MODE,
            velocity_scale: 1.0,
            velocity_range: process_data::Coeffs {
                lowest: i32::MIN,
                highest: i32::MAX,
                lower_limit: f64::from(i32::MIN) - 0.5,
                upper_limit: f64::from(i32::MAX) + 0.499,
            },
            ..Coeffs::default()
        };
        Self::with(coeffs)
    }

    /// Position control in the CNC, with Kv 20/s and a feedforward of the velocity with the weight 1.
    pub fn in_cnc() -> Self {
        let drive = Self::in_drive().coeffs;
        Self::with(Coeffs {
            in_drive: false,
            lead_time: 0.052,
            has_feedforward: true,
            lead_time_per_percent: 0.01 / 20.0,
            position_mode: 0,
            velocity_mode: 0,
            velocity_scale: 0.0,
            velocity_range: process_data::Coeffs::default(),
            ..drive
        })
    }

    pub fn with(coeffs: Coeffs<f64>) -> Self {
        let inputs = Inputs {
            drive_on: true,
            task_cycle_ns: coeffs.cycle_time_ns,
            s_word: 1000.0 * RPM,
            s_position: 180_000.0,
            ..<Spindle as Block<f64>>::inputs(&coeffs)
        };
        let state = <Spindle as Block<f64>>::state();
        let outputs = Outputs { operation_mode: coeffs.position_mode, ..<Spindle as Block<f64>>::outputs() };
        let (x_command, x_actual, v_actual, display) = (None, None, None, None);
        Self { coeffs, state, outputs, inputs, v: 0.0, x_command, x_actual, v_actual, display }
    }

    /// Both kinds.
    pub fn both() -> [Self; 2] {
        [Self::in_drive(), Self::in_cnc()]
    }

    /// A cycle.
    pub fn cycle(&mut self) -> Outputs<f64> {
        let o = self.outputs;
        let inputs = Inputs {
            x_command: self.x_command.unwrap_or(o.x_spindle + o.v_spindle * T),
            v_interpolator: self.v,
            x_actual: self.x_actual.unwrap_or(o.x_spindle),
            v_actual: self.v_actual.unwrap_or(o.v_spindle),
            operation_mode_display: self.display.unwrap_or(o.operation_mode),
            ..self.inputs
        };
        <Spindle as Block<f64>>::step(&mut self.state, &self.coeffs, &inputs, &mut self.outputs);
        self.outputs
    }

    /// Cycles; the outputs of the last one.
    pub fn cycles(&mut self, count: u32) -> Outputs<f64> {
        for _ in 0..count {
            self.cycle();
        }
        self.outputs
    }

    /// A cycle with other inputs, which are gone after it.
    pub fn with_inputs(&mut self, change: impl FnOnce(&mut Inputs<f64>)) -> Outputs<f64> {
        let before = self.inputs;
        change(&mut self.inputs);
        let outputs = self.cycle();
        self.inputs = before;
        outputs
    }

    /// Cycles until a state is put out.
    pub fn until(&mut self, state: SpindleState) -> Outputs<f64> {
        for _ in 0..200 {
            if self.cycle().spindle_state == state {
                return self.outputs;
            }
            assert!(!self.outputs.fault, "{:?}", self.outputs);
        }
        panic!("no {state:?}: {:?}", self.outputs);
    }

    /// Cycles, if need be, until the next one begins in a state.
    pub fn until_next(&mut self, state: SpindleState) -> Outputs<f64> {
        for _ in 0..200 {
            if self.next() == state {
                return self.outputs;
            }
            self.cycle();
            assert!(!self.outputs.fault, "{:?}", self.outputs);
        }
        panic!("no {state:?}: {:?}", self.outputs);
    }

    /// In POSITION, at rest.
    pub fn at_rest(mut self) -> Self {
        self.until(SpindleState::Position);
        self
    }

    /// In POSITION with the job TURN, one cycle before TO_VELOCITY; S is 1000 rpm.
    pub fn turning(self) -> Self {
        let mut bench = self.at_rest();
        bench.with_inputs(|i| i.m3 = true);
        bench
    }

    /// In TO_VELOCITY at 1000 rpm, whose first cycle is the next one.
    pub fn before_to_velocity(self) -> Self {
        let mut bench = self.turning();
        bench.v = 1000.0 * RPM;
        bench.cycle();
        bench
    }

    /// In VELOCITY at a velocity.
    pub fn fast(self, v: f64) -> Self {
        let mut bench = self.before_to_velocity();
        bench.until(SpindleState::Velocity);
        bench.v = v;
        bench.cycle();
        bench
    }

    /// In BRAKE at a velocity, whose first cycle is the next one; M19 waits.
    pub fn before_brake(self, v: f64) -> Self {
        let mut bench = self.fast(v);
        bench.with_inputs(|i| i.m19 = true);
        bench
    }

    /// In BRAKE, with as many requests as can wait.
    pub fn full(self) -> Self {
        let mut bench = self.before_brake(1000.0 * RPM);
        for _ in 0..3 {
            bench.with_inputs(|i| i.m5 = true);
            bench.cycle();
        }
        bench
    }

    /// In TO_POSITION, whose first cycle is the next one; M19 waits.
    pub fn before_to_position(self) -> Self {
        let mut bench = self.before_brake(60.0 * RPM);
        bench.until_next(SpindleState::ToPosition);
        bench
    }

    /// In POSITION after TO_POSITION, whose first cycle is the next one.
    pub fn before_takeover(self) -> Self {
        let mut bench = self.before_to_position();
        bench.until_next(SpindleState::Position);
        bench.v = bench.outputs.v_spindle;
        bench
    }

    /// What the next cycle begins in.
    pub fn next(&self) -> SpindleState {
        self.state.control
    }
}

/// The angle within one turn, by another way than the block's.
pub fn wrap(x: f64) -> f64 {
    x.rem_euclid(360_000.0)
}

/// The same angle, but for the last bits of a few operations.
pub fn assert_angle(found: f64, expected: f64) {
    let distance = wrap(found - expected + 180_000.0) - 180_000.0;
    assert!(distance.abs() < 1e-6, "{found} instead of {expected}");
}
