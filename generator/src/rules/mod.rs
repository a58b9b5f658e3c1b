//! Common parts of the rules of several blocks: effective values, the drive, corrections of the controller. No rule of one
//! block.

pub(crate) mod corrected;
pub(crate) mod drive;
pub(crate) mod effective;
pub(crate) mod presence;
