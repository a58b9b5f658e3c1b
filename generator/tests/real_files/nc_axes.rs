//! Projects of TwinCAT with axes of the NC, which have no axis list: what of an axis is taken, and what is said to be missing.

use super::{read, read_named};
use generator::import_export;
use std::path::Path;

/// An axis as TwinCAT writes it: only what has not its default.
fn axis(name: &str, velo: &str, encoder: &str, pid: &str) -> String {
    format!(
        "\t<Axis Id=\"1\" CreateSymbols=\"true\" AxisType=\"1\">\n\t\t<Name>{name}</Name>\n\t\t<AxisPara>\n\
         \t\t\t<Dynamic AccelerationMaximum=\"0.8\" DelayTime=\"0.008\"/>\n{velo}\t\t</AxisPara>\n\
         \t\t<Encoder Name=\"Enc\" EncType=\"7\">\n\t\t\t<EncPara {encoder}Inverse=\"true\" MaxCount=\"#x0000ffff\"/>\n\t\t</Encoder>\n\
         \t\t<Drive Name=\"Drive\" DrvType=\"24\">\n\t\t\t<DrvPara Inverse=\"true\">\n\t\t\t\t<Analog VeloReferenz=\"50\"/>\n\t\t\t</DrvPara>\n\t\t</Drive>\n\
         \t\t<Controller Name=\"Ctrl\" CtrType=\"2\">\n\t\t\t<CtrPara PriorControlFactor=\"1\">\n{pid}\t\t\t</CtrPara>\n\t\t</Controller>\n\t</Axis>\n"
    )
}

fn file(axes: &[String]) -> String {
    format!("<?xml version=\"1.0\"?>\n<TcSmItem ClassName=\"CNcAxisDef\">\n{}</TcSmItem>\n", axes.concat())
}

const VELO: &str = "\t\t\t<Velo Maximum=\"800\"/>\n";
const PID: &str = "\t\t\t\t<PID PosKp=\"20.5\" PosExtKp=\"20\"/>\n";
const SCALE: &str = "ScaleFactorNumerator=\"0.0008302003481\" ";

#[test]
fn largest_velocity_gain_and_scale_are_taken() {
    let xti = file(&[axis("__FILENAME__", VELO, SCALE, PID)]);
    let (set, report) = read(&[("Axis 7.xti", xti.as_bytes())]);
    let set = set.unwrap_or_else(|| panic!("{report}"));
    let of = &set.axes[0].axis;
    assert_eq!((of.name.as_str(), of.ipc.v_max), ("Axis_7", 800_000.0));
    assert_eq!(of.control.position_control.as_ref().map(|control| control.kv), Some(2050));
    assert_eq!(
        report.to_string(),
        "Axis 7.xti:3: warning[AX478]: axis of TwinCAT NC, which has no axis list: \
         Velo Maximum 800 mm/s is getriebe[0].dynamik.vb_max 800000 (P-AXIS-00212); \
         PID PosKp 20.5/s is getriebe[0].kv 2050 (P-AXIS-00099); \
         EncPara scale 0.0008302003481 mm per increment is getriebe[0].wegaufz 100000000, getriebe[0].wegaufn 830200348 \
         (P-AXIS-00234, 00233); DrvPara Inverse: the drive counts against the axis: negate what the program writes to it and \
         reads from it; EncPara Inverse: negate what the program reads from the encoder, but not NcToPlc\n    \
         write instead: a TOML set whose axis names this file as its list, with the cycle time of the NC's SAF task, the stages and \
         the type of the axis, if it is rotary\n"
    );
}

#[test]
fn what_is_not_in_the_file_is_said() {
    let xti = file(&[axis("Lift", "", "", "")]);
    let (set, report) = read(&[("x.xti", xti.as_bytes())]);
    let said = report.to_string();
    assert!(set.is_none_or(|set| set.axes[0].axis.name == "Lift"));
    let whole = "axis `Lift` of TwinCAT NC, which has no axis list: DrvPara Inverse: the drive counts against the axis: negate what the \
                 program writes to it and reads from it; EncPara Inverse: negate what the program reads from the encoder, but not NcToPlc; not in the file, for TwinCAT leaves out what \
                 has its default: Velo Maximum: write getriebe[0].dynamik.vb_max; PID PosKp: write getriebe[0].kv; EncPara \
                 ScaleFactorNumerator: write getriebe[0].wegaufz and wegaufn, if a spindle needs them\n";
    assert!(said.contains(whole), "{said}");
}

/// A value that a rule refuses has the line of the file in which it stands.
#[test]
fn a_value_has_its_line_of_the_file() {
    let xti = file(&[axis("X", "\t\t\t<Velo Maximum=\"0\"/>\n", SCALE, PID)]);
    let line = xti.lines().position(|line| line.contains("<Velo")).unwrap() + 1;
    let said = read(&[("x.xti", xti.as_bytes())]).1.to_string();
    assert!(said.lines().any(|said| said.starts_with(&format!("x.xti:{line}: error[AX2"))), "{said}");
}

#[test]
fn scales_are_whole_numbers() {
    for (scale, z, n) in [
        ("ScaleFactorNumerator=\"0.0001\" ", "1", "1"),
        ("ScaleFactorNumerator=\"0.00001\" ", "10", "1"),
        ("ScaleFactorNumerator=\"360\" ScaleFactorDenominator=\"65536\" ", "10000000", "549316406"),
    ] {
        let xti = file(&[axis("X", VELO, scale, PID)]);
        let said = read(&[("x.xti", xti.as_bytes())]).1.to_string();
        assert!(said.contains(&format!("is getriebe[0].wegaufz {z}, getriebe[0].wegaufn {n} (")), "{scale}: {said}");
    }
}

#[test]
fn a_project_has_several_axes_and_the_cycle_of_its_task() {
    let task = "<NC><SafTask Priority=\"4\" CycleTime=\"20000\"><Name>SAF</Name></SafTask></NC>\n".to_owned();
    let project = file(&[task, axis("Axis 1", VELO, SCALE, PID), axis("Axis 2", VELO, SCALE, PID)]);
    let (set, report) = read(&[("m.tsproj", project.as_bytes())]);
    let names: Vec<String> =
        set.unwrap_or_else(|| panic!("{report}")).axes.iter().map(|of| of.axis.name.clone()).collect();
    assert_eq!(names, ["Axis_1", "Axis_2"]);
    assert!(report.to_string().contains("the cycle time of the SAF task, 2000 us"), "{report}");
    assert_eq!(read_named(&[("m.tsproj", project.as_bytes())], Some("Axis_2")).0.unwrap().axes.len(), 1);
}

#[test]
fn axes_in_files_of_their_own_are_named() {
    let project =
        "<TcSmItem><NC><Axis File=\"Axis 1.xti\" Id=\"1\"/><Axis File=\"Axis 2.xti\" Id=\"2\"/></NC></TcSmItem>";
    let said = read(&[("NC.xti", project.as_bytes())]).1.to_string();
    let end = "holds an axis list; its 2 axes of TwinCAT NC are in files of their own, the first in `Axis 1.xti`\n";
    assert!(said.contains("error[AX116]") && said.contains(end), "{said}");
}

#[test]
fn an_axis_is_imported_and_nothing_is_written_into_its_project() {
    let xti = file(&[axis("X", VELO, SCALE, PID)]);
    let (set, report) =
        import_export::import(Path::new("x.xti"), &Default::default(), &|_| Ok(xti.clone().into_bytes()));
    assert!(set.is_some_and(|set| set.contains("dynamik.vb_max = 800000")), "{report}");
    let set = "cycle_time = \"1ms\"\n[axis.X]\nlist = \"x.xti\"\n";
    let load = |path: &Path| Ok(if path.ends_with("x.xti") { xti.clone() } else { set.to_owned() }.into_bytes());
    let (bytes, report) = import_export::export(Path::new("set.toml"), Some("X"), &load);
    let said = report.to_string();
    assert!(bytes.is_none() && said.contains("error[AX116]: the list is an axis of TwinCAT NC"), "{said}");
}
