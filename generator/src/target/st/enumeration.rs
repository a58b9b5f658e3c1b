//! Numbers of signals under their names, for callers: enumerations in TwinCAT and CODESYS, data blocks in SCL. The signals
//! themselves are DINTs.

use compiler::program::{snake_case, variant_name};
use portable::{Portable, Ty};
use reference::ipc;
use reference::spindle::{Job, SpindleState};

/// The numbers of one signal.
pub(super) struct Enumeration {
    /// the name of the signal, which follows `E_axgen_`
    pub(super) signal: String,
    /// the signal that has these values
    pub(super) note: &'static str,
    pub(super) values: Vec<Value>,
}

/// One of the numbers.
pub(super) struct Value {
    pub(super) name: String,
    pub(super) number: i32,
    /// its meaning
    pub(super) doc: &'static str,
}

/// The enumerations of the blocks with these names: always the modes, and the outputs of a spindle.
pub(super) fn enumerations<'b>(mut blocks: impl Iterator<Item = &'b &'static str>) -> Vec<Enumeration> {
    let mut all = vec![modes()];
    if blocks.any(|block| block.starts_with("spindle")) {
        all.extend([
            of::<SpindleState>("Values of the output spindle_state: what controls the spindle."),
            of::<Job>("Values of the output job: what the interpolator has to do."),
        ]);
    }
    all
}

fn modes() -> Enumeration {
    let value = |name: &str, number, doc| Value { name: name.to_owned(), number, doc };
    Enumeration {
        signal: "mode".to_owned(),
        note: "Values of the input mode (P-AXIS-00758).",
        values: vec![
            value("MODE_OFF", ipc::mode_off(), "the block is off"),
            value("MODE_ON", ipc::mode_on(), "the block acts"),
            value("MODE_DRYRUN", ipc::mode_dryrun(), "the block calculates and does not act"),
        ],
    }
}

/// An enumeration of the reference.
fn of<E: Portable>(note: &'static str) -> Enumeration {
    let Ty::Enum { def } = E::TY else { panic!("enumeration: {:?} is none", E::TY) };
    let mut values = Vec::new();
    for (index, variant) in (0..).zip(def.variants) {
        let name = variant_name(portable::Variant { of: def, index }).to_ascii_uppercase();
        let number = i32::try_from(index).unwrap_or(i32::MAX);
        values.push(Value { name, number, doc: variant.doc });
    }
    Enumeration { signal: snake_case(def.name.chars()), note, values }
}
