/// Runs {{ self_test.expected.len() }} samples and compares outputs and state with the bits of the reference. Returns 0 if all
/// bits are equal, otherwise the number of the first sample that differs; 1 also if the build fuses a product with a sum. Call
/// it once at start-up on the machine. It also detects a build that reorders floating-point operations or treats a NaN as a
/// number.
#[must_use]
#[allow(clippy::all, clippy::pedantic)] // generated arithmetic, some factors are equal
#[rustfmt::skip]
pub fn self_test() -> u32 {
    // the reference's digest of all outputs and of the state, after each sample
    const EXPECTED: [u32; {{ self_test.expected.len() }}] = [
{%- for digest in self_test.expected %}
        {{ "0x{:08x}"|format(digest) }},
{%- endfor %}
    ];
    // opaque: the compiler must call the same function as the caller and must not evaluate it at compile time
    let step: fn(&mut State, &Inputs, &mut Outputs) = core::hint::black_box(step);
    // 1 + 2^-{% if bits == 64 %}30{% else %}15{% endif %} and its rounded square
    let factor = core::hint::black_box({{ real }}::from_bits({% if bits == 64 %}0x3ff0_0000_0040_0000{% else %}0x3f80_0100{% endif %}));
    let square = core::hint::black_box({{ real }}::from_bits({% if bits == 64 %}0x3ff0_0000_0080_0000{% else %}0x3f80_0200{% endif %}));
    // 0, unless the compiler fuses the product with the following sum; noise alone detects that too rarely
    if (factor * factor - square).to_bits() != 0 {
        return 1;
    }

    let mut state = State::new();
    let {% if !usual.is_empty() || counter.is_some() || !self_test.bad.is_empty() %}mut {% endif %}inputs = Inputs::new();
    let mut outputs = Outputs::new();
{%- for (input, value) in usual %}
    inputs.{{ input }} = {{ value }};
{%- endfor %}
{%- if !self_test.bad.is_empty() %}
    let mut random: u32 = 0;
    // next integer of the pseudo-random noise
    let mut integer = || {
        random = random.wrapping_mul({{ Noise::FACTOR }}).wrapping_add({{ Noise::SUMMAND }}) % {{ Noise::RANGE }};
        random
    };
{%- if self.is_scaled() %}
    // a real sample of the noise; one in four is small
    let noise = |integer: u32, scale: {{ real }}| {
        let noise = ({% if bits == 64 %}f64::from(integer){% else %}integer as f32{% endif %} - {{ Noise::HALF }}.0) * scale;
        if integer < {{ Noise::SMALL_BELOW }} { noise * {{ Noise::SMALL }} } else { noise }
    };
{%- endif %}
    let not_a_number = {{ real }}::from_bits({% if bits == 64 %}0x7ff8_0000_0000_0000{% else %}0x7fc0_0000{% endif %});
{%- endif %}
    let fold = |digest: u32, word: u32| (digest.rotate_left(5) ^ word).wrapping_mul(0x9e37_79b1);
    let mut digest: u32 = 0;
    let mut sample: u32 = 0;
    for expected in &EXPECTED {
{%- if let Some(counter) = counter %}
        inputs.{{ counter }} = sample.wrapping_add(1);
{%- endif %}
{%- if self.is_scaled() %}
        // the first samples stay within every limit, so that nothing is cut off
        let scale = if sample < {{ self_test.loud_from }} { {{ scales[0] }} } else { {{ scales[1] }} };
{%- endif %}
{%- for (bad_sample, input) in self_test.bad %}
{%- if loop.first %}
        // each input is NaN for one sample; a build that does not detect it goes on with different bits
{%- endif %}
        let value = {% if input.is_fraction %}{% if bits == 64 %}f64::from(integer()){% else %}integer() as f32{% endif %} * {{ part }}{% else %}noise(integer(), scale){% endif %};
        inputs.{{ inputs[input.in_axis].name }} = if sample == {{ bad_sample }} { not_a_number } else { value };
{%- endfor %}
        step(&mut state, &inputs, &mut outputs);
{%- for words in watched %}
        digest = fold(digest, {{ words[0] }});
{%- if !words[1].is_empty() %}
        digest = fold(digest, {{ words[1] }});
{%- endif %}
{%- endfor %}
        sample = sample.wrapping_add(1);
        if digest != *expected {
            return sample;
        }
    }
    0
}

#[cfg(test)]
mod tests {
    #[test]
    fn this_build_has_the_bits_of_the_reference() {
        assert_eq!(super::self_test(), 0);
    }
}
