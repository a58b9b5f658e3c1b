//! TcUnit suites: the calls that the framework needs, the self-test that they run, and how many asserts they have.

use super::twincat::{code, object};
use super::{CASES, xml};
use generator::blocks::blocks;

/// What TcUnit takes of one suite unless its library is built for more.
const ASSERTS: usize = 1000;

/// The asserts of a suite; none of them in a loop, which would count more than once.
fn asserts(suite: &xml::Element) -> usize {
    let mut count = 0;
    for method in suite.all("Method") {
        let code = code(&method.at("Implementation/ST").text);
        let mut depth = 0;
        for line in code.lines() {
            depth += usize::from(line.trim_start().starts_with("FOR "));
            depth -= usize::from(line.trim() == "END_FOR;");
            let found = line.matches("Assert").count();
            assert!(found == 0 || depth == 0, "{line}");
            count += found;
        }
    }
    count
}

#[test]
fn every_block_has_a_suite_that_tcunit_takes() {
    let mut count = 0;
    for case in CASES.iter() {
        for (file, text) in case.with(&["_Test.TcPOU"]) {
            let suite = object(text);
            let name = suite.attribute("Name");
            let header = format!("FUNCTION_BLOCK {name} EXTENDS TcUnit.FB_TestSuite\n");
            assert!(suite.at("Declaration").text.contains(&header), "{}: {file}", case.name);
            let methods: Vec<&xml::Element> = suite.all("Method").collect();
            let calls: Vec<String> =
                methods.iter().map(|method| format!("{}();\n", method.attribute("Name"))).collect();
            assert!(!methods.is_empty() && suite.at("Implementation/ST").text == calls.concat(), "{file}");
            for method in &methods {
                let body = &method.at("Implementation/ST").text;
                assert!(body.starts_with("TEST('") && body.ends_with("\nTEST_FINISHED();\n"), "{file}: {body}");
                assert_eq!((body.matches("TEST('").count(), body.matches("TEST_FINISHED(").count()), (1, 1), "{file}");
            }
            let asserts = asserts(&suite);
            assert!((1..=ASSERTS).contains(&asserts), "{file}: {asserts}");
            count += 1;
        }
        let all: usize = case.set.axes.iter().map(|axis| blocks(axis).unwrap().len()).sum();
        assert_eq!(case.with(&["_Test.TcPOU"]).len(), all, "{}", case.name);
    }
    assert!(count > 20, "{count} suites");
}

/// The suite runs the self-test as often as it has samples, and asks for its end and its answer.
#[test]
fn a_suite_runs_the_self_test_to_its_end() {
    for case in CASES.iter() {
        for axis in &case.set.axes {
            for block in blocks(axis).unwrap() {
                let stem = format!("axis_{}_{}", axis.axis.name.to_ascii_lowercase(), block.program.block);
                let suite = object(&case.files[&format!("twincat/Tests/FB_{stem}_Test.TcPOU")]);
                let method = suite.at("Method");
                let (declaration, body) = (&method.at("Declaration").text, &method.at("Implementation/ST").text);
                assert!(declaration.contains(&format!("    run : FB_{stem}_self_test;\n")), "{stem}");
                let samples = block.trial_inputs().len();
                assert!(body.contains(&format!("FOR sample := 1 TO {samples} DO\n    run();\nEND_FOR;\n")), "{stem}");
                assert!(body.contains("AssertTrue(Condition := run.done,"), "{stem}");
                assert!(body.contains("AssertEquals_DINT(Expected := 0, Actual := run.differing,"), "{stem}");
            }
        }
    }
}
