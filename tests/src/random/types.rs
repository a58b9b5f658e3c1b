//! What can be asked of the syntax: types of values and places, and which items mention the real type.

use super::syntax::{Block, Callee, Expr, Function, Mode, Place, Program, Scalar, Step, Type, Value};
use super::visit::Node;
use portable::{Binary, Unary};

impl Value {
    /// The type of the value.
    #[must_use]
    pub fn scalar(self) -> Scalar {
        match self {
            Self::Zero | Self::One | Self::Lit(_) | Self::PerKind(..) => Scalar::Real,
            Self::Bool(_) => Scalar::Bool,
            Self::I32(_) => Scalar::I32,
            Self::U32(_) => Scalar::U32,
            Self::Usize(_) | Self::Length(_) => Scalar::Usize,
            Self::Variant(which, _) => Scalar::Enum(which),
        }
    }
}

impl Expr {
    /// The type of a scalar expression.
    ///
    /// # Panics
    /// If the expression is an array.
    #[must_use]
    pub fn scalar(&self) -> Scalar {
        match self {
            Self::Literal(value) => value.scalar(),
            Self::Read(_, scalar) => *scalar,
            Self::Unary(Unary::Not, _) => Scalar::Bool,
            Self::Unary(_, operand) => operand.scalar(),
            Self::Binary(
                Binary::Add | Binary::Subtract | Binary::Multiply | Binary::Divide | Binary::Remainder,
                left,
                _,
            ) => left.scalar(),
            Self::Binary(..) => Scalar::Bool,
            Self::Call(call) => call.returns.expect("types: a call that is a value has one"),
            Self::If(choice) => choice.then.scalar(),
            Self::Match(selection) => selection.arms[0].body.scalar(),
            Self::Array(_) | Self::Repeat(..) => panic!("types: an array is no scalar"),
        }
    }
}

impl Block {
    fn scalar(&self) -> Scalar {
        self.value.as_ref().expect("types: a block of a value has one").scalar()
    }
}

impl Place {
    /// A whole local or parameter.
    #[must_use]
    pub fn root(name: &str) -> Self {
        Self { root: name.to_owned(), steps: Vec::new() }
    }

    /// The type of the place in a local or parameter of a type, if it is in there.
    #[must_use]
    pub fn ty<'t>(&self, root: &'t Type, program: &'t Program) -> Option<&'t Type> {
        let mut ty = root;
        for step in &self.steps {
            ty = match (step, ty) {
                (Step::Field(name), Type::Struct(which)) => {
                    &program.structs[*which].fields.iter().find(|(field, _)| field == name)?.1
                }
                (Step::Index(_), Type::Array(element, _)) => element,
                _ => return None,
            };
        }
        Some(ty)
    }

    /// Whether the two may hold a common part. Elements of an array count as one, as they do for Rust.
    #[must_use]
    pub fn overlaps(&self, other: &Self) -> bool {
        let apart = self.steps.iter().zip(&other.steps).any(|steps| match steps {
            (Step::Field(a), Step::Field(b)) => a != b,
            _ => false,
        });
        self.root == other.root && !apart
    }
}

impl Function {
    /// Whether a call changes something of the caller's.
    #[must_use]
    pub fn mutates(&self) -> bool {
        self.params.iter().any(|param| param.mode == Mode::Mutable)
    }
}

impl Program {
    /// Whether a type mentions the real type.
    #[must_use]
    pub fn is_real(&self, ty: &Type) -> bool {
        self.contains(ty, Scalar::Real)
    }

    /// Whether a parameter of a function mentions the real type, so that rustc finds it out at every call.
    #[must_use]
    pub fn shows_real(&self, function: &Function) -> bool {
        function.params.iter().any(|param| self.is_real(&param.ty))
    }

    /// For each function, whether it has the real type as its parameter. `init` and `step` always have.
    #[must_use]
    pub fn generic(&self) -> Vec<bool> {
        let mut generic = Vec::new();
        for (which, function) in self.functions.iter().enumerate() {
            let of_block = which + 2 >= self.functions.len();
            let signature = self.shows_real(function) || function.returns == Some(Scalar::Real);
            generic.push(of_block || signature || mentions_real(&function.body, &generic));
        }
        generic
    }

    /// Whether a value of the type has any part at all.
    #[must_use]
    pub fn has_scalar(&self, ty: &Type) -> bool {
        match ty {
            Type::Scalar(_) => true,
            Type::Array(element, _) => self.has_scalar(element),
            Type::Struct(which) => self.structs[*which].fields.iter().any(|(_, field)| self.has_scalar(field)),
        }
    }

    /// Whether a value of the type has a part of that scalar type.
    #[must_use]
    pub fn contains(&self, ty: &Type, scalar: Scalar) -> bool {
        match ty {
            Type::Scalar(own) => *own == scalar,
            Type::Array(element, _) => self.contains(element, scalar),
            Type::Struct(which) => self.structs[*which].fields.iter().any(|(_, field)| self.contains(field, scalar)),
        }
    }
}

fn mentions_real(block: &Block, generic: &[bool]) -> bool {
    let mut found = block.calls().into_iter().any(|call| match call.callee {
        Callee::Function(which) => generic[which],
        Callee::Intrinsic(_) => true,
    });
    block.visit(&mut |node| {
        found |= match node {
            Node::Expr(Expr::Literal(value)) => value.scalar() == Scalar::Real,
            Node::Expr(Expr::Read(_, scalar)) => *scalar == Scalar::Real,
            _ => false,
        };
    });
    found
}
