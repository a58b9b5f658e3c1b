//! Whether an axis has something, once its parameters are valid.

/// Something that an axis may have. As `Option<Presence<T>>` it is the result of a rule; `None` after a reported error.
pub(crate) enum Presence<T> {
    /// the axis does not have it, or does not use it
    Absent,
    Present(T),
}

impl<T> Presence<T> {
    /// What the axis has.
    pub(crate) fn present(self) -> Option<T> {
        match self {
            Self::Absent => None,
            Self::Present(value) => Some(value),
        }
    }

    /// A reference to what the axis has.
    pub(crate) fn as_present(&self) -> Option<&T> {
        match self {
            Self::Absent => None,
            Self::Present(value) => Some(value),
        }
    }
}
