/* The axis C of spindles.toml written by hand for speed: the yardstick for its generated block `spindle_axis`.
 *
 * Cycle 2 ms. Compile without contraction.
 *   feedforward: VEL, conventional, weight 1
 *   position control: in the CNC, Kv 20/s; 20000 increments at 1000 deg/min, 32 bits
 *   improved position control: one band-pass, limit 600000, fade 0.1 s
 *   changeover: Von 200 rpm, Voff 50 rpm
 *
 * The step below is what runs cycle after cycle: POSITION with the fade full or VELOCITY, with all samples, without a request.
 * It leaves by a call in last place where anything else is the case, so that none of that costs it a register.
 * The coefficients are those that the generator prints.
 */
#include "axis_hand_c_spindle_axis.h"

#define SPINDLE(name) axis_hand_c_spindle_axis_##name
#define in_drive 0
#define DISPLAYS(inputs, a_mode) true
#define LEAD_TIME(inputs) lead_time_of(inputs)

static double lead_time_of(const axis_hand_c_spindle_axis_inputs *inputs);

#include "hand_spindle.h"

#define FADE_CYCLES 50u

static const double anti_denormal = 1.0e-30; /* keeps a section at rest out of the subnormal range */
static const double limit = 600000.0;
static const double rest = 2.6020852139652106e-11; /* 30000000 * 2^-60 */
static const double fade_step = 0.02;

static const double kv = 20.0; /* 1/s */
static const double increments_per_velocity = 1.2;
static const double highest = 2147483647.5; /* rounded beyond the range from here on */
static const double lowest = -2147483648.5;

/* BANDPASS order 1, 53 Hz, Q 10 */
static const double bp0_minus_b0 = -0.03223920621235247;
static const double bp0_a1 = -1.5218782344611583;
static const double bp0_a2 = 0.935521587575295;
static const double gain0 = -3.0; /* -weight */

static double lead_time_of(const axis_inputs *inputs)
{
    int32_t percentage = inputs->feedforward_active ? inputs->feedforward_percentage : 0;
    percentage = percentage < 0 ? 0 : percentage < 100 ? percentage : 100;
    return 0.052000000000000005 - 0.0005 * (double)percentage;
}

void axis_hand_c_spindle_axis_init(axis_state *state)
{
    init_spindle(&state->spindle);
    state->preset = false;
    state->fade = 0u;
    state->lag = 0.0;
    state->v_held = 0.0;
}

void axis_hand_c_spindle_axis_inputs_init(axis_inputs *inputs)
{
    *inputs = (axis_inputs){ .mode = MODE_ON, .feedforward_percentage = 100 };
}

/* The stage, within the limit; 0 for an axis at rest. */
OFTEN double run_stage(axis_state *restrict state, double v_motor, bool *limited)
{
    const double t = bp0_minus_b0 * v_motor;
    const double y = state->bp0.s1 - t;
    state->bp0.s1 = state->bp0.s2 - bp0_a1 * y;
    state->bp0.s2 = t + anti_denormal - bp0_a2 * y;
    const double v = gain0 * y;
    *limited = fabs(v) > limit;
    if (*limited) {
        return copysign(limit, v);
    }
    return fabs(v) <= rest ? 0.0 : v;
}

/* The lag as an angle, on the side of the one before. Without samples it has grown by up to the whole way. */
OFTEN double continued(double lag, double before, double v_missed, uint32_t missed)
{
    const double angle = fabs(lag) <= 180000.0 ? lag : shortest(lag);
    if (!(fabs(before) <= 170000.0)) {
        return angle;
    }
    double expected = before;
    if (missed > 0u) {
        expected += v_missed * (cycle_time * ((double)(missed + 1u) * 0.5));
    }
    if (fabs(angle - expected) <= 180000.0) {
        return angle;
    }
    return angle < expected ? angle + 360000.0 : angle - 360000.0;
}

/* The output of the position controller. A lag up to 60 deg is what it looks like. */
OFTEN double control(
    axis_state *restrict state,
    double x,
    double x_actual,
    double v_missed,
    double v_feedforward,
    uint32_t missed,
    bool *gives_up)
{
    double lag = x - x_actual;
    *gives_up = false;
    if (missed > 0u || !(fabs(lag) <= 60000.0)) {
        lag = continued(lag, state->lag, v_missed, missed);
        *gives_up = !(fabs(lag) <= 170000.0);
    }
    state->lag = lag;
    state->v_held = kv * (x - (x - lag)) + v_feedforward;
    return state->v_held;
}

/* The additive velocity in any cycle of a spindle that follows its position; gives the error of improved position control. */
OFTEN uint32_t improve(
    axis_state *restrict state,
    const axis_inputs *restrict inputs,
    axis_outputs *restrict outputs,
    bool loop_closed,
    double *v_add,
    bool *limited)
{
    const int32_t mode = inputs->mode;
    uint32_t error_id = 0u;
    *v_add = 0.0;
    *limited = false;
    if (!in_range(inputs->v_motor)) {
        error_id = 12u;
    } else if (mode != MODE_OFF && mode != MODE_ON && mode != MODE_DRYRUN) {
        error_id = 2u;
    }
    if (error_id != 0u || !loop_closed) {
        state->preset = false;
        state->fade = 0u;
        outputs->v_add_calculated = 0.0;
    } else if (!state->preset) {
        if (mode != MODE_OFF) {
            state->bp0.s1 = state->bp0.s2 = bp0_minus_b0 * inputs->v_motor;
            state->preset = true;
        }
        outputs->v_add_calculated = 0.0;
    } else {
        if (mode == MODE_ON) {
            state->fade += state->fade < FADE_CYCLES;
        } else if (state->fade > 0u) {
            state->fade -= 1u;
        }
        if (mode == MODE_OFF && state->fade == 0u) {
            state->preset = false;
            outputs->v_add_calculated = 0.0;
            return error_id;
        }
        const double v = run_stage(state, inputs->v_motor, limited);
        if (state->fade == FADE_CYCLES) {
            *v_add = v;
        } else if (state->fade > 0u) {
            *v_add = v * ((double)state->fade * fade_step);
        }
        outputs->v_add_calculated = mode == MODE_OFF ? 0.0 : v;
    }
    return error_id;
}

/* Any cycle. */
SELDOM void any(axis_state *restrict state, const axis_inputs *restrict inputs, axis_outputs *restrict outputs)
{
    hand_spindle *restrict spindle = &state->spindle;
    const uint32_t missed = spindle->missing;
    const double v_missed = spindle->v;
    const bool had_failed = spindle->lasting_error != 0u;
    hand_cycle cycle = change_over(spindle, inputs);
    const bool is_closed = cycle.control == POSITION || cycle.control == TO_VELOCITY;
    if (is_closed && spindle->lasting_error != 0u && !had_failed) {
        hold_back(spindle, state->v_held); /* brakes from what the drive got */
    }
    bool gives_up = false;
    double v_command = spindle->v;
    double v_feedforward = 0.0;
    double v_add = 0.0;
    bool limited = false;
    const bool in_loop = spindle->lasting_error == 0u && inputs->drive_on && is_closed;
    const bool follows = in_loop && spindle->missing == 0u;
    if (follows) {
        v_feedforward = feedforward_gain(inputs->feedforward_active, inputs->feedforward_percentage) * spindle->v;
        v_command = control(state, spindle->x, inputs->x_actual, v_missed, v_feedforward, missed, &gives_up);
        const bool improves = cycle.loop_closed && !inputs->reset;
        const uint32_t error_id = improve(state, inputs, outputs, improves, &v_add, &limited);
        if (error_id != 0u) {
            cycle.error_id = error_id;
        }
    } else {
        state->preset = false;
        state->fade = 0u;
        outputs->v_add_calculated = 0.0;
        if (in_loop) {
            v_command = state->v_held;
        } else if (cycle.control == BRAKE || cycle.control == TO_POSITION) {
            state->lag = 0.0;
            state->v_held = v_command;
        }
    }
    outputs->x_spindle = spindle->x;
    outputs->v_spindle = spindle->v;
    put_out_job(spindle, outputs);
    outputs->v_command = v_command;
    outputs->v_feedforward = v_feedforward;
    outputs->v_add = v_add;
    outputs->spindle_state = cycle.control;
    outputs->waiting = spindle->queued;
    const double increments = increments_per_velocity * (follows ? v_command + v_add : v_command);
    if (fabs(increments) < highest) {
        outputs->manipulated_variable = nearest(increments);
    } else {
        outputs->manipulated_variable = increments > 0.0 ? INT32_MAX : INT32_MIN;
        limited = limited || increments > 0.0 || increments <= lowest;
    }
    if (gives_up) {
        hold_back(spindle, state->v_held);
        spindle->lasting_error = 48u;
        cycle.error_id = 48u;
    }
    outputs->error_id = cycle.error_id;
    outputs->loop_closed = cycle.loop_closed;
    outputs->limited = limited;
    outputs->fault = cycle.error_id != 0u;
}

/* The manipulated variable beyond the range, or at its lower end. */
SELDOM void saturate(axis_outputs *restrict outputs, double increments, bool limited)
{
    outputs->manipulated_variable = increments > 0.0 ? INT32_MAX : INT32_MIN;
    outputs->limited = limited || increments > 0.0 || increments <= lowest;
}

/* POSITION or VELOCITY with all samples, and nothing to report. */
OFTEN void put_out(
    hand_spindle *restrict spindle,
    axis_outputs *restrict outputs,
    double x,
    double v,
    double v_drive,
    bool limited,
    bool in_position)
{
    spindle->x = x;
    spindle->v = v;
    outputs->x_spindle = x;
    outputs->v_spindle = v;
    put_out_job(spindle, outputs);
    outputs->spindle_state = in_position ? POSITION : VELOCITY;
    outputs->waiting = 0u;
    outputs->error_id = 0u;
    outputs->loop_closed = in_position;
    outputs->fault = false;
    const double increments = increments_per_velocity * v_drive;
    if (fabs(increments) < highest) {
        outputs->manipulated_variable = nearest(increments);
        outputs->limited = limited;
    } else {
        saturate(outputs, increments, limited);
    }
}

/* POSITION, and the fade full. */
OFTEN void run_in_position(
    axis_state *restrict state, const axis_inputs *restrict inputs, axis_outputs *restrict outputs)
{
    hand_spindle *restrict spindle = &state->spindle;
    const double v = inputs->v_interpolator;
    if (spindle->turns_fast && fabs(v) >= v_velocity_control_on) {
        enter(spindle, TO_VELOCITY);
    }
    const double x = wrap(inputs->x_command);
    const double v_feedforward = feedforward_gain(inputs->feedforward_active, inputs->feedforward_percentage) * v;
    bool gives_up;
    const double v_command = control(state, x, inputs->x_actual, 0.0, v_feedforward, 0u, &gives_up);
    bool limited;
    const double v_add = run_stage(state, inputs->v_motor, &limited);
    outputs->v_command = v_command;
    outputs->v_feedforward = v_feedforward;
    outputs->v_add = v_add;
    outputs->v_add_calculated = v_add;
    put_out(spindle, outputs, x, v, v_command + v_add, limited, true);
    if (gives_up) {
        hold_back(spindle, state->v_held);
        spindle->lasting_error = 48u;
        outputs->error_id = 48u;
        outputs->fault = true;
    }
}

/* VELOCITY: improved position control has been off since TO_VELOCITY. */
OFTEN void run_in_velocity(
    axis_state *restrict state, const axis_inputs *restrict inputs, axis_outputs *restrict outputs)
{
    const double v = inputs->v_interpolator;
    state->spindle.missing = 0u;
    outputs->v_command = v;
    outputs->v_feedforward = 0.0;
    outputs->v_add = 0.0;
    outputs->v_add_calculated = 0.0;
    put_out(&state->spindle, outputs, wrap(inputs->x_actual), v, v, false, false);
}

void axis_hand_c_spindle_axis_step(
    axis_state *restrict state, const axis_inputs *restrict inputs, axis_outputs *restrict outputs)
{
    hand_spindle *restrict spindle = &state->spindle;
    if (has_requests(spindle, inputs) || !is_plain(spindle, inputs) || !in_range(inputs->v_interpolator)
        || !position_in_range(inputs->x_actual)) {
        any(state, inputs, outputs);
        return;
    }
    switch (spindle->control) {
    case POSITION:
        /* What takes over, and every missing sample, has emptied the fade. */
        if (!position_in_range(inputs->x_command) || !in_range(inputs->v_motor) || inputs->mode != MODE_ON
            || state->fade != FADE_CYCLES) {
            any(state, inputs, outputs);
            return;
        }
        run_in_position(state, inputs, outputs);
        return;
    case VELOCITY:
        if (spindle->returns) {
            any(state, inputs, outputs);
            return;
        }
        run_in_velocity(state, inputs, outputs);
        return;
    default:
        any(state, inputs, outputs);
        return;
    }
}
