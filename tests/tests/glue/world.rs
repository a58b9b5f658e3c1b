//! What surrounds the program at a machine: it gets a row of each axis and the counter of its task.

use super::script::Row;
use portable::Literal;
use st::Instance;

fn set(run: &mut Instance<'_>, path: &str, value: Literal) {
    assert!(run.set(path, value), "no variable {path} of the type of {value:?}");
}

pub fn get(run: &Instance<'_>, path: &str) -> Literal {
    run.get(path).unwrap_or_else(|| panic!("no variable {path}"))
}

/// Gives the program what it reads in the next cycle of its task.
pub fn task(run: &mut Instance<'_>, cycle: u32, count: u32) {
    set(run, super::project::CYCLE, Literal::U32(cycle));
    set(run, super::project::COUNT, Literal::U32(count));
}

/// Gives the program what it reads of an axis.
pub fn axis(run: &mut Instance<'_>, letter: char, row: &Row) {
    for (path, value) in [
        ("PlcToNc.Override", Literal::U32(row.percentage)),
        ("NcToPlc.ErrorCode", Literal::U32(row.nc_error)),
        ("NcToPlc.ActVelo", Literal::F64(row.velocity)),
        ("NcToPlc.SetVelo", Literal::F64(row.set_velocity)),
        ("NcToPlc.SetAcc", Literal::F64(row.acceleration)),
        ("NcToPlc.stub_operational", Literal::Bool(row.operational)),
        ("NcToPlc.stub_control_loop_closed", Literal::Bool(row.closed)),
        ("NcToPlc.stub_not_moving", Literal::Bool(row.not_moving)),
        ("NcToPlc.stub_homing_busy", Literal::Bool(row.homing)),
    ] {
        set(run, &format!("axis_{letter}.{path}"), value);
    }
    for (name, value) in [
        ("drive_status", Literal::U32(row.drive)),
        ("mode", Literal::I32(row.mode)),
        ("stop", Literal::Bool(row.stop)),
        ("setup", Literal::Bool(row.setup)),
        ("hold", Literal::Bool(row.hold)),
        ("brake_closed", Literal::Bool(row.brake_closed)),
        ("feed_torque", Literal::Bool(row.feed_torque)),
        ("weight_torque", Literal::I32(row.weight)),
        ("acknowledge", Literal::Bool(row.acknowledge)),
    ] {
        set(run, &format!("GVL_axis_{letter}.{name}"), value);
    }
}
