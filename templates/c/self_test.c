static {{ bits_type }} {{ block }}_bits_of({{ real }} value)
{
    union {
        {{ real }} value;
        {{ bits_type }} bits;
    } view;
    view.value = value;
    return view.bits;
}

static {{ real }} {{ block }}_real_of({{ bits_type }} bits)
{
    union {
        {{ real }} value;
        {{ bits_type }} bits;
    } view;
    view.bits = bits;
    return view.value;
}

static {{ bits_type }} {{ block }}_fold({{ bits_type }} digest, {{ bits_type }} bits)
{
    return ((digest << 5) | (digest >> {{ turn }})) + bits;
}

uint32_t {{ prefix }}_self_test(void)
{
    /* the reference's digest of all outputs and of the whole state, after each sample */
    static const {{ bits_type }} expected[{{ expected.len() }}] = {
{%- for digest in expected %}
        {{ digest }},
{%- endfor %}
    };
    /* volatile: the compiler must call what the caller calls, and not work it out by itself */
    void (*volatile step)({{ prefix }}_state *, const {{ prefix }}_inputs *, {{ prefix }}_outputs *) =
        {{ prefix }}_step;
    {{ prefix }}_state state;
    {{ prefix }}_inputs inputs;
    {{ prefix }}_outputs outputs;
    {{ bits_type }} digest = 0u;
    {{ bits_type }} noise;
    {{ real }} scale;
    uint32_t random = 1u;
    uint32_t sample;
    /* 1 + 2^-{% if real == "double" %}30{% else %}15{% endif %} and its rounded square; volatile: worked out when it runs */
    volatile {{ real }} factor = {{ block }}_real_of({% if real == "double" %}UINT64_C(0x3ff0000000400000){% else %}UINT32_C(0x3f800100){% endif %});
    volatile {{ real }} square = {{ block }}_real_of({% if real == "double" %}UINT64_C(0x3ff0000000800000){% else %}UINT32_C(0x3f800200){% endif %});
    const {{ real }} product = factor * factor;
    const {{ real }} remainder = product - square;

    /* 0, unless the compiler fuses a product with the sum behind it: noise alone shows that too rarely */
    if ({{ block }}_bits_of(remainder) != 0u) {
        return 1u;
    }
{%- if real == "double" %}
    /* as it stands here, unless the compiler takes constants for single precision */
    if ({{ block }}_bits_of(0.1) != UINT64_C(0x3fb999999999999a)) {
        return 1u;
    }
{%- endif %}

    {{ prefix }}_init(&state);
    {{ prefix }}_inputs_init(&inputs);
{%- for switch in switches %}
    inputs.{{ switch.name }} = {{ switch.value }};
{%- endfor %}
    for (sample = 0u; sample < {{ expected.len() }}u; sample++) {
        /* at first within every limit, so that nothing is cut off */
        scale = sample < {{ loud_from }}u ? {{ scales[0] }} : {{ scales[1] }};
        /* noise; each input is no number for one sample: a block that does not notice it goes on with other bits */
{%- for input in noisy %}
        random = random * 1664525u + 1013904223u;
        noise = {{ block }}_bits_of((({{ real }})(random >> 8) - {{ middle }}) * scale);
        inputs.{{ input.name }} = {{ block }}_real_of(sample == {{ input.bad_sample }}u ? {{ not_a_number }} : noise);
{%- endfor %}
        step(&state, &inputs, &outputs);
{%- for bits in watched %}
        digest = {{ block }}_fold(digest, {{ bits }});
{%- endfor %}
        if (digest != expected[sample]) {
            return sample + 1u;
        }
    }
    return 0u;
}
