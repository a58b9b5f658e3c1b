#ifndef {{ guard }}
#define {{ guard }}

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

{% if !block.certificate.is_empty() -%}
/* {{ block.certificate }} */

{% endif -%}
/* What code can compare with what it expects, at its start or in an #if. */
{%- for of in macros %}
{%- if !of.doc.is_empty() %}
/* {{ of.doc }} */
{%- endif %}
#define {{ names }}_{{ of.name }} {{ of.value }}
{%- endfor %}

/* With another number of bits in {{ real }} the block would compute other numbers, and the structs would be laid out differently.
 * Nothing else is asserted: the alignment of members is the ABI's own affair. */
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
/* A parameter set: what `axgen params-of` writes, and what the block checks before it takes it over. Its contents stay as they are while
 * step may look at them: in ROM, or in memory that another task writes before it hands the pointer over. */
typedef struct {
{%- for member in block.set %}
{%- include "c/member.h" %}
{%- endfor %}
} {{ block.prefix }}_params;

/* The set that the block was generated with. */
extern const {{ block.prefix }}_params {{ block.prefix }}_designed;
{% endif %}
/* Written by the caller. {{ block.prefix }}_inputs_init fills in what is said to be the start. */
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
    /* the parameter set, never NULL; start &{{ block.prefix }}_designed; volatile: each number is read once, so that what was checked is what is
     * used */
    const volatile {{ block.prefix }}_params *params;
{%- endif %}
} {{ block.prefix }}_inputs;

/* Written by {{ block.prefix }}_step. */
typedef struct {
{%- for member in block.outputs %}
{%- include "c/member.h" %}
{%- endfor %}
} {{ block.prefix }}_outputs;

/* Kept from cycle to cycle; only the functions below look inside. */
typedef struct {
{%- for member in block.state %}
{%- include "c/member.h" %}
{%- endfor %}
{%- if block.state.is_empty() %}
    bool unused; /* this block keeps nothing; C has no struct without a member */
{%- endif %}
} {{ block.prefix }}_state;

/* Tasks and interrupts: a function works on the structs that it gets and on nothing else. It has no global variable, calls
 * no library, and takes little stack. Calls with different states may interrupt each other. Of one state only one
 * function may be at work: neither step nor init may be interrupted by a call for the same state.
 * step writes each output once, with its final value, but one output after another. Another task or interrupt that reads
 * several of them copies them while step cannot run (its interrupt is off), or reads copies that the task of step
 * puts into two buffers in turn, behind a counter.
{%- if !block.set.is_empty() %}
 * A cycle that checks a parameter set takes some hundred bytes of stack.
{%- endif %} */

/* Once before the first cycle: every member of the state gets its start. */
void {{ block.prefix }}_init({{ block.prefix }}_state *fresh);

/* Gives every input the value that it has until the caller writes it. */
void {{ block.prefix }}_inputs_init({{ block.prefix }}_inputs *inputs);

/* Once per position-controller cycle. The three structs do not overlap. */
void {{ block.prefix }}_step(
    {{ block.prefix }}_state *state,
    const {{ block.prefix }}_inputs *inputs,
    {{ block.prefix }}_outputs *outputs);

/* In a file of its own, {{ block.prefix }}_self_test.c: a build that does not call it leaves it out.
 * Compares a run of {{ self_test.expected.len() }} samples, outputs and state, with the bits of the reference: 0 if all are the same, else the
 * number of the first sample that differs, or 1 if the build fuses a product with a sum or takes constants for single
 * precision. Run it once at start-up, on the machine, both files with the same compiler options: it finds a build that
 * fuses or reorders floating-point operations, too, or that takes a NaN for a number. */
uint32_t {{ block.prefix }}_self_test(void);

#ifdef __cplusplus
}
#endif

#endif
