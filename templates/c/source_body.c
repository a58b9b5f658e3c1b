#include "{{ header }}"

{% include "c/guards.h" %}
{%- if uses_magnitude %}

/* |value|, without a library */
static {{ real }} {{ block.prefix }}_magnitude({{ real }} value)
{
#if defined(__GNUC__)
    return __builtin_fabs{{ suffix }}(value);
#else
    return value < 0.0{{ suffix }} ? -value : value;
#endif
}
{%- endif %}
{%- if uses_is_zero %}

/* whether value is exactly 0: that is meant where a compiler is asked to warn of it */
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wfloat-equal"
#endif
static bool {{ block.prefix }}_is_zero({{ real }} value)
{
    return value == 0.0{{ suffix }};
}
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
{%- endif %}
{%- if uses_nearest %}

/* the nearest integer, half away from zero; the number added is the largest below 1/2, so that every number is rounded
 * rightly; without a library */
static int32_t {{ block.prefix }}_nearest({{ real }} value)
{
#if defined(__GNUC__)
    return (int32_t)(value + __builtin_copysign{{ suffix }}({{ nearly_half }}, value));
#else
    return (int32_t)(value < 0.0{{ suffix }} ? value - {{ nearly_half }} : value + {{ nearly_half }});
#endif
}
{%- endif %}
{% let (margin, next_line, constants) = ("", "\n * ", &block.shared) -%}
{% include "c/constants.c" %}
{%- if !block.set.is_empty() %}
const {{ block.prefix }}_params {{ block.prefix }}_designed = {
{%- for member in block.set %}
    {{ member.value }}{% if !loop.last %},{% endif %} /* {{ member.name }} */
{%- endfor %}
};
{% endif %}
void {{ block.prefix }}_init({{ block.prefix }}_state *fresh)
{
    /* volatile: each member is written as it stands here, so that no compiler calls memset */
    volatile {{ block.prefix }}_state *const state = fresh;
{%- if block.state.is_empty() %}
    state->unused = false;
{%- endif %}
{{ block.init }}}

void {{ block.prefix }}_inputs_init({{ block.prefix }}_inputs *inputs)
{
{%- for member in block.inputs %}
    inputs->{{ member.name }} = {{ member.value }};
{%- endfor %}
{%- if !block.set.is_empty() %}
    inputs->params = &{{ block.prefix }}_designed;
{%- endif %}
}

{% if !block.any_cycle.is_empty() -%}
/* any cycle that is not a usual one; in a function of its own, so that a usual cycle saves no registers */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static void {{ block.prefix }}_any_cycle(
    {{ block.prefix }}_state *restrict state,
    const {{ block.prefix }}_inputs *restrict inputs,
    {{ block.prefix }}_outputs *restrict outputs)
{
{%- let (margin, next_line, constants) = ("    ", "\n     * ", &block.constants_apart) %}
{%- include "c/constants.c" %}
{{ block.any_cycle }}}

{% endif -%}
void {{ block.prefix }}_step(
    {{ block.prefix }}_state *restrict state,
    const {{ block.prefix }}_inputs *restrict inputs,
    {{ block.prefix }}_outputs *restrict outputs)
{
{%- let (margin, next_line, constants) = ("    ", "\n     * ", &block.constants) %}
{%- include "c/constants.c" %}
{%- if block.state.is_empty() %}
    (void)state;
{%- endif %}
{{ block.step }}}
