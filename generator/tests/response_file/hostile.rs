//! Files that are cut or damaged: a verdict or a response, never a panic.

use super::plant::{decibels, degrees, lines, velocity_loop};
use super::{BANDS, COMMAND, CYCLE_TIME, table};
use generator::response_file::{From, read};

#[test]
fn damaged_files_do_not_panic() {
    let whole = table("f [Hz];magnitude [dB];phase [deg];coherence;averages", &lines()[..400], |hz| {
        format!("{:.4};{:.4};0.98;20", decibels(velocity_loop(hz)), degrees(velocity_loop(hz)))
    });
    let open = From::Current { kp: 2.0, tn: 0.02, delay: 2e-3 };
    let (mut noise, mut refused) = (1_u32, 0);
    for round in 0..400_usize {
        let mut bytes = whole.as_bytes()[..whole.len() - 7 * round].to_vec();
        for _ in 0..round % 4 {
            noise = noise.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let at = usize::try_from(noise >> 8).unwrap() % bytes.len();
            bytes[at] = b"0123456789-+eE.,;\t\n\"#%\0\xff\xe4[] nN"[usize::try_from(noise % 30).unwrap()];
        }
        for from in [COMMAND, open] {
            match read("p.csv", &bytes, from, CYCLE_TIME, &BANDS) {
                Ok(measured) => assert!(measured.response.value(53.0).norm().is_finite()),
                Err(report) => {
                    assert!(report.has_errors());
                    refused += 1;
                }
            }
        }
    }
    assert!((400..800).contains(&refused), "{refused}");
}
