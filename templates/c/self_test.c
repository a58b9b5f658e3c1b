#include "{{ header }}"

{% include "c/guards.h" %}

static uint{{ exercise.bits }}_t {{ block.prefix }}_bits_of({{ exercise.real }} value)
{
    union {
        {{ exercise.real }} value;
        uint{{ exercise.bits }}_t bits;
    } view;
    view.value = value;
    return view.bits;
}

static {{ exercise.real }} {{ block.prefix }}_real_of(uint{{ exercise.bits }}_t bits)
{
    union {
        {{ exercise.real }} value;
        uint{{ exercise.bits }}_t bits;
    } view;
    view.bits = bits;
    return view.value;
}

{{ exercise }}

uint32_t {{ block.prefix }}_self_test(void)
{
    /* the reference's digest of all outputs and of the state, after each sample */
    static const uint32_t expected[{{ self_test.expected.len() }}] = {
    {{ exercise.expected }}
    };
    /* volatile: the compiler must call the same function as the caller and must not evaluate it at compile time */
    void (*volatile step)(
        {{ block.prefix }}_state *,
        const {{ block.prefix }}_inputs *,
        {{ block.prefix }}_outputs *) = {{ block.prefix }}_step;
    {{ block.prefix }}_state state;
    {{ block.prefix }}_inputs inputs;
    {{ block.prefix }}_outputs outputs;
    uint32_t digest = 0u;
{%- if !self_test.bad.is_empty() %}
    uint32_t random = 0u;
    const {{ exercise.real }} not_a_number = {{ block.prefix }}_real_of({% if exercise.bits == 64 %}UINT64_C(0x7ff8000000000000){% else %}UINT32_C(0x7fc00000){% endif %});
{%- endif %}
    uint32_t sample;
    /* 1 + 2^-{% if exercise.real == "double" %}30{% else %}15{% endif %} and its rounded square; volatile: evaluated at run time */
    volatile {{ exercise.real }} factor = {{ block.prefix }}_real_of({% if exercise.real == "double" %}UINT64_C(0x3ff0000000400000){% else %}UINT32_C(0x3f800100){% endif %});
    volatile {{ exercise.real }} square = {{ block.prefix }}_real_of({% if exercise.real == "double" %}UINT64_C(0x3ff0000000800000){% else %}UINT32_C(0x3f800200){% endif %});
    const {{ exercise.real }} one = factor;
    const {{ exercise.real }} product = one * one;
    const {{ exercise.real }} remainder = product - square;

    /* 0, unless the compiler fuses the product with the following sum; noise alone detects that too rarely */
    if ({{ block.prefix }}_bits_of(remainder) != 0u) {
        return 1u;
    }
{%- if exercise.real == "double" %}
    /* not equal if the compiler treats constants as single precision */
    if ({{ block.prefix }}_bits_of(0.1) != UINT64_C(0x3fb999999999999a)) {
        return 1u;
    }
{%- endif %}

    {{ block.prefix }}_init(&state);
    {{ block.prefix }}_inputs_init(&inputs);
{%- for (input, value) in exercise.usual %}
    inputs.{{ input }} = {{ value }};
{%- endfor %}
    for (sample = 0u; sample < {{ self_test.expected.len() }}u; sample++) {
{%- if exercise.is_scaled %}
        /* the first samples stay within every limit, so that nothing is cut off */
        const {{ exercise.real }} scale = sample < {{ self_test.loud_from }}u ? {{ exercise.scales[0] }} : {{ exercise.scales[1] }};
{%- endif %}
{%- if let Some(counter) = exercise.counter %}
        inputs.{{ counter }} = sample + 1u;
{%- endif %}
{%- for (input, noise) in exercise.reals %}
        inputs.{{ input }} = {{ noise }};
{%- endfor %}
{%- for (bad_sample, _) in self_test.bad %}
{%- if loop.first %}
        /* each input is NaN for one sample; a build that does not detect it goes on with different bits */
{%- endif %}
        if (sample == {{ bad_sample }}u) {
            inputs.{{ exercise.reals[loop.index0].0 }} = not_a_number;
        }
{%- endfor %}
        step(&state, &inputs, &outputs);
{%- for value in exercise.folded %}
        digest = {{ value }};
{%- endfor %}
        if (digest != expected[sample]) {
            return sample + 1u;
        }
    }
    return 0u;
}

{% include "c/guards_end.h" %}
