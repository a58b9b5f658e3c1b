//! The possible values of every variable at one point of a program, and conclusions from the answer to a condition that a
//! variable holds. A branch is followed, undone, and joined with the other one; only its changes are touched.

use super::value::Value;
use super::whole::Names;
use std::rc::Rc;

/// A variable, by its position among all of them.
pub(super) type Place = usize;

/// The knowledge about one variable.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub value: Value,
    /// the number of the assignment of the value
    pub written: u32,
    /// the variable that it is a copy of, and the number of the assignment of that variable
    copy_of: Option<(Place, u32)>,
    /// for a bool: the facts if it is FALSE, and if it is TRUE
    follows: Option<[Rc<Vec<Fact>>; 2]>,
}

/// A variable has one of these values, if it has not been written since.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fact {
    place: Place,
    written: u32,
    value: Value,
}

/// The changes of one branch.
pub(super) type Changes = Vec<(Place, Entry)>;

pub(super) struct Known {
    entries: Vec<Entry>,
    /// the previous knowledge, for every change
    log: Vec<(Place, Entry)>,
    assignments: u32,
    pub names: Names,
}

impl Known {
    pub(super) fn new(values: impl Iterator<Item = Value>, names: Names) -> Self {
        let entry = |value| Entry { value, written: 0, copy_of: None, follows: None };
        Self { entries: values.map(entry).collect(), log: Vec::new(), assignments: 0, names }
    }

    pub(super) fn value(&self, place: Place) -> Value {
        let Entry { value, copy_of, .. } = &self.entries[place];
        match copy_of {
            Some((source, written)) if self.entries[*source].written == *written => {
                value.meet(self.entries[*source].value, &self.names)
            }
            _ => *value,
        }
    }

    /// The number of the assignment of a variable's value.
    pub(super) fn written(&self, place: Place) -> u32 {
        self.entries[place].written
    }

    /// Assigns a value to a variable; for a copy, that of `source`.
    pub(super) fn assign(
        &mut self,
        place: Place,
        value: Value,
        source: Option<Place>,
        follows: Option<[Vec<Fact>; 2]>,
    ) {
        self.assignments += 1;
        let copy_of = source.map(|source| (source, self.entries[source].written));
        let entry =
            Entry { value, written: self.assignments, copy_of, follows: follows.map(|facts| facts.map(Rc::new)) };
        self.put(place, entry);
    }

    fn put(&mut self, place: Place, entry: Entry) {
        let before = std::mem::replace(&mut self.entries[place], entry);
        self.log.push((place, before));
    }

    /// Restricts a variable to these values. Returns whether any is left, so that the point can be reached.
    pub(super) fn restrict(&mut self, place: Place, to: Value) -> bool {
        let before = self.entries[place].value;
        let value = before.meet(to, &self.names);
        if value.is_none() {
            return false;
        }
        if value == before {
            return true;
        }
        let entry = Entry { value, ..self.entries[place].clone() };
        let copy_of = entry.copy_of;
        self.put(place, entry);
        if let Some((source, written)) = copy_of
            && self.entries[source].written == written
            && !self.restrict(source, value)
        {
            return false;
        }
        let answer = match value {
            Value::Bool([true, false]) => 0,
            Value::Bool([false, true]) => 1,
            _ => return true,
        };
        let facts = self.entries[place].follows.as_ref().map(|follows| Rc::clone(&follows[answer]));
        facts
            .iter()
            .flat_map(|facts| facts.iter())
            .all(|fact| self.entries[fact.place].written != fact.written || self.restrict(fact.place, fact.value))
    }

    pub(super) fn mark(&self) -> usize {
        self.log.len()
    }

    /// Undoes all changes since a mark; returns them.
    pub(super) fn take_back(&mut self, mark: usize) -> Changes {
        let mut changes = self.log.split_off(mark);
        for (place, before) in changes.iter_mut().rev() {
            std::mem::swap(&mut self.entries[*place], before);
        }
        changes.sort_by_key(|(place, _)| *place);
        // The last entry of a variable is its last knowledge.
        changes.dedup_by(|later, kept| {
            let is_same = later.0 == kept.0;
            if is_same {
                std::mem::swap(later, kept);
            }
            is_same
        });
        changes
    }

    /// Changes as facts about the variables.
    pub(super) fn facts(changes: &Changes) -> Vec<Fact> {
        let fact = |(place, entry): &(Place, Entry)| Fact { place: *place, written: entry.written, value: entry.value };
        changes.iter().map(fact).collect()
    }

    /// Joins the knowledge after two branches; `None` for a branch that cannot be reached, or is never left.
    pub(super) fn merge(&mut self, branches: [Option<Changes>; 2]) {
        match branches {
            [None, None] => {}
            [Some(changes), None] | [None, Some(changes)] => {
                changes.into_iter().for_each(|(place, entry)| self.put(place, entry));
            }
            [Some(one), Some(other)] => self.join(&one, &other),
        }
    }

    fn join(&mut self, one: &Changes, other: &Changes) {
        let Self { entries, assignments, names, .. } = self;
        let mut both = Vec::with_capacity(one.len() + other.len());
        let mut after = Changes::with_capacity(one.len() + other.len());
        let mut rest = [&one[..], &other[..]];
        loop {
            let place = match rest.map(<[_]>::first) {
                [None, None] => break,
                [Some((place, _)), None] | [None, Some((place, _))] => *place,
                [Some((one, _)), Some((other, _))] => *one.min(other),
            };
            let [one, other] = rest.each_mut().map(|changes| match changes.split_first() {
                Some(((at, entry), later)) if *at == place => {
                    *changes = later;
                    entry
                }
                _ => &entries[place],
            });
            let value = one.value.join(other.value, names);
            let (mut written, mut copy_of) = (one.written, one.copy_of);
            if one.written != other.written {
                *assignments += 1;
                written = *assignments;
                copy_of = copy_of.filter(|copy_of| other.copy_of == Some(*copy_of));
            }
            both.push([one, other]);
            after.push((place, Entry { value, written, copy_of, follows: None }));
        }
        let joined = Joined { entries, names, both: &both, after: &after };
        let follows = joined.follows();
        for (index, follows) in follows {
            after[index].1.follows = Some(follows);
        }
        after.into_iter().for_each(|(place, entry)| self.put(place, entry));
    }
}

/// The variables that differ after two branches.
struct Joined<'k> {
    /// the knowledge before the branches
    entries: &'k [Entry],
    names: &'k Names,
    /// the knowledge after each branch
    both: &'k [[&'k Entry; 2]],
    /// the joined knowledge
    after: &'k Changes,
}

impl Joined<'_> {
    /// The facts that hold for each answer of the bools, by the position of the bool.
    fn follows(&self) -> Vec<(usize, [Rc<Vec<Fact>>; 2])> {
        let is_open = |index: &usize| self.after[*index].1.value == Value::Bool([true, true]);
        let mut bools = (0..self.after.len()).filter(is_open).peekable();
        if bools.peek().is_none() {
            return Vec::new();
        }
        let narrower = [0, 1].map(|side| Rc::new(self.narrower(side)));
        bools.map(|index| (index, [0, 1].map(|answer| self.follow(index, answer, &narrower)))).collect()
    }

    /// The facts of one of the branches about the variables for which it is narrower than the joined knowledge.
    fn narrower(&self, side: usize) -> Vec<Fact> {
        let fact = |((place, after), both): (&(Place, Entry), &[&Entry; 2])| {
            let value = both[side].value;
            (value != after.value).then_some(Fact { place: *place, written: after.written, value })
        };
        let mut facts = Vec::with_capacity(self.after.len());
        facts.extend(self.after.iter().zip(self.both).filter_map(fact));
        facts
    }

    /// The facts that hold for an answer of this bool.
    fn follow(&self, index: usize, answer: usize, narrower: &[Rc<Vec<Fact>>; 2]) -> Rc<Vec<Fact>> {
        match [0, 1].map(|side| self.follow_in(side, index, answer, &narrower[side])) {
            [Some(facts), None] | [None, Some(facts)] => facts,
            [Some(one), Some(other)] => {
                let both = |fact: &Fact| {
                    let same = other.iter().find(|same| same.place == fact.place)?;
                    Some(Fact { value: fact.value.join(same.value, self.names), ..*fact })
                };
                let mut facts = Vec::with_capacity(one.len());
                facts.extend(one.iter().filter_map(both));
                Rc::new(facts)
            }
            [None, None] => Rc::default(),
        }
    }

    /// The facts of one of the branches for an answer of this bool; `None` if the bool has the other value there.
    fn follow_in(&self, side: usize, index: usize, answer: usize, narrower: &Rc<Vec<Fact>>) -> Option<Rc<Vec<Fact>>> {
        let Entry { value: Value::Bool(may_be), follows, .. } = self.both[index][side] else { return None };
        if !may_be[answer] {
            return None;
        }
        let own = follows.as_ref().map_or(&[][..], |follows| &follows[answer]);
        if own.is_empty() {
            return Some(Rc::clone(narrower));
        }
        let mut facts = Vec::with_capacity(narrower.len() + own.len());
        facts.extend_from_slice(narrower);
        for fact in own {
            let (before, after) = match self.after.binary_search_by_key(&fact.place, |(place, _)| *place) {
                Ok(found) => (self.both[found][side].written, self.after[found].1.written),
                Err(_) => (self.entries[fact.place].written, self.entries[fact.place].written),
            };
            if before == fact.written {
                match facts.iter_mut().find(|known| known.place == fact.place) {
                    Some(known) => known.value = known.value.meet(fact.value, self.names),
                    None => facts.push(Fact { written: after, ..*fact }),
                }
            }
        }
        Some(Rc::new(facts))
    }
}
