//! GUIDs of TwinCAT's objects, each derived from a name: the same object has the same GUID in every run.

use uuid::{Uuid, uuid};

/// The namespace of all GUIDs that axgen makes: version 5 of the name `axgen` in RFC 9562's namespace of URLs. Another
/// namespace would give every object of every project another GUID.
const NAMESPACE: Uuid = uuid!("4af64489-b926-5bad-acb2-20dca8f42d6a");

/// The GUID of an object of some kind: version 5 of `KIND NAME`, in braces.
pub(super) fn derive(kind: &str, name: &str) -> String {
    Uuid::new_v5(&NAMESPACE, format!("{kind} {name}").as_bytes()).braced().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Figures of Python's module `uuid`: `uuid5(NAMESPACE_URL, "axgen")`, and `uuid5` of that.
    #[test]
    fn others_derive_the_same() {
        assert_eq!(Uuid::new_v5(&Uuid::NAMESPACE_URL, b"axgen"), NAMESPACE);
        assert_eq!(derive("POU", "PRG_axgen_tests"), "{ebd13820-5460-597f-88e6-b9a2a6e8e69d}");
    }
}
