//! The emitted C in a loop with the ideal drive: of stages that nothing was said about, none oscillates.
