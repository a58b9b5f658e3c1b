//! Blocks and what the documents state about them: one program, as a link costs more than most of these tests.
#![forbid(unsafe_code)]

mod behaviour;
mod call_rate;
mod disturbed_states;
mod evaluation;
mod exercise;
mod feedforward;
mod literals;
mod scenarios;
mod scl;
mod spindle_reset;
mod stated;
mod stated_ipc;
mod usual_cycles;
mod watch;
