//! Other stages in the lines of an axis list: values are replaced in their lines, and what is missing gets a line
//! after its stage. No file.

use super::keys_of_stage::{Given, keys};
use super::slot;
use crate::axis::Stage;
use crate::config::lines::{self, Content, Line};
use crate::parameters::words::{Enable, StageMode, Words};
use crate::parameters::{Name, STAGES, path_with};

/// What a line of the list is about.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Place {
    Other,
    /// improved position control, but no stage
    Block,
    Stage(u32),
}

/// The list with other stages, and the mode DRYRUN. A stage that is no longer there is NOT_ACTIVE; its other lines stay.
pub(super) fn edited(list: &[u8], stages: &[Stage]) -> Vec<u8> {
    let (mark, all) = lines::split(list);
    let all: Vec<Line<'_>> = all.collect();
    let places: Vec<Place> = all.iter().map(place).collect();
    let line_end = all.iter().map(|line| line.end).find(|end| end.ends_with(b"\n")).unwrap_or(b"\n");
    let mut wanted = wanted(stages, is_old(&all));
    let mut texts: Vec<Vec<u8>> = Vec::with_capacity(all.len());
    for (n, line) in all.iter().enumerate() {
        let to = all.get(n + 1).map_or(list.len(), |next| next.at);
        let mut text = list[line.at..to].to_vec();
        if let Some(slot) = slot::in_line(line).filter(|slot| !slot.own)
            && let Some(at) = wanted.iter().position(|(stage, key)| is_it(*stage, key, slot.key))
        {
            let (_, key) = wanted.remove(at);
            if slot.text != key.text {
                text.splice(slot.range, key.text.bytes());
            }
        }
        texts.push(text);
    }
    wanted.retain(|(_, key)| key.is_needed);
    let end = all.iter().position(|line| matches!(line.content, Content::Statement(of) if of.is_end()));
    for (stage, key) in wanted {
        put(&mut texts, &places, &all, end, (stage, &key), line_end);
    }
    [mark.to_vec(), texts.concat()].concat()
}

fn place(line: &Line<'_>) -> Place {
    let Some(slot) = slot::in_line(line).filter(|slot| !slot.own) else { return Place::Other };
    let path = slot.key.0.parameter().path;
    match () {
        () if path.contains("improved_position_control.stage[") => Place::Stage(slot.key.1[0]),
        () if path.contains("improved_position_control.") => Place::Block,
        () => Place::Other,
    }
}

fn is_it(stage: Option<u32>, key: &Given, found: crate::config::Key) -> bool {
    found == (key.name, [stage.unwrap_or(0), key.filter])
}

/// Whether the list has the damping of the simulated oscillation below its filter only, as older controllers need it.
fn is_old(all: &[Line<'_>]) -> bool {
    let has = |name: Name| all.iter().filter_map(slot::in_line).any(|slot| slot.key.0 == name);
    has(Name::FilterDamping) && !has(Name::OscDamping)
}

/// All keys that the list shall have, with the stage of each; `None` for the block.
fn wanted(stages: &[Stage], is_old: bool) -> Vec<(Option<u32>, Given)> {
    let enable = Given { name: Name::Enable, filter: 0, text: Enable::DryRun.name().to_owned(), is_needed: true };
    let mut wanted = vec![(None, enable)];
    for stage in 0..STAGES {
        let Some(of) = stages.get(stage as usize) else {
            let text = StageMode::NotActive.name().to_owned();
            wanted.push((Some(stage), Given { name: Name::Mode, filter: 0, text, is_needed: false }));
            continue;
        };
        for mut key in keys(of) {
            if is_old && key.name == Name::OscDamping {
                key.name = Name::FilterDamping;
            }
            // No controller knows what is a key of a set only.
            key.is_needed &= key.name != Name::DirectSource;
            wanted.push((Some(stage), key));
        }
    }
    wanted
}

/// Puts a line after those of its stage, else after the last one of the block, else at the end of the list.
fn put(
    texts: &mut [Vec<u8>],
    places: &[Place],
    all: &[Line<'_>],
    end: Option<usize>,
    (stage, key): (Option<u32>, &Given),
    line_end: &[u8],
) {
    let last = |of: &dyn Fn(Place) -> bool| places.iter().rposition(|place| of(*place));
    let before = |place: Place| stage.is_some_and(|stage| matches!(place, Place::Stage(of) if of <= stage));
    let of_block = || last(&|place| place == Place::Block || stage.is_none() && place != Place::Other);
    let at = last(&before).or_else(of_block).or_else(|| last(&|place| place != Place::Other));
    let path = path_with(key.name.parameter().path, [stage.unwrap_or(0), key.filter]);
    // The values of the block are mostly in one column.
    let column = at.and_then(|at| match all[at].content {
        Content::Statement(of) => Some(of.value_at()),
        Content::Remark { .. } | Content::Unreadable { .. } => None,
    });
    let mut line = format!("{path:<width$} {}", key.text, width = column.unwrap_or(1).saturating_sub(1)).into_bytes();
    line.extend(line_end);
    let at = at.or_else(|| end.and_then(|end| end.checked_sub(1))).or_else(|| texts.len().checked_sub(1));
    let Some(text) = at.and_then(|at| texts.get_mut(at)) else { return };
    if !text.ends_with(b"\n") {
        text.extend(line_end);
    }
    text.extend(line);
}
