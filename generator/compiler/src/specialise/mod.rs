//! Partial evaluation: a portable function and the coefficients of one axis become a [`Program`].
//!
//! Calls are inlined, loops unrolled, branches on known values chosen, arrays and structs taken apart. The value of a
//! local is tracked, so that a local is assigned once on each way and a copy costs nothing. A named coefficient keeps its
//! name: it decides branches, but is never folded into an anonymous number.

mod call;
mod expr;
mod node;
mod statement;

use crate::leaves::leaves;
use crate::program::{Constant, Expr, Local, Origin, Program, Statement, Switch, Type, Var, Variable};
use node::{Cell, Node};
use portable::{Block, Enable, Fn, Literal, Portable, Real, RealKind, Ty};
use std::collections::BTreeMap;
use std::rc::Rc;

/// Specialises a block. `notes` say in words what the parts of the state at these paths are.
///
/// # Panics
/// If the block is not portable in a way that only shows here: a loop whose bound or an index that is not known, a
/// struct passed by value. That is a defect of the block, not of anybody's input.
#[must_use]
pub fn block<R: Real, B: Block<R>>(coeffs: &B::Coeffs, notes: &BTreeMap<String, String>) -> Program {
    let mut specialiser = Specialiser::new(notes, R::KIND);
    let coefficients = specialiser.enter_coefficients(<B::Coeffs as Portable>::TY, &leaves(coeffs));
    let state = specialiser.enter_variables(<B::State as Portable>::TY, &leaves(&B::state()), Space::State);
    let inputs = specialiser.enter_variables(<B::Inputs as Portable>::TY, &leaves(&B::inputs(coeffs)), Space::Input);
    let outputs = specialiser.enter_variables(<B::Outputs as Portable>::TY, &leaves(&B::outputs()), Space::Output);
    specialiser.entered = specialiser.cells.len();
    let init = specialiser.function(&B::INIT, vec![state.clone()]);
    let step = specialiser.function(&B::STEP, vec![state, coefficients, inputs, outputs]);
    let switch = B::ENABLE.map(|enable| specialiser.switch(enable));
    specialiser.into_program(B::NAME, switch, init, step)
}

/// A list of variables of the program.
#[derive(Clone, Copy)]
enum Space {
    Input,
    Output,
    State,
}

/// What is known at the present point of the function that is being specialised.
struct Specialiser<'n> {
    notes: &'n BTreeMap<String, String>,
    real: RealKind,
    inputs: Vec<Variable>,
    outputs: Vec<Variable>,
    state: Vec<Variable>,
    constants: Vec<Constant>,
    /// the constant that each coefficient is, by its position
    coefficient_of: Vec<Option<usize>>,
    /// the constants that functions without parameters are
    function_of: Vec<(&'static Fn, usize)>,
    locals: Vec<Local>,
    cells: Vec<Cell>,
    /// how many cells no branch can change: coefficients, state, inputs and outputs
    entered: usize,
    coefficients: Vec<Literal>,
    coefficient_type: Option<Ty>,
    frames: Vec<Frame>,
    statements: Vec<Statement>,
}

/// A function that is being inlined.
struct Frame {
    names: Vec<(&'static str, Rc<Node>)>,
    /// the path of the state that the function works on, which names its locals
    context: Rc<str>,
    function: &'static str,
}

impl<'n> Specialiser<'n> {
    fn new(notes: &'n BTreeMap<String, String>, real: RealKind) -> Self {
        Self {
            notes,
            real,
            inputs: Vec::new(),
            outputs: Vec::new(),
            state: Vec::new(),
            constants: Vec::new(),
            coefficient_of: Vec::new(),
            function_of: Vec::new(),
            locals: Vec::new(),
            cells: Vec::new(),
            entered: 0,
            coefficients: Vec::new(),
            coefficient_type: None,
            frames: Vec::new(),
            statements: Vec::new(),
        }
    }

    /// Enters the coefficients: every leaf is known.
    fn enter_coefficients(&mut self, ty: Ty, leaves: &[Literal]) -> Rc<Node> {
        self.coefficient_type = Some(ty);
        self.coefficients = leaves.to_vec();
        self.coefficient_of = vec![None; leaves.len()];
        let mut position = 0;
        node::build_unnamed(ty, &mut || {
            self.cells.push(Cell::Coefficient(position));
            position += 1;
            self.cells.len() - 1
        })
    }

    /// Enters inputs, outputs or state: every leaf is a variable.
    fn enter_variables(&mut self, ty: Ty, leaves: &[Literal], space: Space) -> Rc<Node> {
        let mut position = 0;
        node::build(ty, &mut String::new(), "", &mut |leaf, path, doc| {
            let start = number(leaves[position]);
            let variable = Variable { path: path.to_owned(), doc, ty: scalar_type(leaf, path), start };
            let cell = match space {
                Space::Input => Cell::Fixed(Var::Input(position)),
                Space::Output => Cell::Memory(Var::Output(position)),
                Space::State => Cell::Memory(Var::State(position)),
            };
            match space {
                Space::Input => self.inputs.push(variable),
                Space::Output => self.outputs.push(variable),
                Space::State => self.state.push(variable),
            }
            position += 1;
            self.cells.push(cell);
            self.cells.len() - 1
        })
    }

    /// Specialises a function without a value.
    fn function(&mut self, function: &'static Fn, arguments: Vec<Rc<Node>>) -> Vec<Statement> {
        let names = function.params.iter().map(|param| param.name).zip(arguments).collect();
        self.frames.push(Frame { names, context: "".into(), function: function.name });
        self.block(&function.body.block);
        self.frames.pop();
        std::mem::take(&mut self.statements)
    }

    /// What turns the block off. The number of its mode OFF is named as where the block asks for it.
    fn switch(&mut self, enable: Enable) -> Switch {
        let find = |list: &[Variable], path: &str| list.iter().position(|variable| variable.path == path);
        let input = find(&self.inputs, enable.input).expect("specialise: the block has the input that turns it off");
        let Some((off, busy)) = enable.mode else { return Switch { input, off: None, busy: None } };
        let value = match off.body.block.value {
            Some(portable::Expr::Constant { value }) => value(),
            _ => panic!("specialise: {} is no number", off.name),
        };
        let off = Constant { path: off.name.to_owned(), doc: off.doc, value, origin: Origin::Function };
        Switch { input, off: Some(off), busy: find(&self.state, busy).map(Var::State) }
    }

    fn into_program(
        self,
        block: &'static str,
        switch: Option<Switch>,
        init: Vec<Statement>,
        step: Vec<Statement>,
    ) -> Program {
        let Self { real, inputs, outputs, state, constants, locals, .. } = self;
        Program { block, switch, real, inputs, outputs, state, constants, locals, init, step }
    }

    /// The coefficient as a named number, entered where it is first met.
    fn coefficient(&mut self, position: usize) -> Expr {
        let index = self.coefficient_of[position].unwrap_or_else(|| {
            let ty = self.coefficient_type.expect("specialise: the coefficients were entered");
            let (path, doc) = node::leaf_at(ty, position);
            let (value, origin) = (self.coefficients[position], Origin::Coefficient(position));
            self.constants.push(Constant { path, doc, value, origin });
            self.constants.len() - 1
        });
        self.coefficient_of[position] = Some(index);
        Expr::Var(Var::Constant(index))
    }

    /// The value of a function without parameters as a named number, entered where it is first met.
    fn named(&mut self, function: &'static Fn, value: Literal) -> Expr {
        let is_same = |known: &Fn| (known.name, known.module) == (function.name, function.module);
        let known = self.function_of.iter().find(|(known, _)| is_same(known)).map(|(_, index)| *index);
        let index = known.unwrap_or_else(|| {
            let (path, doc) = (function.name.to_owned(), function.doc);
            self.constants.push(Constant { path, doc, value, origin: Origin::Function });
            self.function_of.push((function, self.constants.len() - 1));
            self.constants.len() - 1
        });
        Expr::Var(Var::Constant(index))
    }

    /// A new local of the function that is being inlined.
    fn local(&mut self, name: &str) -> Var {
        let context = &self.frame().context;
        let path = if context.is_empty() { name.to_owned() } else { format!("{context}.{name}") };
        self.locals.push(Local { path, ty: None });
        Var::Local(self.locals.len() - 1)
    }

    fn frame(&self) -> &Frame {
        self.frames.last().expect("specialise: inside a function")
    }

    fn frame_mut(&mut self) -> &mut Frame {
        self.frames.last_mut().expect("specialise: inside a function")
    }
}

/// The type of a scalar variable. A `usize` exists only while specialising.
fn scalar_type(ty: Ty, path: &str) -> Type {
    match ty {
        Ty::Bool => Type::Bool,
        Ty::I32 | Ty::Enum { .. } => Type::I32,
        Ty::U32 => Type::U32,
        Ty::Real(_) => Type::Real,
        Ty::Usize | Ty::Array { .. } | Ty::Struct { .. } => panic!("specialise: `{path}` is no variable: {ty:?}"),
    }
}

/// A literal as the program has it: a variant is its number.
fn number(literal: Literal) -> Literal {
    match literal {
        Literal::Variant(index) => Literal::I32(i32::try_from(index).expect("specialise: an enum has few variants")),
        other => other,
    }
}
