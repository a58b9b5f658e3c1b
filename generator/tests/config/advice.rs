//! Warnings about what is legal, but inert, out of date or dangerous.

use super::{assert_said, direct, said};

#[test]
fn a_largest_velocity_in_another_unit() {
    assert_said(
        &said(&direct("getriebe[0].dynamik.vb_max 30\nkenngr.achs_typ ACHSTYP_ROTATOR")),
        &[
            "x.lis:1:28: warning[AX438]: `getriebe[0].dynamik.vb_max` (P-AXIS-00212) is 30, which is only 0.03 deg/s",
            "    write instead: 30000, if 30 deg/s is meant, or 180000, if 30 revolutions/min is meant: the unit is 0.001 deg/s",
        ],
    );
    assert_said(&said(&direct("getriebe[0].dynamik.vb_max 5000")), &[]);
    assert!(said("getriebe[0].dynamik.vb_max 30\ngetriebe[0].kv 2000").starts_with("x.lis:1:28: warning[AX438]"));
}
