//! The number of a parameter set whose turn it is: one in a cycle, so that a cycle costs the same for any set.

use portable::portable;

constants! {
    /// what a number of a set is: a coefficient of a section
    pub fn role_coefficient() -> i32 { 0i32 }
    /// what a number of a set is: the largest |v_add|
    pub fn role_limit() -> i32 { 1i32 }
    /// what a number of a set is: the negative limit, after the limit
    pub fn role_lower_limit() -> i32 { 2i32 }
    /// what a number of a set is: the largest sum, after both limits
    pub fn role_sum_limit() -> i32 { 3i32 }
    /// what a number of a set is: the smallest span at which growth counts
    pub fn role_quiet() -> i32 { 4i32 }
    /// what a number of a set is: -weight
    pub fn role_gain() -> i32 { 5i32 }
    /// what a number of a set is: a2 of a biquad, after its a1
    pub fn role_a2() -> i32 { 6i32 }
    /// what a number of a set is: C of a trapezoidal section, after its A and B
    pub fn role_c() -> i32 { 7i32 }
    /// what a number of a set is: G2 of the simulated oscillation, after its H, R and G
    pub fn role_g2() -> i32 { 8i32 }
}

/// The number whose turn it is.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Picked<R> {
    /// the number whose turn it is
    pub number: R,
    /// its copy
    pub copy: R,
    /// what that number is, which decides what is checked
    pub role: i32,
}
