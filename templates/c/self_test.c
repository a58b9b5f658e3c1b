#include "{{ header }}"

{% include "c/guards.h" %}

static uint{{ bits }}_t {{ block.prefix }}_bits_of({{ real }} value)
{
    union {
        {{ real }} value;
        uint{{ bits }}_t bits;
    } view;
    view.value = value;
    return view.bits;
}

static {{ real }} {{ block.prefix }}_real_of(uint{{ bits }}_t bits)
{
    union {
        {{ real }} value;
        uint{{ bits }}_t bits;
    } view;
    view.bits = bits;
    return view.value;
}

static uint{{ bits }}_t {{ block.prefix }}_fold(uint{{ bits }}_t digest, uint{{ bits }}_t bits)
{
    return ((digest << 5) | (digest >> {{ bits - 5 }})) + bits;
}

uint32_t {{ block.prefix }}_self_test(void)
{
    /* the reference's digest of all outputs and of the state, after each sample */
    static const uint{{ bits }}_t expected[{{ expected.len() }}] = {
{%- for digest in expected %}
        {{ digest }},
{%- endfor %}
    };
    /* volatile: the compiler must call what the caller calls, and not work it out by itself */
    void (*volatile step)(
        {{ block.prefix }}_state *,
        const {{ block.prefix }}_inputs *,
        {{ block.prefix }}_outputs *) = {{ block.prefix }}_step;
    {{ block.prefix }}_state state;
    {{ block.prefix }}_inputs inputs;
    {{ block.prefix }}_outputs outputs;
    uint{{ bits }}_t digest = 0u;
{%- if !self_test.bad.is_empty() %}
    uint32_t random = 1u;
{%- endif %}
    uint32_t sample;
    /* 1 + 2^-{% if real == "double" %}30{% else %}15{% endif %} and its rounded square; volatile: worked out when it runs */
    volatile {{ real }} factor = {{ block.prefix }}_real_of({% if real == "double" %}UINT64_C(0x3ff0000000400000){% else %}UINT32_C(0x3f800100){% endif %});
    volatile {{ real }} square = {{ block.prefix }}_real_of({% if real == "double" %}UINT64_C(0x3ff0000000800000){% else %}UINT32_C(0x3f800200){% endif %});
    const {{ real }} one = factor;
    const {{ real }} product = one * one;
    const {{ real }} remainder = product - square;

    /* 0, unless the compiler fuses a product with the sum behind it: noise alone shows that too rarely */
    if ({{ block.prefix }}_bits_of(remainder) != 0u) {
        return 1u;
    }
{%- if real == "double" %}
    /* as it stands here, unless the compiler takes constants for single precision */
    if ({{ block.prefix }}_bits_of(0.1) != UINT64_C(0x3fb999999999999a)) {
        return 1u;
    }
{%- endif %}

    {{ block.prefix }}_init(&state);
    {{ block.prefix }}_inputs_init(&inputs);
{%- for (input, value) in switches %}
    inputs.{{ block.inputs[*input].name }} = {{ value }};
{%- endfor %}
    for (sample = 0u; sample < {{ expected.len() }}u; sample++) {
{%- if self_test.is_scaled() %}
        /* at first within every limit, so that nothing is cut off */
        const {{ real }} scale = sample < {{ self_test.loud_from }}u ? {{ scales[0] }} : {{ scales[1] }};
{%- endif %}
{%- if !self_test.bad.is_empty() %}
        /* noise; each input is no number for one sample: a block that does not notice it goes on with other bits */
        uint{{ bits }}_t noise;
{%- endif %}
{%- for (bad_sample, input) in self_test.bad %}
        random = random * 1664525u + 1013904223u;
        noise = {{ block.prefix }}_bits_of({% if input.is_fraction %}({{ real }})(random >> 8) * {{ part }}{% else %}(({{ real }})(random >> 8) - 8388608.0{{ suffix }}) * scale{% endif %});
        inputs.{{ block.inputs[input.own].name }} = {{ block.prefix }}_real_of(sample == {{ bad_sample }}u ? {% if real == "double" %}UINT64_C(0x7ff8000000000000){% else %}UINT32_C(0x7fc00000){% endif %} : noise);
{%- endfor %}
        step(&state, &inputs, &outputs);
{%- for value in watched %}
        digest = {{ block.prefix }}_fold(digest, {{ value }});
{%- endfor %}
        if (digest != expected[sample]) {
            return sample + 1u;
        }
    }
    return 0u;
}

{% include "c/guards_end.h" %}
