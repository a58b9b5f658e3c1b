//! What improved position control promises its caller, in both real types. The coefficients are those of a rack-and-pinion
//! axis, typed in: no design here.
#![forbid(unsafe_code)]

mod bench;
mod fade;
mod faults;
mod filters;
mod limit;

/// Makes a test for each real type of a function that is generic over it.
macro_rules! in_both_real_types {
    ($($name:ident)+) => {
        $(mod $name {
            #[test]
            fn f64() {
                super::$name::<f64>();
            }
            #[test]
            fn f32() {
                super::$name::<f32>();
            }
        })+
    };
}
use in_both_real_types;
