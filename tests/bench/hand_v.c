/* The axis V of examples/feedforward.toml written by hand for speed: the yardstick for its generated block `axis`.
 *
 * Cycle 1 ms. Compile without contraction.
 *   feedforward: ADD_VEL, delay 150 us, weight 1; 10000 increments are 3333 um/min, 32 bits
 *   position control: in the drive, the position command goes there as it is
 *
 * The coefficients are those that the generator prints.
 */
#include "axis_hand_v.h"

typedef axis_hand_v_axis_state axis_state;
typedef axis_hand_v_axis_inputs axis_inputs;
typedef axis_hand_v_axis_outputs axis_outputs;

static const double now = 0.85; /* delay of 0.15 cycles */
static const double earlier = 0.15;
static const double increments_per_velocity = 180.01800180018003;
static const double highest = 2147483647.0;
static const double lowest = -2147483648.0;

void axis_hand_v_axis_init(axis_state *state)
{
    state->settled = false;
    state->x_held = 0.0;
}

void axis_hand_v_axis_inputs_init(axis_inputs *inputs)
{
    hand_axis_inputs_init(inputs, MODE_OFF);
}

/* A cycle without a usable command position: the drive keeps the one that it has. */
SELDOM void hold(axis_state *restrict state, axis_outputs *restrict outputs)
{
    state->settled = false;
    *outputs = (axis_outputs){ .x_drive = state->x_held, .fault = true, .error_id = 17u };
}

/* A cycle in which only the position command is put out. */
SELDOM void follow(
    axis_state *restrict state,
    const axis_inputs *restrict inputs,
    axis_outputs *restrict outputs,
    uint32_t error_id)
{
    state->settled = false;
    state->x_held = inputs->x_command;
    *outputs = (axis_outputs){ .x_drive = inputs->x_command, .fault = error_id != 0u, .error_id = error_id };
}

/* An additive velocity beyond the range, or at its ends. */
SELDOM void saturate(axis_outputs *restrict outputs, double increments)
{
    if (increments >= highest) {
        outputs->additive_velocity = INT32_MAX;
        outputs->limited = increments > highest;
    } else if (increments <= lowest) {
        outputs->additive_velocity = INT32_MIN;
        outputs->limited = increments < lowest;
    } else {
        outputs->additive_velocity = nearest(increments);
    }
}

void axis_hand_v_axis_step(
    axis_state *restrict state, const axis_inputs *restrict inputs, axis_outputs *restrict outputs)
{
    if (!usable(inputs->x_command)) {
        hold(state, outputs);
        return;
    }
    if (inputs->task_cycle_ns != 0u && inputs->task_cycle_ns != CYCLE_TIME_NS) {
        follow(state, inputs, outputs, 1u);
        return;
    }
    if (!inputs->position_controlled || inputs->reset) {
        follow(state, inputs, outputs, 0u);
        return;
    }
    if (!usable(inputs->v_interpolator)) {
        follow(state, inputs, outputs, 14u);
        return;
    }
    const double v = feedforward_gain(inputs) * inputs->v_interpolator;
    const double before = state->settled ? state->before : v;
    state->settled = true;
    state->before = v;
    state->x_held = inputs->x_command;
    *outputs = (axis_outputs){ .x_drive = inputs->x_command };

    const double increments = increments_per_velocity * (now * v + earlier * before);
    if (fabs(increments) < highest) {
        outputs->additive_velocity = nearest(increments);
    } else {
        saturate(outputs, increments);
    }
}
