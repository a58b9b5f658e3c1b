/* The axis S of spindles.toml written by hand for speed: the yardstick for its generated block `spindle_axis`.
 *
 * Cycle 2 ms. Compile without contraction.
 *   position control: in the drive, the position command goes there as it is
 *   changeover: Von 200 rpm, Voff 50 rpm; 1 increment at 36/1000 deg/min, 32 bits
 *
 * The step below is what runs cycle after cycle: POSITION or VELOCITY, with all samples, without a request. It leaves by a
 * call in last place where anything else is the case, so that none of that costs it a register.
 */
#include "axis_hand_s_spindle_axis.h"

#define SPINDLE(name) axis_hand_s_spindle_axis_##name
#define in_drive 1
#define DISPLAYS(inputs, a_mode) ((inputs)->operation_mode_display == (a_mode))
#define LEAD_TIME(inputs) lead_time

static const int32_t position_mode = 0;
static const int32_t velocity_mode = 1;
static const double lead_time = 0.035; /* s */
static const double increments_per_velocity = 1.6666666666666667;
static const double highest = 2147483647.5; /* rounded beyond the range from here on */
static const double lowest = -2147483648.5;
static const double v_half_turn = 90000000.0; /* 180 deg in a cycle; process data within the range */

#include "hand_spindle.h"

void axis_hand_s_spindle_axis_init(axis_state *state)
{
    init_spindle(&state->spindle);
}

void axis_hand_s_spindle_axis_inputs_init(axis_inputs *inputs)
{
    *inputs = (axis_inputs){ .drive_on = false };
}

/* Any cycle. */
SELDOM void any(axis_state *restrict state, const axis_inputs *restrict inputs, axis_outputs *restrict outputs)
{
    hand_spindle *restrict spindle = &state->spindle;
    const hand_cycle cycle = change_over(spindle, inputs);
    outputs->x_spindle = spindle->x;
    outputs->v_spindle = spindle->v;
    outputs->x_drive = spindle->x;
    outputs->spindle_state = cycle.control;
    put_out_job(spindle, outputs);
    outputs->waiting = spindle->queued;
    outputs->operation_mode = spindle->asks_velocity ? velocity_mode : position_mode;
    const double increments = increments_per_velocity * spindle->v;
    if (fabs(increments) < highest) {
        outputs->velocity_command = nearest(increments);
        outputs->limited = false;
    } else {
        outputs->velocity_command = increments > 0.0 ? INT32_MAX : INT32_MIN;
        outputs->limited = increments > 0.0 || increments <= lowest;
    }
    outputs->error_id = cycle.error_id;
    outputs->loop_closed = cycle.loop_closed;
    outputs->fault = cycle.error_id != 0u;
}

/* POSITION or VELOCITY with all samples, and nothing to report. */
OFTEN void put_out(
    hand_spindle *restrict spindle, axis_outputs *restrict outputs, double x, double v, double increments, bool in_position)
{
    spindle->x = x;
    spindle->v = v;
    outputs->x_spindle = x;
    outputs->v_spindle = v;
    put_out_job(spindle, outputs);
    outputs->x_drive = x;
    outputs->spindle_state = in_position ? POSITION : VELOCITY;
    outputs->waiting = 0u;
    outputs->operation_mode = in_position ? position_mode : velocity_mode;
    outputs->velocity_command = nearest(increments);
    outputs->error_id = 0u;
    outputs->loop_closed = in_position;
    outputs->limited = false;
    outputs->fault = false;
}

void axis_hand_s_spindle_axis_step(
    axis_state *restrict state, const axis_inputs *restrict inputs, axis_outputs *restrict outputs)
{
    hand_spindle *restrict spindle = &state->spindle;
    if (has_requests(spindle, inputs) || !is_plain(spindle, inputs)) {
        any(state, inputs, outputs);
        return;
    }
    const double v = inputs->v_interpolator;
    const double increments = increments_per_velocity * v;
    switch (spindle->control) {
    case POSITION:
        if (!(fabs(v) < v_half_turn) || !position_in_range(inputs->x_command)
            || inputs->operation_mode_display != position_mode || spindle->takes_over) {
            any(state, inputs, outputs);
            return;
        }
        if (spindle->turns_fast && fabs(v) >= v_velocity_control_on) {
            enter(spindle, TO_VELOCITY);
        }
        put_out(spindle, outputs, wrap(inputs->x_command), v, increments, true);
        return;
    case VELOCITY:
        if (!(fabs(increments) < highest) || !position_in_range(inputs->x_actual)
            || inputs->operation_mode_display != velocity_mode || spindle->returns) {
            any(state, inputs, outputs);
            return;
        }
        spindle->missing = 0u;
        put_out(spindle, outputs, wrap(inputs->x_actual), v, increments, false);
        return;
    default:
        any(state, inputs, outputs);
        return;
    }
}
