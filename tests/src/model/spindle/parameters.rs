//! What is fixed for a spindle, the example of the tests, and random ones. Nothing is computed from them here.

use crate::random::rng::Rng;

/// Positions in 0.001 deg, velocities in 0.001 deg/s.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameters {
    /// cycle time T [s]
    pub cycle: f64,
    /// the same [ns]
    pub cycle_ns: u32,
    /// Von (P-AXIS-00767)
    pub v_on: f64,
    /// Voff (P-AXIS-00768)
    pub v_off: f64,
    /// around Voff
    pub window: f64,
    /// of BRAKE and of an error that stays [0.001 deg/s^2]
    pub deceleration: f64,
    /// Nd (P-AXIS-00191)
    pub nd: u32,
    /// weight of the feedforward in the drive (P-AXIS-00766, 00833); not with position control in the CNC
    pub w: f64,
    /// Kv [1/s] (P-AXIS-00099)
    pub kv: f64,
    /// position control in the CNC
    pub in_cnc: bool,
    /// the position loop is the block's own
    pub closes_loop: bool,
    /// the drive has no velocity control
    pub only_position: bool,
    /// the drive has no position control
    pub only_velocity: bool,
    /// weight of the feedforward of the velocity in the CNC (P-AXIS-00228/00229), if there is one
    pub feedforward: Option<f64>,
    /// `operation_mode` of position control
    pub position_mode: i32,
    /// `operation_mode` of velocity control
    pub velocity_mode: i32,
    /// of TO_VELOCITY and TO_POSITION, rounded up
    pub mode_timeout_cycles: u32,
    /// of BRAKE, rounded up
    pub brake_timeout_cycles: u32,
    /// largest step of the position when the interpolator takes over
    pub takeover_window: f64,
    /// by `n (n + 1)` times this way the interpolator may be further after n cycles
    pub takeover_way: f64,
    /// increments per 0.001 deg/s
    pub velocity_scale: f64,
    /// lowest, highest value of `velocity_command`
    pub velocity_range: [i32; 2],
}

impl Parameters {
    /// 200 and 50 rpm at 2 ms, a drive with Kv 20/s and half of the feedforward, 1e-4 rpm as increments.
    #[must_use]
    pub fn example() -> Self {
        Self {
            cycle: 0.002,
            cycle_ns: 2_000_000,
            v_on: 1_200_000.0,
            v_off: 300_000.0,
            window: 3000.0,
            deceleration: 6_000_000.0,
            nd: 4,
            w: 0.5,
            kv: 20.0,
            in_cnc: false,
            closes_loop: false,
            only_position: false,
            only_velocity: false,
            feedforward: None,
            position_mode: 8,
            velocity_mode: 9,
            mode_timeout_cycles: 20,
            brake_timeout_cycles: 300,
            takeover_window: 1000.0,
            takeover_way: 12.0,
            velocity_scale: 10.0 / 6.0,
            velocity_range: [i32::MIN, i32::MAX],
        }
    }

    /// A spindle in the drive or in the CNC.
    #[must_use]
    pub fn random(rng: &mut Rng) -> Self {
        let cycle_ns = *rng.pick(&[2_000_000, 1_000_000, 500_000, 3_333_333]);
        let cycle = f64::from(cycle_ns) * 1e-9;
        let v_on = *rng.pick(&[1_200_000.0, 1_200_000.0, 1_200_000.0, 600_000.0, 600_000.0, 12_345_678.0, 0.0, 2e8]);
        let v_off = *rng.pick(&[1.0, 0.25, 0.5, 0.0]) * v_on;
        let in_cnc = rng.chance(40);
        let only_velocity = !in_cnc && (v_on, v_off) == (0.0, 0.0);
        let velocity_mode = *rng.pick(&[9, 1, 2]);
        let fast: f64 = if v_on > 0.0 { v_on } else { 600_000.0 };
        // No whole number of steps from Von to Voff: whether one is left would be a matter of rounding.
        let cycles_of_braking = *rng.pick(&[10.03, 60.07, 200.17]);
        let deceleration = fast / (cycles_of_braking * cycle);
        let small = |rng: &mut Rng, largest| u32::try_from(rng.between(1, largest)).expect("small");
        Self {
            cycle,
            cycle_ns,
            v_on,
            v_off,
            window: (0.01 * v_off).max(*rng.pick(&[2000.0, 36_000.0])),
            deceleration,
            nd: small(rng, 11) - 1,
            w: *rng.pick(&[0.0, 0.5, 1.0, 1.2]),
            kv: *rng.pick(&[20.0, 66.66, 100.0, 5.0]),
            in_cnc,
            closes_loop: in_cnc && rng.chance(50),
            only_position: !in_cnc && rng.chance(10),
            only_velocity,
            feedforward: (in_cnc && rng.chance(60)).then(|| *rng.pick(&[1.0, 0.4, 1.3])),
            position_mode: if only_velocity { velocity_mode } else { *rng.pick(&[8, 3, 0]) },
            velocity_mode,
            mode_timeout_cycles: small(rng, 40),
            brake_timeout_cycles: small(rng, 600),
            takeover_window: *rng.pick(&[1000.0, 200.0, 10_000.0]),
            takeover_way: deceleration * cycle * cycle / 2.0,
            velocity_scale: *rng.pick(&[10.0 / 6.0, 10.0 / 6.0, 0.001, 500.0]),
            velocity_range: *rng.pick(&[[i32::MIN, i32::MAX], [i32::MIN, i32::MAX], [-32_768, 32_767]]),
        }
    }
}
