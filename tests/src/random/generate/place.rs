//! Random places: to be read, to be written, to be lent, and the indices in them.

use super::constant::LARGEST_KNOWN;
use super::expression::operation;
use super::scope::{Access, Binding, Writer};
use crate::random::syntax::{
    COEFFS, Call, Callee, Expr, INPUTS, Length, Mode, OUTPUTS, Place, Program, Scalar, Step, Type, Value,
};
use portable::Binary;

impl Writer<'_> {
    /// Whether there is a place of a scalar type that may be read.
    pub fn can_read(&self, scalar: Scalar) -> bool {
        self.scope.iter().any(|binding| self.sees(binding) && self.program.contains(&binding.ty, scalar))
    }

    fn sees(&self, binding: &Binding) -> bool {
        binding.readable && (binding.known || !self.known)
    }

    /// Reads some place of a scalar type.
    pub fn read(&mut self, scalar: Scalar) -> Option<Expr> {
        if !self.can_read(scalar) {
            return None;
        }
        let weigh = |binding: &Binding| {
            let weight = match binding.ty {
                Type::Struct(COEFFS) => 1,
                Type::Struct(OUTPUTS) => 2,
                Type::Struct(INPUTS) => 4,
                _ if !binding.used => 10,
                _ => 3,
            };
            usize::from(self.sees(binding) && self.program.contains(&binding.ty, scalar)) * weight
        };
        let weights: Vec<usize> = self.scope.iter().map(weigh).collect();
        let names = self.scope.iter().map(|binding| binding.name.as_str());
        let chosen = self.choices.named(names.zip(weights));
        let binding = self.scope[chosen].clone();
        let place = self.inside(&binding, |ty, program| program.contains(ty, scalar));
        let hidden = self.lent.iter().any(|(lent, mode)| *mode == Mode::Mutable && lent.overlaps(&place));
        self.scope[chosen].used |= !hidden;
        (!hidden).then_some(Expr::Read(place, scalar))
    }

    /// A scalar that can be assigned; of one type, if it is given.
    pub fn writable(&mut self, only: Option<Scalar>) -> Option<(Place, Scalar)> {
        let holds = |ty: &Type, program: &Program| {
            only.map_or_else(|| program.has_scalar(ty), |scalar| program.contains(ty, scalar))
        };
        let fits = |binding: &&Binding| {
            matches!(binding.access, Access::Local | Access::Mutable) && holds(&binding.ty, self.program)
        };
        let candidates: Vec<Binding> = self.scope.iter().filter(fits).cloned().collect();
        if candidates.is_empty() {
            return None;
        }
        // Most locals would be assigned nowhere: there are many of them, and few statements after each.
        let weigh = |binding: &Binding| if binding.access == Access::Local { 3 } else { 1 };
        let named = candidates.iter().map(|binding| (binding.name.as_str(), weigh(binding)));
        let binding = candidates[self.choices.named(named)].clone();
        let place = self.inside(&binding, holds);
        match place.ty(&binding.ty, self.program) {
            Some(Type::Scalar(scalar)) => Some((place, *scalar)),
            _ => None,
        }
    }

    /// A place of a type that a call can borrow.
    pub fn borrowable(&mut self, ty: &Type, mode: Mode) -> Option<Place> {
        let mut found = Vec::new();
        for binding in self.scope.clone() {
            let writable = matches!(binding.access, Access::Local | Access::Mutable);
            if binding.readable && (writable || mode == Mode::Shared) {
                self.choices.enter_named(&binding.name);
                self.parts(&Place::root(&binding.name), &binding.ty, ty, &mut found);
                self.choices.leave();
            }
        }
        found.retain(|place| {
            let in_the_way = |(lent, other): &(Place, Mode)| {
                lent.overlaps(place) && (mode == Mode::Mutable || *other == Mode::Mutable)
            };
            !self.lent.iter().any(in_the_way)
        });
        let names: Vec<String> = found.iter().map(|place| format!("{place:?}")).collect();
        let chosen = self.choices.named(names.iter().map(|name| (name.as_str(), 1)));
        found.get(chosen).cloned()
    }

    /// The parts of a place that have a type.
    fn parts(&mut self, place: &Place, own: &Type, wanted: &Type, found: &mut Vec<Place>) {
        if own == wanted {
            found.push(place.clone());
        }
        match own {
            Type::Scalar(_) => {}
            Type::Array(element, length) => {
                let index = Step::Index(self.index(*length));
                self.parts(&part(place, index), element, wanted, found);
            }
            Type::Struct(which) => {
                let program = self.program;
                for (name, field) in &program.structs[*which].fields {
                    self.parts(&part(place, Step::Field(name.clone())), field, wanted, found);
                }
            }
        }
    }

    /// A scalar of a local or parameter, on a way on which every type holds what is wanted.
    fn inside(&mut self, binding: &Binding, holds: impl Fn(&Type, &Program) -> bool) -> Place {
        self.choices.enter();
        let place = self.inside_here(binding, holds);
        self.choices.leave();
        place
    }

    fn inside_here(&mut self, binding: &Binding, holds: impl Fn(&Type, &Program) -> bool) -> Place {
        let (program, mut place, mut ty) = (self.program, Place::root(&binding.name), &binding.ty);
        loop {
            match ty {
                Type::Scalar(_) => return place,
                Type::Array(element, length) => {
                    place.steps.push(Step::Index(self.index(*length)));
                    ty = element;
                }
                Type::Struct(which) => {
                    let fields = program.structs[*which].fields.iter().filter(|(_, field)| holds(field, program));
                    let fields: Vec<&(String, Type)> = fields.collect();
                    let (name, field) = fields[self.choices.named(fields.iter().map(|(name, _)| (name.as_str(), 1)))];
                    place.steps.push(Step::Field(name.clone()));
                    ty = field;
                }
            }
        }
    }

    /// An index below a length.
    pub fn index(&mut self, length: Length) -> Expr {
        let mut options = vec![Expr::Literal(Value::Usize(self.choices.below(length.count)))];
        let last = match length.named {
            Some(named) => operation(Binary::Subtract, Expr::Literal(Value::Length(named)), usize_literal(1)),
            None => usize_literal(length.count - 1),
        };
        options.push(last.clone());
        for (read, below) in self.indices() {
            if below <= length.count {
                options.extend([read.clone(), read.clone(), read.clone()]);
                options.push(operation(Binary::Subtract, last.clone(), read.clone()));
            }
            if below < length.count {
                options.push(operation(Binary::Add, read, usize_literal(1)));
            }
        }
        self.choices.pick(&options).clone()
    }

    /// The whole numbers that are known and visible, each with a number that it is below.
    fn indices(&self) -> Vec<(Expr, usize)> {
        let mut indices = Vec::new();
        for binding in &self.scope {
            let root = Place::root(&binding.name);
            match (&binding.ty, binding.access) {
                (Type::Scalar(Scalar::Usize), Access::Index(below)) => indices.push((usize_read(root), below)),
                (Type::Scalar(Scalar::Usize), _) => indices.push((usize_read(root), LARGEST_KNOWN + 1)),
                (Type::Struct(COEFFS), _) => {
                    let fields = self.program.structs[COEFFS].fields.iter();
                    let known = fields.filter(|(_, ty)| *ty == Type::Scalar(Scalar::Usize));
                    let read = known.map(|(name, _)| usize_read(part(&root, Step::Field(name.clone()))));
                    indices.extend(read.map(|read| (read, LARGEST_KNOWN + 1)));
                }
                _ => {}
            }
        }
        let named = self.program.functions.iter().enumerate();
        let named = named.filter(|(_, function)| function.params.is_empty() && function.returns == Some(Scalar::Usize));
        indices.extend(named.map(|(which, _)| (named_usize(which), LARGEST_KNOWN + 1)));
        indices
    }
}

fn usize_read(place: Place) -> Expr {
    Expr::Read(place, Scalar::Usize)
}

/// A call of a function that is a named `usize`.
fn named_usize(which: usize) -> Expr {
    Expr::Call(Call { callee: Callee::Function(which), arguments: Vec::new(), returns: Some(Scalar::Usize) })
}

fn part(place: &Place, step: Step) -> Place {
    let mut inner = place.clone();
    inner.steps.push(step);
    inner
}

fn usize_literal(value: usize) -> Expr {
    Expr::Literal(Value::Usize(value))
}
