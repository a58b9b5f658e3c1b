/* The rack-and-pinion axis written by hand for speed: the yardstick for the generated block of the same axis.
 *
 * Cycle 1 ms, limit 530000 um/s, fade 0.1 s. Compile without contraction.
 *   stage 0: DIRECT from v_motor, BANDPASS order 1, 53 Hz, Q 10, weight 3
 *   stage 1: INDIRECT, damping 0.8, BANDPASS order 1, 11 Hz, Q 2, weight 1.9
 *
 * Sign convention of the coefficients, a0 = 1:  y = b0 x + s1;  s1 = b1 x - a1 y + s2;  s2 = b2 x - a2 y
 * (band-pass: b1 = 0, b2 = -b0). They come from coefficients.py.
 * A band-pass holds -b0: -b0 x, subtracted for y and added for s2, gives the same bits as b0 x added and subtracted, and
 * spares a register copy in every section.
 */
#include "axis_hand_rack_and_pinion_ipc.h"

#include <math.h>

#define CYCLE_TIME_NS 1000000u
#define FADE_CYCLES 100u
#define MODE_OFF 0
#define MODE_ON 1
#define MODE_DRYRUN 2

static const double sample_limit = 1.0e15;
static const double anti_denormal = 1.0e-30; /* keeps a section at rest out of the subnormal range */
static const double limit = 530000.0; /* um/s */
static const double lower_limit = -530000.0;
static const double rest = 4.597017211338539e-13; /* 530000 * 2^-60 */
static const double fade_step = 0.01;

/* stage 0: BANDPASS order 1, 53 Hz, Q 10 */
static const double bp0_minus_b0 = -0.016379233277825977;
static const double bp0_a1 = -1.8591673332183505;
static const double bp0_a2 = 0.967241533444348;
static const double gain0 = -3.0; /* -weight */

/* stage 1: oscillation 11 Hz, damping 0.8 */
static const double osc1_b0 = 0.05348673135661799;
static const double osc1_b1 = 0.002262495254415846;
static const double osc1_b2 = -0.051224236102202135;
static const double osc1_a1 = -1.8907640420323482;
static const double osc1_a2 = 0.8952890325411799;
static const double osc1_preset_s1 = 0.946513268643382;
static const double osc1_preset_s2 = -0.946513268643382;
/* stage 1: BANDPASS order 1, 11 Hz, Q 2 */
static const double bp1_minus_b0 = -0.01698693694336859;
static const double bp1_a1 = -1.9613322512435025;
static const double bp1_a2 = 0.9660261261132629;
static const double gain1 = -1.9; /* -weight */

void axis_hand_rack_and_pinion_ipc_init(axis_hand_rack_and_pinion_ipc_state *state)
{
    state->preset = false;
    state->fade = 0u;
}

void axis_hand_rack_and_pinion_ipc_inputs_init(axis_hand_rack_and_pinion_ipc_inputs *inputs)
{
    inputs->v_motor = 0.0;
    inputs->mode = MODE_ON;
    inputs->position_controlled = true;
    inputs->reset = false;
    inputs->task_cycle_ns = 0u;
}

/* A cycle in which the block does not act. */
static void idle(
    axis_hand_rack_and_pinion_ipc_state *restrict state,
    axis_hand_rack_and_pinion_ipc_outputs *restrict outputs,
    uint32_t error_id)
{
    state->preset = false;
    state->fade = 0u;
    outputs->v_add = 0.0;
    outputs->v_add_calculated = 0.0;
    outputs->limited = false;
    outputs->fault = error_id != 0u;
    outputs->error_id = error_id;
}

/* Puts all sections where the present input, held constant, would have brought them: there they put out 0. */
static void preset(
    axis_hand_rack_and_pinion_ipc_state *restrict state,
    const axis_hand_rack_and_pinion_ipc_inputs *restrict inputs)
{
    const double v_motor = inputs->v_motor;

    const double preset_bp0 = bp0_minus_b0 * v_motor;
    state->bp0.s1 = preset_bp0;
    state->bp0.s2 = preset_bp0;
    state->osc1.s1 = osc1_preset_s1 * v_motor;
    state->osc1.s2 = osc1_preset_s2 * v_motor;
    const double preset_bp1 = bp1_minus_b0 * v_motor;
    state->bp1.s1 = preset_bp1;
    state->bp1.s2 = preset_bp1;
    state->preset = true;
}

/* Runs the stages, limits their sum, fades it. It is a function of its own, called last on every path: placed behind a
 * branch that presets the sections, it would make compilers load all states ahead, one instruction a state. */
static void act(
    axis_hand_rack_and_pinion_ipc_state *restrict state,
    const axis_hand_rack_and_pinion_ipc_inputs *restrict inputs,
    axis_hand_rack_and_pinion_ipc_outputs *restrict outputs)
{
    const double v_motor = inputs->v_motor;

    /* stage 0 */
    const double t_bp0 = bp0_minus_b0 * v_motor;
    const double y_bp0 = state->bp0.s1 - t_bp0;
    state->bp0.s1 = state->bp0.s2 - bp0_a1 * y_bp0;
    state->bp0.s2 = anti_denormal + t_bp0 - bp0_a2 * y_bp0;

    /* stage 1 */
    const double y_osc1 = osc1_b0 * v_motor + state->osc1.s1;
    state->osc1.s1 = osc1_b1 * v_motor - osc1_a1 * y_osc1 + state->osc1.s2;
    state->osc1.s2 = osc1_b2 * v_motor + anti_denormal - osc1_a2 * y_osc1;
    const double t_bp1 = bp1_minus_b0 * y_osc1;
    const double y_bp1 = state->bp1.s1 - t_bp1;
    state->bp1.s1 = state->bp1.s2 - bp1_a1 * y_bp1;
    state->bp1.s2 = anti_denormal + t_bp1 - bp1_a2 * y_bp1;

    double v = gain0 * y_bp0 + gain1 * y_bp1;

    outputs->limited = false;
    outputs->fault = false;
    outputs->error_id = 0u;
    const double magnitude = fabs(v);
    if (magnitude > limit) {
        v = v > 0.0 ? limit : lower_limit;
        outputs->limited = true;
    } else if (magnitude <= rest) {
        v = 0.0;
    }
    outputs->v_add_calculated = v;
    if (state->fade == FADE_CYCLES) { /* in ON only: any other mode has lowered the fade */
        outputs->v_add = v;
        return;
    }
    outputs->v_add = 0.0;
    if (state->fade > 0u) {
        outputs->v_add = v * ((double)state->fade * fade_step);
    }
    if (inputs->mode == MODE_OFF) {
        outputs->v_add_calculated = 0.0;
    }
}

/* A cycle in a mode other than ON. */
static void step_not_on(
    axis_hand_rack_and_pinion_ipc_state *restrict state,
    const axis_hand_rack_and_pinion_ipc_inputs *restrict inputs,
    axis_hand_rack_and_pinion_ipc_outputs *restrict outputs)
{
    if (!(fabs(inputs->v_motor) <= sample_limit)) {
        idle(state, outputs, 12u);
        return;
    }
    if (inputs->mode != MODE_OFF && inputs->mode != MODE_DRYRUN) {
        idle(state, outputs, 2u);
        return;
    }
    if (!inputs->position_controlled || inputs->reset) {
        idle(state, outputs, 0u);
        return;
    }
    if (!state->preset) {
        idle(state, outputs, 0u);
        if (inputs->mode == MODE_DRYRUN) {
            preset(state, inputs);
        }
        return;
    }
    if (state->fade > 0u) {
        state->fade -= 1u;
    }
    if (inputs->mode == MODE_OFF && state->fade == 0u) {
        idle(state, outputs, 0u);
        return;
    }
    act(state, inputs, outputs);
}

/* The id of a sample that is out of range, else the other one. */
static uint32_t error_of_samples(const axis_hand_rack_and_pinion_ipc_inputs *restrict inputs, uint32_t other)
{
    return fabs(inputs->v_motor) <= sample_limit ? other : 12u;
}

void axis_hand_rack_and_pinion_ipc_step(
    axis_hand_rack_and_pinion_ipc_state *restrict state,
    const axis_hand_rack_and_pinion_ipc_inputs *restrict inputs,
    axis_hand_rack_and_pinion_ipc_outputs *restrict outputs)
{
    if (inputs->task_cycle_ns != 0u && inputs->task_cycle_ns != CYCLE_TIME_NS) {
        idle(state, outputs, error_of_samples(inputs, 1u));
        return;
    }
    if (inputs->mode != MODE_ON) {
        step_not_on(state, inputs, outputs);
        return;
    }
    if (!(fabs(inputs->v_motor) <= sample_limit)) {
        idle(state, outputs, 12u);
        return;
    }
    if (!inputs->position_controlled || inputs->reset) {
        idle(state, outputs, 0u);
        return;
    }
    if (state->fade != FADE_CYCLES) { /* a full fade means preset sections */
        if (!state->preset) {
            idle(state, outputs, 0u);
            preset(state, inputs);
            return;
        }
        state->fade += 1u;
    }
    act(state, inputs, outputs);
}
