//! Inputs, outputs and modes of the block `ipc`. Nothing is computed here.

use portable::portable;

/// Stages of a block.
pub const STAGES: usize = 3;

/// Declares the inputs of the block; its form with parameter sets has others instead of those for tuning.
macro_rules! inputs {
    ([$($tuning:tt)*] $($more:tt)*) => {
        /// Inputs. Velocities are in um/s for a translatory axis, in 0.001 deg/s for a rotary axis or a spindle.
        #[portable]
        #[derive(Clone, Copy, Debug, Default)]
        pub struct Inputs<R> {
            /// output of the position controller with feedforward, before v_add is added [um/s or 0.001 deg/s]; input of
            /// SET_POINT (P-AXIS-00753)
            pub v_command: R,
            /// velocity of the motor encoder, v_ist1 [um/s or 0.001 deg/s]; input of DIRECT and INDIRECT (P-AXIS-00753)
            pub v_motor: R,
            /// velocity of the direct measuring system, v_ist2 [um/s or 0.001 deg/s]; input of DIRECT (P-AXIS-00753) by the key
            /// direct_source
            pub v_direct: R,
            $($tuning)*
            /// 0 OFF, 1 ON, 2 DRYRUN; any other value is a fault; starts with the value of P-AXIS-00758
            pub mode: i32,
            /// FALSE: the axis is not in position control: v_add is 0 at once; connect it if the axis can leave position control
            pub position_controlled: bool,
            /// while TRUE v_add is 0; afterwards the filters start from the input, and v_add fades in; hold it while an encoder
            /// value is set (homing)
            pub reset: bool,
            /// cycle time of the calling task [ns]; 0: unchecked; a value other than the designed cycle time is a fault
            pub task_cycle_ns: u32,
            /// with the key cycle_counter: cycle counter of the controller; 0: unchecked, in TwinCAT the counter of the task is
            /// used; skipped and doubled calls are a fault; the block restarts after a pause
            pub cycle_counter: u32,
            $($more)*
        }
    };
}

pub(crate) use inputs;

inputs! { [
    /// with the key tunable: factor of the stage's weight, 0 to 1; outside this range the last valid value stays active, with the
    /// id 4, which is not a fault
    pub tuning_weight: [R; STAGES],
    /// with the key tunable: factor of the limit (P-AXIS-00757), 0 to 1; outside this range the last valid value stays active,
    /// with the id 4, which is not a fault
    pub tuning_limit: R,
] }

/// Declares the outputs of the block; its form with parameter sets has more of them, and another limit.
macro_rules! outputs {
    ($limited:tt $($more:tt)*) => {
        /// Outputs.
        #[portable]
        #[derive(Clone, Copy, Debug, Default)]
        pub struct Outputs<R> {
            /// additive velocity of improved position control, to be added to the manipulated variable [um/s or 0.001 deg/s]
            pub v_add: R,
            /// v_add before the fade, within the limit (P-AXIS-00757); 0 in OFF [um/s or 0.001 deg/s]
            pub v_add_calculated: R,
            #[doc = $limited]
            pub limited: bool,
            /// a sample is bad and is replaced by the last good one (key ride_through)
            pub held: bool,
            /// the loop was found unstable: v_add fades out and stays 0 until mode is not ON or reset is TRUE (key watch)
            pub tripped: bool,
            /// the block cannot act in this cycle; the error id gives the reason
            pub fault: bool,
            /// 0 none
            pub error_id: u32,
            $($more)*
        }
    };
}

pub(crate) use outputs;

outputs! {
    "the sum of the stages is above the limit (P-AXIS-00757, in 0.1 % of P-AXIS-00212, or a smaller one by tuning) in this \
     cycle"
}

constants! {
    /// mode: the block is off
    pub fn mode_off() -> i32 { 0i32 }
    /// mode: the block acts
    pub fn mode_on() -> i32 { 1i32 }
    /// mode: the block calculates and does not act
    pub fn mode_dryrun() -> i32 { 2i32 }
}
