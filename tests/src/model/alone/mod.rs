//! An independent model of the block `ipc` that stands alone: with constants, with weights that the caller tunes, with parameter sets. What the
//! stages, the fade, the ride-through and the watch do stands in [`super::ipc`] and [`super::watch`], which the block `axis` has too; here is what
//! only this block has: the order of its faults, and the parameter sets (docs/parameter-sets.md, docs/decisions/faults.md,
//! ipc.md and parameter-sets.md).
//!
//! # What is compared ([`agree`])
//!
//! Every output of every cycle. An axis ([`axes`]) has several sets: its own, other numbers of the same structure, one with a smaller limit. Its history
//! ([`history`]) begins with memory of zeros, with a set without a number, a damaged one or a whole one, and offers others at any moment: whole ones,
//! ones that a rule refuses though their check word fits, damaged ones ([`damage`]); the same number with other contents, torn while the
//! block fades out for it, repaired after it was refused. The model forms the check word in whole numbers ([`check_word`]), and finds the poles by the
//! polynomials of the sections ([`set`]).
//!
//! # What the model took from the block where the page leaves a choice
//!
//! 1. A refused set waits for as many cycles as it is offered: those of another set between them do not count. A fault of the state ends the wait.
//! 2. While the block fades out for a set, a set that waits keeps it fading out until the fade is 0.
//! 3. Whether the watch has tripped is asked before a mode that is not ON, or a reset, arms it again in that cycle.
//! 4. Bad samples are ridden through, and tuned parts move, in cycles with a fault, a reset and without position control too.

pub mod agree;
pub mod axes;
pub mod block;
pub mod check_word;
pub mod cycle;
pub mod damage;
pub mod history;
pub mod set;
