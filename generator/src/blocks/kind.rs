//! A block as its folder describes it, and as the registry has it: everything that can be asked of it, whatever its types are.

use super::designed::Designed;
use super::values::{self, Values};
use crate::exercise::runner::{self, Runner};
use crate::exercise::{self, Drill, Exercise, Recording, Run, Running, SelfTest, Trial, Wanted};
use crate::{axis::Axis, design::rounding::rounded};
use compiler::legalise::{self, Own};
use compiler::pass::{self, Defect};
use compiler::ranges::{self, Shown};
use compiler::{arithmetic, leaves, program::Program, specialise, structure};
use portable::{Block as Reference, Literal, Real, RealKind};
use std::collections::BTreeMap;
use std::sync::Arc;

/// What a block's folder says of it: what the parameters of an axis make of a reference.
pub trait Part: Sync {
    /// Whether the parameters of an axis ask for it.
    fn is_asked_for(&self, axis: &Axis) -> bool;

    /// What it is called where names have to be short.
    fn short_name(&self) -> &'static str;

    /// Its coefficients, in double precision.
    fn design(designed: &Designed) -> <Self as Reference<f64>>::Coeffs
    where
        Self: Reference<f64> + Sized;

    /// What its coefficients mean: a path among them, or the beginning of one, and a text.
    fn notes(&self, designed: &Designed) -> Vec<(String, String)>;

    /// What it takes from other blocks of its axis beside parameters, for the digest.
    fn terms(&self, _: &Axis) -> String {
        String::new()
    }

    /// The ranges of the noise on its real inputs in a self-test: where no limit acts, and where limits do.
    fn ranges(&self, designed: &Designed) -> [f64; 2];

    /// How many cycles it takes from its start until it acts in full.
    fn start_cycles(&self, _: &Designed) -> usize {
        0
    }

    /// What it is led through in a self-test, beside noise.
    fn drill(&self, _: &Designed) -> Vec<Drill> {
        Vec::new()
    }

    /// What it does, for the summary of an axis.
    fn summary(&self, designed: &Designed) -> Summary;

    /// What it means for the machine: tables and verdicts in words, a line each.
    fn verdict(&self, designed: &Designed) -> Vec<String> {
        self.summary(designed).lines
    }

    /// What it does as named values, for the semantic diff.
    fn values(&self, _: &Designed) -> Values {
        Values::new()
    }

    /// What differs between two versions of an axis, as far as this block shows it: in words, a line each.
    fn differences(&self, old: &Designed, new: &Designed) -> Vec<String> {
        values::differences(&self.values(old), &self.values(new))
    }

    /// The same of an axis that has no older version.
    fn description(&self, designed: &Designed) -> Vec<String> {
        values::description(&self.values(designed))
    }

    /// The largest |v_add|, where it puts one out.
    fn limit(&self, _: &Designed) -> Option<Figure> {
        None
    }

    /// What is certain of its program.
    ///
    /// # Errors
    /// The program does something else than what was designed.
    fn certificate(&self, _: &Designed, _: &Program) -> Result<Certified, Defect> {
        Ok(Certified::default())
    }
}

/// What a block does.
#[derive(Clone, Debug, Default)]
pub struct Summary {
    /// behind the first line of its axis
    pub head: String,
    /// lines of its own
    pub lines: Vec<String>,
}

/// What is certain of a block.
#[derive(Clone, Debug, Default)]
pub struct Certified {
    /// in words, a line each
    pub lines: Vec<String>,
    /// for code
    pub figures: Vec<Figure>,
}

/// The last pass.
const VERIFIED: &str = "verified";

/// A number that code may compare with what it expects.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// in capital letters
    pub name: &'static str,
    /// what it is, with its unit
    pub doc: String,
    /// in the real type of the block
    pub value: Literal,
}

/// A block that an axis may have, in the real type of the axis.
pub trait Kind: Part {
    /// Its name in files and on the command line.
    fn name(&self) -> &'static str;

    /// The program after the pass of that name; none: as the specialiser gives it.
    ///
    /// # Errors
    /// A defect of the block or of a pass.
    fn program(&self, designed: &Designed, last: Option<&str>) -> Result<Program, Defect>;

    /// What is certain of its outputs, whatever its state and its inputs hold.
    ///
    /// # Errors
    /// A defect of the block or of a pass.
    fn shown(&self, designed: &Designed) -> Result<Shown, Defect>;

    /// The block, ready to be printed.
    ///
    /// # Errors
    /// A defect of the block or of a pass.
    fn block(&self, designed: &Designed) -> Result<Block, Defect>;

    /// A run of so many samples for a user's own board, of a block of that axis.
    fn runner(&self, designed: &Designed, block: &Block, samples: usize) -> Runner {
        runner::record(&block.exercise, &mut *self.start(designed), samples)
    }

    /// The reference, before its first cycle.
    fn start(&self, designed: &Designed) -> Box<dyn Run>;

    /// All its coefficients.
    fn coefficients(&self, designed: &Designed) -> Vec<Literal>;
}

/// A block of one axis, ready to be printed.
#[derive(Clone, Debug)]
pub struct Block {
    /// verified
    pub program: Program,
    /// the same with the signals that the axis has
    pub own: Own,
    /// what the coefficients under a path mean, for a reviewer
    pub(crate) notes: BTreeMap<String, String>,
    pub(crate) exercise: Arc<Exercise>,
    pub(crate) self_test: SelfTest,
    pub(crate) trial: Trial,
    /// what the reference answers in the trial
    pub(crate) answers: Recording,
    /// what is certain of its range, and its measured response
    pub certificate: Certified,
    /// what is certain of its outputs, whatever its state and its inputs hold
    pub shown: Shown,
    /// what is in it, without the values of its coefficients: the same text, the same structure
    pub structure: String,
}

impl Block {
    /// The inputs of the run that its self-test on the controller has, sample by sample.
    pub fn trial_inputs(&self) -> Vec<Vec<Literal>> {
        self.trial.inputs()
    }
}

impl<P: Part + Reference<f64> + Reference<f32> + 'static> Kind for P {
    fn name(&self) -> &'static str {
        <P as Reference<f64>>::NAME
    }

    fn program(&self, designed: &Designed, last: Option<&str>) -> Result<Program, Defect> {
        match designed.axis.real {
            RealKind::F64 => program::<f64, P>(self, designed, last),
            RealKind::F32 => program::<f32, P>(self, designed, last),
        }
    }

    fn shown(&self, designed: &Designed) -> Result<Shown, Defect> {
        Ok(shown(self, designed, &Kind::program(self, designed, Some(VERIFIED))?))
    }

    fn block(&self, designed: &Designed) -> Result<Block, Defect> {
        match designed.axis.real {
            RealKind::F64 => block::<f64, P>(self, designed),
            RealKind::F32 => block::<f32, P>(self, designed),
        }
    }

    fn start(&self, designed: &Designed) -> Box<dyn Run> {
        let (coeffs, real) = (P::design(designed), designed.axis.real);
        match real {
            RealKind::F64 => Box::new(Running::<f64, P>::start(coeffs)),
            RealKind::F32 => Box::new(Running::<f32, P>::start(rounded(&coeffs, real))),
        }
    }

    fn coefficients(&self, designed: &Designed) -> Vec<Literal> {
        let (coeffs, real) = (P::design(designed), designed.axis.real);
        match real {
            RealKind::F64 => leaves(&coeffs),
            RealKind::F32 => leaves(&rounded::<_, <P as Reference<f32>>::Coeffs>(&coeffs, real)),
        }
    }
}

/// The program after the pass of that name; none: as the specialiser gives it.
fn program<R: Real, P: Part + Reference<f64> + Reference<R>>(
    part: &P,
    designed: &Designed,
    last: Option<&str>,
) -> Result<Program, Defect> {
    let notes = part.notes(designed).into_iter().collect();
    let specialised = specialise::block::<R, P>(&rounded(&P::design(designed), R::KIND), &notes);
    if last.is_some() { pass::run(specialised, last) } else { Ok(specialised) }
}

/// Specialises one block and records what it does.
fn block<R: Real, P: Part + Reference<f64> + Reference<R> + 'static>(
    part: &P,
    designed: &Designed,
) -> Result<Block, Defect> {
    let coeffs = || rounded(&P::design(designed), R::KIND);
    let notes = part.notes(designed).into_iter().collect();
    let specialised = specialise::block::<R, P>(&coeffs(), &notes);
    let structure = structure::of(&specialised);
    let state_paths: Vec<String> = specialised.state.iter().map(|variable| variable.path.clone()).collect();
    let program = pass::run(specialised, None)?;
    let own = legalise::own(&program)?;
    let certificate = part.certificate(designed, &program)?;
    let wanted = Wanted {
        ranges: part.ranges(designed),
        start: part.start_cycles(designed),
        drill: part.drill(designed),
        cycle_time_ns: designed.axis.cycle_time_ns,
    };
    let exercise = Arc::new(Exercise::of::<R, P>(&coeffs(), (&program, &own), &state_paths, &wanted));
    let self_test = SelfTest::record(&exercise, &mut Running::<R, P>::start(coeffs()));
    let trial = Trial::of(&exercise);
    let numbers = coeffs();
    let start = || Box::new(Running::<R, P>::start(numbers)) as Box<dyn Run>;
    let answers = exercise::recording(trial.clone(), &program, &state_paths, start);
    let shown = shown(part, designed, &program);
    shown.refuse(program.block)?;
    Ok(Block { program, own, notes, exercise, self_test, trial, answers, certificate, shown, structure })
}

/// What is certain of the outputs of a program.
fn shown<P: Part>(part: &P, designed: &Designed, program: &Program) -> Shown {
    // Where nothing adds a velocity, it is 0.
    let limit = part.limit(designed).and_then(|figure| arithmetic::wide(figure.value)).unwrap_or(0.0);
    ranges::run(program, &["v_add", "v_add_calculated"].map(|path| (path, limit)))
}
