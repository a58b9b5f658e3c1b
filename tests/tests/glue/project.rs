//! The example's files, the test doubles and the emitted blocks, read by the strict engine into one program. No cycle
//! is run here.

use generator::blocks::{self, Block as Emitted, Designed};
use generator::config::ListOptions;
use golden::engine::emitted;
use portable::RealKind;
use st::{Block, Dialect, Mistake, Program};
use std::path::{Path, PathBuf};

/// The files of the example.
pub const PERMIT: &str = "POUs/FB_damping_permit.TcPOU";
pub const VELOCITY: &str = "POUs/FB_motor_velocity.TcPOU";
pub const OFFSETS: &str = "POUs/FB_damping_offsets.TcPOU";
pub const MAIN: &str = "POUs/MAIN.TcPOU";
pub const LISTS: [&str; 2] = ["GVLs/GVL_axis_x.TcGVL", "GVLs/GVL_axis_z.TcGVL"];
/// The blocks that no axis is named in.
pub const BLOCKS: [&str; 3] = [PERMIT, VELOCITY, OFFSETS];
/// What the program reads of the runtime.
pub const CYCLE: &str = "_TaskInfo[GETCURTASKINDEXEX()].CycleTime";
pub const COUNT: &str = "_TaskInfo[GETCURTASKINDEXEX()].CycleCount";

const STRUCTURES: [&str; 4] = ["PLCTONC_AXIS_REF", "NCTOPLC_AXIS_REF", "ST_AxisStatus", "AXIS_REF"];
/// The only block of the library: with another one, such as MC_Power, the engine refuses the program.
const LIBRARY: &str = "MC_ReadStatus";

/// An axis of the example: what its list of global variables says of it.
pub struct Axis {
    pub letter: char,
    pub designed: Designed,
    /// increments of 60B1h for 1 um/s
    pub increments: f64,
    /// the NC's filter of the actual velocity, in cycles
    pub filter_cycles: f64,
    pub inverted: bool,
}

/// The example.
pub struct Project {
    folder: PathBuf,
    pub axes: [Axis; 2],
    /// a block of the axis X of which one number is another one
    spoilt: Option<&'static str>,
}

pub fn all(mistakes: &[Mistake]) -> String {
    mistakes.iter().map(Mistake::to_string).collect::<Vec<_>>().join("\n")
}

/// The name of a block's object: that of its file.
pub fn stem(file: &str) -> &str {
    Path::new(file).file_stem().and_then(|stem| stem.to_str()).unwrap()
}

impl Axis {
    /// A block of the axis.
    pub fn emitted(&self, name: &str) -> Emitted {
        let mut blocks = blocks::blocks(&self.designed).unwrap().into_iter();
        blocks.find(|block| block.program.block == name).unwrap()
    }

    /// In which cycle the self-tests are done, from 0.
    pub fn tested(&self) -> usize {
        ["ipc", "feedforward"].map(|name| self.emitted(name).trial_inputs().len()).into_iter().max().unwrap() - 1
    }

    /// What v_add stays within [um/s].
    pub fn limit(&self) -> f64 {
        if self.letter == 'x' { 25_000.0 } else { 12_500.0 }
    }
}

impl Project {
    pub fn of_example() -> Self {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/twincat");
        let (set, report) = generator::pipeline::read(&folder.join("axes.toml"), &ListOptions::default());
        let set = set.unwrap_or_else(|| panic!("{report:#?}"));
        let Ok([x, z]) = <[Designed; 2]>::try_from(set.axes) else { panic!("the example has two axes") };
        let x = Axis { letter: 'x', designed: x, increments: 60.0, filter_cycles: 0.0, inverted: false };
        let z = Axis { letter: 'z', designed: z, increments: 120.0, filter_cycles: 4.0, inverted: true };
        Self { folder, axes: [x, z], spoilt: None }
    }

    /// The example, with a block of the axis X that is not what was emitted.
    pub fn with_spoilt(block: &'static str) -> Self {
        Self { spoilt: Some(block), ..Self::of_example() }
    }

    /// The example, with another number of increments for 1 um/s of the axis X.
    pub fn with_increments(increments: f64) -> Self {
        let mut project = Self::of_example();
        project.axes[0].increments = increments;
        project
    }

    /// The program with its files changed by `edit`, which gets their names.
    pub fn program(&self, edit: impl Fn(&str, String) -> String) -> Block {
        self.try_program(edit).unwrap_or_else(|said| panic!("{said}"))
    }

    pub fn try_program(&self, edit: impl Fn(&str, String) -> String) -> Result<Block, String> {
        let read = |name: &str| edit(name, self.text(name));
        let mut program = self.library();
        for name in LISTS {
            program.globals(&read(name)).map_err(|said| format!("{name}:{}", all(&said)))?;
        }
        for name in BLOCKS {
            program.block(&read(name), stem(name)).map_err(|said| format!("{name}:{}", all(&said)))?;
        }
        program.read(&read(MAIN), "MAIN").map_err(|said| format!("{MAIN}:{}", all(&said)))
    }

    /// The program without one assignment of a file.
    pub fn without(&self, file: &str, which: usize) -> Block {
        let mut program = self.library();
        LISTS.iter().for_each(|name| program.globals(&self.text(name)).unwrap());
        for name in BLOCKS {
            let block = program.read(&self.text(name), stem(name)).unwrap();
            program.add(if file == name { block.without(which).unwrap() } else { block });
        }
        let main = program.read(&self.text(MAIN), "MAIN").unwrap();
        if file == MAIN { main.without(which).unwrap() } else { main }
    }

    /// The assignments of a file's body, in its order: a call has parentheses before `:=`, or the rest of them on
    /// other lines.
    pub fn statements(&self, file: &str) -> Vec<String> {
        let text = self.text(file);
        let code = |line: &str| line.split("//").next().unwrap_or_default().trim().to_owned();
        let is_statement = |code: &String| {
            let balanced = code.matches('(').count() == code.matches(')').count();
            let target = code.split_once(":=").map(|(target, _)| target);
            balanced && code.ends_with(';') && target.is_some_and(|target| !target.contains('('))
        };
        text.split("<ST><![CDATA[").nth(1).unwrap().lines().map(code).filter(is_statement).collect()
    }

    pub fn text(&self, name: &str) -> String {
        let path = self.folder.join(name);
        let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        if name == LISTS[0] { text.replace(":= 60.0;", &format!(":= {:.1};", self.axes[0].increments)) } else { text }
    }

    /// The library's test doubles, and the emitted blocks with their self-tests, as strictly as ever.
    fn library(&self) -> Program {
        let mut program = Program::new(RealKind::F64);
        program.runtime(CYCLE);
        program.runtime(COUNT);
        for name in STRUCTURES {
            let read = program.structure(&self.text(&format!("stubs/{name}.TcDUT")));
            read.unwrap_or_else(|said| panic!("{name}: {}", all(&said)));
        }
        let read = program.block(&self.text(&format!("stubs/{LIBRARY}.TcPOU")), LIBRARY);
        read.unwrap_or_else(|said| panic!("{LIBRARY}: {}", all(&said)));
        for (axis, name) in self.axes.iter().flat_map(|axis| [(axis, "ipc"), (axis, "feedforward")]) {
            let block = axis.emitted(name);
            let [file, test] = emitted::files(Dialect::TwinCat, &axis.designed, &block).unwrap();
            let read = emitted::read(Dialect::TwinCat, &file, &axis.designed, &block).unwrap();
            let is_spoilt = axis.letter == 'x' && self.spoilt == Some(name);
            let read = if is_spoilt { read.with_other_constant(0).unwrap() } else { read };
            let test_name = format!("FB_axis_{}_{name}_self_test", axis.letter);
            let others = std::slice::from_ref(&read);
            let test = Block::read_with(Dialect::TwinCat, &test.text, &test_name, RealKind::F64, others);
            program.add(test.unwrap_or_else(|said| panic!("{}", all(&said))));
            program.add(read);
        }
        program
    }
}
