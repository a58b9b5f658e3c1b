//! Texts: the name that was meant, by the definition of the distance of two names; paths of other hosts.

use super::sets::Random;
use generator::config::closest::all_nearest;
use generator::diagnostics::with_slashes;

/// No filter may reject a near name.
#[test]
fn the_nearest_names_are_those_of_the_definition() {
    let mut random = Random(1);
    for _ in 0..20_000 {
        let [name, a, b] = [(); 3].map(|()| {
            let length = random.below(9);
            (0..length).map(|_| char::from(b"abAB_1q"[random.below(7)])).collect::<String>()
        });
        let distance = |of: &str| strsim::osa_distance(&name.to_ascii_lowercase(), &of.to_ascii_lowercase());
        let least = distance(&a).min(distance(&b)).min(1 + name.len() / 4);
        let expected: Vec<&str> = [a.as_str(), &b].into_iter().filter(|of| distance(of) == least).collect();
        assert_eq!(all_nearest(&name, [a.as_str(), &b].into_iter()), expected, "{name}");
    }
}

#[test]
fn paths_of_any_host_have_one_separator() {
    assert_eq!(with_slashes(r"\\server\share\axes/lists\x 1.lis", '\\'), "//server/share/axes/lists/x 1.lis");
    assert_eq!(with_slashes(r"a\b/c", '/'), r"a\b/c");
}
