//! Every construct of the subset, and the IR that it becomes. What is rejected: `unit/refused.txt`.
#![expect(dead_code, unused_variables, reason = "most functions are here for their description only")]

mod calls;
mod statements;
mod text;
mod types;
mod values;
