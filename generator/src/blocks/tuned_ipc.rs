//! The block `ipc` of an axis whose weights and limit the caller tunes: all that is said of it is said of `ipc`.

use super::ipc::is_there;
use super::{Certified, Figure, Part, Summary};
use crate::axis::Axis;
use crate::blocks::designed::Designed;
use compiler::pass::Defect;
use compiler::program::Program;
use reference::ipc::{Coeffs, Ipc};
use reference::tuned_ipc::TunedIpc;

impl Part for TunedIpc {
    fn is_asked_for(&self, axis: &Axis) -> bool {
        is_there(axis) && axis.ipc.tuning.is_some()
    }

    fn short_name(&self) -> &'static str {
        Ipc.short_name()
    }

    fn design(designed: &Designed) -> Coeffs<f64> {
        designed.ipc
    }

    fn notes(&self, designed: &Designed) -> Vec<(String, String)> {
        Ipc.notes(designed)
    }

    fn ranges(&self, designed: &Designed) -> [f64; 2] {
        Ipc.ranges(designed)
    }

    fn start_cycles(&self, designed: &Designed) -> usize {
        Ipc.start_cycles(designed)
    }

    fn summary(&self, designed: &Designed) -> Summary {
        Ipc.summary(designed)
    }

    fn verdict(&self, designed: &Designed) -> Vec<String> {
        Ipc.verdict(designed)
    }

    fn limit(&self, designed: &Designed) -> Option<Figure> {
        Ipc.limit(designed)
    }

    fn certificate(&self, designed: &Designed, program: &Program) -> Result<Certified, Defect> {
        Ipc.certificate(designed, program)
    }
}
