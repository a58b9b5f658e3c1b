//! The block `spindle`: every transition and every row of docs/spindle.md by name, stated figures, and the exploration of all
//! its states. Coefficients are written here; their design is tested elsewhere.

#![expect(clippy::float_cmp, reason = "what is held, copied or exact by the page is that number")]

mod bench;
mod every_state;
mod exploration;
mod faults;
mod figures;
mod overwritten;
mod script;
