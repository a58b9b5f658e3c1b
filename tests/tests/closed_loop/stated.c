/* What docs/spindle.md states about the emitted block `spindle_axis`. With position control in the CNC: which angle is the lag,
 * from which velocity an error brakes, which command a lost sample leaves. In the drive: when its velocity command is limited,
 * and that both of its velocities together are v_spindle. Each row is a history of a few cycles, without a drive. Prints each
 * row that does not hold, then the number of rows. Angles are in degrees; Kv is 20/s, the deceleration 1000 rpm/s.
 *
 * -DAXIS, -DHEADER, -DIN_DRIVE and -DADDITIVE as for drive.c.
 */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include HEADER

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
#define STATE JOIN(AXIS, _spindle_axis_state)
#define INPUTS JOIN(AXIS, _spindle_axis_inputs)
#define OUTPUTS JOIN(AXIS, _spindle_axis_outputs)

#define T 0.002
#define DEGREE 1000.0
#define PER_DEGREE (20.0 * DEGREE) /* of the lag, in the command of the position controller */
#define STEP 12000.0 /* by which an error slows the spindle down in a cycle */
#define GIVEN_UP 999.0 /* error 48 instead of a lag */

static STATE state;
static INPUTS inputs;
static OUTPUTS outputs;
static double x; /* the interpolator's position, turns not taken off */
static double v;
static int rows;
#ifndef IN_DRIVE
static bool feeds_forward; /* all of v, in the command or as an additive velocity */
#endif

static double wrap(double of)
{
    const double rest = fmod(of, 360000.0);
    return rest < 0.0 ? rest + 360000.0 : rest;
}

/* The interpolator has moved on, and the actual position is behind it by a difference [deg]. */
static void cycle(double difference)
{
    x += v * T;
    inputs.x_command = wrap(x);
    inputs.x_actual = inputs.x_command - difference * DEGREE;
    inputs.v_interpolator = v;
    JOIN(AXIS, _spindle_axis_step)(&state, &inputs, &outputs);
}

/* The first cycle of POSITION is the next one. The spindle stands. */
static void before_position(void)
{
    STATE before = state;
    v = 0.0;
    for (int i = 0; i < 20; i++) {
        before = state;
        x = outputs.x_spindle;
        cycle(0.0);
        if (outputs.spindle_state == 0) {
            break;
        }
    }
    state = before;
}

/* POSITION with a velocity, and a lag that grows to a value; v_add has faded in. */
static void turn(double velocity, double lag)
{
    JOIN(AXIS, _spindle_axis_init)(&state);
    JOIN(AXIS, _spindle_axis_inputs_init)(&inputs);
    outputs.x_spindle = 90000.0;
    inputs.drive_on = true;
#ifndef IN_DRIVE
    inputs.feedforward_active = feeds_forward;
#ifndef ADDITIVE
    inputs.mode = 1;
#endif
#endif
    before_position();
    cycle(0.0);
    v = velocity;
    for (int i = 0; i <= 60; i++) {
        cycle(lag * i / 60.0);
    }
}

#if defined IN_DRIVE || !defined ADDITIVE
/* From there with M3 to VELOCITY. */
static void turn_fast(void)
{
    turn(0.0, 0.0);
    inputs.s_word = 2e6;
    inputs.m3 = true;
    v = 2e6;
    for (int i = 0; i < 5; i++) {
#ifdef IN_DRIVE
        inputs.operation_mode_display = i < 3 ? 0 : 1;
#endif
        cycle(0.0);
    }
}
#endif

static void holds(bool condition, const char *name, double value)
{
    rows++;
    if (!condition) {
        printf("%s %.1f: error %u, v_spindle %.1f\n", name, value, (unsigned)outputs.error_id, outputs.v_spindle);
    }
}

#ifndef IN_DRIVE
static bool is_slowed_to(double velocity)
{
    return !outputs.loop_closed && fabs(outputs.v_spindle - velocity) < 1e-3 && outputs.v_command == outputs.v_spindle;
}

#ifndef ADDITIVE
/* The lag of the last cycle is this one, in the command of the position controller. */
static void has_lag(const char *name, double row, double lag)
{
    const bool is_given_up = outputs.error_id == 48u;
    const bool is_lag = outputs.error_id == 0u && fabs(outputs.v_command - PER_DEGREE * lag) < 1e-3;
    holds(lag == GIVEN_UP ? is_given_up : is_lag, name, row);
}

static void lose_x_actual(int cycles)
{
    for (int i = 0; i < cycles; i++) {
        cycle(NAN);
    }
}

/* The lag differs by at most 180 deg from the one before plus v (m + 1) T / 2: 20 deg a cycle are 20, 30 and 40. */
static const struct {
    double before, v;
    int missed;
    double difference, lag;
} lags[] = {
    { 0.0, 1e7, 1, -161.0, GIVEN_UP }, { 0.0, 1e7, 1, -159.0, -159.0 }, { 0.0, -1e7, 1, 161.0, GIVEN_UP },
    { 0.0, -1e7, 1, 159.0, 159.0 }, { 0.0, 1e7, 2, -151.0, GIVEN_UP }, { 0.0, 1e7, 2, -149.0, -149.0 },
    { 0.0, 1e7, 3, -141.0, GIVEN_UP }, { 0.0, 1e7, 3, -139.0, -139.0 }, { 100.0, 1e6, 0, -81.0, GIVEN_UP },
    { 100.0, 1e6, 0, -79.0, -79.0 }, { -100.0, -1e6, 0, 81.0, GIVEN_UP }, { -100.0, -1e6, 0, 79.0, 79.0 },
    /* Up to 60 deg, and without a lost sample, the angle between the positions is the lag, of whichever turn it is. */
    { 160.0, 1e6, 0, -59.0, -59.0 }, { 160.0, 1e6, 0, -61.0, GIVEN_UP }, { 160.0, 1e6, 1, -59.0, GIVEN_UP },
    { 160.0, 1e6, 0, 301.0, -59.0 }, { 160.0, 1e6, 0, 299.0, GIVEN_UP }, { -160.0, -1e6, 0, -301.0, 59.0 },
    /* Up to 170 deg it is no error; the raw difference may be that of another turn. */
    { 160.0, 1e6, 0, 169.0, 169.0 }, { 160.0, 1e6, 0, 171.0, GIVEN_UP }, { 160.0, 1e6, 0, -191.0, 169.0 },
    { -160.0, -1e6, 0, -171.0, GIVEN_UP },
};

static void lags_continue(void)
{
    for (size_t i = 0; i < sizeof lags / sizeof lags[0]; i++) {
        turn(lags[i].v, lags[i].before);
        lose_x_actual(lags[i].missed);
        cycle(lags[i].difference);
        has_lag("lag", (double)i, lags[i].lag);
    }
    /* The velocity after the lost sample, however wild, does not count. */
    turn(0.0, 0.0);
    lose_x_actual(1);
    v = 1e8;
    x -= v * T;
    cycle(0.0);
    has_lag("wild", 0.0, 0.0);
    /* Of a lag before BRAKE, or before the drive was off, nothing is left: neither the angle nor the command. */
    for (int i = 0; i < 4; i++) {
        turn(0.0, 160.0);
        inputs.task_cycle_ns = i < 2 ? 1u : 0u;
        inputs.drive_on = i < 2;
        cycle(0.0);
        inputs.task_cycle_ns = 0u;
        inputs.drive_on = true;
        inputs.reset = i < 2;
        cycle(0.0);
        inputs.reset = false;
        before_position();
        cycle(i % 2 == 0 ? -100.0 : NAN);
        if (i % 2 == 0) {
            has_lag("after", i, -100.0);
        } else {
            holds(outputs.error_id == 18u && outputs.v_command == 0.0, "after", i);
        }
    }
}

/* Error 48 comes with the closed loop's outputs, and before the fault of another part; then the spindle brakes from its command. */
static void gives_up(bool has_fault)
{
    turn(1e7, 160.0);
    inputs.v_motor = has_fault ? NAN : 0.0;
    cycle(172.0);
    const double command = outputs.v_command;
    holds(outputs.error_id == 48u && fabs(command - PER_DEGREE * 172.0) < 1e-3, "gives up", has_fault);
    inputs.v_motor = 0.0;
    for (int i = 1; i < 4; i++) {
        cycle(0.0);
        holds(outputs.error_id == 48u && is_slowed_to(command - STEP * i), "given up", i);
    }
}

/* An error in VELOCITY brakes from its own command, not from the last one of the position controller. */
static void stops_in_velocity(void)
{
    turn_fast();
    inputs.task_cycle_ns = 1u;
    const bool was_fast = outputs.spindle_state == 2;
    cycle(0.0);
    holds(was_fast && is_slowed_to(2e6 - STEP), "stops", 2.0);
}
#endif

/* A lost sample leaves the command; an error in POSITION brakes from v_spindle, within 0 and the whole velocity that the drive got. */
static void stops(double velocity, double lag, double whole)
{
    turn(velocity, lag);
    const double command = outputs.v_command;
    cycle(NAN);
    holds(outputs.error_id == 18u && outputs.v_command == command, "lost", lag);
    inputs.task_cycle_ns = 1u;
    cycle(lag);
    holds(is_slowed_to(fmax(fmin(velocity - STEP, whole), 0.0)), "stops", lag);
}
#elif defined ADDITIVE
#define INCREMENTS (10.0 / 6.0) /* of the drive, for 0.001 deg/s */

/* A whole way there and back, with a drive that follows and changes its mode three cycles later; in every cycle the drive, which may be
 * in either mode, gets v_spindle once. In TO_POSITION the block ignores the interpolator, which may be anything. */
static void shares(int32_t percentage, bool loses_sample)
{
    int32_t modes[3] = { 0, 0, 0 };
    bool seen[5] = { false, false, false, false, false };
    turn(0.0, 0.0);
    inputs.feedforward_active = true;
    inputs.feedforward_percentage = percentage;
    inputs.s_word = 2e6;
    for (int i = 0; i < 800; i++) {
        const bool is_led = outputs.spindle_state < 3;
        v = is_led ? fmin(outputs.v_spindle + 1e5, outputs.job == 1 ? 2e6 : 0.0) : NAN;
        x = is_led ? outputs.x_spindle : NAN;
        inputs.a_interpolator = is_led ? 1e6 : NAN;
        inputs.m3 = i == 5;
        inputs.m19 = i == 200;
        inputs.v_actual = outputs.v_spindle;
        inputs.operation_mode_display = modes[i % 3];
        modes[i % 3] = outputs.operation_mode;
        x += v * T;
        inputs.x_command = wrap(x);
        inputs.v_interpolator = v;
        inputs.x_actual = wrap(outputs.x_spindle);
        if (loses_sample && outputs.spindle_state == 1) {
            inputs.v_interpolator = NAN;
            loses_sample = false;
        }
        JOIN(AXIS, _spindle_axis_step)(&state, &inputs, &outputs);
        const double sum = (double)outputs.velocity_command + (double)outputs.additive_velocity;
        seen[outputs.spindle_state] = true;
        if (fabs(sum - INCREMENTS * outputs.v_spindle) > 1.0 || (outputs.spindle_state == 4 && outputs.additive_torque != 0)
            || (outputs.error_id != 0u && outputs.error_id != 14u)) {
            holds(false, "share", i);
            return;
        }
    }
    holds(seen[0] && seen[1] && seen[2] && seen[3] && seen[4] && outputs.spindle_state == 0, "shares", percentage);
}

/* The additive velocity is this part of v_spindle, and the velocity command the rest. */
static bool is_shared(double part)
{
    return fabs((double)outputs.additive_velocity - INCREMENTS * part * outputs.v_spindle) <= 0.5
        && fabs((double)outputs.velocity_command - INCREMENTS * (1.0 - part) * outputs.v_spindle) <= 0.5;
}

/* An error, or drive_on FALSE while the drive is on after all: as long as the drive displays position control, it needs the
 * additive velocity that the lead of its position command counts on. */
static void keeps_lead(bool goes_off)
{
    turn(0.0, 0.0);
    inputs.feedforward_active = true;
    for (v = 0.0; v <= 9e5; v += STEP) {
        inputs.v_actual = v;
        cycle(0.0);
    }
    const bool was_shared = outputs.spindle_state == 0 && outputs.v_spindle > 8e5 && is_shared(1.0);
    inputs.v_actual = outputs.v_spindle;
    inputs.drive_on = !goes_off;
    inputs.task_cycle_ns = goes_off ? 0u : 1u;
    bool is_kept = true;
    for (int i = 0; i < 30; i++) {
        cycle(0.0);
        is_kept = is_kept && is_shared(1.0);
    }
    inputs.operation_mode_display = 1;
    cycle(0.0);
    holds(was_shared && is_kept && outputs.v_spindle > 4e5 && is_shared(0.0), "keeps", goes_off);
}
#endif

#ifdef IN_DRIVE
/* The velocity command is limited at the ends of INT32: 2^31 increments are 1.288e9. */
static void limits(double velocity, bool is_limited)
{
    turn_fast();
    v = velocity;
    cycle(0.0);
    const bool is_end = outputs.velocity_command == (velocity > 0.0 ? INT32_MAX : INT32_MIN);
    holds(outputs.spindle_state == 2 && outputs.limited == is_limited && is_end == is_limited, "limits", velocity);
}
#endif

int main(void)
{
#ifdef IN_DRIVE
#ifdef ADDITIVE
    shares(100, false);
    shares(37, true);
    keeps_lead(false);
    keeps_lead(true);
#endif
    limits(1.288e9, false);
    limits(1.289e9, true);
    limits(-1.288e9, false);
    limits(-1.289e9, true);
#else
#ifndef ADDITIVE
    lags_continue();
    gives_up(false);
    gives_up(true);
    stops_in_velocity();
#endif
    for (double lag = -80.0; lag <= 80.0; lag += 20.0) {
        feeds_forward = false;
        stops(1e6, lag, PER_DEGREE * lag);
        feeds_forward = true;
        stops(1e6, lag, PER_DEGREE * lag + 1e6);
    }
#endif
    printf("%d\n", rows);
    return 0;
}
