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
    follows: Option<Rc<[Vec<Fact>; 2]>>,
}

/// A variable has one of these values, if it has not been written since.
#[derive(Clone, Debug, PartialEq)]
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
        let entry = Entry { value, written: self.assignments, copy_of, follows: follows.map(Rc::new) };
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
        let (copy_of, follows) = (entry.copy_of, entry.follows.clone());
        self.put(place, entry);
        if let Some((source, written)) = copy_of
            && self.entries[source].written == written
            && !self.restrict(source, value)
        {
            return false;
        }
        let facts = match value {
            Value::Bool([true, false]) => 0,
            Value::Bool([false, true]) => 1,
            _ => return true,
        };
        follows.is_none_or(|follows| {
            follows[facts]
                .iter()
                .all(|fact| self.entries[fact.place].written != fact.written || self.restrict(fact.place, fact.value))
        })
    }

    pub(super) fn mark(&self) -> usize {
        self.log.len()
    }

    /// Undoes all changes since a mark; returns them.
    pub(super) fn take_back(&mut self, mark: usize) -> Changes {
        let mut changes = Changes::new();
        for (place, before) in self.log.drain(mark..).rev() {
            changes.push((place, std::mem::replace(&mut self.entries[place], before)));
        }
        // The first entry of a variable is its last knowledge.
        changes.sort_by_key(|(place, _)| *place);
        changes.dedup_by_key(|(place, _)| *place);
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
        let mut joined: Vec<Joined<'_>> = Vec::with_capacity(one.len() + other.len());
        let mut rest = [&one[..], &other[..]];
        loop {
            let place = match rest.map(<[_]>::first) {
                [None, None] => break,
                [Some((place, _)), None] | [None, Some((place, _))] => *place,
                [Some((one, _)), Some((other, _))] => *one.min(other),
            };
            let both = rest.each_mut().map(|changes| match changes.split_first() {
                Some(((at, entry), later)) if *at == place => {
                    *changes = later;
                    entry
                }
                _ => &entries[place],
            });
            let value = both[0].value.join(both[1].value, names);
            let (mut written, mut copy_of) = (both[0].written, both[0].copy_of);
            if both[0].written != both[1].written {
                *assignments += 1;
                written = *assignments;
                copy_of = copy_of.filter(|copy_of| both[1].copy_of == Some(*copy_of));
            }
            joined.push(Joined { place, both, entry: Entry { value, written, copy_of, follows: None } });
        }
        // Facts of both branches about the variables that differ after them.
        let narrower = [0, 1].map(|side| joined.iter().filter_map(|of| of.narrower(side)).collect::<Vec<Fact>>());
        let follow = |of: &Joined<'_>| {
            let may_be_both = of.entry.value == Value::Bool([true, true]);
            may_be_both.then(|| Rc::new([0, 1].map(|answer| of.follow(answer, &narrower, &joined, entries, names))))
        };
        let follows: Vec<_> = joined.iter().map(follow).collect();
        let joined: Changes =
            joined.into_iter().zip(follows).map(|(of, follows)| (of.place, Entry { follows, ..of.entry })).collect();
        joined.into_iter().for_each(|(place, entry)| self.put(place, entry));
    }
}

/// A variable after two branches.
struct Joined<'k> {
    place: Place,
    /// the knowledge after each of them
    both: [&'k Entry; 2],
    entry: Entry,
}

impl Joined<'_> {
    /// The fact of one of the branches about the variable, if it is narrower than the joined knowledge.
    fn narrower(&self, side: usize) -> Option<Fact> {
        let value = self.both[side].value;
        (value != self.entry.value).then_some(Fact { place: self.place, written: self.entry.written, value })
    }

    /// Adds the facts that hold for each answer of this bool.
    fn follow(
        &self,
        answer: usize,
        narrower: &[Vec<Fact>; 2],
        joined: &[Self],
        entries: &[Entry],
        names: &Names,
    ) -> Vec<Fact> {
        let of = |side: usize| self.follow_in(side, answer, &narrower[side], joined, entries, names);
        match [of(0), of(1)] {
            [Some(facts), None] | [None, Some(facts)] => facts,
            [Some(one), Some(other)] => {
                let both = |fact: Fact| {
                    let same = other.iter().find(|same| same.place == fact.place)?;
                    Some(Fact { value: fact.value.join(same.value, names), ..fact })
                };
                one.into_iter().filter_map(both).collect()
            }
            [None, None] => Vec::new(),
        }
    }

    /// The facts of one of the branches for an answer of this bool; `None` if the bool has the other value there.
    fn follow_in(
        &self,
        side: usize,
        answer: usize,
        narrower: &[Fact],
        joined: &[Self],
        entries: &[Entry],
        names: &Names,
    ) -> Option<Vec<Fact>> {
        let Value::Bool(may_be) = self.both[side].value else { return None };
        if !may_be[answer] {
            return None;
        }
        let mut facts = narrower.to_vec();
        for fact in self.both[side].follows.iter().flat_map(|follows| &follows[answer]) {
            let found = joined.binary_search_by_key(&fact.place, |of| of.place);
            let (before, after) = match found {
                Ok(index) => (joined[index].both[side].written, joined[index].entry.written),
                Err(_) => (entries[fact.place].written, entries[fact.place].written),
            };
            if before == fact.written {
                let fact = Fact { written: after, ..fact.clone() };
                match facts.iter_mut().find(|known| known.place == fact.place) {
                    Some(known) => known.value = known.value.meet(fact.value, names),
                    None => facts.push(fact),
                }
            }
        }
        Some(facts)
    }
}
