//! What the checker of SCL refuses: a small source for every rule, and that it takes the source without the mistake.

use super::check;

/// A source with everything that a source may have.
const SOURCE: &str = "(* c *)
FUNCTION_BLOCK \"FB_x\"
{ S7_Optimized_Access := 'TRUE' }
VERSION : 0.1
VAR_INPUT
    a : LREAL := 0.0;
    r : REAL;
    n : UDINT := 0; (* c *)
    i : DINT := -1;
END_VAR
VAR_OUTPUT
    o : LREAL;
    p : REAL;
END_VAR
VAR
    s : BOOL;
END_VAR
VAR_TEMP
    t : LREAL;
END_VAR
VAR CONSTANT
    c : LREAL := 1.5E-3;
    d : REAL := -2.0;
END_VAR
BEGIN
IF (#n <> 0) AND NOT #s THEN
    #t := #c * (#a - #c);
ELSIF #i = 2 THEN
    #t := UDINT_TO_LREAL(#n + 1) / #a;
ELSE
    #t := 0.0;
END_IF;
#s := (-#c <= #t) OR #s;
#o := -#t;
#p := #r * #d + UDINT_TO_REAL(#n);
END_FUNCTION_BLOCK
";

fn source() -> String {
    SOURCE.to_owned()
}

#[test]
fn the_source_without_a_mistake_passes() {
    assert_eq!(check(&source()).map(|blocks| blocks.len()), Ok(1));
    assert_eq!(check(&(source() + &source())).map(|blocks| blocks.len()), Ok(2));
    assert!(check("").is_err());
}

/// What is replaced, by what, and what the checker says.
#[rustfmt::skip]
const MISTAKES: &[(&str, &str, &str)] = &[
    // the block
    ("\"FB_x\"", "FB_x", "\"name\" is wanted"),
    ("\"FB_x\"", "\"FB_x", "a quote without end"),
    ("\"FB_x\"", "\"FB__x\"", "is no name"),
    ("'TRUE'", "'FALSE'", "'TRUE' is wanted"),
    ("{ S7_Optimized_Access := 'TRUE' }\n", "", "{ is wanted"),
    ("VERSION : 0.1", "VERSION : 0.2", "0.1 is wanted"),
    ("VERSION : 0.1\n", "", "VERSION is wanted"),
    ("BEGIN\n", "", "BEGIN is wanted"),
    ("END_FUNCTION_BLOCK\n", "", "END_FUNCTION_BLOCK is wanted"),
    ("END_FUNCTION_BLOCK\n", "END_FUNCTION_BLOCK;\n", "FUNCTION_BLOCK is wanted"),
    // sections
    ("VAR\n    s : BOOL;\nEND_VAR\nVAR_TEMP\n    t : LREAL;\nEND_VAR\n",
     "VAR_TEMP\n    t : LREAL;\nEND_VAR\nVAR\n    s : BOOL;\nEND_VAR\n", "BEGIN is wanted"),
    ("    s : BOOL;\n", "", "a declaration in every section"),
    ("VAR_TEMP", "VAR_IN_OUT", "BEGIN is wanted"),
    ("s : BOOL;\nEND_VAR", "s : BOOL;", "is wanted"),
    // declarations
    ("    s : BOOL;", "    s BOOL;", ": is wanted"),
    ("    s : BOOL;", "    s : BOOL", "; is wanted"),
    ("    s : BOOL;", "    s : INT;", "no type"),
    ("    s : BOOL;", "    s : bool;", "no type"),
    ("    s : BOOL;", "    A : BOOL;\n    s : BOOL;", "declared twice"),
    ("    s : BOOL;", "    Limit : BOOL;\n    s : BOOL;", "no name"),
    ("    s : BOOL;", "    udint_to_real : BOOL;\n    s : BOOL;", "no name"),
    ("    s : BOOL;", "    s_ : BOOL;\n    s : BOOL;", "no name"),
    ("    s : BOOL;", "    s : BOOL := 0;", "its value is of another type"),
    ("a : LREAL := 0.0", "a : LREAL := 0", "its value is of another type"),
    ("a : LREAL := 0.0", "a : LREAL := 1.0E+999", "its value is of another type"),
    ("d : REAL := -2.0", "d : REAL := 3.5E+38", "its value is of another type"),
    ("n : UDINT := 0", "n : UDINT := -1", "its value is of another type"),
    ("n : UDINT := 0", "n : UDINT := 4294967296", "its value is of another type"),
    ("i : DINT := -1", "i : DINT := 2147483648", "its value is of another type"),
    ("i : DINT := -1", "i : DINT := 1.0", "its value is of another type"),
    ("t : LREAL;", "t : LREAL := 0.0;", "a temporary with a value"),
    ("c : LREAL := 1.5E-3", "c : LREAL", "a constant without a value"),
    ("c : LREAL := 1.5E-3", "c : LREAL := 1.5 * 2.0", "; is wanted"),
    ("c : LREAL := 1.5E-3", "c : LREAL := --1.5", "an operand is wanted"),
    // numbers
    ("1.5E-3", "1.E-3", "ends with its point"),
    ("1.5E-3", ".5", "`.`"),
    ("1.5E-3", "1.5E3", "an exponent without sign or digits"),
    ("1.5E-3", "1.5E-", "an exponent without sign or digits"),
    ("1.5E-3", "1E-3", "goes on"),
    ("1.5E-3", "16#1", "goes on"),
    ("1.5E-3", "1_0.0", "goes on"),
    // comments and letters
    ("(* c *)", "(* c", "a comment in a comment"),
    ("#p :=", "(* c\n#p :=", "a comment without end"),
    ("(* c *)", "// c\n", "`/`"),
    ("(* c *)", "\t", "`\t`"),
    ("#o", "\u{e4}", "`\u{e4}`"),
    // statements
    ("#s := (-#c", "s := (-#c", "END_FUNCTION_BLOCK is wanted"),
    ("#o := -#t;", "#o := -t;", "an operand is wanted"),
    ("#o := -#t;", "#o = -#t;", ":= is wanted"),
    ("#o := -#t;", "#o := -#t", "; is wanted"),
    ("#o := -#t;", ";", "END_FUNCTION_BLOCK is wanted"),
    ("#o := -#t;", "RETURN;", "END_FUNCTION_BLOCK is wanted"),
    ("#o := -#t;", "#o := - -#t;", "an operand is wanted"),
    ("#o := -#t;", "#o := ABS(#t);", "is no conversion"),
    ("#o := -#t;", "#o := UDINT_TO_LREAL(#i);", "Dint instead of Udint"),
    ("#o := -#t;", "#o := (#t;", ") is wanted"),
    ("END_IF;", "END_IF", "; is wanted"),
    ("END_IF;\n", "", "END_IF is wanted"),
    (" THEN\n    #t := UDINT", "\n    #t := UDINT", "THEN is wanted"),
    ("    #t := 0.0;\n", "", "a statement is wanted"),
    // names
    ("#o := -#t;", "#q := -#t;", "#q: not declared"),
    ("#o := -#t;", "#o := -#q;", "#q is not declared"),
    ("#o := -#t;", "#a := -#t;", "#a: must not be written"),
    ("#o := -#t;", "#c := -#t;", "#c: must not be written"),
    // types
    ("#o := -#t;", "#o := #r;", "Real instead of Lreal"),
    ("#o := -#t;", "#o := #t * #r;", "Real instead of Lreal"),
    ("#o := -#t;", "#o := #t * 2;", "takes no type here"),
    ("#o := -#t;", "#o := #t * 2.0;", "a real number without a name"),
    ("#o := -#t;", "#o := 2;", "takes no type here"),
    ("#o := -#t;", "#o := 2.0 * 3.0;", "takes no type here"),
    ("#o := -#t;", "#o := #s;", "Bool instead of Lreal"),
    ("#o := -#t;", "#o := -#s;", "- of Bool"),
    ("#o := -#t;", "#s := NOT #n;", "NOT of Udint"),
    ("#o := -#t;", "#s := #n AND #n;", "AND of Udint"),
    ("#o := -#t;", "#s := #s < #s;", "< of Bool"),
    ("#o := -#t;", "#s := #s + #s;", "+ of Bool"),
    ("#o := -#t;", "#s := #n = #i;", "Dint instead of Udint"),
    ("#o := -#t;", "#s := #n = 1.0;", "takes no type here"),
    ("#i = 2", "#i / 2 = 1", "/ of Dint"),
    ("#i = 2", "#i", "Dint instead of Bool"),
    // temporaries
    ("#a - #c", "#a - #t", "#t is read before"),
    ("#i = 2", "#t = #a", "#t is read before"),
    ("ELSE\n    #t := 0.0;\n", "", "#t is read before"),
    ("    #t := 0.0;\n", "    #o := 0.0;\n", "#t is read before"),
    ("    #t := #c * (#a - #c);\n", "    #s := TRUE;\n", "#t is read before"),
    ("IF (#n <> 0)", "#o := #t;\nIF (#n <> 0)", "#t is read before"),
];

#[test]
fn every_mistake_is_refused_for_its_reason() {
    for (from, to, reason) in MISTAKES {
        let source = source();
        assert!(source.contains(from), "{from}");
        match check(&source.replacen(from, to, 1)) {
            Ok(_) => panic!("`{from}` -> `{to}` passes"),
            Err(said) => assert!(said.contains(reason), "`{from}` -> `{to}`: {said}"),
        }
    }
}
