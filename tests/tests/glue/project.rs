//! The example's files, the test doubles and the emitted blocks, read by the strict engine into one program. No cycle is run here.

use generator::blocks::{self, Block as Emitted, Designed};
use generator::config::ListOptions;
use golden::engine::emitted;
use portable::RealKind;
use st::{Block, Dialect, Mistake, Program};
use std::path::{Path, PathBuf};

/// The files of the example.
pub const FB: &str = "POUs/FB_damped_axis.TcPOU";
pub const MAIN: &str = "POUs/MAIN.TcPOU";
pub const GVL: &str = "GVLs/GVL_axis_x.TcGVL";
/// What the program reads of the runtime.
pub const CYCLE: &str = "_TaskInfo[GETCURTASKINDEXEX()].CycleTime";

const STRUCTURES: [&str; 4] = ["PLCTONC_AXIS_REF", "NCTOPLC_AXIS_REF", "ST_AxisStatus", "AXIS_REF"];
const LIBRARY: [&str; 3] = ["MC_ReadStatus", "MC_Power", "MC_Reset"];

/// The example.
pub struct Project {
    pub folder: PathBuf,
    pub designed: Designed,
    /// increments of 60B1h for 1 um/s
    pub increments: f64,
    /// a block of which one number is another one
    pub spoilt: Option<&'static str>,
}

fn all(mistakes: &[Mistake]) -> String {
    mistakes.iter().map(Mistake::to_string).collect::<Vec<_>>().join("\n")
}

impl Project {
    pub fn of_example() -> Self {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/twincat");
        let (set, report) = generator::pipeline::read(&folder.join("axes.toml"), &ListOptions::default());
        let set = set.unwrap_or_else(|| panic!("{report:#?}"));
        Self { folder, designed: set.axes.into_iter().next().unwrap(), increments: 60.0, spoilt: None }
    }

    /// A block of the axis.
    pub fn emitted(&self, name: &str) -> Emitted {
        let mut blocks = blocks::blocks(&self.designed).unwrap().into_iter();
        blocks.find(|block| block.program.block == name).unwrap()
    }

    /// In which cycle the self-tests are done, from 0.
    pub fn tested(&self) -> usize {
        ["ipc", "feedforward"].map(|name| self.emitted(name).trial_inputs().len()).into_iter().max().unwrap() - 1
    }

    /// The program with its files changed by `edit`, which gets their names.
    pub fn program(&self, edit: impl Fn(&str, String) -> String) -> Block {
        self.try_program(edit).unwrap_or_else(|said| panic!("{said}"))
    }

    pub fn try_program(&self, edit: impl Fn(&str, String) -> String) -> Result<Block, String> {
        let read = |name: &str| edit(name, self.text(name));
        let mut program = self.library();
        self.list_and(&mut program, &read)?;
        program.block(&read(FB), "FB_damped_axis").map_err(|said| format!("{FB}:{}", all(&said)))?;
        program.read(&read(MAIN), "MAIN").map_err(|said| format!("{MAIN}:{}", all(&said)))
    }

    /// The program without one assignment of a file.
    pub fn without(&self, file: &str, which: usize) -> Block {
        let mut program = self.library();
        self.list_and(&mut program, &|name| self.text(name)).unwrap();
        let block = program.read(&self.text(FB), "FB_damped_axis").unwrap();
        program.add(if file == FB { block.without(which).unwrap() } else { block });
        let main = program.read(&self.text(MAIN), "MAIN").unwrap();
        if file == MAIN { main.without(which).unwrap() } else { main }
    }

    /// The assignments of a file's body, in its order: a call has parentheses before `:=`, or the rest of them on other lines.
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

    fn text(&self, name: &str) -> String {
        let path = self.folder.join(name);
        let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        if name == GVL { text.replace(":= 60.0;", &format!(":= {:.1};", self.increments)) } else { text }
    }

    /// The library's test doubles, and the emitted blocks with their self-tests, as strictly as ever.
    fn library(&self) -> Program {
        let mut program = Program::new(RealKind::F64);
        program.runtime(CYCLE);
        for name in STRUCTURES {
            let read = program.structure(&self.text(&format!("stubs/{name}.TcDUT")));
            read.unwrap_or_else(|said| panic!("{name}: {}", all(&said)));
        }
        for name in LIBRARY {
            let read = program.block(&self.text(&format!("stubs/{name}.TcPOU")), name);
            read.unwrap_or_else(|said| panic!("{name}: {}", all(&said)));
        }
        for name in ["ipc", "feedforward"] {
            let block = self.emitted(name);
            let [file, test] = emitted::files(Dialect::TwinCat, &self.designed, &block).unwrap();
            let read = emitted::read(Dialect::TwinCat, &file, &self.designed, &block).unwrap();
            let read = if self.spoilt == Some(name) { read.with_other_constant(0).unwrap() } else { read };
            let test_name = format!("FB_axis_x_{name}_self_test");
            let others = std::slice::from_ref(&read);
            let test = Block::read_with(Dialect::TwinCat, &test.text, &test_name, RealKind::F64, others);
            program.add(test.unwrap_or_else(|said| panic!("{}", all(&said))));
            program.add(read);
        }
        program
    }

    fn list_and(&self, program: &mut Program, read: &dyn Fn(&str) -> String) -> Result<(), String> {
        program.globals(&read(GVL)).map_err(|said| format!("{GVL}:{}", all(&said)))
    }
}
