//! Numbers of double precision rounded to 24 bits, so that a conversion to single precision is exact in every language, whatever
//! rounding it uses.

use crate::filter::{MAX_ORDER, Type};
use crate::stage::{Coeffs, FILTERS, Mode, Numbers};
use crate::{allpass, bandpass, oscillation};
use portable::{Real, portable};

/// x rounded to 24 bits: Veltkamp's split by 2^29 + 1. For a normal number of single precision, that is the nearest one.
#[portable]
pub fn narrow<R: Real>(x: R) -> R {
    let t = R::lit(536_870_913.0) * x;
    t - (t - x)
}

/// Rounds the numbers of a stage that a block in single precision uses.
#[portable]
pub fn stage<R: Real>(numbers: &mut Numbers<R>, structure: &Coeffs<R>) {
    if structure.mode != Mode::Direct {
        oscillation_section(&mut numbers.oscillation);
    }
    for k in 0..FILTERS {
        match structure.filter[k].kind {
            Type::NoFilter => {}
            Type::Bandpass => {
                for i in 0..MAX_ORDER {
                    if i < structure.filter[k].order {
                        bandpass_section(&mut numbers.filter[k].bandpass[i]);
                    }
                }
            }
            Type::Allpass => allpass_section(&mut numbers.filter[k].allpass),
        }
    }
    numbers.gain = narrow(numbers.gain);
}

/// Rounds the numbers of a band-pass section.
#[portable]
pub fn bandpass_section<R: Real>(coeffs: &mut bandpass::Coeffs<R>) {
    coeffs.a = narrow(coeffs.a);
    coeffs.b = narrow(coeffs.b);
    coeffs.c = narrow(coeffs.c);
}

/// Rounds the numbers of an all-pass section.
#[portable]
pub fn allpass_section<R: Real>(coeffs: &mut allpass::Coeffs<R>) {
    coeffs.a = narrow(coeffs.a);
    coeffs.b = narrow(coeffs.b);
    coeffs.c = narrow(coeffs.c);
}

/// Rounds the numbers of the simulated oscillation.
#[portable]
pub fn oscillation_section<R: Real>(coeffs: &mut oscillation::Coeffs<R>) {
    coeffs.h = narrow(coeffs.h);
    coeffs.r = narrow(coeffs.r);
    coeffs.g = narrow(coeffs.g);
    coeffs.g2 = narrow(coeffs.g2);
}
