static uint{{ bits }}_t bits_of({{ real }} value)
{
    union {
        {{ real }} value;
        uint{{ bits }}_t bits;
    } view;
    view.value = value;
    return view.bits;
}

static {{ real }} real_of(uint{{ bits }}_t bits)
{
    union {
        {{ real }} value;
        uint{{ bits }}_t bits;
    } view;
    view.bits = bits;
    return view.value;
}

static uint{{ bits }}_t fold(uint{{ bits }}_t digest, uint{{ bits }}_t bits)
{
    return ((digest << 5) | (digest >> {{ bits - 5 }})) + bits;
}

uint32_t {{ prefix }}_self_test(void)
{
    /* the reference's digest of all outputs and of the state, after each sample */
    static const uint{{ bits }}_t expected[{{ block.expected.len() }}] = {
{%- for digest in block.expected %}
        {{ digest }},
{%- endfor %}
    };
    /* volatile: the compiler must call what the caller calls, and not work it out by itself */
    void (*volatile step)({{ prefix }}_state *, const {{ prefix }}_inputs *, {{ prefix }}_outputs *) =
        {{ prefix }}_step;
    {{ prefix }}_state state;
    {{ prefix }}_inputs inputs;
    {{ prefix }}_outputs outputs;
    uint{{ bits }}_t digest = 0u;
    uint{{ bits }}_t noise;
    {{ real }} scale;
    uint32_t random = 1u;
    uint32_t sample;
    /* 1 + 2^-{% if real == "double" %}30{% else %}15{% endif %} and its rounded square; volatile: worked out when it runs */
    volatile {{ real }} factor = real_of({% if real == "double" %}UINT64_C(0x3ff0000000400000){% else %}UINT32_C(0x3f800100){% endif %});
    volatile {{ real }} square = real_of({% if real == "double" %}UINT64_C(0x3ff0000000800000){% else %}UINT32_C(0x3f800200){% endif %});
    const {{ real }} product = factor * factor;
    const {{ real }} remainder = product - square;

    /* 0, unless the compiler fuses a product with the sum behind it: noise alone shows that too rarely */
    if (bits_of(remainder) != 0u) {
        return 1u;
    }
{%- if real == "double" %}
    /* as it stands here, unless the compiler takes constants for single precision */
    if (bits_of(0.1) != UINT64_C(0x3fb999999999999a)) {
        return 1u;
    }
{%- endif %}

    {{ prefix }}_init(&state);
    {{ prefix }}_inputs_init(&inputs);
{%- for (input, value) in block.switches %}
    inputs.{{ block.inputs[*input].name }} = {{ value }};
{%- endfor %}
    for (sample = 0u; sample < {{ block.expected.len() }}u; sample++) {
        /* at first within every limit, so that nothing is cut off */
        scale = sample < {{ block.self_test.loud_from }}u ? {{ block.scales[0] }} : {{ block.scales[1] }};
        /* noise; each input is no number for one sample: a block that does not notice it goes on with other bits */
{%- for (bad_sample, input) in block.self_test.bad %}
        random = random * 1664525u + 1013904223u;
        noise = bits_of((({{ real }})(random >> 8) - 8388608.0{{ suffix }}) * scale);
        inputs.{{ block.inputs[*input].name }} = real_of(sample == {{ bad_sample }}u ? {% if real == "double" %}UINT64_C(0x7ff8000000000000){% else %}UINT32_C(0x7fc00000){% endif %} : noise);
{%- endfor %}
        step(&state, &inputs, &outputs);
{%- for value in block.watched %}
        digest = fold(digest, {{ value }});
{%- endfor %}
        if (digest != expected[sample]) {
            return sample + 1u;
        }
    }
    return 0u;
}
