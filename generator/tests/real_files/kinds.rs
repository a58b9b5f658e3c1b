//! Files of another kind: one message, which says what the file seems to be.

use super::{VALID, read};

fn assert_seems(name: &str, content: &str, seems: &str) {
    let (set, report) = read(&[(name, content.as_bytes())]);
    assert!(set.is_none(), "{name}: {content}");
    let [said] = report.diagnostics.as_slice() else { panic!("{name}: one message, not {report}") };
    assert!(said.code == "AX110" && said.found.contains(seems) && said.instead.is_some(), "{said}");
}

#[test]
fn a_list_that_is_none() {
    for (content, seems) in [
        ("", "is empty"),
        ("\n \n# nothing\n", "is empty"),
        ("%main\nN10 G1 X10 F1000\nN20 G135\nM30\n", "an NC program"),
        ("N10 G0 X0\nN20 S[G136=80]\n", "an NC program"),
        ("G135\nG136 X80\n", "an NC program"),
        ("cycle_time = \"1ms\"\n[axis.X]\nlist = \"x.lis\"\n", "a set in TOML"),
        ("[axis.X]\nlist=\"x.lis\"\n", "a set in TOML"),
        ("gruppe[0].achs_anzahl 3\ngruppe[0].achse[0].log_achs_nr 1\n", "a channel list"),
        ("spindel[0].bezeichnung S\n", "a channel list"),
        ("kanal_anzahl 1\nkanal[0].sda_mds sda.lis\n", "a start-up list"),
        ("some text\nwithout a parameter\n", "of another kind"),
        ("a;b;c\n1;2;3\n", "of another kind"),
    ] {
        assert_seems("x.lis", content, seems);
        // In a set the same is said of the list.
        let set = "cycle_time = \"1ms\"\n[axis.X]\nlist = \"x.lis\"\n";
        let said = read(&[("set.toml", set.as_bytes()), ("x.lis", content.as_bytes())]).1.to_string();
        assert!(said.contains("x.lis: error[AX110]") && said.contains(seems), "{said}");
    }
}

#[test]
fn a_set_that_is_an_axis_list() {
    assert_seems("x.toml", VALID, "an axis list, and is named as a set");
    // A set with one bad line is a set.
    let said = read(&[("x.toml", b"cycle_time = \"1ms\"\n[axis.X]\nkopf.achs_nr 1\n")]).1.to_string();
    assert!(
        said.starts_with(
            "x.toml:3:1: error[AX004]: between key and value there is no `=`\n    write instead: kopf.achs_nr = 1\n"
        ),
        "{said}"
    );
}

#[test]
fn a_list_of_other_functions_only_is_a_list() {
    let (set, report) = read(&[("x.lis", b"kenngr.swe_pos 1\nkopf.mds_ident 1\n")]);
    assert!(set.is_some() && report.to_string().contains("AX401"), "{report}");
}

/// Parameters of other functions whose names end as ours do, as the vendor's documents have them.
#[test]
fn filters_of_other_functions_are_theirs() {
    let others = "filter[0].enable 1\nfilter[0].fg_f0 30\nfilter[0].guete 1\nfilter[0].order 2\nfilter[0].prototype 1\nfilter[0].type 1\n\
                  filter_fir.enable 0\nfilter_fir.type 1\nfilter_fir.order 3\nlr_param.add_interface.filter[0].fg_f0 30\n\
                  lr_param.add_interface.filter[0].enable 0\nkenngr.dist_ctrl[0].low_pass_filter_fg_f0 25\n";
    let (set, report) = read(&[("x.lis", format!("{VALID}{others}").as_bytes())]);
    let said = "x.lis:12:18: warning[AX467]: the command filter filter[0] is on (P-AXIS-00319, 00140): it delays the command, and turns its phase\n    \
                write instead: the filter off while the stages are tuned; or tune with it, and again when it changes\n";
    assert_eq!((set.unwrap().foreign, report.to_string().as_str()), (12, said));
}
