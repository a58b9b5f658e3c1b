//! A spindle on the bench: the drive answers at once, and each test says what is otherwise.

use crate::model::spindle::{BRAKE, Inputs, Model, Outputs, POSITION, Parameters, TO_POSITION, TO_VELOCITY, VELOCITY};

/// 300 rpm.
pub const FAST: f64 = 1_800_000.0;

/// Of a cycle's inputs, of parameters, of outputs.
pub type Change<T> = fn(&mut T);

pub struct Bench {
    pub p: Parameters,
    pub model: Model,
    pub inputs: Inputs,
    pub out: Outputs,
    /// false: the display is what the test says
    pub echoes: bool,
}

impl Bench {
    /// Before the first cycle, at 100 deg.
    pub fn new(p: &Parameters) -> Self {
        let inputs = Inputs { drive_on: true, x_actual: 100_000.0, x_command: 100_000.0, ..Inputs::START };
        Self { p: p.clone(), model: Model::new(p), inputs, out: Outputs::START, echoes: true }
    }

    pub fn drive() -> Self {
        Self::new(&Parameters::example())
    }

    pub fn cnc() -> Self {
        Self::new(&Parameters { in_cnc: true, feedforward: Some(0.5), ..Parameters::example() })
    }

    pub fn both() -> [Self; 2] {
        [Self::drive(), Self::cnc()]
    }

    /// A cycle; the drive displays the mode of the cycle before.
    pub fn cycle(&mut self) -> Outputs {
        if self.echoes {
            self.inputs.operation_mode_display = self.out.operation_mode;
        }
        self.out = self.model.cycle(&self.inputs);
        self.out
    }

    pub fn cycles(&mut self, number: usize) -> Outputs {
        (0..number).for_each(|_| _ = self.cycle());
        self.out
    }

    /// One cycle with other inputs.
    pub fn once(&mut self, change: impl FnOnce(&mut Inputs)) -> Outputs {
        let usual = self.inputs;
        change(&mut self.inputs);
        self.cycle();
        self.inputs = usual;
        self.out
    }

    /// The number of the cycle, from 1, in which something is so.
    pub fn until(&mut self, is_so: impl Fn(&Outputs) -> bool) -> usize {
        (1..5000).find(|_| is_so(&self.cycle())).expect("it comes")
    }

    /// The cycle before the first one of POSITION has passed; the interpolator stays with the spindle.
    pub fn positioned(mut self) -> Self {
        for _ in 0..5000 {
            if self.cycle().spindle_state == POSITION {
                break;
            }
            self.inputs.x_command = self.out.x_spindle + self.out.v_spindle * self.p.cycle;
        }
        assert_eq!((self.out.spindle_state, self.out.error_id), (POSITION, 0));
        self
    }

    /// The first cycle of TO_VELOCITY has passed.
    pub fn changing(self) -> Self {
        let mut bench = self.positioned();
        bench.inputs.v_interpolator = FAST;
        bench.once(|i| (i.m3, i.s_word) = (true, FAST));
        bench.cycles(2);
        assert_eq!((bench.out.spindle_state, bench.out.job), (TO_VELOCITY, 1));
        bench
    }

    /// The first cycle of VELOCITY has passed.
    pub fn velocity(self) -> Self {
        let mut bench = self.changing();
        bench.until(|out| out.spindle_state == VELOCITY);
        (bench.inputs.v_actual, bench.inputs.x_command) = (FAST, f64::NAN);
        bench
    }

    /// The first cycle of BRAKE has passed.
    pub fn brake(self) -> Self {
        let mut bench = self.velocity();
        bench.once(|i| (i.m19, i.s_word, i.s_position) = (true, 60_000.0, 180_000.0));
        bench.inputs.v_interpolator = f64::NAN;
        bench.cycle();
        assert_eq!((bench.out.spindle_state, bench.out.job, bench.out.waiting), (BRAKE, 0, 1));
        bench
    }

    /// The first cycle of TO_POSITION after BRAKE has passed; it does not answer.
    pub fn back(self) -> Self {
        let mut bench = self.brake();
        (bench.echoes, bench.inputs.v_actual) = (false, bench.p.v_off);
        bench.until(|out| out.spindle_state == TO_POSITION);
        bench
    }
}
