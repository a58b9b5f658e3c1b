//! TcUnit suites: the calls that the framework needs, what is given to the block, what is compared, and how many asserts.

use crate::twincat::{code, object};
use crate::{CASES, xml};
use compiler::print::identifier;
use compiler::program::Type;
use generator::blocks::blocks;
use generator::target::is_read;
use portable::RealKind;

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

/// Every input that the block reads comes from the list, every output is compared: a real by its bits, through the union.
#[test]
fn a_suite_gives_every_input_and_compares_every_output() {
    for case in CASES.iter() {
        for axis in &case.set.axes {
            for block in blocks(axis).unwrap() {
                let program = &block.program;
                let stem = format!("axis_{}_{}", axis.axis.name.to_ascii_lowercase(), program.block);
                let suite = object(&case.files[&format!("twincat/Tests/FB_{stem}_Test.TcPOU")]);
                let method = suite.at("Method");
                let (declaration, body) = (&method.at("Declaration").text, &method.at("Implementation/ST").text);
                let (real, list) =
                    (if axis.axis.real == RealKind::F64 { "LREAL" } else { "REAL" }, format!("GVL_{stem}_vector"));
                assert!(declaration.contains(&format!("    block : FB_{stem};\n")), "{stem}");
                assert!(declaration.contains(&format!("    view : U_axgen_{real};\n")), "{stem}");
                let call = body.split_once("    block(").unwrap().1.split_once(");").unwrap().0;
                let mut given = vec![("Enable".to_owned(), "TRUE".to_owned())];
                for (input, _) in program.inputs.iter().zip(is_read(program)).filter(|(_, read)| *read) {
                    let name = identifier(&input.path);
                    let value = if input.ty == Type::Real {
                        let copied = format!("    view.bits := {list}.{name}[sample];\n    in_{name} := view.value;\n");
                        assert!(body.contains(&copied), "{stem}: {copied}");
                        assert!(declaration.contains(&format!("    in_{name} : {real};\n")), "{stem}: {name}");
                        format!("in_{name}")
                    } else {
                        format!("{list}.{name}[sample]")
                    };
                    given.push((name, value));
                }
                let found: Vec<(String, String)> = call
                    .split(',')
                    .map(|input| input.trim().split_once(" := ").unwrap())
                    .map(|(name, value)| (name.to_owned(), value.to_owned()))
                    .collect();
                assert_eq!(found, given, "{stem}");
                let compared: String = program
                    .outputs
                    .iter()
                    .map(|output| {
                        let name = identifier(&output.path);
                        let question = if output.ty == Type::Real {
                            format!("    view.value := block.{name};\n    IF view.bits <> {list}.{name}[sample] THEN\n")
                        } else {
                            format!("    IF block.{name} <> {list}.{name}[sample] THEN\n")
                        };
                        question + "        differing := differing + 1;\n    END_IF;\n"
                    })
                    .collect();
                assert!(body.contains(&format!(
                    ");\n{compared}END_FOR;\nAssertEquals_UDINT(Expected := 0, Actual := differing,"
                )));
                let last = block.vector.inputs.len() - 1;
                assert!(body.contains(&format!("FOR sample := 0 TO {last} DO\n")), "{stem}: all samples");
            }
        }
    }
}

#[test]
fn a_union_has_as_many_bits_as_its_real() {
    for case in CASES.iter() {
        for (file, text) in case.with(&[".TcDUT"]).into_iter().filter(|(file, _)| file.contains("/U_axgen_")) {
            let code = code(&object(text).at("Declaration").text);
            let members: Vec<&str> = code.lines().filter(|line| line.starts_with("    ")).map(str::trim).collect();
            let wide = ["value : LREAL;", "bits : LWORD;"];
            let narrow = ["value : REAL;", "bits : DWORD;"];
            assert_eq!(members, if file.contains("LREAL") { wide } else { narrow }, "{}: {file}", case.name);
            assert!(code.contains("UNION\n") && code.contains("END_UNION\n"), "{file}");
        }
    }
}
