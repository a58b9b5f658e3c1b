/* A closed loop of the emitted block `spindle_axis`: an interpolator, a drive that goes off and on, and a bus that is some cycles late.
 *
 *   drive            prints a line for each kind of run: how many, the highest speed at which position control began, how far any
 *                    spindle turned backwards, the longest time to standstill, runs that did not arrive in POSITION
 *   drive lag RPM    M3 with a speed, no feedforward: prints the last error, the lowest command of the drive, the last speed,
 *                    and the largest lag of a cycle of the closed loop without an error [deg]
 *   drive blocked RPM [LOST]
 *                    the same, and the spindle is blocked within 4 to 12 ms, 164 times: prints the lowest command, and the runs
 *                    without error 48; with LOST, it is blocked at once, and x_actual is lost in LOST cycles
 *   drive lost RPM   one, two or three samples of one signal are lost while the spindle accelerates to a speed: prints by how
 *                    many increments the command changed in them at most, and in how many runs an error followed
 *   drive stopped RPM
 *                    the same, and more than three samples of one signal are lost, or the cycle time is wrong: prints by how much
 *                    the error raised the command [rpm], and the runs without an error
 *   drive ahead RPM  something turns the spindle by another 500 rpm: prints the lowest command, and the last error
 *   drive unseen RPM the block sees the drive off, which is on and still controls the position; then the drive leaves its mode by
 *                    itself, and takes it up again when the spindle stands: prints the highest speed, the last error, and how
 *                    far the spindle moved from standstill [deg]
 *
 * -DAXIS=axis_s -DHEADER='"axis_s_spindle_axis.h"', -DIN_DRIVE where the drive controls the position, -DADDITIVE where the drive
 * gets the feedforward as an additive velocity, -DFAST with a drive and a bus that hardly delay. Speeds are in rpm.
 */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include HEADER

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
#define STATE JOIN(AXIS, _spindle_axis_state)
#define INPUTS JOIN(AXIS, _spindle_axis_inputs)
#define OUTPUTS JOIN(AXIS, _spindle_axis_outputs)

#define T 0.002
#define RPM 6000.0
#define MODE_CYCLES 3 /* within which the drive changes its mode */
#ifdef FAST
#define LATE 1 /* cycles from the drive to the block */
#define TAU 1e-4
#else
#define LATE 4
#define TAU 0.005
#endif
#define DRIVE_KV 20.0
#define WEIGHT 0.5
#define COASTS 0.9995 /* of its speed that a spindle keeps in a cycle with the drive off */

typedef struct {
    double x, v;
    int32_t mode;
    bool on;
} actual;

static STATE state;
static INPUTS inputs;
static OUTPUTS outputs;
static actual drive, sent[LATE];
static double v_wanted;
#ifdef IN_DRIVE
static double x_before;
static int32_t asked;
static int32_t mode_cycles = MODE_CYCLES;
#endif
static bool unseen; /* the block sees the drive off */
static int off_cycles; /* until the drive came on */
static bool obeyed; /* the drive has controlled the position in the cycle before */

static double began; /* highest speed at which position control began */
static double backwards; /* highest speed against the first direction */
static double lowest; /* lowest command of a drive in velocity control, times the direction */
static double largest_lag;
static double fastest; /* of a spindle that something blocks */
static double slowest; /* of a spindle that something turns */
static double *lost; /* the input that is lost */

static double wrap(double x)
{
    const double rest = fmod(x, 360000.0);
    return rest < 0.0 ? rest + 360000.0 : rest;
}

#ifdef IN_DRIVE
static double shortest(double x)
{
    return wrap(x + 180000.0) - 180000.0;
}
#endif

static double approach(double from, double to, double step)
{
    return fabs(to - from) <= step ? to : to > from ? from + step : from - step;
}

/* What a drive without a position controller gets [0.001 deg/s]. */
static double command(void)
{
#ifdef IN_DRIVE
    return (double)outputs.velocity_command / 1.6666666666666667;
#elif defined ADDITIVE
    return (double)outputs.manipulated_variable / 1.2 + (double)outputs.additive_velocity / 1.6666666666666667;
#else
    return (double)outputs.manipulated_variable / 1.2;
#endif
}

/* The interpolator goes on from the spindle where the block tells it to. */
static void interpolate(void)
{
    if (outputs.spindle_state == 3 || outputs.spindle_state == 4) {
        v_wanted = outputs.v_spindle;
    }
    v_wanted = approach(v_wanted, outputs.job == 1 ? outputs.job_speed : 0.0, 12000.0);
    inputs.x_command = wrap(outputs.x_spindle + v_wanted * T);
    inputs.v_interpolator = v_wanted;
}

/* The drive obeys the outputs of the cycle before. */
static void obey(bool is_on, double direction)
{
    const double v_before = drive.v;
    bool obeys = false;
    bool changed = false;
    double target = 0.0;
    drive.on = is_on;
#ifdef IN_DRIVE
    asked = outputs.operation_mode == drive.mode ? 0 : asked + 1;
    if (asked > mode_cycles) {
        drive.mode = outputs.operation_mode;
        asked = 0;
        changed = true;
    }
    obeys = is_on && drive.mode == 0;
    if (obeys) {
        if (!obeyed) {
            x_before = outputs.x_drive;
        }
        target = DRIVE_KV * shortest(outputs.x_drive - drive.x) + WEIGHT * shortest(outputs.x_drive - x_before) / T;
        x_before = outputs.x_drive;
    } else {
        target = command();
    }
#else
    obeys = is_on && outputs.spindle_state == 0 && outputs.error_id == 0u;
    target = command();
#endif
    /* A drive that was off for less than its answer to the block has stayed in its mode by itself. */
    const bool has_stayed = !changed && off_cycles > 0 && off_cycles < LATE + MODE_CYCLES + 2;
    off_cycles = is_on ? 0 : off_cycles + 1;
    if (obeys && !obeyed && !has_stayed && fabs(v_before) > began) {
        began = fabs(v_before);
    }
    obeyed = obeys;
    if (is_on) {
        drive.v = fmax(fmin(drive.v + (target - drive.v) * (1.0 - exp(-T / TAU)), fastest), slowest);
        if (target * direction < lowest) {
            lowest = target * direction;
        }
    } else {
        drive.v *= COASTS;
    }
    drive.x = wrap(drive.x + drive.v * T);
    if (-drive.v * direction > backwards) {
        backwards = -drive.v * direction;
    }
}

static void cycle(bool is_on, double direction)
{
    obey(is_on, direction);
    const actual seen = sent[LATE - 1];
    memmove(sent + 1, sent, sizeof sent - sizeof sent[0]);
    sent[0] = drive;
    inputs.x_actual = seen.x;
    inputs.v_actual = seen.v;
    inputs.drive_on = seen.on && !unseen;
#ifdef IN_DRIVE
    inputs.operation_mode_display = seen.mode;
#else
    inputs.v_motor = seen.v;
    inputs.mode = 0;
#endif
    interpolate();
    if (lost != NULL) {
        *lost = NAN;
    }
    JOIN(AXIS, _spindle_axis_step)(&state, &inputs, &outputs);
    if (outputs.loop_closed && outputs.error_id == 0u) {
        largest_lag = fmax(largest_lag, fabs(remainder(outputs.x_spindle - inputs.x_actual, 360000.0)));
    }
}

static void start(double v, bool is_on, int32_t mode)
{
    JOIN(AXIS, _spindle_axis_init)(&state);
    JOIN(AXIS, _spindle_axis_inputs_init)(&inputs);
    memset(&outputs, 0, sizeof outputs);
    outputs.spindle_state = 4;
    drive = (actual){ .x = 100000.0, .v = v, .mode = mode, .on = is_on };
    for (int i = 0; i < LATE; i++) {
        sent[i] = drive;
    }
    v_wanted = 0.0;
    fastest = INFINITY;
    slowest = -INFINITY;
    lost = NULL;
#ifdef IN_DRIVE
    asked = 0;
#endif
#ifdef ADDITIVE
    inputs.feedforward_active = true;
#endif
    off_cycles = 0;
    obeyed = is_on && mode == 0;
    outputs.x_spindle = drive.x;
}

/* Cycles until the spindle stands in POSITION; -1: never. */
static int arrive(double direction, int most)
{
    for (int i = 1; i <= most; i++) {
        cycle(true, direction);
        if (outputs.spindle_state == 0 && fabs(drive.v) < 0.5 * RPM && v_wanted == 0.0 && outputs.error_id == 0u) {
            return i;
        }
    }
    return -1;
}

typedef struct {
    int runs, lost, longest;
} tally;

static void count(tally *of, int cycles)
{
    of->runs++;
    of->lost += cycles < 0;
    of->longest = cycles > of->longest ? cycles : of->longest;
}

static void tell(const char *name, const tally *of)
{
    printf("%s %d %.3f %.3f %.3f %d\n", name, of->runs, began / RPM, backwards / RPM, of->longest * T, of->lost);
    began = 0.0;
    backwards = 0.0;
}

/* M3 or M4 with a speed, until it turns so. */
static void turn(double speed)
{
    start(0.0, true, 0);
    for (int i = 0; i < 20; i++) {
        cycle(true, 1.0);
    }
    inputs.s_word = fabs(speed);
    inputs.m3 = speed > 0.0;
    inputs.m4 = speed < 0.0;
    for (int i = 0; i < 20 + (int)(fabs(speed) / 12000.0) + 100; i++) {
        cycle(true, speed);
        inputs.m3 = false;
        inputs.m4 = false;
    }
    backwards = 0.0;
}

static void block_spindle(double speed, int missing)
{
    int missed = 0;
    double lowest_of_all = INFINITY;
    for (int run = 0; run < 41 * 4; run++) {
        const double seconds = missing > 0 ? T : 0.004 + run / 4 * 0.0002;
        const int first = LATE + run % 4;
        turn(speed);
        lowest = 0.0;
        for (int i = 1; i < 200; i++) {
            fastest = fmax(speed * (1.0 - i * T / seconds), 0.0);
            lost = i > first && i <= first + missing ? &inputs.x_actual : NULL;
            cycle(true, 1.0);
        }
        lowest_of_all = fmin(lowest_of_all, lowest);
        missed += outputs.error_id != 48u;
    }
    printf("%.1f %d\n", lowest_of_all / RPM, missed);
}

#ifdef IN_DRIVE
static void turn_unseen(double speed)
{
    double highest = 0.0;
    double way = 0.0;
    for (int i = 3; i < 50; i += 6) {
        turn(speed);
        unseen = true;
        mode_cycles = i;
        for (int k = 0; k < 500; k++) {
            cycle(true, 1.0);
            highest = fmax(highest, fabs(drive.v));
        }
        unseen = false;
        mode_cycles = MODE_CYCLES;
        turn(speed);
        drive.mode = 1;
        mode_cycles = 1000;
        for (int k = 0; k < 500; k++) {
            cycle(true, 1.0);
        }
        const double x = drive.x;
        mode_cycles = MODE_CYCLES;
        for (int k = 0; k < 500; k++) {
            cycle(true, 1.0);
            way = fmax(way, fabs(shortest(drive.x - x)));
        }
    }
    printf("%.1f %u %.3f\n", highest / RPM, (unsigned)outputs.error_id, way / 1000.0);
}
#endif

#ifndef IN_DRIVE
static double *const samples[] = { &inputs.x_command, &inputs.v_interpolator, &inputs.x_actual };

/* The spindle accelerates to a speed. */
static void accelerate(double speed)
{
    start(0.0, true, 0);
    for (int k = 0; k < 60; k++) {
        inputs.s_word = speed;
        inputs.m3 = k == 20;
        cycle(true, 1.0);
    }
}

static void lose_samples(double speed)
{
    int errors = 0;
    double largest = 0.0;
    for (int i = 0; i < 9; i++) {
        accelerate(speed);
        const double before = command();
        lost = samples[i / 3];
        for (int k = 0; k <= i % 3; k++) {
            cycle(true, 1.0);
            largest = fmax(largest, fabs(command() - before) * 1.2);
        }
        lost = NULL;
        cycle(true, 1.0);
        errors += outputs.error_id != 0u;
    }
    printf("%.0f %d\n", largest, errors);
}

static void stop_with_errors(double speed)
{
    int missed = 0;
    double largest = 0.0;
    for (int i = 0; i < 4; i++) {
        accelerate(speed);
        const double before = command();
        lost = i < 3 ? samples[i] : NULL;
        inputs.task_cycle_ns = i < 3 ? 0u : 1u;
        for (int k = 0; k < 8; k++) {
            cycle(true, 1.0);
            largest = fmax(largest, command() - before);
        }
        missed += outputs.error_id == 0u;
    }
    printf("%.1f %d\n", largest / RPM, missed);
}

static void turn_ahead(double speed)
{
    turn(speed);
    lowest = 0.0;
    for (int i = 0; i < 600; i++) {
        slowest = i < 200 ? speed + 500.0 * RPM : -INFINITY;
        cycle(true, 1.0);
    }
    printf("%.1f %u\n", lowest / RPM, (unsigned)outputs.error_id);
}
#endif

int main(int argc, char **argv)
{
    if (argc > 2) {
        const double speed = atof(argv[2]) * RPM;
        if (strcmp(argv[1], "blocked") == 0) {
            block_spindle(speed, argc > 3 ? atoi(argv[3]) : 0);
            return 0;
        }
#ifdef IN_DRIVE
        if (strcmp(argv[1], "unseen") == 0) {
            turn_unseen(speed);
            return 0;
        }
#else
        if (strcmp(argv[1], "lost") == 0) {
            lose_samples(speed);
            return 0;
        }
        if (strcmp(argv[1], "stopped") == 0) {
            stop_with_errors(speed);
            return 0;
        }
        if (strcmp(argv[1], "ahead") == 0) {
            turn_ahead(speed);
            return 0;
        }
#endif
        turn(speed);
        lowest = 0.0;
        for (int i = 0; i < 2000; i++) {
            cycle(true, 1.0);
        }
        printf(
            "%u %.3f %.3f %.1f\n", (unsigned)outputs.error_id, lowest / RPM, drive.v / RPM, largest_lag / 1000.0);
        return 0;
    }
    static const int drops[] = { 1, 2, 3, 4, 5, 10, 50, 200, 1000 };
    const int count_of_drops = (int)(sizeof drops / sizeof drops[0]);
    tally of = { 0, 0, 0 };
    double began_worst = 0.0;
    double backwards_worst = 0.0;
    for (int rpm = -3000; rpm <= 3000; rpm += 100) {
        for (int i = 0; i < count_of_drops; i++) {
            if (rpm == 0) {
                continue;
            }
            turn(rpm * RPM);
            began = 0.0;
            for (int k = 0; k < drops[i]; k++) {
                cycle(false, rpm);
            }
            count(&of, arrive(rpm, 6000));
            began_worst = fmax(began_worst, began);
            backwards_worst = fmax(backwards_worst, backwards);
            began = 0.0;
            backwards = 0.0;
        }
    }
    began = began_worst;
    backwards = backwards_worst;
    tell("drop", &of);
    of = (tally){ 0, 0, 0 };
    for (int rpm = -6000; rpm <= 6000; rpm += 50) {
        for (int off = 4; off <= 40; off += 12) {
            start(rpm * RPM, false, 0);
            for (int k = 0; k < off; k++) {
                cycle(false, rpm);
            }
            count(&of, arrive(rpm, 8000));
        }
    }
    tell("start", &of);
    of = (tally){ 0, 0, 0 };
    for (int rpm = -3000; rpm <= 3000; rpm += 100) {
        if (rpm == 0) {
            continue;
        }
        /* An error that stays, a drive that is off in it, and a reset when it is on again. */
        turn(rpm * RPM);
        inputs.task_cycle_ns = 1u;
        cycle(true, rpm);
        inputs.task_cycle_ns = 0u;
        for (int k = 0; k < 20; k++) {
            cycle(false, rpm);
        }
        for (int k = 0; k < 10; k++) {
            cycle(true, rpm);
        }
        inputs.reset = true;
        cycle(true, rpm);
        inputs.reset = false;
        count(&of, arrive(rpm, 6000));
    }
    tell("fault", &of);
    return 0;
}
