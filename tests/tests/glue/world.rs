//! What surrounds the program at a machine: an NC axis, its drive, the operator. It answers one cycle late, as a bus does.

use super::script::Row;
use portable::Literal;
use st::Instance;

/// The status word of a drive: switch on disabled, switched on, operation enabled.
const DISABLED: u32 = 0x0250;
const SWITCHED_ON: u32 = 0x0233;
const OPERATION_ENABLED: u32 = 0x1237;
/// Cycles from the NC's enable to the NC's ready, to its closed loop, and to the drive's operation enabled.
const READY: usize = 3;
const CLOSED: usize = 4;
pub const OPERATES: usize = 5;
/// Cycles that a reset of the NC takes.
const RESET: usize = 3;

/// The NC and the drive.
#[derive(Default)]
pub struct World {
    enabled: usize,
    error: u32,
    restart: bool,
    /// cycles since a reset began; 0: there is none
    restarting: usize,
    /// whether both say that the axis is in position control
    pub operates: bool,
}

fn set(run: &mut Instance<'_>, path: &str, value: Literal) {
    assert!(run.set(path, value), "no variable {path} of the type of {value:?}");
}

pub fn get(run: &Instance<'_>, path: &str) -> Literal {
    run.get(path).unwrap_or_else(|| panic!("no variable {path}"))
}

pub fn is(run: &Instance<'_>, path: &str) -> bool {
    get(run, path) == Literal::Bool(true)
}

impl World {
    /// Gives the program what it reads in the next cycle.
    pub fn before(&mut self, run: &mut Instance<'_>, row: &Row) {
        self.enabled = if is(run, "axis_x.PlcToNc.stub_enable") { self.enabled + 1 } else { 0 };
        // The rising edge starts the reset; it goes on by itself.
        let restart = is(run, "axis_x.PlcToNc.stub_restart");
        let is_edge = restart && !self.restart;
        self.restart = restart;
        self.restarting = if is_edge { 1 } else { self.restarting + usize::from(self.restarting > 0) };
        if self.restarting == RESET {
            (self.error, self.restarting) = (0, 0);
        }
        self.error = row.nc_error.unwrap_or(self.error);
        let (ready, closed) = (self.enabled >= READY && self.error == 0, self.enabled >= CLOSED && !row.open);
        let status = match self.enabled {
            _ if row.drive.is_some() => row.drive.unwrap_or_default(),
            0 => DISABLED,
            enabled if enabled >= OPERATES => OPERATION_ENABLED,
            _ => SWITCHED_ON,
        };
        self.operates = ready && closed && status == OPERATION_ENABLED;
        for (path, value) in [
            ("axis_x.NcToPlc.ErrorCode", Literal::U32(self.error)),
            ("axis_x.NcToPlc.ActVelo", Literal::F64(row.velocity)),
            ("axis_x.NcToPlc.SetAcc", Literal::F64(row.acceleration)),
            ("axis_x.NcToPlc.stub_operational", Literal::Bool(ready)),
            ("axis_x.NcToPlc.stub_control_loop_closed", Literal::Bool(closed)),
            ("axis_x.NcToPlc.stub_not_moving", Literal::Bool(row.not_moving)),
            ("axis_x.NcToPlc.stub_homing_busy", Literal::Bool(row.homing)),
            ("GVL_axis_x.drive_status", Literal::U32(status)),
            ("GVL_axis_x.enable", Literal::Bool(row.enable)),
            ("GVL_axis_x.acknowledge", Literal::Bool(row.acknowledge)),
            ("GVL_axis_x.mode", Literal::I32(row.mode)),
            ("GVL_axis_x.feed_torque", Literal::Bool(row.feed_torque)),
            (super::project::CYCLE, Literal::U32(row.cycle)),
        ] {
            set(run, path, value);
        }
    }
}
