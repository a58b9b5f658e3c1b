/* What the hand-written spindles share: requests, jobs and the five states of docs/spindle.md, in cycles that are not mostly so.
 *
 * The file that includes it has defined
 *   SPINDLE(name)                 the names of the axis's types and functions
 *   in_drive                      1: the drive controls the position, 0: the CNC
 *   DISPLAYS(inputs, a_mode)      whether the drive says that it is in a mode
 *   LEAD_TIME(inputs)             by how long the position command leads where position control is taken up
 * and the constants of the spindle, as hand_s.c has them.
 */
#include "hand_axis.h"

#define POSITION 0
#define TO_VELOCITY 1
#define VELOCITY 2
#define BRAKE 3
#define TO_POSITION 4

#define STOP 0
#define TURN 1
#define TO_TARGET 2
#define RELEASE 3
#define HOME 4

#define SPINDLE_CYCLE_TIME_NS 2000000u

typedef SPINDLE(state) axis_state;
typedef SPINDLE(inputs) axis_inputs;
typedef SPINDLE(outputs) axis_outputs;

static const double cycle_time = 0.002; /* s */
static const double v_velocity_control_on = 1200000.0; /* Von */
static const double v_position_control_on = 300000.0; /* Voff */
static const double window = 6000.0;
static const double v_taken_up = 306000.0; /* Voff and the window */
static const double v_step = 12000.0; /* deceleration in a cycle */
static const double takeover_window = 1000.0;
static const double takeover_way = 12.0; /* deceleration * cycle_time^2 / 2 */
static const uint32_t mode_cycles = 50u;
static const uint32_t start_cycles = 52u; /* of a drive that has come on */
static const uint32_t brake_cycles = 5200u;
static const double full_turn = 360000.0;
static const double per_turn = 2.777777777777778e-6;

/* As a position. A NaN is not. */
OFTEN bool position_in_range(double x)
{
    return fabs(x) <= 7.0e14;
}

OFTEN double wrap(double x)
{
    double rest = x - (double)(int32_t)(x * per_turn) * full_turn;
    if (rest < 0.0) {
        rest += full_turn;
    }
    if (rest >= full_turn) {
        rest -= full_turn;
    }
    return rest;
}

/* The shortest way. */
OFTEN double shortest(double distance)
{
    return distance - (double)nearest(distance * per_turn) * full_turn;
}

/* Whether a request is TRUE, or was: mostly not. */
OFTEN bool has_requests(const hand_spindle *spindle, const axis_inputs *inputs)
{
    return inputs->m3 | inputs->m4 | inputs->m5 | inputs->m19 | inputs->putax | inputs->g74 | spindle->was_true;
}

/* Whether the job is one that can be asked for: what overwrote it does not come out. */
OFTEN bool is_job(const hand_job *job)
{
    return (uint32_t)job->kind <= HOME && in_range(job->speed) && position_in_range(job->position);
}

/* Whether the spindle is led by its state alone in this cycle. */
OFTEN bool is_plain(const hand_spindle *spindle, const axis_inputs *inputs)
{
    return is_job(&spindle->job) && inputs->drive_on && !inputs->reset && spindle->lasting_error == 0u && spindle->queued == 0u
        && (inputs->task_cycle_ns == 0u || inputs->task_cycle_ns == SPINDLE_CYCLE_TIME_NS);
}

/* The outputs that are the same in all states where nothing waits and nothing is wrong. */
OFTEN void put_out_job(const hand_spindle *spindle, axis_outputs *restrict outputs)
{
    outputs->job_speed = spindle->job.speed;
    outputs->job_position = spindle->job.position;
    outputs->job = spindle->job.kind;
    outputs->job_number = spindle->jobs;
}

OFTEN void enter(hand_spindle *spindle, int32_t control)
{
    spindle->control = control;
    spindle->cycles = 0u;
    spindle->settled = 0u;
    spindle->missing = 0u;
}

OFTEN void advance(hand_spindle *spindle)
{
    spindle->x += spindle->v * cycle_time;
}

/* Towards 0, not beyond v_end or its negative; there is no -0. */
OFTEN void slow_down(hand_spindle *spindle, double v_end)
{
    const double v_end_negative = 0.0 - v_end;
    if (spindle->v > v_end) {
        spindle->v -= v_step;
        if (spindle->v < v_end) {
            spindle->v = v_end;
        }
    } else if (spindle->v < v_end_negative) {
        spindle->v += v_step;
        if (spindle->v > v_end_negative) {
            spindle->v = v_end_negative;
        }
    }
}

/* A request that has become TRUE goes behind those that wait; gives the error. */
SELDOM uint32_t take(hand_spindle *restrict spindle, const axis_inputs *restrict inputs)
{
    const bool m19 = inputs->m19 && !spindle->m19;
    const bool turn = !m19 && ((inputs->m3 && !spindle->m3) || (inputs->m4 && !spindle->m4));
    const bool m5 = inputs->m5 && !spindle->m5;
    const bool putax = inputs->putax && !spindle->putax;
    const bool g74 = inputs->g74 && !spindle->g74;
    spindle->m3 = inputs->m3;
    spindle->m4 = inputs->m4;
    spindle->m5 = inputs->m5;
    spindle->m19 = inputs->m19;
    spindle->putax = inputs->putax;
    spindle->g74 = inputs->g74;
    spindle->was_true = inputs->m3 || inputs->m4 || inputs->m5 || inputs->m19 || inputs->putax || inputs->g74;
    const int count = g74 + putax + m19 + m5 + turn;
    if (inputs->reset || count == 0) {
        return 0u;
    }
    hand_job wanted = { .kind = g74 ? HOME : putax ? RELEASE : m19 ? TO_TARGET : m5 ? STOP : TURN };
    if (wanted.kind == TURN || wanted.kind == TO_TARGET) {
        if (inputs->m3 && inputs->m4) {
            return 32u;
        }
        if (!in_range(inputs->s_word)) {
            return 33u;
        }
        wanted.speed = (inputs->s_word < 0.0) == inputs->m4 ? inputs->s_word : -inputs->s_word;
        if (wanted.kind == TO_TARGET) {
            if (!position_in_range(inputs->s_position)) {
                return 34u;
            }
            wanted.position = inputs->s_position;
        }
    }
    if (!inputs->drive_on) {
        return 36u;
    }
    if (spindle->queued >= 4u) {
        return 35u;
    }
    spindle->request[spindle->queued] = wanted;
    spindle->queued += 1u;
    return count > 1 ? 31u : 0u;
}

/* Without a sample: on as before, an error that stays in the fourth cycle. Gives the error of the cycle. */
OFTEN uint32_t coast(hand_spindle *spindle, uint32_t error_id)
{
    spindle->missing += 1u;
    spindle->takes_over = true;
    if (spindle->missing > 3u) {
        spindle->lasting_error = error_id;
    } else {
        advance(spindle);
    }
    return error_id;
}

OFTEN void track(hand_spindle *spindle, const axis_inputs *inputs)
{
    spindle->missing = 0u;
    spindle->takes_over = false;
    spindle->x = inputs->x_command;
    spindle->v = inputs->v_interpolator;
}

/* 180 deg in a cycle, or more. */
OFTEN bool is_half_turn(double v)
{
    return in_drive && fabs(v) >= 90000000.0;
}

/* The velocity command, not beyond another velocity, in its direction. */
OFTEN void hold_back(hand_spindle *spindle, double v)
{
    const double low = v < 0.0 ? v : 0.0;
    const double high = v < 0.0 ? 0.0 : v;
    if (spindle->v > high) {
        spindle->v = high;
    } else if (spindle->v < low) {
        spindle->v = low;
    }
}

/* Whether the interpolator does not go on from where the spindle is, where it takes over. */
OFTEN bool jumps(const hand_spindle *spindle, const axis_inputs *inputs)
{
    const double cycles = (double)(spindle->missing + 1u);
    const double furthest = takeover_window + takeover_way * (cycles * (cycles + 1.0));
    return spindle->takes_over
        && !(fabs(shortest(inputs->x_command - (spindle->x + spindle->v * cycle_time))) <= furthest);
}

OFTEN uint32_t in_position(hand_spindle *spindle, const axis_inputs *inputs)
{
    if (!in_range(inputs->v_interpolator)) {
        return coast(spindle, 14u);
    }
    if (!position_in_range(inputs->x_command)) {
        return coast(spindle, 17u);
    }
    if (!in_drive && !position_in_range(inputs->x_actual)) {
        return coast(spindle, 18u);
    }
    if (!DISPLAYS(inputs, position_mode)) {
        return coast(spindle, 45u);
    }
    if (is_half_turn(inputs->v_interpolator)) {
        spindle->lasting_error = 44u;
        return 0u;
    }
    if (jumps(spindle, inputs)) {
        spindle->lasting_error = 46u;
        return 0u;
    }
    track(spindle, inputs);
    if (spindle->turns_fast && fabs(inputs->v_interpolator) >= v_velocity_control_on && !inputs->reset) {
        enter(spindle, TO_VELOCITY);
    }
    return 0u;
}

OFTEN uint32_t to_velocity(hand_spindle *spindle, const axis_inputs *inputs)
{
    spindle->asks_velocity = true;
    if (!in_range(inputs->v_interpolator)) {
        return coast(spindle, 14u);
    }
    if (!position_in_range(inputs->x_command)) {
        return coast(spindle, 17u);
    }
    if (!in_drive && !position_in_range(inputs->x_actual)) {
        return coast(spindle, 18u);
    }
    if (is_half_turn(inputs->v_interpolator)) {
        spindle->lasting_error = 44u;
    } else if (jumps(spindle, inputs)) {
        spindle->lasting_error = 46u;
    } else if (DISPLAYS(inputs, velocity_mode)) {
        track(spindle, inputs);
        enter(spindle, VELOCITY);
    } else if (spindle->cycles > mode_cycles) {
        spindle->lasting_error = 41u;
    } else {
        track(spindle, inputs);
    }
    return 0u;
}

OFTEN uint32_t in_velocity(hand_spindle *spindle, const axis_inputs *inputs)
{
    if (!in_range(inputs->v_interpolator)) {
        return coast(spindle, 14u);
    }
    if (!DISPLAYS(inputs, velocity_mode)) {
        return coast(spindle, 45u);
    }
    spindle->missing = 0u;
    spindle->v = inputs->v_interpolator;
    if (position_in_range(inputs->x_actual)) {
        spindle->x = inputs->x_actual;
    } else {
        advance(spindle);
    }
    if (spindle->returns || (spindle->queued > 0u && spindle->request[0].kind > TURN)) {
        spindle->returns = false;
        enter(spindle, BRAKE);
    }
    return 0u;
}

/* A position that leads another one; a velocity that no spindle has leads nowhere. */
OFTEN double ahead(double x, double way)
{
    return fabs(way) <= 1.0e9 ? x + way : x;
}

/* TO_POSITION is next, with the position that belongs to this velocity. */
OFTEN void resynchronise(hand_spindle *spindle, const axis_inputs *inputs)
{
    spindle->x_start = wrap(ahead(inputs->x_actual, spindle->v * LEAD_TIME(inputs)));
    spindle->is_moving = true;
    spindle->catches = false;
    enter(spindle, TO_POSITION);
}

OFTEN uint32_t in_brake(hand_spindle *spindle, const axis_inputs *inputs)
{
    uint32_t error_id = 0u;
    bool is_slow = false;
    if (DISPLAYS(inputs, velocity_mode)) {
        spindle->catches = false;
    }
    if (!in_range(inputs->v_actual)) {
        error_id = 23u;
    } else {
        const double speed = fabs(spindle->v);
        const double along = spindle->v < 0.0 ? -inputs->v_actual : inputs->v_actual;
        is_slow = speed <= v_position_control_on && -window <= along && along <= speed + window;
    }
    spindle->settled = is_slow ? spindle->settled + 1u : 0u;
    bool can_leave = spindle->settled >= 3u;
    if (can_leave && !position_in_range(inputs->x_actual)) {
        can_leave = false;
        error_id = 18u;
    }
    if (!can_leave && spindle->catches && spindle->cycles > mode_cycles) {
        spindle->lasting_error = 41u;
        return error_id;
    }
    if (!can_leave && spindle->cycles > brake_cycles) {
        spindle->lasting_error = 42u;
        return error_id;
    }
    slow_down(spindle, v_position_control_on);
    advance(spindle);
    if (can_leave) {
        resynchronise(spindle, inputs);
    }
    return error_id;
}

/* Takes a sample of a spindle that the block does not move yet. Whether there is one. */
OFTEN bool look(hand_spindle *spindle, double v_actual)
{
    if (!in_range(v_actual)) {
        spindle->samples = 0u;
        spindle->slow = 0u;
        return false;
    }
    if (spindle->samples == 0u) {
        spindle->v_last = v_actual;
        spindle->v_older = v_actual;
    }
    const double low = fmin(spindle->v_older, spindle->v_last);
    const double high = fmax(spindle->v_older, spindle->v_last);
    spindle->v_middle = fmax(low, fmin(high, v_actual));
    spindle->v_older = spindle->v_last;
    spindle->v_last = v_actual;
    spindle->samples += spindle->samples < 3u;
    spindle->slow = fabs(v_actual) <= v_taken_up ? spindle->slow + (spindle->slow < 3u) : 0u;
    return true;
}

/* With what the spindle turns. */
OFTEN double turning(const hand_spindle *spindle)
{
    return fabs(spindle->v_middle) <= window ? 0.0 : spindle->v_middle;
}

/* The position command of a spindle that turns with v. */
OFTEN void show(hand_spindle *spindle, const axis_inputs *inputs)
{
    spindle->x = wrap(ahead(inputs->x_actual, spindle->v * (LEAD_TIME(inputs) - cycle_time)));
}

/* The commands go with a spindle that the block does not move yet; gives the error. */
OFTEN uint32_t accompany(hand_spindle *spindle, const axis_inputs *inputs)
{
    const bool is_known = look(spindle, inputs->v_actual);
    const bool is_found = position_in_range(inputs->x_actual);
    if (is_known) {
        spindle->v = turning(spindle);
    }
    spindle->asks_velocity = !is_known || !is_found || fabs(spindle->v) > v_taken_up;
    return !is_known ? 23u : is_found ? 0u : 18u;
}

/* The drive has come on. */
OFTEN uint32_t at_start(hand_spindle *spindle, const axis_inputs *inputs)
{
    const uint32_t error_id = accompany(spindle, inputs);
    if (error_id == 0u && spindle->samples >= 3u) {
        if (fabs(spindle->v) > v_taken_up) {
            spindle->catches = true;
            spindle->is_moving = true;
            enter(spindle, BRAKE);
        } else if (spindle->slow >= 3u && fabs(spindle->v) > 0.0) {
            resynchronise(spindle, inputs);
        } else if (spindle->slow >= 3u && DISPLAYS(inputs, position_mode)) {
            spindle->takes_over = true;
            enter(spindle, POSITION);
        }
    }
    if (spindle->cycles > start_cycles) {
        spindle->lasting_error = 43u;
    }
    return error_id;
}

OFTEN uint32_t to_position(hand_spindle *spindle, const axis_inputs *inputs)
{
    if (!spindle->is_moving) {
        return at_start(spindle, inputs);
    }
    spindle->asks_velocity = false;
    const bool is_displayed = DISPLAYS(inputs, position_mode);
    if (!is_displayed && spindle->cycles > mode_cycles) {
        spindle->lasting_error = 43u;
        return 0u;
    }
    if (spindle->cycles == 1u) {
        spindle->x = spindle->x_start;
    } else {
        advance(spindle);
    }
    if (is_displayed) {
        spindle->takes_over = true;
        enter(spindle, POSITION);
    }
    return 0u;
}

/* Whether the block does not move the spindle yet. */
OFTEN bool is_at_start(const hand_spindle *spindle)
{
    return spindle->control == TO_POSITION && !spindle->is_moving;
}

OFTEN void reset(hand_spindle *spindle, bool drive_on)
{
    spindle->queued = 0u;
    if (spindle->lasting_error != 0u) {
        spindle->lasting_error = 0u;
        spindle->returns = false;
        if (drive_on && is_at_start(spindle)) {
            spindle->samples = 0u;
            spindle->slow = 0u;
            enter(spindle, TO_POSITION);
        } else if (drive_on) {
            enter(spindle, BRAKE);
        }
    } else if (spindle->control == TO_VELOCITY || spindle->control == VELOCITY) {
        spindle->returns = true;
    }
}

/* The drive is off: the commands follow the spindle, and the velocity goes to 0 besides; gives the error. */
OFTEN uint32_t follow(hand_spindle *spindle, const axis_inputs *inputs)
{
    if (!is_at_start(spindle)) {
        spindle->samples = 0u;
        spindle->slow = 0u;
    }
    enter(spindle, TO_POSITION);
    spindle->returns = false;
    spindle->catches = false;
    spindle->is_moving = false;
    spindle->queued = 0u;
    spindle->takes_over = false;
    slow_down(spindle, 0.0);
    const bool is_found = position_in_range(inputs->x_actual);
    spindle->asks_velocity = true;
    if (look(spindle, inputs->v_actual)) {
        const double v_turning = turning(spindle);
        spindle->asks_velocity = !is_found || fabs(v_turning) > 0.0;
        hold_back(spindle, v_turning);
    }
    if (!is_found) {
        return 18u;
    }
    show(spindle, inputs);
    return 0u;
}

/* The next job, or none. */
OFTEN void serve(hand_spindle *spindle, const axis_inputs *inputs)
{
    if (!inputs->drive_on || inputs->reset || spindle->lasting_error != 0u || spindle->control == BRAKE) {
        if (spindle->job.kind != STOP) {
            spindle->job = (hand_job){ .kind = STOP };
            spindle->turns_fast = false;
            spindle->jobs += 1u;
        }
        return;
    }
    if (spindle->queued == 0u || (spindle->job.kind > TURN && !inputs->job_done)) {
        return;
    }
    if (spindle->control == POSITION || (spindle->control == VELOCITY && spindle->request[0].kind <= TURN)) {
        spindle->job = spindle->request[0];
        spindle->turns_fast = spindle->job.kind == TURN && fabs(spindle->job.speed) > v_velocity_control_on;
        spindle->request[0] = spindle->request[1];
        spindle->request[1] = spindle->request[2];
        spindle->request[2] = spindle->request[3];
        spindle->queued -= 1u;
        spindle->jobs += 1u;
    }
}

/* What the axis needs to know of a cycle of the spindle. */
typedef struct {
    int32_t control;
    uint32_t error_id;
    bool loop_closed;
} hand_cycle;

/* Any cycle. */
OFTEN hand_cycle change_over(hand_spindle *restrict spindle, const axis_inputs *restrict inputs)
{
    uint32_t request_error = 0u;
    if (has_requests(spindle, inputs)) {
        request_error = take(spindle, inputs);
    }
    if (inputs->reset) {
        reset(spindle, inputs->drive_on);
    }
    if (inputs->task_cycle_ns != 0u && inputs->task_cycle_ns != SPINDLE_CYCLE_TIME_NS && spindle->lasting_error == 0u) {
        spindle->lasting_error = 1u;
    }
    uint32_t error_id = 0u;
    hand_cycle cycle;
    if (!inputs->drive_on) {
        error_id = follow(spindle, inputs);
        cycle.control = TO_POSITION;
    } else {
        cycle.control = spindle->control;
        const bool starts = is_at_start(spindle);
        if (spindle->lasting_error != 0u && starts && spindle->cycles == 0u) {
            /* An error has outlasted the drive that was off: in its first cycle the spindle keeps its velocity. */
            error_id = accompany(spindle, inputs);
            spindle->catches = spindle->asks_velocity;
            spindle->is_moving = true;
        } else {
            if (spindle->lasting_error == 0u) {
                spindle->cycles += 1u;
                switch (spindle->control) {
                case POSITION: error_id = in_position(spindle, inputs); break;
                case TO_VELOCITY: error_id = to_velocity(spindle, inputs); break;
                case VELOCITY: error_id = in_velocity(spindle, inputs); break;
                case BRAKE: error_id = in_brake(spindle, inputs); break;
                default: error_id = to_position(spindle, inputs); break;
                }
            }
            if (spindle->lasting_error != 0u) {
                slow_down(spindle, 0.0);
            }
        }
        const bool is_late = spindle->lasting_error != 0u && !DISPLAYS(inputs, position_mode);
        if ((starts || is_late) && position_in_range(inputs->x_actual)) {
            show(spindle, inputs);
        } else if (starts || spindle->lasting_error != 0u) {
            advance(spindle);
        }
    }
    spindle->x = wrap(spindle->x);
    cycle.loop_closed = cycle.control == POSITION && spindle->lasting_error == 0u && error_id == 0u;
    if (spindle->lasting_error != 0u) {
        cycle.error_id = spindle->lasting_error;
    } else {
        cycle.error_id = error_id != 0u ? error_id : request_error;
    }
    serve(spindle, inputs);
    return cycle;
}

OFTEN void init_spindle(hand_spindle *spindle)
{
    *spindle = (hand_spindle){
        .control = TO_POSITION,
        .was_true = true,
        .m3 = true,
        .m4 = true,
        .m5 = true,
        .m19 = true,
        .putax = true,
        .g74 = true,
    };
}
