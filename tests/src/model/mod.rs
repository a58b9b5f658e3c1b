//! An independent model of the blocks `feedforward`, `position_control` and `axis`, in exact rational numbers. It is written
//! from the documents (`docs/feedforward.md`, `docs/position-control.md`, `docs/improved-position-control.md`,
//! `docs/gantry.md`, `docs/decisions/ipc.md`) and shares no line with `reference/`; nothing of a block may be copied into it.
//!
//! The block `spindle` has a model of its own, in double precision ([`spindle`]), and so has the block `ipc` that stands alone, with all that a
//! caller may tune ([`alone`]).
//!
//! # What is compared
//!
//! `tests/model.rs` draws axes ([`random`]) with histories of 1,000 cycles each ([`history`]), runs the three blocks
//! with the coefficients that `axgen` designs ([`subject`]) and compares every output of every cycle ([`agree`]). A
//! disagreement names the set, the block, the cycle, the signal and both values.
//! `AXGEN_MODEL_SEED` and `AXGEN_MODEL_SETS` take other sets.
//!
//! - A real must lie within a running error bound of its exact value ([`exact`]): every operation of the formula adds half an
//!   ulp of the sum of the magnitudes of its terms. The bound is multiplied by 4, for coefficients that the design computes with
//!   other roundings. An output that copies an input must be that input.
//! - An integer, a flag or an id must be that of the exact value. Where rounding may carry the value over a tie or over an
//!   end of the range, both neighbours are allowed ([`rounding`]); the test counts how often, and fails where that is not rare.
//! - `v_add` is a difference equation in double precision ([`sections`]), with 1e-10 of the largest input since the last start
//!   (single precision: 4e-6) for other realisations of the same filters. Everything around the filters is exact: which
//!   input is read, start, stop, limit, fade, fault ([`ipc`]).
//! - Three outputs go on into other outputs, after they have been compared themselves: `x_drive` of the cycle before (held),
//!   `v_command` (read by SET_POINT) and `v_add` (added to the integers).
//!
//! # Formulas ([`coefficients`], [`feedforward`], [`position_control`], [`axis`])
//!
//! | what | formula | source |
//! | --- | --- | --- |
//! | active | (G135 or 00255) and not 00256 | feedforward.md, One cycle |
//! | gain | W p/100 while active, else 0; p within 0..100; W = 00228/00229 | feedforward.md, One cycle |
//! | `v_feedforward` | gain (v + Ta a + Tj j), the quantities without an output bit | feedforward.md, The mode word |
//! | `v_additive` | delay(gain v); PROFIdrive with 0x100: of the whole sum | feedforward.md, The mode word |
//! | Ta, Tj | 00225/00226 1e-6; 00337/00338 Ta^2, a denominator 0 is 100 | feedforward.md, One cycle; 110473 |
//! | delay | d = (N + f) Ts, y\[n\] = (1-f) x\[n-N\] + f x\[n-N-1\]; six cycles or more: 0; filled in the first cycle after a stop | feedforward.md, Delays; 70348, 70349 |
//! | R | 00092 00234/00233 00363/00362 where a feed constant is not 1, else 00234/00233 | feedforward.md, One cycle |
//! | torque | (10 R / 00092 2 pi, linear motor 1e-6) 00391 / 00392 00325/00326 times 00225/00226 delay(gain a), or 00337/00338 delay(gain j) | feedforward.md, One cycle, ADD_JERK |
//! | `velocity_scale` | 00206/00205 tb, tb = 60, 1, Ts | feedforward.md, One cycle |
//! | integers | half away from zero, saturated at the ends of INT16, INT32 | feedforward.md, Rounding |
//! | `v_command` | Kv (x_command - x_actual) + v_feedforward in the CNC, else 0 | position-control.md, The block |
//! | `manipulated_variable` | 60e-6 00129/00128 (v_command + v_add) | position-control.md, The block |
//! | `x_drive` | shift(x_command) + v_feedforward / Kv; held with a bad x_command; follows where it does not act | position-control.md, Faults |
//! | `xerr` | 10 R (x_drive - x_actual), PROFIdrive | position-control.md, The block |
//! | `additive_velocity` | velocity_scale (v_additive + v_add), v_add only where the drive has the controller | position-control.md, The block |
//! | shift | 00165 cycles, PROFIdrive with any feedforward | position-control.md |
//! | `v_add` | fade limited(-sum of weight filter(x)), x by mode; SET_POINT reads `v_command`, with a drive `v_interpolator` | improved-position-control.md, position-control.md |
//! | limit | v_add_max_fact/1000 vb_max; of a slave the master's | improved-position-control.md, gantry.md |
//! | fade | n / ceil(fade/Ts), fade at least one period of the lowest f0 of any filter; the first active cycle presets the stages and puts out 0 | docs/decisions/ipc.md |
//! | watch | blocks of max(0.6 / f0, 30 ms) of the sum; + 2 where it fills the limit and does not die away, + 1 where it grows, - 1 where it fills the limit and dies away, else 0; trips at twice the blocks in 150 ms, at least 6 | improved-position-control.md, The watch |
//! | faults | 17, 1, 18 stop all; else the last of 14 to 16 (the highest), and of the first of 11, 12, 13, 3, 2, or 22 | position-control.md, Faults |
//!
//! # Where the documents leave a choice, and what the model took from the blocks
//!
//! 1. `axis` tells only 17, 1 and 18 while `position_controlled` is false or `reset` true: the other parts do not run.
//!    The block `feedforward` that stands alone tells its ids in such a cycle.
//! 2. A `v_reso_num` of 0 leaves the quantity in (AX433): it is read and judged. A weight, a time constant, a jerk factor or a load of 0
//!    takes it out.
//! 3. With the limit 0, `limited` of improved position control sees the states' anti-denormal constant.

pub mod agree;
pub mod alone;
pub mod axis;
pub mod calls;
pub mod coefficients;
pub mod exact;
pub mod feedforward;
pub mod history;
pub mod ipc;
pub mod parameters;
pub mod position_control;
pub mod random;
pub mod rounding;
pub mod sections;
pub mod spindle;
pub mod subject;
pub mod watch;
