#ifndef {{ guard }}
#define {{ guard }}

#include <stdbool.h>
#include <stdint.h>
{%- if let Some(header) = header_of_set %}
#include "{{ header }}"
{%- endif %}

#ifdef __cplusplus
extern "C" {
#endif

/* {{ block.purpose }} */

{% if !block.certificate.is_empty() -%}
/* {{ block.certificate }} */

{% endif -%}
/* Constants that the caller can check, at start-up or in an #if. */
{%- for of in macros %}
{%- if !of.doc.is_empty() %}
/* {{ of.doc }} */
{%- endif %}
#define {{ names }}_{{ of.name }} {{ of.value }}
{%- endfor %}

/* The results and the layout of the structs depend on a {{ real }} with {{ bits }} bits. Nothing else is asserted: the ABI defines the
 * alignment of members. */
#if defined(__cplusplus) && __cplusplus >= 201103L
static_assert(sizeof({{ real }}) == sizeof(uint{{ bits }}_t), "{{ real }} must have {{ bits }} bits");
#elif defined(__STDC_VERSION__) && __STDC_VERSION__ >= 201112L
_Static_assert(sizeof({{ real }}) == sizeof(uint{{ bits }}_t), "{{ real }} must have {{ bits }} bits");
#else
typedef char {{ block.prefix }}_real_has_{{ bits }}_bits[sizeof({{ real }}) == sizeof(uint{{ bits }}_t) ? 1 : -1];
#endif
{% for group in enumerations %}
/* {{ group.note }} */
enum {
{%- for member in group.constants %}
{%- match member.above("\n     * ") %}
{%- when Some with (above) %}
    /* {{ above }} */
    {{ member.name }} = {{ member.value }}{% if !loop.last %},{% endif %}
{%- when None %}
    {{ member.name }} = {{ member.value }}{% if !loop.last %},{% endif %} /* {{ member.doc }} */
{%- endmatch %}
{%- endfor %}
};
{% endfor %}
{%- if !block.set.is_empty() %}
{%- if let Some(shared) = shared_set %}
/* A parameter set: that of the block ipc of this axis. Its contents must not change while step can read them. */
typedef {{ shared }} {{ block.prefix }}_params;
{%- else %}
/* A parameter set, written by `axgen params-of`. The block checks a set before it uses it. The contents must not change while step
 * can read them: keep the set in ROM, or write it completely before you pass the pointer. */
typedef struct {
{%- for member in block.set %}
{%- include "c/member.h" %}
{%- endfor %}
} {{ block.prefix }}_params;
{%- endif %}

/* The set that the block was generated with. */
extern const {{ block.prefix }}_params {{ block.prefix }}_designed;
{% endif %}
/* Written by the caller. {{ block.prefix }}_inputs_init writes the start values. */
typedef struct {
{%- for member in block.inputs %}
{%- match member.above("\n     * ") %}
{%- when Some with (above) %}
    /* {{ above }}; start {{ member.value }} */
    {{ member.ty }} {{ member.name }};
{%- when None %}
    {{ member.ty }} {{ member.name }}; /* {{ member.doc }}; start {{ member.value }} */
{%- endmatch %}
{%- endfor %}
{%- if !block.set.is_empty() %}
    /* the parameter set, never NULL; start &{{ block.prefix }}_designed; volatile: each number is read once, so that the
     * checked value is the one that is used */
    const volatile {{ block.prefix }}_params *params;
{%- endif %}
} {{ block.prefix }}_inputs;

/* Written by {{ block.prefix }}_step. */
typedef struct {
{%- for member in block.outputs %}
{%- include "c/member.h" %}
{%- endfor %}
} {{ block.prefix }}_outputs;

/* Memory of the block from cycle to cycle. Only the functions below may access the members. */
typedef struct {
{%- for member in block.state %}
{%- include "c/member.h" %}
{%- endfor %}
{%- if block.state.is_empty() %}
    bool unused; /* the block has no state; a C struct needs a member */
{%- endif %}
} {{ block.prefix }}_state;

/* Tasks and interrupts: each function accesses only the structs that are passed to it. It uses no global variables, calls no
 * library and needs little stack. Calls with different states may interrupt each other. Calls with the same state must
 * not: neither step nor init may be interrupted by a call for the same state.
 * step writes each output once, with its final value, but not all outputs at the same instant. Another task or interrupt
 * that needs several consistent outputs copies them while step cannot run (its interrupt is disabled), or reads copies
 * that the task of step writes to two buffers alternately, with a counter that shows the valid one.
{%- if !block.set.is_empty() %}
 * A cycle that checks a parameter set needs a few hundred bytes of stack.
{%- endif %} */

/* Call once before the first cycle: sets every member of the state to its start value. */
void {{ block.prefix }}_init({{ block.prefix }}_state *fresh);

/* Sets every input to its start value. */
void {{ block.prefix }}_inputs_init({{ block.prefix }}_inputs *inputs);

/* Call {{ block.rate }}. The three structs must not overlap. */
void {{ block.prefix }}_step(
    {{ block.prefix }}_state *state,
    const {{ block.prefix }}_inputs *inputs,
    {{ block.prefix }}_outputs *outputs);

/* Defined in {{ block.prefix }}_self_test.c; a build that does not call it can omit that file.
 * Runs {{ self_test.expected.len() }} samples and compares outputs and state with the bits of the reference. Returns 0 if all bits are equal,
 * otherwise the number of the first sample that differs; 1 also if the build fuses a product with a sum or treats
 * constants as single precision. Call it once at start-up on the machine, and compile both files with the same options.
 * It also detects a build that reorders floating-point operations or treats a NaN as a number. */
uint32_t {{ block.prefix }}_self_test(void);

#ifdef __cplusplus
}
#endif

#endif
