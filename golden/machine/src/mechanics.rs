//! Three masses on two springs and the drive's current loop: differential equations without sampling. With a bed of infinite
//! mass they are two masses on one spring.

use std::f64::consts::TAU;

/// Masses, springs, dampers, the mesh, and the lag of the current loop.
///
/// ```text
/// Fc = k1 (q1 - (x2 - xb)) + c1 d/dt(q1 - (x2 - xb))
/// m1 q1'' = Fm - Fc + Fr        m2 x2'' = Fc        m3 xb'' = -Fc - k2 xb - c2 xb'
/// Fr = mesh.force sin(2 pi q1 / mesh.pitch)              current_lag Fm' = F - Fm
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mechanics {
    /// rotor and gear, reflected to the rack [kg]
    pub m1: f64,
    /// carriage [kg]
    pub m2: f64,
    /// bed, which carries the rack [kg]
    pub m3: f64,
    /// stiffness of the contact [N/m]
    pub k1: f64,
    /// damping of the contact [Ns/m]
    pub c1: f64,
    /// stiffness between bed and ground [N/m]
    pub k2: f64,
    /// damping between bed and ground [Ns/m]
    pub c2: f64,
    /// the force of the teeth
    pub mesh: Mesh,
    /// time constant of the current loop [s]
    pub current_lag: f64,
}

/// The mesh of rack and pinion: a force on the motor that depends on its position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mesh {
    /// amplitude [N]; 0 for ideal teeth
    pub force: f64,
    /// pitch of the teeth [m]
    pub pitch: f64,
}

/// The state: q1, q1', x2, x2', xb, xb' [m, m/s], Fm [N].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Place([f64; 7]);

impl Place {
    /// The motor's position [m].
    #[must_use]
    pub fn q1(&self) -> f64 {
        self.0[0]
    }

    /// The motor's velocity [m/s].
    #[must_use]
    pub fn v1(&self) -> f64 {
        self.0[1]
    }

    /// The carriage's velocity relative to the bed [m/s].
    #[must_use]
    pub fn v2(&self) -> f64 {
        self.0[3] - self.0[5]
    }
}

/// Steps of the integration per cycle of the velocity loop. The fastest time constant is 0.4 ms, a step is 31 us: the error
/// of the fourth order is below 1e-6 of a vibration (measured: with four times as many steps the numbers of the table change
/// by less).
const STEPS: u32 = 4;

impl Mechanics {
    /// The force of the contact Fc [N].
    fn contact(&self, place: &Place) -> f64 {
        let [q1, v1, x2, v2, xb, vb, _] = place.0;
        self.k1 * (q1 - (x2 - xb)) + self.c1 * (v1 - (v2 - vb))
    }

    /// The acceleration of the carriage x2'' [m/s^2].
    #[must_use]
    pub fn a2(&self, place: &Place) -> f64 {
        self.contact(place) / self.m2
    }

    fn derivative(&self, place: &Place, force: f64) -> [f64; 7] {
        let [q1, v1, _, v2, xb, vb, fm] = place.0;
        let contact = self.contact(place);
        let teeth = self.mesh.force * libm::sin(TAU * q1 / self.mesh.pitch);
        let a1 = (fm - contact + teeth) / self.m1;
        let ab = (-contact - self.k2 * xb - self.c2 * vb) / self.m3;
        [v1, a1, v2, contact / self.m2, vb, ab, (force - fm) / self.current_lag]
    }

    /// Advances by a time [s] with a constant force command F [N]: Runge-Kutta of the fourth order.
    pub fn advance(&self, place: &mut Place, force: f64, time: f64) {
        let h = time / f64::from(STEPS);
        for _ in 0..STEPS {
            let at = |d: &[f64; 7], h: f64| Place(std::array::from_fn(|i| place.0[i] + h * d[i]));
            let d1 = self.derivative(place, force);
            let d2 = self.derivative(&at(&d1, h / 2.0), force);
            let d3 = self.derivative(&at(&d2, h / 2.0), force);
            let d4 = self.derivative(&at(&d3, h), force);
            for i in 0..7 {
                place.0[i] += h / 6.0 * (d1[i] + 2.0 * d2[i] + 2.0 * d3[i] + d4[i]);
            }
        }
    }
}
