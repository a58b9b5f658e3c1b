//! Judges of the crate: sums and closed formulas, the demonstration plant with seeded noise, synthesised records.
//! Nothing of the command.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]
#![expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "numbers of samples")]

mod excitation;
mod offset;
mod plant;
mod proposals;
mod random_axes;
mod response;
mod stage;
mod vibrations;
mod what_if;

/// How much there is of something: in a plain run, in an exhaustive one, and where everything is run.
fn by_depth<T>(plain: T, exhaustive: T, every: T) -> T {
    let is_set = |name| std::env::var_os(name).is_some();
    match (is_set("AXGEN_EVERY_LEVEL"), is_set("AXGEN_EXHAUSTIVE")) {
        (true, _) => every,
        (_, true) => exhaustive,
        _ => plain,
    }
}
