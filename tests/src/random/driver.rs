// Runs every program of a file on the words of another one and compares: outputs, and the state that the program keeps. `Real` is the
// real type, `Bits` the unsigned integer of the same size, `run_all` the programs: the file that includes this one has them.
// For each program that differs one line: its number, run, sample, scalar, the bits found, the bits that the reference has.
pub struct File {
    words: std::vec::IntoIter<u64>,
}

impl File {
    fn next(&mut self) -> u64 {
        self.words.next().expect("the words have not ended")
    }
}

/// Bits, whether they are those of a real number, and whose they are.
pub type Found = (u64, bool, &'static str);

pub trait Words: Default {
    fn put(&mut self, words: &mut File);
    fn get(&self, found: &mut Vec<Found>);
}

fn real(word: u64) -> Real {
    Real::from_bits(word as Bits)
}

fn nearest(value: Real) -> i32 {
    let nearly_half = if size_of::<Real>() == 4 { 0.49999997_f32 as Real } else { 0.49999999999999994_f64 as Real };
    (if value < 0.0 { value - nearly_half } else { value + nearly_half }) as i32
}

fn run<S: Words, I: Words, O: Words>(number: usize, words: &mut File, init: fn(&mut S), step: fn(&mut S, &I, &mut O)) {
    let (runs, samples) = (words.next(), words.next());
    let (mut state, mut outputs) = (S::default(), O::default());
    // The same start for every run.
    let start = words.words.clone();
    state.put(words);
    outputs.put(words);
    let mut differs = false;
    for run in 0..runs {
        let (mut state, mut inputs, mut outputs) = (S::default(), I::default(), O::default());
        let mut from = File { words: start.clone() };
        state.put(&mut from);
        outputs.put(&mut from);
        init(&mut state);
        for sample in 0..samples {
            inputs.put(words);
            step(&mut state, &inputs, &mut outputs);
            let mut found = Vec::new();
            outputs.get(&mut found);
            state.get(&mut found);
            for (bits, is_real, path) in found {
                let expected = words.next();
                let same = bits == expected || is_real && real(bits).is_nan() && real(expected).is_nan();
                if !same && !differs {
                    differs = true;
                    println!(
                        "{number}\trun {run}, sample {sample}: {path} has the bits {bits:x}, in Rust it has {expected:x}"
                    );
                }
            }
        }
    }
}

fn main() {
    let path = std::env::args().nth(1).expect("a file of words");
    let bytes = std::fs::read(path).expect("the file of words");
    let words: Vec<u64> = bytes.chunks_exact(8).map(|word| u64::from_ne_bytes(word.try_into().unwrap())).collect();
    run_all(&mut File { words: words.into_iter() });
    println!("{PROGRAMS} programs have run");
}
