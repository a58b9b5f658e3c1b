/* What the hand-written axes with position control in the drive and one additive command share: all but its numbers.
 *
 * The file that includes it has defined
 *   AXIS(name)                      the names of the axis's types and functions
 *   INPUT, INPUT_ERROR              the input that the command comes from, and the error_id of one out of range
 *   OUTPUT, OUTPUT_MIN, OUTPUT_MAX  the output that it goes to, and the ends of its process data
 * and the constants now, earlier (the delay's weights), increments_per_input, highest, lowest.
 */
#include "hand_axis.h"

typedef AXIS(state) axis_state;
typedef AXIS(inputs) axis_inputs;
typedef AXIS(outputs) axis_outputs;

void AXIS(init)(axis_state *state)
{
    state->preset = false;
    state->x_held = 0.0;
    state->x_held_copy = 0.0;
}

void AXIS(inputs_init)(axis_inputs *inputs)
{
    *inputs = (axis_inputs){ .feedforward_percentage = 100, .position_controlled = true };
}

/* A cycle without a command position in range: the drive keeps the one that it has. */
SELDOM void hold(axis_state *restrict state, axis_outputs *restrict outputs)
{
    const bool is_intact = state->x_held == state->x_held_copy;
    state->preset = false;
    *outputs = (axis_outputs){
        .x_drive = is_intact ? state->x_held : 0.0, .fault = true, .error_id = is_intact ? 17u : 3u
    };
}

/* A cycle in which only the position command is put out. */
SELDOM void follow(
    axis_state *restrict state,
    const axis_inputs *restrict inputs,
    axis_outputs *restrict outputs,
    uint32_t error_id)
{
    state->preset = false;
    state->x_held = inputs->x_command;
    state->x_held_copy = inputs->x_command;
    *outputs = (axis_outputs){ .x_drive = inputs->x_command, .fault = error_id != 0u, .error_id = error_id };
}

/* An additive command beyond the range, or at its lower end. */
SELDOM void saturate(axis_outputs *restrict outputs, double increments)
{
    if (increments >= highest) {
        outputs->OUTPUT = OUTPUT_MAX;
        outputs->limited = true;
    } else if (increments <= lowest) {
        outputs->OUTPUT = OUTPUT_MIN;
        outputs->limited = true;
    } else {
        outputs->OUTPUT = nearest(increments);
    }
}

void AXIS(step)(
    axis_state *restrict state, const axis_inputs *restrict inputs, axis_outputs *restrict outputs)
{
    if (!in_range(inputs->x_command)) {
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
    if (!in_range(inputs->INPUT)) {
        follow(state, inputs, outputs, INPUT_ERROR);
        return;
    }
    const double x = feedforward_gain(inputs->feedforward_active, inputs->feedforward_percentage) * inputs->INPUT;
    if (!state->preset) {
        state->preset = true;
        state->before = x;
        state->before_copy = x;
    }
    const double before = state->before;
    const bool is_intact = before == state->before_copy;
    state->before = x;
    state->before_copy = x;
    state->x_held = inputs->x_command;
    state->x_held_copy = inputs->x_command;
    outputs->x_drive = inputs->x_command;
    outputs->error_id = 0u;
    outputs->limited = false;
    outputs->fault = false;

    double delayed = now * x + earlier * before;
    if (!is_intact) {
        state->preset = false;
        outputs->error_id = 3u;
        outputs->fault = true;
        delayed = x;
    }
    const double increments = increments_per_input * delayed;
    if (fabs(increments) < highest) {
        outputs->OUTPUT = nearest(increments);
    } else {
        saturate(outputs, increments);
    }
}
