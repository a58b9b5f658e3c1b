//! Values and types of portable Rust as data, and the trait that converts Rust values to them. No expressions here.

use crate::RealKind;

/// One scalar value.
#[derive(Clone, Copy, Debug)]
pub enum Literal {
    /// `bool`
    Bool(bool),
    /// `i32`: C `int32_t`, ST `DINT`
    I32(i32),
    /// `u32`: C `uint32_t`, ST `UDINT`
    U32(u32),
    /// `usize`: an index, a length or a loop variable; known before any block is emitted
    Usize(usize),
    /// `f64`: C `double`, ST `LREAL`
    F64(f64),
    /// `f32`: C `float`, ST `REAL`
    F32(f32),
    /// a unit variant
    Variant(Variant),
}

impl Literal {
    /// The value at run time: a variant is its number.
    #[must_use]
    pub fn at_run_time(self) -> Self {
        match self {
            Self::Variant(variant) => Self::I32(variant.index.cast_signed()),
            other => other,
        }
    }
}

/// Literals are equal where their bits are: `-0.0` differs from `0.0`, and a NaN equals itself.
impl PartialEq for Literal {
    fn eq(&self, other: &Self) -> bool {
        match (*self, *other) {
            (Self::Bool(a), Self::Bool(b)) => a == b,
            (Self::I32(a), Self::I32(b)) => a == b,
            (Self::U32(a), Self::U32(b)) => a == b,
            (Self::Variant(a), Self::Variant(b)) => a == b,
            (Self::Usize(a), Self::Usize(b)) => a == b,
            (Self::F64(a), Self::F64(b)) => a.to_bits() == b.to_bits(),
            (Self::F32(a), Self::F32(b)) => a.to_bits() == b.to_bits(),
            _ => false,
        }
    }
}

/// A type of portable Rust.
#[derive(Clone, Copy, Debug)]
pub enum Ty {
    /// `bool`
    Bool,
    /// `i32`
    I32,
    /// `u32`
    U32,
    /// `usize`
    Usize,
    /// the real type that the generic `R` stands for
    Real(RealKind),
    /// `[element; len]`
    Array {
        /// the type of each element
        element: &'static Ty,
        /// the number of elements
        len: usize,
    },
    /// a portable struct
    Struct {
        /// its fields
        def: &'static StructDef,
    },
    /// a portable enum
    Enum {
        /// its variants
        def: &'static EnumDef,
    },
}

/// A struct: its fields in the order of their declaration.
#[derive(Debug)]
pub struct StructDef {
    /// the Rust name
    pub name: &'static str,
    /// the fields
    pub fields: &'static [Field],
    /// the number of their scalars
    pub leaves: usize,
}

/// A field of a struct.
#[derive(Debug)]
pub struct Field {
    /// the Rust name
    pub name: &'static str,
    /// the doc comment: meaning, unit, sign convention; it is printed with the number in every target
    pub doc: &'static str,
    /// the type
    pub ty: Ty,
    /// the number of scalars of the struct before it
    pub first: usize,
}

impl Ty {
    /// The number of scalars in a value of the type.
    #[must_use]
    pub const fn leaves(&self) -> usize {
        match self {
            Self::Struct { def } => def.leaves,
            Self::Array { element, len } => *len * element.leaves(),
            _ => 1,
        }
    }
}

/// An enum of unit variants, numbered from 0 in the order of their declaration.
#[derive(Debug)]
pub struct EnumDef {
    /// the Rust name
    pub name: &'static str,
    /// the doc comment
    pub doc: &'static str,
    /// the variants
    pub variants: &'static [VariantDef],
}

/// A variant of an enum.
#[derive(Debug)]
pub struct VariantDef {
    /// the Rust name
    pub name: &'static str,
    /// the doc comment; it is printed with the number in every target
    pub doc: &'static str,
}

/// The value of an enum.
#[derive(Clone, Copy)]
pub struct Variant {
    /// its type
    pub of: &'static EnumDef,
    /// its position among the variants
    pub index: u32,
}

impl Variant {
    /// The doc comment of the variant.
    #[must_use]
    pub fn def(&self) -> &'static VariantDef {
        &self.of.variants[self.index as usize]
    }

    fn key(&self) -> (&'static str, u32) {
        (self.of.name, self.index)
    }
}

impl core::fmt::Debug for Variant {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{}::{}", self.of.name, self.def().name)
    }
}

/// Ordered by the names of the types, then by variant.
impl Ord for Variant {
    fn cmp(&self, other: &Self) -> core::cmp::Ordering {
        self.key().cmp(&other.key())
    }
}

impl PartialOrd for Variant {
    fn partial_cmp(&self, other: &Self) -> Option<core::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Variant {
    fn eq(&self, other: &Self) -> bool {
        self.key() == other.key()
    }
}

impl Eq for Variant {}

impl core::hash::Hash for Variant {
    fn hash<H: core::hash::Hasher>(&self, state: &mut H) {
        self.key().hash(state);
    }
}

/// A type that the generator can describe, split into scalars and put together again.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a type of portable Rust",
    label = "put #[portable] on it, or use R, bool, i32, u32, or an array of these"
)]
pub trait Portable: Sized {
    /// The type as data.
    const TY: Ty;

    /// Calls `visit` once for each scalar, in the order in which [`Portable::TY`] lists them.
    fn visit(&self, visit: &mut dyn FnMut(Literal));

    /// The scalar at a place in this order. Those before it are not visited.
    ///
    /// # Panics
    /// If the value has fewer scalars.
    fn leaf(&self, _place: usize) -> Literal {
        scalar(self)
    }

    /// The inverse of [`Portable::visit`]: takes each scalar from `next`, in the same order.
    ///
    /// # Panics
    /// If `next` yields a literal of another type than the expected one.
    fn build(next: &mut dyn FnMut() -> Literal) -> Self;
}

/// The literal of a scalar.
#[doc(hidden)]
pub fn scalar<T: Portable>(value: &T) -> Literal {
    let mut found = None;
    value.visit(&mut |literal| {
        assert!(found.is_none(), "a constant of portable Rust is a scalar");
        found = Some(literal);
    });
    found.expect("a constant of portable Rust is a scalar")
}

macro_rules! scalar {
    ($type:ty, $ty:expr, $literal:ident) => {
        impl Portable for $type {
            const TY: Ty = $ty;

            fn visit(&self, visit: &mut dyn FnMut(Literal)) {
                visit(Literal::$literal(*self));
            }

            fn build(next: &mut dyn FnMut() -> Literal) -> Self {
                match next() {
                    Literal::$literal(value) => value,
                    other => panic!("{} expected, found {other:?}", stringify!($type)),
                }
            }
        }
    };
}

scalar!(bool, Ty::Bool, Bool);
scalar!(i32, Ty::I32, I32);
scalar!(u32, Ty::U32, U32);
scalar!(usize, Ty::Usize, Usize);
scalar!(f64, Ty::Real(RealKind::F64), F64);
scalar!(f32, Ty::Real(RealKind::F32), F32);

impl<T: Portable, const N: usize> Portable for [T; N] {
    const TY: Ty = Ty::Array { element: &T::TY, len: N };

    fn visit(&self, visit: &mut dyn FnMut(Literal)) {
        for element in self {
            element.visit(visit);
        }
    }

    fn leaf(&self, place: usize) -> Literal {
        let leaves = const { T::TY.leaves() };
        self[place / leaves].leaf(place % leaves)
    }

    fn build(next: &mut dyn FnMut() -> Literal) -> Self {
        core::array::from_fn(|_| T::build(next))
    }
}
