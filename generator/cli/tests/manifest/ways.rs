//! The table: what happens to a folder, the run that follows, and what is said of the files that it leaves over.

use crate::folder::MINE;
use crate::folder::Step::{self, CarriageReturns, Delete, Edit, Kill, Merge, Put, Rename, Run, Save, Set};

/// A way from one folder to another.
pub struct Way {
    pub way: &'static str,
    pub steps: &'static [Step],
    /// the arguments of the run, whose `--check` comes first
    pub run: &'static str,
    /// the exit codes of the check and of the run
    pub codes: (i32, i32),
    /// `-` removed, `!` kept because it is not as it was generated, `?` kept because nothing lists it; of a run that
    /// is refused: its words
    pub said: &'static [&'static str],
    /// the runs that give the same in a fresh folder
    pub whole: &'static [&'static str],
    /// the runs that have no more to say at the end
    pub satisfied: &'static [&'static str],
}

const A: &str = "axes.toml";
const B: &str = "b.toml";
const ONE: &[&str] = &[A];
const BOTH: &[&str] = &[A, B];

/// A run of the whole set.
const fn whole(way: &'static str, steps: &'static [Step], said: &'static [&'static str]) -> Way {
    Way { way, steps, run: A, codes: (1, 0), said, whole: ONE, satisfied: ONE }
}

/// The same, of which `--check` has nothing to say.
const fn silent(way: &'static str, steps: &'static [Step]) -> Way {
    Way { codes: (0, 0), ..whole(way, steps, &[]) }
}

const X_IN_C: &[&str] = &["- axis_x_commissioning.md", "- axis_x_ipc.c", "- axis_x_ipc.h", "- axis_x_ipc_self_test.c"];
const Y_IN_TWINCAT: &[&str] = &[
    "- axis_y_commissioning.md",
    "- twincat/POUs/FB_axis_y_ipc.TcPOU",
    "- twincat/Tests/FB_axis_y_ipc_Test.TcPOU",
    "- twincat/Tests/FB_axis_y_ipc_self_test.TcPOU",
];

pub const WAYS: &[Way] = &[
    silent("nothing changes", &[Set(A, "c twincat", &["X kv stage"]), Run(A)]),
    whole("the first run", &[Set(A, "c twincat codesys scl", &["X kv stage"])], &[]),
    whole("an axis is renamed", &[Set(A, "c", &["X stage"]), Run(A), Set(A, "c", &["X1 stage"])], X_IN_C),
    whole("its case is changed", &[Set(A, "c", &["x stage"]), Run(A), Set(A, "c", &["X stage"])], &[]),
    whole(
        "an axis goes, and the project and the tests with it",
        &[Set(A, "twincat", &["X stage", "Y stage"]), Run(A), Set(A, "twincat", &["X stage"])],
        Y_IN_TWINCAT,
    ),
    whole(
        "Kv goes: two blocks do",
        &[Set(A, "st", &["X kv stage"]), Run(A), Set(A, "st", &["X stage"])],
        &[
            "- axis_x_axis.st",
            "- axis_x_axis_self_test.st",
            "- axis_x_position_control.st",
            "- axis_x_position_control_self_test.st",
        ],
    ),
    whole(
        "no stage is active: the block of improved position control goes, and the page is another one",
        &[Set(A, "rust", &["X kv stage"]), Run(A), Set(A, "rust", &["X kv"])],
        &["- axis_x_ipc.rs"],
    ),
    whole(
        "`tunable` comes: the block `axis` goes",
        &[Set(A, "scl", &["X kv stage"]), Run(A), Set(A, "scl", &["X kv stage tunable"])],
        &["- axis_x_axis.scl", "- axis_x_axis_self_test.scl"],
    ),
    whole(
        "`tunable` goes: the type of its sets does",
        &[Set(A, "twincat", &["X stage tunable"]), Run(A), Set(A, "twincat", &["X stage"])],
        &["- twincat/DUTs/ST_axis_x_ipc_params.TcDUT"],
    ),
    whole(
        "the last axis in single precision becomes another: the function of its type goes",
        &[Set(A, "twincat", &["X stage", "Y f32 stage"]), Run(A), Set(A, "twincat", &["X stage", "Y stage"])],
        &["- twincat/POUs/F_axgen_in_range_REAL.TcPOU"],
    ),
    whole(
        "a target goes, with its folders",
        &[Set(A, "c scl", &["X stage"]), Run(A), Set(A, "c", &["X stage"])],
        &["- IMPORT_SCL.md", "- axgen_mode.scl", "- axis_x_ipc.scl", "- axis_x_ipc_self_test.scl"],
    ),
    whole("a target comes", &[Set(A, "c", &["X stage"]), Run(A), Set(A, "c codesys", &["X stage"])], &[]),
    Way {
        run: "axes.toml --axis X",
        ..whole(
            "--axis: another axis, which is no axis of the set any more, goes",
            &[Set(A, "c", &["X stage", "Y"]), Run(A), Set(A, "c", &["X stage"])],
            &["- axis_y_commissioning.md", "- axis_y_ipc.c", "- axis_y_ipc.h", "- axis_y_ipc_self_test.c"],
        )
    },
    Way {
        run: "axes.toml --axis X",
        ..whole(
            "--axis: the other axes stay, and a block of this one goes",
            &[Set(A, "rust", &["X kv stage", "Y kv stage"]), Run(A), Set(A, "rust", &["X stage", "Y kv stage"])],
            &["- axis_x_axis.rs", "- axis_x_position_control.rs"],
        )
    },
    Way {
        run: "axes.toml --axis X --target twincat",
        codes: (0, 0),
        ..whole(
            "--axis of one target: the rest stays",
            &[Set(A, "c twincat", &["X stage", "Y f32 stage"]), Run(A)],
            &[],
        )
    },
    Way {
        run: "axes.toml --target rust",
        whole: &[A, "axes.toml --target rust"],
        satisfied: &[A, "axes.toml --target rust"],
        ..whole("--target: another one is added", &[Set(A, "-", &["X stage"]), Run(A)], &[])
    },
    Way {
        whole: &["axes.toml --target c --target st --target rust"],
        ..whole(
            "a target that was asked for once is brought up to date",
            &[Set(A, "-", &["X kv stage"]), Run("axes.toml --target rust"), Run(A), Set(A, "-", &["X stage"])],
            &[
                "- axis_x_axis.c",
                "- axis_x_axis.h",
                "- axis_x_axis.rs",
                "- axis_x_axis.st",
                "- axis_x_axis_self_test.c",
                "- axis_x_axis_self_test.st",
                "- axis_x_position_control.c",
                "- axis_x_position_control.h",
                "- axis_x_position_control.rs",
                "- axis_x_position_control.st",
                "- axis_x_position_control_self_test.c",
                "- axis_x_position_control_self_test.st",
            ],
        )
    },
    whole(
        "a runner that is not asked for any more",
        &[Set(A, "c", &["X stage"]), Run("axes.toml --runner=1000")],
        &["- axis_x_ipc_runner.c"],
    ),
    whole(
        "the block of an axis that goes was edited: it stays, the others go",
        &[Set(A, "st", &["X", "Y"]), Run(A), Edit("axis_y_ipc.st"), Set(A, "st", &["X"])],
        &["! axis_y_ipc.st", "- axis_y_commissioning.md", "- axis_y_ipc_self_test.st"],
    ),
    Way {
        run: "axes.toml --force",
        ..whole(
            "so it does by force",
            &[Set(A, "st", &["X", "Y"]), Run(A), Edit("axis_y_ipc.st"), Set(A, "st", &["X"])],
            &["! axis_y_ipc.st", "- axis_y_commissioning.md", "- axis_y_ipc_self_test.st"],
        )
    },
    whole(
        "somebody's own file is in the place of one that goes",
        &[Set(A, "rust", &["X", "Y"]), Run(A), Put("axis_y_ipc.rs", MINE), Set(A, "rust", &["X"])],
        &["! axis_y_ipc.rs", "- axis_y_commissioning.md"],
    ),
    silent(
        "files of somebody's own, with names of ours too",
        &[Set(A, "rust", &["X"]), Run(A), Put("axis_z_ipc.rs", MINE), Put("main.rs", MINE), Put("notes.md", MINE)],
    ),
    Way {
        codes: (1, 2),
        ..whole(
            "a file that is generated was edited: nothing goes either",
            &[Set(A, "rust", &["X", "Y"]), Run(A), Edit("axis_x_ipc.rs"), Set(A, "rust", &["X stage"])],
            &["generated/axis_x_ipc.rs: error[AX013]: "],
        )
    },
    whole(
        "what would go was deleted by hand",
        &[Set(A, "rust", &["X", "Y"]), Run(A), Delete("axis_y_ipc.rs"), Set(A, "rust", &["X"])],
        &["- axis_y_commissioning.md"],
    ),
    whole("a file is missing", &[Set(A, "rust", &["X", "Y"]), Run(A), Delete("axis_y_ipc.rs")], &[]),
    silent("version control has other line ends", &[Set(A, "c twincat", &["X stage"]), Run(A), CarriageReturns]),
    whole(
        "it has, and an axis goes",
        &[Set(A, "twincat", &["X stage", "Y stage"]), Run(A), CarriageReturns, Set(A, "twincat", &["X stage"])],
        Y_IN_TWINCAT,
    ),
    silent("TwinCAT has saved all objects", &[Set(A, "twincat", &["X kv stage", "Y f32 stage tunable"]), Run(A), Save]),
    whole(
        "it has, and an axis goes",
        &[Set(A, "twincat", &["X stage", "Y stage"]), Run(A), Save, Set(A, "twincat", &["X stage"])],
        Y_IN_TWINCAT,
    ),
    whole(
        "it has, and an axis changes",
        &[Set(A, "twincat", &["X stage"]), Run(A), Save, Set(A, "twincat", &["X f32 stage"])],
        &["- twincat/POUs/F_axgen_in_range_LREAL.TcPOU"],
    ),
    whole(
        "somebody has edited an object there",
        &[
            Set(A, "twincat", &["X", "Y"]),
            Run(A),
            Edit("twincat/POUs/FB_axis_y_ipc.TcPOU"),
            Save,
            Set(A, "twincat", &["X"]),
        ],
        &[
            "! twincat/POUs/FB_axis_y_ipc.TcPOU",
            "- axis_y_commissioning.md",
            "- twincat/Tests/FB_axis_y_ipc_Test.TcPOU",
            "- twincat/Tests/FB_axis_y_ipc_self_test.TcPOU",
        ],
    ),
    Way {
        codes: (0, 0),
        whole: BOTH,
        satisfied: BOTH,
        ..whole(
            "two sets share tests, project and functions",
            &[
                Set(A, "twincat codesys", &["X stage"]),
                Set(B, "twincat codesys", &["Y f32 stage"]),
                Run(A),
                Run(B),
                Run(A),
            ],
            &[],
        )
    },
    Way {
        whole: BOTH,
        satisfied: BOTH,
        ..whole(
            "an axis of one of two sets goes",
            &[
                Set(A, "twincat", &["X", "Y stage"]),
                Set(B, "twincat", &["Z tunable stage"]),
                Run(A),
                Run(B),
                Set(A, "twincat", &["X"]),
            ],
            Y_IN_TWINCAT,
        )
    },
    Way {
        whole: BOTH,
        satisfied: BOTH,
        ..whole(
            "one of two sets has a target no more: the project of the other one stays",
            &[Set(A, "twincat scl", &["X f32"]), Set(B, "twincat", &["Y"]), Run(A), Run(B), Set(A, "scl", &["X f32"])],
            &[
                "- twincat/POUs/FB_axis_x_ipc.TcPOU",
                "- twincat/POUs/F_axgen_in_range_REAL.TcPOU",
                "- twincat/Tests/FB_axis_x_ipc_Test.TcPOU",
                "- twincat/Tests/FB_axis_x_ipc_self_test.TcPOU",
            ],
        )
    },
    Way {
        whole: &[B, A],
        ..whole(
            "the set is renamed, and its targets are others: the rest are files of another set, which `generate` says",
            &[Set(B, "c scl", &["X"]), Run(B), Set(A, "c", &["X"])],
            &[],
        )
    },
    Way { ..whole("the set is renamed", &[Set(B, "c scl", &["X stage"]), Run(B), Set(A, "c scl", &["X stage"])], &[]) },
    Way {
        whole: &[B, A],
        satisfied: BOTH,
        ..whole(
            "an axis moves from one set to the other",
            &[
                Set(A, "c", &["X"]),
                Set(B, "c", &["Y", "Z"]),
                Run(A),
                Run(B),
                Set(B, "c", &["Z"]),
                Set(A, "c", &["X", "Y"]),
            ],
            &[],
        )
    },
    whole(
        "an earlier axgen left no manifest: what goes is named, and stays",
        &[Set(A, "rust", &["X kv stage", "Y"]), Run(A), Delete("axgen.manifest"), Set(A, "rust", &["X stage"])],
        &["? axis_x_axis.rs", "? axis_x_position_control.rs", "? axis_y_commissioning.md", "? axis_y_ipc.rs"],
    ),
    whole(
        "so is what axes shared",
        &[Set(A, "scl", &["X stage"]), Run(A), Delete("axgen.manifest"), Set(A, "c", &["X"])],
        &["? IMPORT_SCL.md", "? axgen_mode.scl", "? axis_x_ipc.scl", "? axis_x_ipc_self_test.scl"],
    ),
    whole("nothing goes", &[Set(A, "c", &["X"]), Run(A), Delete("axgen.manifest")], &[]),
    Way {
        whole: BOTH,
        satisfied: BOTH,
        ..whole(
            "of two sets without a manifest the other one is generated first",
            &[Set(A, "c", &["X"]), Set(B, "c", &["Y"]), Run(A), Run(B), Delete("axgen.manifest"), Run(B)],
            &[],
        )
    },
    whole(
        "two branches were merged",
        &[Set(A, "rust", &["X", "Y"]), Run(A), Merge, Set(A, "rust", &["X"])],
        &["- axis_y_commissioning.md", "- axis_y_ipc.rs"],
    ),
    Way {
        codes: (2, 2),
        ..whole(
            "they were not",
            &[
                Set(A, "c", &["X"]),
                Run(A),
                Put("axgen.manifest", "<<<<<<< HEAD\naxis_x_ipc.c c X axes.toml\n=======\n"),
            ],
            &[
                "generated/axgen.manifest:1: error[AX492]: the line is not an entry of a manifest\n  1 | <<<<<<< HEAD\n",
                "generated/axgen.manifest:3: error[AX492]: ",
            ],
        )
    },
    Way {
        codes: (2, 2),
        ..whole(
            "a manifest names files elsewhere",
            &[Set(A, "c", &["X"]), Run(A), Put("axgen.manifest", "../axes.toml c Y axes.toml\n/etc/x c Y axes.toml\n")],
            &["generated/axgen.manifest:1: error[AX492]: ", "generated/axgen.manifest:2: error[AX492]: "],
        )
    },
    whole(
        "a run was killed while it took a file out",
        &[Set(A, "rust", &["X", "Y"]), Run(A), Rename("axis_y_ipc.rs", "axis_y_ipc.rs.axgen-kept-1")],
        &[],
    ),
    whole(
        "a run was killed at its beginning, and the set was undone",
        &[
            Set(A, "c twincat", &["X kv stage"]),
            Run(A),
            Set(A, "c", &["X1"]),
            Kill(A, 0),
            Set(A, "c twincat", &["X f32"]),
            Run(A),
            Set(A, "c twincat", &["X"]),
        ],
        &["- twincat/POUs/F_axgen_in_range_REAL.TcPOU"],
    ),
    #[cfg(unix)]
    whole(
        "a link is in the place of one that goes",
        &[Set(A, "rust", &["X", "Y"]), Run(A), Step::Link("axis_y_ipc.rs"), Set(A, "rust", &["X"])],
        &["! axis_y_ipc.rs", "- axis_y_commissioning.md"],
    ),
];
