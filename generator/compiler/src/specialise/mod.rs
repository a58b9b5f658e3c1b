//! Partial evaluation: a portable function and the coefficients of one axis become a [`Program`].
//!
//! Calls are inlined, loops unrolled, branches on known values decided, arrays and structs split. The value of a local is
//! tracked, so that a local is assigned once on each path and a copy costs nothing. A named coefficient keeps its name: it
//! decides branches, but is never folded into an anonymous number.

mod call;
mod expr;
mod part;
mod statement;

use crate::leaves;
use crate::program::{
    Constant, Expr, Local, Off, Origin, Program, Statement, Switch, Type, Var, Variable, push_index, retain_mut,
    variant_name,
};
use part::{Cell, Leaf, Named, Part};
use portable::{Block, Enable, Fn, Intrinsic, Literal, Portable, Real, Ty};
use std::collections::BTreeMap;
use std::rc::Rc;

/// Specialises a block. `notes` describe the parts of the state at these paths in words.
///
/// # Panics
/// If the block is not portable in a way that is only detected here: a loop with an unknown bound, an unknown index, a
/// struct passed by value. That is a defect of the block, not of an input.
pub fn block<R: Real, B: Block<R>>(coeffs: &B::Coeffs, notes: &BTreeMap<String, String>) -> Program {
    let parts = [entered(coeffs), entered(&B::state()), entered(&B::inputs(coeffs)), entered(&B::outputs())];
    specialised(empty::<R, B>(coeffs), parts, [&B::INIT, &B::STEP], B::enable(coeffs), notes)
}

/// The type and the scalars of a value.
fn entered<T: Portable>(value: &T) -> (Ty, Vec<Literal>) {
    (T::TY, leaves(value))
}

/// Fills an empty program: coefficients, state, inputs and outputs of a block, then its functions.
fn specialised(
    program: Program,
    [(coefficient_type, coefficients), state, inputs, outputs]: [(Ty, Vec<Literal>); 4],
    [init, step]: [&'static Fn; 2],
    enable: Option<Enable>,
    notes: &BTreeMap<String, String>,
) -> Program {
    let mut specialiser = Specialiser {
        notes,
        program,
        coefficient_of: vec![None; coefficients.len()],
        function_of: Vec::new(),
        cells: Vec::new(),
        entered: 0,
        coefficients,
        coefficient_type,
        frames: Vec::new(),
        names: Vec::new(),
        rounds: Vec::new(),
        statements: Vec::new(),
    };
    let coefficients = (0..specialiser.coefficients.len()).map(Cell::Coefficient);
    let coefficients = specialiser.enter(coefficient_type, coefficients);
    let state = specialiser.variables(state.0, &state.1, Var::State);
    let inputs = specialiser.variables(inputs.0, &inputs.1, Var::Input);
    let outputs = specialiser.variables(outputs.0, &outputs.1, Var::Output);
    specialiser.entered = specialiser.cells.len();
    let init = specialiser.function(init, &[state]);
    let step = specialiser.function(step, &[state, coefficients, inputs, outputs]);
    let switch = enable.map(|enable| specialiser.switch(enable));
    let mut program = Program { switch, init, step, ..specialiser.program };
    if program.is_made_single {
        narrow(&mut program);
    }
    program
}

/// The program before its variables and statements are known.
fn empty<R: Real, B: Block<R>>(coeffs: &B::Coeffs) -> Program {
    Program {
        block: B::NAME,
        switch: None,
        usual_first: B::is_usual_first(coeffs),
        fractions: B::FRACTIONS,
        set: B::SET,
        made: B::MADE,
        is_made_single: R::IS_FOR_SINGLE,
        typed: B::TYPED,
        real: R::KIND,
        inputs: Vec::new(),
        outputs: Vec::new(),
        state: Vec::new(),
        rows: Vec::new(),
        constants: Vec::new(),
        locals: Vec::new(),
        init: Vec::new(),
        step: Vec::new(),
    }
}

/// Narrows the reals of the parameter set that a program makes. They are numbers that single precision represents.
fn narrow(program: &mut Program) {
    let is_single: Vec<bool> = program.outputs.iter().map(|output| program.is_single(output)).collect();
    retain_mut(&mut program.step, &mut |statement| {
        // A printer writes a literal in the type of what it is assigned to.
        if let Statement::Assign { target: Var::Output(index), value } = statement
            && is_single[*index]
            && !matches!(value, Expr::Literal(_))
        {
            let wide = std::mem::replace(value, Expr::bool(true));
            *value = Expr::Intrinsic(Intrinsic::Narrow, vec![wide]);
        }
        true
    });
}

/// The knowledge at the present point of the function that is being specialised.
struct Specialiser<'n> {
    notes: &'n BTreeMap<String, String>,
    program: Program,
    /// the constant for each coefficient, by its position
    coefficient_of: Vec<Option<usize>>,
    /// the constants for functions without parameters
    function_of: Vec<(&'static Fn, usize)>,
    cells: Vec<Cell>,
    /// number of cells that no branch can change: coefficients, state, inputs and outputs
    entered: usize,
    coefficients: Vec<Literal>,
    coefficient_type: Ty,
    frames: Vec<Frame>,
    /// the names of all frames, innermost last
    names: Vec<Named>,
    /// the iterations of the loops around this point, which number the locals
    rounds: Vec<usize>,
    statements: Vec<Statement>,
}

/// A function that is being inlined.
struct Frame {
    /// the position of its first name
    first_name: usize,
    /// the path of the state that the function works on, which names its locals
    context: Rc<str>,
    /// the position of the first iteration that the path does not contain
    first_round: usize,
    function: &'static str,
}

impl Specialiser<'_> {
    /// Enters a value, scalar by scalar.
    fn enter(&mut self, ty: Ty, cells: impl Iterator<Item = Cell>) -> Part {
        let first = self.cells.len();
        self.cells.extend(cells);
        Part { ty, first }
    }

    /// Enters inputs, outputs or state: every leaf is a variable.
    fn variables(&mut self, ty: Ty, starts: &[Literal], var: fn(usize) -> Var) -> Part {
        let mut variables = Vec::with_capacity(starts.len());
        Leaf::each(ty, &mut |leaf| {
            let start = starts[variables.len()].at_run_time();
            variables.push(Variable { ty: scalar_type(leaf), doc: leaf.doc(), path: leaf.path.clone(), start });
        });
        let (list, cell): (_, fn(Var) -> Cell) = match var(0) {
            Var::Output(_) => (&mut self.program.outputs, Cell::Memory),
            Var::State(_) => (&mut self.program.state, Cell::Memory),
            _ => (&mut self.program.inputs, Cell::Fixed),
        };
        list.extend(variables);
        self.enter(ty, (0..starts.len()).map(|position| cell(var(position))))
    }

    /// Specialises a function without a value.
    fn function(&mut self, function: &'static Fn, arguments: &[Part]) -> Vec<Statement> {
        let names = function.params.iter().zip(arguments);
        self.names.extend(names.map(|(param, part)| Named { name: param.name, part: *part, path: Some("".into()) }));
        self.frames.push(Frame { first_name: 0, context: "".into(), first_round: 0, function: function.name });
        self.block(&function.body.block);
        self.frames.pop();
        self.names.clear();
        std::mem::take(&mut self.statements)
    }

    /// The input that turns the block off. The number of its mode OFF is named as in the block.
    fn switch(&mut self, enable: Enable) -> Switch {
        let find = |list: &[Variable], path: &str| list.iter().position(|variable| variable.path == path);
        let input =
            find(&self.program.inputs, enable.input).expect("specialise: the block has the input that turns it off");
        let off = match enable.off {
            portable::Off::False => Off::False,
            portable::Off::Execute(works) => Off::Execute(find(&self.program.state, works).map(Var::State)),
            portable::Off::Brake(brake) => Off::Brake(brake),
            portable::Off::Mode(off, fades) => {
                let value = match off.body.block.value {
                    Some(portable::Expr::Constant { value }) => value(),
                    _ => panic!("specialise: {} is not a number", off.name),
                };
                let off = Constant { path: off.name.to_owned(), doc: off.doc, value, origin: Origin::Function };
                Off::Mode(off, find(&self.program.state, fades).map(Var::State))
            }
        };
        Switch { input, off }
    }

    /// The coefficient as a named number, entered at its first use.
    fn coefficient(&mut self, position: usize) -> Expr {
        let index = self.coefficient_of[position].unwrap_or_else(|| {
            let leaf = Leaf::at(self.coefficient_type, position);
            self.constant(leaf.doc(), leaf.path, self.coefficients[position], Origin::Coefficient(position))
        });
        self.coefficient_of[position] = Some(index);
        Expr::Var(Var::Constant(index))
    }

    /// The value of a function without parameters as a named number, entered at its first use.
    fn named(&mut self, function: &'static Fn, value: Literal) -> Expr {
        let is_same = |known: &Fn| (known.name, known.module) == (function.name, function.module);
        let known = self.function_of.iter().find(|(known, _)| is_same(known)).map(|(_, index)| *index);
        let index = known.unwrap_or_else(|| {
            let index = self.constant(function.doc, function.name.to_owned(), value, Origin::Function);
            self.function_of.push((function, index));
            index
        });
        Expr::Var(Var::Constant(index))
    }

    /// A value that the program stores or computes with: a variant becomes a named number.
    fn run_time(&mut self, value: Expr) -> Expr {
        let Expr::Literal(literal @ Literal::Variant(variant)) = value else { return value };
        let constants = &self.program.constants;
        let known = constants.iter().position(|constant| constant.origin == Origin::Variant(variant));
        Expr::Var(Var::Constant(known.unwrap_or_else(|| {
            self.constant(variant.def().doc, variant_name(variant), literal.at_run_time(), Origin::Variant(variant))
        })))
    }

    fn constant(&mut self, doc: &'static str, path: String, value: Literal, origin: Origin) -> usize {
        self.program.constants.push(Constant { path, doc, value, origin });
        self.program.constants.len() - 1
    }

    /// A new local of the function that is being inlined.
    fn local(&mut self, name: &str) -> Var {
        let Frame { context, first_round, .. } = self.frame();
        let mut path = [&**context, if context.is_empty() { "" } else { "." }, name].concat();
        self.rounds[*first_round..].iter().for_each(|round| push_index(&mut path, *round));
        self.program.locals.push(Local { path, ty: None });
        Var::Local(self.program.locals.len() - 1)
    }

    fn frame(&self) -> &Frame {
        self.frames.last().expect("specialise: inside a function")
    }
}

/// The paths of the scalars of a type, in their order.
pub fn paths<T: Portable>() -> Vec<String> {
    let mut paths = Vec::new();
    Leaf::each(T::TY, &mut |leaf| paths.push(leaf.path.clone()));
    paths
}

/// The type of a scalar variable. A `usize` exists only while specialising.
fn scalar_type(leaf: &Leaf) -> Type {
    match leaf.ty {
        Ty::Bool => Type::Bool,
        Ty::I32 | Ty::Enum { .. } => Type::I32,
        Ty::U32 => Type::U32,
        Ty::Real(_) => Type::Real,
        ty => panic!("specialise: `{}` is not a variable: {ty:?}", leaf.path),
    }
}
