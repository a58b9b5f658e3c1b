#include "{{ header }}"

/* The numbers below hold for IEEE 754 arithmetic that rounds every operation once. */
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) \
    || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || defined(__NO_SIGNED_ZEROS__)
#error "this block needs exact arithmetic: compile it without -ffast-math and its parts"
#endif
#include <float.h>
#if FLT_EVAL_METHOD != 0
#error "this block needs arithmetic in the declared type: on x86 compile it with -mfpmath=sse"
#endif
/* A fused multiply-add rounds once where the reference rounds twice. */
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize ("fp-contract=off")
#else
#pragma STDC FP_CONTRACT OFF
#endif
{%- if block.uses_magnitude %}

/* |value|, without a library */
static {{ real }} magnitude({{ real }} value)
{
#if defined(__GNUC__)
    return __builtin_fabs{{ suffix }}(value);
#else
    return value < 0.0{{ suffix }} ? -value : value;
#endif
}
{%- endif %}
{%- if block.uses_nearest %}

/* the nearest integer, half away from zero; the number added is the largest below 1/2, so that every number is rounded
 * rightly; without a library */
static int32_t nearest({{ real }} value)
{
#if defined(__GNUC__)
    return (int32_t)(value + __builtin_copysign{{ suffix }}({{ block.nearly_half }}, value));
#else
    return (int32_t)(value < 0.0{{ suffix }} ? value - {{ block.nearly_half }} : value + {{ block.nearly_half }});
#endif
}
{%- endif %}
{% for group in block.constants %}
{%- if !group.note.is_empty() %}
/* {{ group.note }} */
{%- endif %}
{%- for member in group.constants %}
{%- match member.above("\n * ") %}
{%- when Some with (above) %}
/* {{ above }} */
static const {{ member.ty }} {{ member.name }} = {{ member.value }};
{%- when None %}
static const {{ member.ty }} {{ member.name }} = {{ member.value }}; /* {{ member.doc }} */
{%- endmatch %}
{%- endfor %}
{% endfor %}
{%- for group in block.enumerations %}
/* {{ group.note }} */
enum {
{%- for member in group.constants %}
    {{ member.name }} = {{ member.value }}{% if !loop.last %},{% endif %} /* {{ member.doc }} */
{%- endfor %}
};
{% endfor %}
void {{ prefix }}_init({{ prefix }}_state *state)
{
{%- if block.state.is_empty() %}
    state->unused = false;
{%- endif %}
{{ block.init }}}

void {{ prefix }}_inputs_init({{ prefix }}_inputs *inputs)
{
{%- for member in block.inputs %}
    inputs->{{ member.name }} = {{ member.value }};
{%- endfor %}
}

{% if !block.any_cycle.is_empty() -%}
/* any cycle that is not a usual one; in a function of its own, so that a usual cycle saves no registers */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static void any_cycle(
    {{ prefix }}_state *restrict state,
    const {{ prefix }}_inputs *restrict inputs,
    {{ prefix }}_outputs *restrict outputs)
{
{{ block.any_cycle }}}

{% endif -%}
void {{ prefix }}_step(
    {{ prefix }}_state *restrict state,
    const {{ prefix }}_inputs *restrict inputs,
    {{ prefix }}_outputs *restrict outputs)
{
{%- if block.state.is_empty() %}
    (void)state;
{%- endif %}
{{ block.step }}}

{% include "c/self_test.c" %}
