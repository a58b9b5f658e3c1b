/* Two axes of single.toml written by hand for speed: the yardstick for the generated blocks of the same axes. SECTIONS = 1: `one`,
 * SECTIONS = 6: `stages`. Compile without contraction.
 *
 * Cycle 62.5 us, limit 250000 um/s, fade 0.1 s, weights 1.
 *   first section of a stage:  p += change;  u = A p - B s1;  y = s1 + (s1 + u);  s1 += u;  p -= C y
 *   further one:               u = A (x - low) - B s1;        y = s1 + (s1 + u);  s1 += u;  low += C y
 * The coefficients are those of the generated blocks; `cortex_m4` compares the bits of the outputs.
 */
#include "hand_single.h"

#define CYCLE_TIME_NS 62500u
#define FADE_CYCLES 1600u
#define MODE_OFF 0
#define MODE_ON 1
#define MODE_DRYRUN 2

static const float sample_limit = 1.0e9f;
static const float least_change = 1.0e-18f; /* keeps a section at rest out of the subnormal range */
static const float limit = 250000.0f; /* um/s */
static const float rest = 4.5474735e-7f; /* 500000 * 2^-40 */
static const float fade_step = 0.000625f;
#if SECTIONS == 1
static const float sum_limit = 4000000.0f;
#else
static const float sum_limit = 12000000.0f;
#endif

void HAND_NAME(AXIS, _ipc_init)(HAND_STATE *state)
{
    state->preset = false;
    state->disturbed = false;
    state->fade = 0u;
}

void HAND_NAME(AXIS, _ipc_inputs_init)(HAND_INPUTS *inputs)
{
    inputs->v_motor = 0.0f;
    inputs->mode = MODE_ON;
    inputs->position_controlled = true;
    inputs->reset = false;
    inputs->task_cycle_ns = 0u;
}

/* The first section of a stage. */
static inline float first(hand_section *restrict state, float change, float a, float b, float c)
{
    const float left = state->p + change;
    const float u = a * left - b * state->s1;
    const float next = state->s1 + u;
    const float y = state->s1 + next;
    state->s1 = next;
    state->p = left - c * y;
    return y;
}

#if SECTIONS > 1
/* A section behind another one. */
static inline float further(hand_section *restrict state, float x, float a, float b, float c)
{
    const float u = a * (x - state->p) - b * state->s1;
    const float next = state->s1 + u;
    const float y = state->s1 + next;
    state->s1 = next;
    state->p = state->p + (c * y + least_change);
    return y;
}
#endif

/* A cycle in which the block does not act. Behind a state that was overwritten this is the fault that says so, if no other one comes before it: then nothing is preset. */
static bool idle(HAND_STATE *restrict state, HAND_OUTPUTS *restrict outputs, uint32_t error_id)
{
    const bool was_disturbed = state->disturbed;
    if (was_disturbed && error_id != 12u && error_id != 1u) {
        error_id = 3u;
    }
    state->disturbed = false;
    state->preset = false;
    state->fade = 0u;
    outputs->v_add = 0.0f;
    outputs->v_add_calculated = 0.0f;
    outputs->limited = false;
    outputs->fault = error_id != 0u;
    outputs->error_id = error_id;
    return was_disturbed;
}

/* Puts all sections where the present input, held constant, would have brought them: there they put out 0. */
static void preset(HAND_STATE *restrict state, const HAND_INPUTS *restrict inputs)
{
    unsigned n;
    state->before = inputs->v_motor;
    for (n = 0u; n < SECTIONS; n++) {
        state->section[n].s1 = 0.0f;
        state->section[n].p = 0.0f;
    }
    state->preset = true;
}

/* Runs the stages, limits their sum, fades it. */
static void act(HAND_STATE *restrict state, const HAND_INPUTS *restrict inputs, HAND_OUTPUTS *restrict outputs)
{
    const float change = inputs->v_motor - state->before + least_change;
    state->before = inputs->v_motor;
    hand_section *const section = state->section;
#if SECTIONS == 1
    float v = -first(&section[0], change, 0.0010395711f, 0.0022955008f, 0.20812292f);
#else
    const float y0 = first(&section[0], change, 0.0010037806f, 0.0016203219f, 0.20088975f);
    const float y1 = first(&section[2], change, 0.00039789308f, 0.00059402647f, 0.079600446f);
    const float y2 = first(&section[4], change, 0.00020844798f, 0.000303297f, 0.041695658f);
    float v = -further(&section[1], y0, 0.0010772931f, 0.001754852f, 0.21561652f);
    v = v - further(&section[3], y1, 0.00042705005f, 0.0006400476f, 0.085435405f);
    v = v - further(&section[5], y2, 0.00022372516f, 0.0003262095f, 0.044752054f);
#endif
    const float magnitude = __builtin_fabsf(v);

    outputs->limited = false;
    outputs->fault = false;
    outputs->error_id = 0u;
    if (!(magnitude <= limit)) {
        outputs->limited = true;
        if (!(magnitude <= sum_limit)) { /* a state has been overwritten */
            state->disturbed = true;
            state->preset = false;
            state->fade = 0u;
            v = 0.0f;
        } else {
            v = v > 0.0f ? limit : -limit;
        }
    } else if (magnitude <= rest) {
        v = 0.0f;
    }
    outputs->v_add_calculated = v;
    if (state->fade == FADE_CYCLES) { /* in ON only: any other mode has lowered the fade */
        outputs->v_add = v;
        return;
    }
    outputs->v_add = state->fade > 0u ? v * ((float)state->fade * fade_step) : 0.0f;
    if (inputs->mode == MODE_OFF) {
        outputs->v_add_calculated = 0.0f;
    }
}

/* A cycle in a mode other than ON. */
static void step_not_on(HAND_STATE *restrict state, const HAND_INPUTS *restrict inputs, HAND_OUTPUTS *restrict outputs)
{
    if (!(__builtin_fabsf(inputs->v_motor) <= sample_limit)) {
        idle(state, outputs, 12u);
    } else if (inputs->mode != MODE_OFF && inputs->mode != MODE_DRYRUN) {
        idle(state, outputs, 2u);
    } else if (!inputs->position_controlled || inputs->reset) {
        idle(state, outputs, 0u);
    } else if (!state->preset) {
        if (!idle(state, outputs, 0u) && inputs->mode == MODE_DRYRUN) {
            preset(state, inputs);
        }
    } else {
        if (state->fade > 0u) {
            state->fade -= 1u;
        }
        if (inputs->mode == MODE_OFF && state->fade == 0u) {
            idle(state, outputs, 0u);
        } else {
            act(state, inputs, outputs);
        }
    }
}

void HAND_NAME(AXIS, _ipc_step)(
    HAND_STATE *restrict state, const HAND_INPUTS *restrict inputs, HAND_OUTPUTS *restrict outputs)
{
    if (inputs->task_cycle_ns != 0u && inputs->task_cycle_ns != CYCLE_TIME_NS) {
        idle(state, outputs, __builtin_fabsf(inputs->v_motor) <= sample_limit ? 1u : 12u);
        return;
    }
    if (inputs->mode != MODE_ON) {
        step_not_on(state, inputs, outputs);
        return;
    }
    if (!(__builtin_fabsf(inputs->v_motor) <= sample_limit)) {
        idle(state, outputs, 12u);
        return;
    }
    if (!inputs->position_controlled || inputs->reset) {
        idle(state, outputs, 0u);
        return;
    }
    if (state->fade != FADE_CYCLES) { /* a full fade means preset sections */
        if (!state->preset) {
            if (!idle(state, outputs, 0u)) {
                preset(state, inputs);
            }
            return;
        }
        state->fade += 1u;
    }
    act(state, inputs, outputs);
}
