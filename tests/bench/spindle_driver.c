/* Leads the block `spindle_axis` of one spindle through its states N times, with a simple interpolator and drive that answer
 * what it puts out; prints a digest of all outputs of all cycles.
 *
 *   spindle_driver N [STATE]        every 10,000 cycles M3 below Von, M3 and another speed above it, M19, M4, G74, S[PUTAX]:
 *                                   about half POSITION, half VELOCITY, and what lies between. STATE: only the cycles that
 *                                   begin in it go through `measured_step`; -1: all. Their number is printed
 *   spindle_driver N SEED disturb   disturbed at random: requests, samples, resets, modes, cycle times; prints which errors each
 *                                   state had
 *
 * AXIS_HEADER, AXIS and CONTROL come with -D, for example -DAXIS=axis_s -DAXIS_HEADER='"axis_s_spindle_axis.h"'
 * -DCONTROL=spindle_control, the state's member with the state that the next cycle is in; and IN_DRIVE where the drive controls
 * the position.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include AXIS_HEADER
#include "counted.h"

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
#define STATE JOIN(AXIS, _spindle_axis_state)
#define INPUTS JOIN(AXIS, _spindle_axis_inputs)
#define OUTPUTS JOIN(AXIS, _spindle_axis_outputs)
#define INIT JOIN(AXIS, _spindle_axis_init)
#define INPUTS_INIT JOIN(AXIS, _spindle_axis_inputs_init)
#define STEP JOIN(AXIS, _spindle_axis_step)

#define T 0.002
#define PERIOD 10000
#ifdef IN_DRIVE
#define INCREMENTS 1.6666666666666667 /* for 0.001 deg/s */
#else
#define INCREMENTS 1.2
#endif
#define DISPLAY_CYCLES 5 /* from the mode that is asked for to the one that the drive says */

static STATE state;
static INPUTS inputs;
static OUTPUTS outputs;

static uint32_t seed = 1u;

static uint32_t random_below(uint32_t n)
{
    seed = seed * 1664525u + 1013904223u;
    return (uint32_t)(((uint64_t)seed * n) >> 32);
}

/* within +-1, both signs */
static double noise(void)
{
    return ((double)random_below(262144u) - 131072.0) / 131072.0;
}

/* One jump: one instruction more than the step. */
__attribute__((noinline)) void measured_step(STATE *a_state, const INPUTS *some_inputs, OUTPUTS *some_outputs);
void measured_step(STATE *a_state, const INPUTS *some_inputs, OUTPUTS *some_outputs)
{
    STEP(a_state, some_inputs, some_outputs);
}

static double within_a_turn(double x)
{
    const double rest = fmod(x, 360000.0);
    return rest < 0.0 ? rest + 360000.0 : rest;
}

/* towards an end, by at most a step */
static double approach(double from, double to, double step)
{
    return fabs(to - from) <= step ? to : to > from ? from + step : from - step;
}

static double v_wanted;
static double v_drive;
static double x_drive;
#ifdef IN_DRIVE
static int32_t display[DISPLAY_CYCLES];
#endif
static const double x_home = 0.0;

/* The job of the cycle before, from where the spindle was. */
static void interpolate(void)
{
    const double v_step = 12000.0; /* 1000 rpm/s */
    inputs.job_done = false;
    if (outputs.spindle_state == 3 || outputs.spindle_state == 4) {
        v_wanted = outputs.v_spindle;
    }
    if (outputs.job == 1) {
        v_wanted = approach(v_wanted, outputs.job_speed, v_step);
        inputs.x_command = within_a_turn(outputs.x_spindle + v_wanted * T);
    } else if (outputs.job == 0 || v_wanted != 0.0) {
        v_wanted = approach(v_wanted, 0.0, v_step);
        inputs.x_command = within_a_turn(outputs.x_spindle + v_wanted * T);
    } else {
        const double x_stop = outputs.job == 3 ? outputs.x_spindle : x_home;
        const double target = outputs.job == 2 ? within_a_turn(outputs.job_position) : x_stop;
        inputs.x_command = approach(outputs.x_spindle, target, 600.0);
        inputs.job_done = inputs.x_command == target;
    }
    inputs.v_interpolator = v_wanted;
}

/* What the drive does with the command of the cycle before. */
static void drive(void)
{
#ifdef IN_DRIVE
    v_drive += 0.3 * (outputs.v_spindle - v_drive);
#else
    v_drive += 0.3 * ((double)outputs.manipulated_variable / INCREMENTS - v_drive);
#endif
    x_drive = within_a_turn(x_drive + v_drive * T);
    inputs.v_actual = v_drive + 500.0 * noise();
    inputs.x_actual = x_drive;
#ifdef IN_DRIVE
    memmove(display + 1, display, sizeof display - sizeof display[0]);
    display[0] = outputs.operation_mode;
    inputs.operation_mode_display = display[DISPLAY_CYCLES - 1];
#else
    inputs.v_motor = v_drive + 20000.0 * noise();
    inputs.mode = 1;
    inputs.feedforward_active = true;
    inputs.feedforward_percentage = 87;
#endif
}

/* A request is TRUE for three cycles. */
static void request(long i)
{
    const long at = i % PERIOD;
    inputs.m3 = (at >= 100 && at < 103) || (at >= 2000 && at < 2003) || (at >= 4000 && at < 4003);
    inputs.m4 = at >= 7000 && at < 7003;
    inputs.m5 = (at >= 1500 && at < 1503) || (at >= 9400 && at < 9403);
    inputs.m19 = (at >= 6000 && at < 6003) || (at >= 9300 && at < 9303);
    inputs.g74 = at >= 8000 && at < 8003;
    inputs.putax = at >= 9200 && at < 9203;
    inputs.s_word = at < 2000 ? 600000.0 : at < 4000 ? 18000000.0 : at < 7000 ? 6000000.0 : 2400000.0;
    inputs.s_position = 90000.0;
    inputs.drive_on = true;
}

static double bad_sample(void)
{
    static const double limits[] = { 1.0e15, 7.0e14, 1.0000000000000002e15, 7.000000000000001e14, 9.0e7, 1.2e6 };
    switch (random_below(5u)) {
    case 0: return NAN;
    case 1: return INFINITY;
    case 2: return -INFINITY;
    case 3: return -limits[random_below(6u)];
    default: return limits[random_below(6u)];
    }
}

/* A velocity of about so many increments and a half: within the process data, and at their ends. */
static double half_increment(void)
{
    const double increments = random_below(2u) == 0u ? 100.5 : 2147483646.5 + (double)random_below(3u);
    double v = (random_below(2u) == 0u ? increments : -increments) / INCREMENTS;
    for (uint32_t ulps = random_below(4u); ulps > 0u; ulps--) {
        v = nextafter(v, random_below(2u) == 0u ? 0.0 : 2.0 * v);
    }
    return v;
}

/* Each kind of disturbance in its own cycles; some last. */
static void disturb(void)
{
    static uint32_t lasts[12];
    static const uint32_t often[12] = { 300u, 300u, 1500u, 900u, 2500u, 2500u, 2500u, 1500u, 5000u, 1500u, 2500u, 2500u };
    static double s_word = 0.0;
    for (int kind = 0; kind < 12; kind++) {
        if (lasts[kind] > 0u) {
            lasts[kind]--;
        } else if (random_below(often[kind]) == 0u) {
            lasts[kind] = 1u + random_below(random_below(6u) == 0u ? 80u : 5u);
            s_word = 3.0e6 * noise();
        }
    }
    inputs.m3 = lasts[0] > 0u;
    inputs.m4 = lasts[1] > 0u;
    inputs.m5 = lasts[2] > 0u;
    inputs.m19 = lasts[3] > 0u;
    inputs.putax = lasts[4] > 0u;
    inputs.g74 = lasts[5] > 0u;
    inputs.s_word = random_below(50u) == 0u ? bad_sample() : s_word;
    inputs.s_position = random_below(50u) == 0u ? bad_sample() : 1.0e6 * noise();
    inputs.reset = lasts[6] > 0u;
    inputs.drive_on = lasts[8] == 0u;
    inputs.task_cycle_ns = random_below(5000u) == 0u ? 1000000u : random_below(2u) == 0u ? 2000000u : 0u;
    if (lasts[7] > 0u) {
        switch (random_below(2u)) {
        case 0: inputs.v_interpolator = bad_sample(); break;
        default: inputs.x_command = bad_sample(); break;
        }
    }
    if (lasts[9] > 0u) {
        switch (random_below(2u)) {
        case 0: inputs.x_actual = bad_sample(); break;
        default: inputs.v_actual = bad_sample(); break;
        }
    }
    if (random_below(300u) == 0u) {
        inputs.x_command += 2000.0 * noise() + 360000.0 * (double)random_below(3u);
    }
    if (random_below(500u) == 0u) {
        inputs.v_interpolator = 1.0e9 * noise(); /* beyond half a turn, and beyond the process data */
    }
    if (random_below(500u) == 0u) {
        inputs.v_interpolator = 0.001 * noise();
    }
    if (random_below(100u) == 0u) {
        inputs.v_interpolator = half_increment();
    }
    if (random_below(800u) == 0u) {
        x_drive = within_a_turn(x_drive + 360000.0 * noise());
    }
#ifdef IN_DRIVE
    if (outputs.spindle_state == 1 && lasts[11] == 0u && random_below(60u) == 0u) {
        lasts[11] = 60u; /* longer than a drive may take */
    }
    if (lasts[10] > 0u) {
        inputs.operation_mode_display = (int32_t)random_below(3u);
    } else if (lasts[11] > 0u) {
        inputs.operation_mode_display = 3;
        lasts[11] += random_below(2u);
    }
#else
    if (lasts[10] > 0u) {
        inputs.v_motor = random_below(2u) == 0u ? bad_sample() : 1.0e8 * noise();
    }
    /* Twice the largest velocity leads to no sum that is a fault: tests/tests/blocks/disturbed_states.rs has those. */
    if (fabs(inputs.v_motor) <= 1.0e15 && fabs(inputs.v_motor) > 6.0e7) {
        inputs.v_motor = inputs.v_motor > 0.0 ? 6.0e7 : -6.0e7;
    }
    if (lasts[11] > 0u) {
        inputs.mode = (int32_t)random_below(4u);
    }
    inputs.feedforward_active = random_below(40u) != 0u;
    inputs.feedforward_percentage = random_below(40u) == 0u ? (int32_t)random_below(300u) - 100 : 87;
#endif
    if ((outputs.error_id > 40u || outputs.error_id == 1u) && random_below(20u) == 0u) {
        inputs.reset = true; /* of an error that stays */
    }
}

static uint64_t digest;

static void fold(uint64_t bits)
{
    digest = (digest ^ bits) * UINT64_C(0x100000001b3);
    digest ^= digest >> 29;
}

static void fold_real(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    fold(bits);
}

static void fold_outputs(void)
{
    fold_real(outputs.x_spindle);
    fold_real(outputs.v_spindle);
    fold_real(outputs.job_speed);
    fold_real(outputs.job_position);
    fold((uint32_t)outputs.spindle_state);
    fold((uint32_t)outputs.job);
    fold(outputs.job_number);
    fold(outputs.waiting);
    fold(outputs.error_id);
    fold(outputs.loop_closed);
    fold(outputs.limited);
    fold(outputs.fault);
#ifdef IN_DRIVE
    fold_real(outputs.x_drive);
    fold((uint32_t)outputs.operation_mode);
    fold((uint32_t)outputs.velocity_command);
#else
    fold_real(outputs.v_command);
    fold_real(outputs.v_feedforward);
    fold_real(outputs.v_add);
    fold_real(outputs.v_add_calculated);
    fold((uint32_t)outputs.manipulated_variable);
#endif
}

int main(int argc, char **argv)
{
    const long n = argc > 1 ? strtol(argv[1], NULL, 10) : PERIOD;
    const bool disturbed = argc > 3;
    const long only = argc == 3 ? strtol(argv[2], NULL, 10) : -1;
    long measured = 0;
    static long seen[5][64]; /* state, error_id; 63: an output cut off */

    if (disturbed) {
        seed = (uint32_t)strtoul(argv[2], NULL, 10);
    }
    INIT(&state);
    INPUTS_INIT(&inputs);
    for (long i = 0; i < n; i++) {
        if (counts_from(i)) {
            measured = 0;
        }
        interpolate();
        drive();
        if (disturbed) {
            disturb();
        } else {
            request(i);
        }
        memset(&outputs, 0xa5, sizeof outputs);
        const int32_t control = state.CONTROL;
        if (only < 0 || control == only) {
            measured++;
            measured_step(&state, &inputs, &outputs);
        } else {
            STEP(&state, &inputs, &outputs);
        }
        fold_outputs();
        if (disturbed) {
            seen[outputs.spindle_state][outputs.error_id]++;
            seen[outputs.spindle_state][63] += outputs.limited;
        } else if (outputs.limited || outputs.fault) {
            fprintf(stderr, "cycle %ld: state %d, error %u\n", i, (int)outputs.spindle_state, (unsigned)outputs.error_id);
            return 1;
        }
        if (!disturbed) {
            seen[outputs.spindle_state][0]++;
        }
        if (i % 1000 == 999) {
            printf("cycle %ld: %016llx\n", i, (unsigned long long)digest);
        }
    }
    printf("measured: %ld\n", measured);
    for (int i = 0; i < 5; i++) {
        printf("state %d:", i);
        for (int k = 0; k < 64; k++) {
            if (seen[i][k] > 0) {
                printf(" %d x%ld", k, seen[i][k]);
            }
        }
        printf("\n");
    }
    printf("digest %016llx\n", (unsigned long long)digest);
    return 0;
}
