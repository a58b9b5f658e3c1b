//! Numbers with N significant digits: those of the correctly rounded decimal, whatever the way to them.

use generator::number::significant;

/// Numbers with few digits, with all of them, on a tie, and at the ends of the range.
fn numbers() -> impl Iterator<Item = f64> {
    let exact = [0.0, -0.0, 1.0, 10.0, 0.05, 1e-5, 1e11, 1e12, 123_456.5, 1.5, 2.5, 0.125, 1e300, 5e-324, f64::MAX];
    let random = (1..20_000_u64).map(|index| {
        let mixed = index.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        f64::from_bits(mixed ^ mixed >> 29)
    });
    let short = (1..2_000_u32).map(|index| f64::from(index) / 1000.0);
    exact.into_iter().chain(short).chain(random.filter(|number| number.is_finite()))
}

#[test]
fn significant_digits_are_those_of_the_rounded_decimal() {
    for number in numbers().flat_map(|number| [number, -number]) {
        for digits in 1..=17_u32 {
            let text = significant(number, digits);
            let rounded = format!("{number:.*e}", digits as usize - 1);
            assert_eq!(
                text.parse::<f64>(),
                rounded.parse::<f64>(),
                "{number:e} with {digits} digits: {text}, {rounded}"
            );
            let mantissa = text.split('e').next().unwrap_or_default();
            assert!(!mantissa.contains('.') || !mantissa.ends_with(['0', '.']), "{text} ends with a zero");
            let all: String = mantissa.chars().filter(char::is_ascii_digit).collect();
            assert!(all.trim_matches('0').len() <= digits as usize, "{text} has more than {digits} digits");
        }
    }
}
