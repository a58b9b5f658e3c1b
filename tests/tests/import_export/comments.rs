//! Where the comments of a list stand in its set.

use super::{IPC, round_trip};

#[test]
fn comments_stand_above_and_beside_the_values_they_stood_with() {
    let list = "\
# file

#   indented \t
(bracket
kopf.achs_nr 1 ( beside

# about a foreign one
kenngr.foreign 1 # foreign
# axis type

kenngr.achs_typ 1#no blank
# at the end
";
    let set = round_trip(list.as_bytes());
    let expected = "
# file

#   indented
# (bracket
[axis.X]
kopf.achs_nr = 1 # ( beside
# axis type

kenngr.achs_typ = 1 #no blank

# The list, line by line";
    assert!(set.contains(expected), "{set}");
}

#[test]
fn a_comment_within_a_filter_makes_it_a_table_of_its_own() {
    let list = "ipc.enable ON\nipc.stage[0].filter[0].order 1 # low\nipc.stage[0].filter[0].fg_f0 5\nipc.stage[0].filter[1].order 2\n";
    let set = round_trip(list.replace("ipc.", IPC).as_bytes());
    let expected = "
[[axis.X.ipc.stage]]

[[axis.X.ipc.stage.filter]]
order = 1 # low
fg_f0 = 5

[[axis.X.ipc.stage.filter]]
order = 2
";
    assert!(set.contains(&expected.replace("ipc.", IPC)), "{set}");
}
