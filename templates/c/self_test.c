static {{ bits_type }} {{ bits_of }}({{ real }} value)
{
    union {
        {{ real }} value;
        {{ bits_type }} bits;
    } view;
    view.value = value;
    return view.bits;
}

uint32_t {{ prefix }}_self_test(void)
{
    /* {{ output }} of the reference, sample by sample */
    static const {{ bits_type }} expected[{{ expected.len() }}] = {
{%- for bits in expected %}
        {{ bits }},
{%- endfor %}
    };
    /* volatile: the compiler must call what the caller calls, and not work it out by itself */
    void (*volatile step)({{ prefix }}_state *, const {{ prefix }}_inputs *, {{ prefix }}_outputs *) = {{ prefix }}_step;
    {{ prefix }}_state state;
    {{ prefix }}_inputs inputs;
    {{ prefix }}_outputs outputs;
    uint32_t random = 1u;
    uint32_t sample;

    {{ prefix }}_init(&state);
    {{ prefix }}_inputs_init(&inputs);
{%- for switch in switches %}
    inputs.{{ switch.name }} = {{ switch.value }};
{%- endfor %}
    for (sample = 0u; sample < {{ expected.len() }}u; sample++) {
{%- for input in noisy %}
        random = random * 1664525u + 1013904223u;
        inputs.{{ input }} = (({{ real }})(random >> 8) - {{ middle }}) * {{ scale }};
{%- endfor %}
        step(&state, &inputs, &outputs);
        if ({{ bits_of }}(outputs.{{ output }}) != expected[sample]) {
            return sample + 1u;
        }
    }
{%- for leaf in state %}
    if ({{ bits_of }}(state.{{ leaf.name }}) != {{ leaf.bits }}) {
        return {{ expected.len() + 1 }}u;
    }
{%- endfor %}
    return 0u;
}
