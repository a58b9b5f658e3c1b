//! What improved position control of an axis does, in a few lines.

use super::super::part::Summary;
use super::filter;
use crate::axis::Stage;
use crate::blocks::designed::Designed;
use crate::parameters::words::{StageMode, Words};

/// How it starts, its limit and its fade; a line for each stage.
pub(crate) fn summary(designed: &Designed) -> Summary {
    let ipc = &designed.axis.ipc;
    let head = format!(
        ", starts {}, |v_add| <= {}, fades in {} cycles",
        ipc.enable.name(),
        ipc.limit(),
        designed.ipc.fade_cycles
    );
    let line = |(index, stage): (usize, &Option<Stage>)| {
        let what = stage.as_ref().map_or_else(|| StageMode::NotActive.name().to_owned(), of_stage);
        format!("stage[{index}] {what}")
    };
    Summary { head, lines: ipc.stage.iter().enumerate().map(line).collect() }
}

fn of_stage(stage: &Stage) -> String {
    let damping = stage.mode.osc_damping().map_or_else(String::new, |damping| format!(", damping {damping}"));
    let filters: Vec<String> = stage.filter.iter().filter_map(filter::summary).collect();
    format!("{}{damping}: {}, weight {}", stage.mode.text(), filters.join(", "), stage.weight())
}
