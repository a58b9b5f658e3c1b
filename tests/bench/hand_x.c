/* The axis X of examples/feedforward.toml written by hand for speed: the yardstick for its generated block `axis`.
 *
 * Cycle 1 ms. Compile without contraction.
 *   feedforward: VEL | ACC, conventional, time constant 4 ms, weight 1
 *   position control: in the CNC, Kv 20/s; 20000 increments at 1 m/min, 32 bits
 *   improved position control: the stages of hand_rack_and_pinion.c, limit 530000 um/s, fade 0.1 s
 *
 * The step below is what runs cycle after cycle: ON, the fade full, nothing at a limit. It leaves by a call in last place
 * where anything else is the case, so that none of that costs it a register.
 * The coefficients are those that the generator prints.
 */
#include "axis_hand_x_axis.h"

#include "hand_axis.h"

#define FADE_CYCLES 100u

typedef axis_hand_x_axis_state axis_state;
typedef axis_hand_x_axis_inputs axis_inputs;
typedef axis_hand_x_axis_outputs axis_outputs;

static const double anti_denormal = 1.0e-30; /* keeps a section at rest out of the subnormal range */
static const double limit = 530000.0; /* um/s */
static const double rest = 4.597017211338539e-13; /* 530000 * 2^-60 */
static const double fade_step = 0.01;

static const double t_a = 0.004; /* s */
static const double kv = 20.0; /* 1/s */
static const double increments_per_velocity = 1.2;
static const double highest = 2147483647.5; /* rounded beyond the range from here on */
static const double lowest = -2147483648.5;

/* stage 0: BANDPASS order 1, 53 Hz, Q 10 */
static const double bp0_minus_b0 = -0.016379233277825974;
static const double bp0_a1 = -1.8591673332183505;
static const double bp0_a2 = 0.967241533444348;
static const double gain0 = -3.0; /* -weight */

/* stage 1: oscillation 11 Hz, damping 0.8 */
static const double osc1_b0 = 0.05348673135661798;
static const double osc1_b1 = 0.002262495254415846;
static const double osc1_b2 = -0.051224236102202135;
static const double osc1_a1 = -1.8907640420323482;
static const double osc1_a2 = 0.8952890325411799;
static const double osc1_preset_s1 = 0.946513268643382;
static const double osc1_preset_s2 = -0.946513268643382;
/* stage 1: BANDPASS order 1, 11 Hz, Q 2 */
static const double bp1_minus_b0 = -0.01698693694336859;
static const double bp1_a1 = -1.9613322512435023;
static const double bp1_a2 = 0.9660261261132628;
static const double gain1 = -1.9; /* -weight */

void axis_hand_x_axis_init(axis_state *state)
{
    state->preset = false;
    state->fade = 0u;
}

void axis_hand_x_axis_inputs_init(axis_inputs *inputs)
{
    *inputs = (axis_inputs){ .mode = MODE_ON, .feedforward_percentage = 100, .position_controlled = true };
}

OFTEN double bandpass(hand_section *section, double minus_b0, double a1, double a2, double x)
{
    const double t = minus_b0 * x;
    const double y = section->s1 - t;
    section->s1 = section->s2 - a1 * y;
    section->s2 = anti_denormal + t - a2 * y;
    return y;
}

/* Both stages; gives their sum. */
OFTEN double run_stages(axis_state *restrict state, double v_motor)
{
    const double y0 = bandpass(&state->bp0, bp0_minus_b0, bp0_a1, bp0_a2, v_motor);

    const double osc = osc1_b0 * v_motor + state->osc1.s1;
    state->osc1.s1 = osc1_b1 * v_motor - osc1_a1 * osc + state->osc1.s2;
    state->osc1.s2 = osc1_b2 * v_motor + anti_denormal - osc1_a2 * osc;
    const double y1 = bandpass(&state->bp1, bp1_minus_b0, bp1_a1, bp1_a2, osc);

    return gain0 * y0 + gain1 * y1;
}

/* Puts all sections where the present input, held constant, would have brought them. */
SELDOM void preset(axis_state *restrict state, double v_motor)
{
    state->bp0.s1 = state->bp0.s2 = bp0_minus_b0 * v_motor;
    state->osc1.s1 = osc1_preset_s1 * v_motor;
    state->osc1.s2 = osc1_preset_s2 * v_motor;
    state->bp1.s1 = state->bp1.s2 = bp1_minus_b0 * v_motor;
    state->preset = true;
}

/* A cycle in which the axis does not act. */
SELDOM void idle(axis_state *restrict state, axis_outputs *restrict outputs, uint32_t error_id)
{
    state->preset = false;
    state->fade = 0u;
    *outputs = (axis_outputs){ .fault = error_id != 0u, .error_id = error_id };
}

/* What the drive gets: of a velocity beyond the range, or at its lower end. */
SELDOM void saturate(axis_outputs *restrict outputs, double increments, bool limited)
{
    if (increments >= highest) {
        outputs->manipulated_variable = INT32_MAX;
        limited = true;
    } else if (increments <= lowest) {
        outputs->manipulated_variable = INT32_MIN;
        limited = true;
    } else {
        outputs->manipulated_variable = nearest(increments);
    }
    outputs->limited = limited;
}

/* What the drive gets. */
OFTEN void put_out(axis_outputs *restrict outputs, double velocity, bool limited)
{
    const double increments = increments_per_velocity * velocity;
    if (fabs(increments) < highest) {
        outputs->manipulated_variable = nearest(increments);
        outputs->limited = limited;
    } else {
        saturate(outputs, increments, limited);
    }
}

/* The sum of the stages within the limit; 0 for an axis at rest. */
OFTEN double within_limit(bool *limited, double v)
{
    const double magnitude = fabs(v);
    *limited = magnitude > limit;
    if (*limited) {
        return copysign(limit, v);
    }
    return magnitude <= rest ? 0.0 : v;
}

OFTEN void report(axis_outputs *restrict outputs, uint32_t error_id)
{
    outputs->fault = error_id != 0u;
    outputs->error_id = error_id;
}

/* A cycle in which improved position control cannot act or is off. */
SELDOM void without_addition(
    axis_state *restrict state, axis_outputs *restrict outputs, double v_command, uint32_t error_id)
{
    state->preset = false;
    state->fade = 0u;
    outputs->v_add = 0.0;
    outputs->v_add_calculated = 0.0;
    report(outputs, error_id);
    put_out(outputs, v_command, false);
}

/* Improved position control while its fade is not full, or will not be. Its errors stand before feedforward's. */
SELDOM void fade(
    axis_state *restrict state,
    const axis_inputs *restrict inputs,
    axis_outputs *restrict outputs,
    double v_command,
    uint32_t error_id)
{
    const int32_t mode = inputs->mode;
    if (!in_range(inputs->v_motor)) {
        without_addition(state, outputs, v_command, 12u);
        return;
    }
    if (mode != MODE_OFF && mode != MODE_ON && mode != MODE_DRYRUN) {
        without_addition(state, outputs, v_command, 2u);
        return;
    }
    if (!state->preset) {
        if (mode == MODE_OFF) {
            without_addition(state, outputs, v_command, error_id);
            return;
        }
        preset(state, inputs->v_motor);
        outputs->v_add = 0.0;
        outputs->v_add_calculated = 0.0;
        report(outputs, error_id);
        put_out(outputs, v_command, false);
        return;
    }
    if (mode == MODE_ON) {
        state->fade += 1u;
    } else if (state->fade > 0u) {
        state->fade -= 1u;
    }
    if (mode == MODE_OFF && state->fade == 0u) {
        without_addition(state, outputs, v_command, error_id);
        return;
    }
    bool limited;
    const double v = within_limit(&limited, run_stages(state, inputs->v_motor));
    double v_add = v;
    if (state->fade == 0u) {
        v_add = 0.0;
    } else if (state->fade < FADE_CYCLES) {
        v_add = v * ((double)state->fade * fade_step);
    }
    outputs->v_add = v_add;
    outputs->v_add_calculated = mode == MODE_OFF ? 0.0 : v;
    report(outputs, error_id);
    put_out(outputs, v_command + v_add, limited);
}

void axis_hand_x_axis_step(
    axis_state *restrict state, const axis_inputs *restrict inputs, axis_outputs *restrict outputs)
{
    if (!in_range(inputs->x_command)) {
        idle(state, outputs, 17u);
        return;
    }
    if (inputs->task_cycle_ns != 0u && inputs->task_cycle_ns != CYCLE_TIME_NS) {
        idle(state, outputs, 1u);
        return;
    }
    if (!in_range(inputs->x_actual)) {
        idle(state, outputs, 18u);
        return;
    }
    if (!inputs->position_controlled || inputs->reset) {
        idle(state, outputs, 0u);
        return;
    }
    uint32_t error_id = 0u;
    double v_feedforward = 0.0;
    if (!in_range(inputs->v_interpolator) || !in_range(inputs->a_interpolator)) {
        error_id = in_range(inputs->a_interpolator) ? 14u : 15u;
    } else {
        v_feedforward = feedforward_gain(inputs->feedforward_active, inputs->feedforward_percentage)
            * (inputs->v_interpolator + t_a * inputs->a_interpolator);
    }
    const double v_command = kv * (inputs->x_command - inputs->x_actual) + v_feedforward;
    outputs->v_feedforward = v_feedforward;
    outputs->v_command = v_command;

    if (inputs->mode != MODE_ON || state->fade != FADE_CYCLES || !in_range(inputs->v_motor)) {
        fade(state, inputs, outputs, v_command, error_id);
        return;
    }
    bool limited;
    const double v_add = within_limit(&limited, run_stages(state, inputs->v_motor));
    outputs->v_add = v_add;
    outputs->v_add_calculated = v_add;
    report(outputs, error_id);
    put_out(outputs, v_command + v_add, limited);
}
