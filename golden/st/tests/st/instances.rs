//! Instances of other blocks: what their calls do, in each form of a file.

use crate::support::{answers, block, block_with};
use portable::{Literal, RealKind};
use st::{Block, Dialect};

/// The block of which there are instances: every type, jumps, a start value, memory.
const INNER: &str = include_str!("forms/adder.st");

/// Two instances, of which one is called twice in some cycles.
const OUTER: &str = include_str!("forms/adders.st");

/// Calls and answers of a block with the variables of the outer one.
fn found(block: &Block, inputs: &[(bool, i32)]) -> Vec<Vec<Literal>> {
    let (real, whole, bit) = (Literal::F64(0.0), Literal::I32(0), Literal::Bool(false));
    let samples: Vec<Vec<Literal>> = inputs.iter().map(|&(up, n)| vec![Literal::Bool(up), Literal::I32(n)]).collect();
    let outputs = [("y", real), ("z", real), ("k", whole), ("q", bit), ("v", Literal::U32(0))];
    answers(block, &[("up", bit), ("n", whole)], &samples, &outputs, &[])
}

fn row(y: f64, z: f64, k: i32, q: bool, v: u32) -> Vec<Literal> {
    vec![Literal::F64(y), Literal::F64(z), Literal::I32(k), Literal::Bool(q), Literal::U32(v)]
}

#[test]
fn each_instance_has_its_memory_and_keeps_the_inputs_that_a_call_leaves_out() {
    let inner = block(Dialect::Plain, INNER, "adder", RealKind::F64);
    let outer = block_with(Dialect::Plain, OUTER, "probe", RealKind::F64, &[inner]);
    let inputs = [(true, 0), (true, 4), (true, 0), (false, 5), (true, 1)];
    let expected = [
        // No start value of a plain file counts: `up` of `one` is FALSE.
        row(0.0, -1.0, 0, false, 1),
        row(2.0, 1.0, 4, false, 2),
        row(3.0, -1.0, 0, true, 2),
        row(0.0, -1.0, -2, false, 2),
        row(2.0, 1.0, 1, false, 2),
    ];
    assert_eq!(found(&outer, &inputs), expected);
}

/// Instances in the forms of the tools, which honour start values.
fn in_form(dialect: Dialect, text: &str, body: &str, variables: &str) -> String {
    let part = |start: &str, end: &str| {
        let from = text.find(start).expect("a test's text has its parts") + start.len();
        text[from..from + text[from..].find(end).expect("a test's text has its parts")].to_owned()
    };
    let name = part("FUNCTION_BLOCK ", "\n");
    let sections = format!("VAR_INPUT{}\n{variables}", part("VAR_INPUT", "\nVAR\n"));
    match dialect {
        Dialect::Plain => text.to_owned(),
        Dialect::TwinCat => format!(
            "<TcPlcObject><POU Name=\"{name}\"><Declaration><![CDATA[FUNCTION_BLOCK {name}\n{sections}]]></Declaration>\
             <Implementation><ST><![CDATA[{body}]]></ST></Implementation></POU></TcPlcObject>"
        ),
        Dialect::Scl => format!(
            "FUNCTION_BLOCK \"{name}\"\n{{ S7_Optimized_Access := 'TRUE' }}\nVERSION : 0.1\n{sections}BEGIN\n{body}\nEND_FUNCTION_BLOCK\n"
        ),
        Dialect::Codesys => {
            let mut xml = String::new();
            for section in sections.split_inclusive("END_VAR\n") {
                let kind = match section.split_whitespace().next() {
                    Some("VAR_INPUT") => "inputVars",
                    Some("VAR_OUTPUT") => "outputVars",
                    _ => "localVars",
                };
                xml += &format!("<{kind}>");
                for line in section.lines().filter(|line| line.contains(" : ")) {
                    let (name, rest) = line.trim().trim_end_matches(';').split_once(" : ").expect("it has one");
                    let (ty, start) = rest.split_once(" := ").map_or((rest, None), |(ty, start)| (ty, Some(start)));
                    let derived = ty.chars().any(char::is_lowercase);
                    let ty = if derived { format!("<derived name=\"{ty}\"/>") } else { format!("<{ty}/>") };
                    let start = start.map_or_else(String::new, |start| {
                        format!("<initialValue><simpleValue value=\"{start}\"/></initialValue>")
                    });
                    xml += &format!("<variable name=\"{name}\"><type>{ty}</type>{start}</variable>");
                }
                xml += &format!("</{kind}>");
            }
            let body = body.replace('<', "&lt;");
            format!(
                "<project xmlns=\"http://www.plcopen.org/xml/tc6_0200\"><types><pous><pou name=\"{name}\" pouType=\"functionBlock\">\
                 <interface>{xml}</interface><body><ST><xhtml>{body}</xhtml></ST></body></pou></pous></types></project>"
            )
        }
    }
}

#[test]
fn the_forms_of_the_tools_have_instances_too() {
    for dialect in [Dialect::TwinCat, Dialect::Codesys, Dialect::Scl] {
        let hash = |body: &str| if dialect == Dialect::Scl { body.to_owned() } else { body.replace('#', "") };
        let inner_body = "IF #up THEN\n    #sum := #sum + #width;\n    #k := #n;\nELSE\n    #sum := #zero;\n    #k := -#n / 2;\nEND_IF;\n\
                          #y := #sum;\n#q := #y > #limit_of_y;\n#v := #u + 1;";
        let inner_variables =
            "VAR\n    sum : LREAL;\n    zero : LREAL := 0.0;\n    limit_of_y : LREAL := 2.0;\nEND_VAR\n";
        let inner = in_form(dialect, INNER, &hash(inner_body), inner_variables);
        let inner = block(dialect, &inner, "Adder", RealKind::F64);
        let body = "IF #n > 0 THEN\n    #one(up := #up, n := #n + 1, U:=#two.v);\nEND_IF;\n#ONE(n := #n);\n\
                    #two(width := #one.y, up := #one.Q);\n#y := #one.y;\n#z := #two.y - #w;\n#k := #One.k;\n\
                    #q := #one.q OR #two.q;\n#v := #one.v;";
        let quote = if dialect == Dialect::Scl { "\"" } else { "" };
        let variables = format!(
            "VAR\n    one : {quote}Adder{quote};\n    two : {quote}adder{quote};\n    w : LREAL := 0.25;\nEND_VAR\n"
        );
        let outer = in_form(dialect, OUTER, &hash(body), &variables);
        let outer = block_with(dialect, &outer, "probe", RealKind::F64, &[inner]);
        let expected = [
            // `up` of `one` is TRUE at the start, and its width 1.5.
            row(1.5, -0.25, 0, false, 1),
            row(4.5, 4.25, 4, true, 2),
            row(0.0, -0.25, -2, false, 2),
        ];
        assert_eq!(found(&outer, &[(true, 0), (true, 4), (false, 5)]), expected, "{dialect:?}");
    }
}

#[test]
fn a_block_with_an_instance_may_be_instantiated() {
    let inner = block(Dialect::Plain, INNER, "adder", RealKind::F64);
    let outer = block_with(Dialect::Plain, OUTER, "probe", RealKind::F64, std::slice::from_ref(&inner));
    let text = include_str!("forms/outermost.st");
    let outermost = block_with(Dialect::Plain, text, "outermost", RealKind::F64, &[inner, outer.clone()]);
    let inputs = [(true, 0), (true, 4), (true, 0), (false, 5), (true, 1)];
    assert_eq!(found(&outermost, &inputs), found(&outer, &inputs));
}
