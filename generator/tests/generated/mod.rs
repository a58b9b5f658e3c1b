//! What is generated, and what stands next to it: one program, as a link costs more than most of these tests.
mod commissioning;
mod commissioning_names;
mod diff;
mod digests;
mod emitted_signs_and_zeros;
mod error_ids;
mod set_change;
mod staged_link;
mod structure;
mod trace;
