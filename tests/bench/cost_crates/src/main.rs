//! Three stages of two sections in single precision by other crates: `biquad` or `idsp`, and how many calls. callgrind counts
//! `measured_biquad` and `measured_idsp`.

use biquad::{Biquad as _, Coefficients, DirectForm2Transposed};
use idsp::iir::Biquad;
use std::hint::black_box;

const WEIGHTS: [f32; 3] = [1.0, 0.5, 0.25];

#[unsafe(no_mangle)]
#[inline(never)]
fn measured_biquad(stages: &mut [[DirectForm2Transposed<f32>; 2]; 3], x: f32) -> f32 {
    let mut sum = 0.0;
    for (stage, weight) in stages.iter_mut().zip(black_box(&WEIGHTS)) {
        sum -= weight * stage.iter_mut().fold(x, |x, section| section.run(x));
    }
    sum
}

#[unsafe(no_mangle)]
#[inline(never)]
fn measured_idsp(sections: &[[Biquad<f32>; 2]; 3], states: &mut [[[f32; 2]; 2]; 3], x: f32) -> f32 {
    let mut sum = 0.0;
    for ((stage, states), weight) in sections.iter().zip(states).zip(black_box(&WEIGHTS)) {
        let step = |x, (section, state): (&Biquad<f32>, &mut [f32; 2])| section.update(state, x);
        sum -= weight * stage.iter().zip(states).fold(x, step);
    }
    sum
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let crate_name = arguments.next().unwrap_or_default();
    let calls: u32 = arguments.next().and_then(|text| text.parse().ok()).unwrap_or(100);
    let section = Coefficients { b0: 0.02, b1: 0.0, b2: -0.02, a1: -1.8, a2: 0.9 };
    let mut stages = black_box([[DirectForm2Transposed::<f32>::new(section); 2]; 3]);
    let sections = black_box([(); 3].map(|()| [(); 2].map(|()| Biquad::from(&[[0.02, 0.0, -0.02], [1.0, -1.8, 0.9]]))));
    let mut states = [[[0.0; 2]; 2]; 3];
    let mut sum = 0.0;
    for call in 0..calls {
        let x = (call % 17) as f32;
        sum += if crate_name == "idsp" {
            measured_idsp(&sections, &mut states, x)
        } else {
            measured_biquad(&mut stages, x)
        };
    }
    println!("{sum}");
}
