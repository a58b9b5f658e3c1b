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
/* Written by the caller. {{ prefix }}_inputs_init fills in what is said to be the start. */
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
} {{ prefix }}_inputs;

/* Written by {{ prefix }}_step. */
typedef struct {
{%- for member in block.outputs %}
{%- include "c/member.h" %}
{%- endfor %}
} {{ prefix }}_outputs;

/* Kept from cycle to cycle; only the functions below look inside. */
typedef struct {
{%- for member in block.state %}
{%- include "c/member.h" %}
{%- endfor %}
{%- if block.state.is_empty() %}
    bool unused; /* this block keeps nothing; C has no struct without a member */
{%- endif %}
} {{ prefix }}_state;

/* Once before the first cycle. */
void {{ prefix }}_init({{ prefix }}_state *state);

/* Gives every input the value that it has until the caller writes it. */
void {{ prefix }}_inputs_init({{ prefix }}_inputs *inputs);

/* Once per position-controller cycle. The three structs do not overlap. */
void {{ prefix }}_step(
    {{ prefix }}_state *state,
    const {{ prefix }}_inputs *inputs,
    {{ prefix }}_outputs *outputs);

/* Compares a run of {{ block.expected.len() }} samples, outputs and state, with the bits of the reference: 0 if all are the same, else the
 * number of the first sample that differs, or 1 if the build fuses a product with a sum or takes constants for single
 * precision. Run it once at start-up, on the machine and with the compiler options that the block runs with: it finds a
 * build that fuses or reorders floating-point operations, too, or that takes a NaN for a number. */
uint32_t {{ prefix }}_self_test(void);

#ifdef __cplusplus
}
#endif

#endif
