#include "{{ header }}"

{% include "c/guards.h" %}
/* Sections of code and of constants: none, unless the firmware defines these macros. */
#ifndef AXGEN_CODE_SECTION
#define AXGEN_CODE_SECTION
#endif
{%- if !block.set.is_empty() %}
#ifndef AXGEN_CONST_SECTION
#define AXGEN_CONST_SECTION
#endif
{%- endif %}
{%- if uses_magnitude %}

/* |value|, without a library call */
AXGEN_CODE_SECTION static {{ real }} {{ block.prefix }}_magnitude({{ real }} value)
{
#if defined(__GNUC__)
    return __builtin_fabs{{ suffix }}(value);
#else
    return value < 0.0{{ suffix }} ? -value : value;
#endif
}
{%- endif %}
{%- if uses_is_zero %}

/* whether value is exactly 0; the exact comparison is intended, so the warning is disabled */
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wfloat-equal"
#endif
AXGEN_CODE_SECTION static bool {{ block.prefix }}_is_zero({{ real }} value)
{
    return value == 0.0{{ suffix }};
}
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
{%- endif %}
{%- if uses_nearest %}

/* nearest integer, halves away from zero, without a library call; the added constant is the largest number below 1/2,
 * so that every value is rounded correctly */
AXGEN_CODE_SECTION static int32_t {{ block.prefix }}_nearest({{ real }} value)
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
AXGEN_CONST_SECTION const {{ block.prefix }}_params {{ block.prefix }}_designed = {
{%- for member in block.set %}
    {{ member.value }}{% if !loop.last %},{% endif %} /* {{ member.name }} */
{%- endfor %}
};
{% endif %}
AXGEN_CODE_SECTION void {{ block.prefix }}_init({{ block.prefix }}_state *fresh)
{
    /* volatile: each member is written on its own, so that no compiler calls memset */
    volatile {{ block.prefix }}_state *const state = fresh;
{%- if block.state.is_empty() %}
    state->unused = false;
{%- endif %}
{{ block.init }}}

AXGEN_CODE_SECTION void {{ block.prefix }}_inputs_init({{ block.prefix }}_inputs *inputs)
{
{%- for member in block.inputs %}
    inputs->{{ member.name }} = {{ member.value }};
{%- endfor %}
{%- if !block.set.is_empty() %}
    inputs->params = &{{ block.prefix }}_designed;
{%- endif %}
}

{% if !block.any_cycle.is_empty() -%}
/* all cycles except the usual ones, which are the fast path; a separate function, so that the fast path saves no registers */
{%- if !block.set.is_empty() %}
/* cold: compiled for size, because only a few cycles check or take over a parameter set */
{%- endif %}
#if defined(__GNUC__)
__attribute__((noinline{% if !block.set.is_empty() %}, cold{% endif %}))
#endif
AXGEN_CODE_SECTION static void {{ block.prefix }}_any_cycle(
    {{ block.prefix }}_state *restrict state,
    const {{ block.prefix }}_inputs *restrict inputs,
    {{ block.prefix }}_outputs *restrict outputs)
{
{%- let (margin, next_line, constants) = ("    ", "\n     * ", &block.constants_apart) %}
{%- include "c/constants.c" %}
{{ block.any_cycle }}}

{% endif -%}
{% if block.is_slow -%}
/* cold: compiled for size, because a slow task runs it */
#if defined(__GNUC__)
__attribute__((cold))
#endif
{% endif -%}
AXGEN_CODE_SECTION void {{ block.prefix }}_step(
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

{% include "c/guards_end.h" %}
