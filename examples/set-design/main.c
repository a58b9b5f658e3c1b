/* An axis vibrates while it moves; somebody types f0 and the weight of its damping into the drive. Prints what happens.
 *
 * The axis is a simulation in this file, and so are all numbers that it prints: no machine was measured. On a controller, the
 * interrupt is that of the position controller, and the background is the main loop or a slow task.
 */
#include <math.h>
#include <stdio.h>

#include "tuning.h"

#define CYCLES_PER_SECOND (1000000000u / AXIS_X_IPC_CYCLE_TIME_NS)
#define FADE_CYCLES 400u /* fade in axes.toml: 100 ms */

/* --- the simulated axis ------------------------------------------------------------------------------------------------ */

/* Motor and load, reduced to the motor's side: um/s and s; stiffness and damping per mass. */
typedef struct {
    float v_motor; /* um/s */
    float v_load;  /* um/s */
    float twist;   /* um: motor against load */
    float sine;    /* the ripple that excites the axis at 53 Hz */
    float cosine;
} axis_simulation;

/* One cycle of 250 us, in 10 steps. The drive has a P controller of the velocity; its motor has a ripple of torque at 53 Hz. */
static void simulate_axis(axis_simulation *axis, float v_command)
{
    const float step = 25.0e-6f;      /* s */
    const float controller = 120.0f;  /* 1/s: of the velocity controller */
    const float stiffness = 55450.0f; /* 1/s^2: per mass of the motor, and of the load: (53 Hz * 2 pi)^2 / 2 */
    const float friction = 20.0f;     /* 1/s: damping of the coupling per mass */
    const float ripple = 4.0e5f;      /* um/s^2 */
    const float turn = 8.3252205e-3f; /* rad: 53 Hz in a step */
    unsigned n;
    for (n = 0u; n < 10u; n++) {
        const float coupling = stiffness * axis->twist + friction * (axis->v_motor - axis->v_load);
        axis->cosine -= turn * axis->sine;
        axis->sine += turn * axis->cosine;
        axis->v_motor += step * (controller * (v_command - axis->v_motor) - coupling + ripple * axis->sine);
        axis->v_load += step * coupling;
        axis->twist += step * (axis->v_motor - axis->v_load);
    }
}

/* --- the interrupt of the position controller -------------------------------------------------------------------------- */

static axis_simulation axis;
static axis_x_ipc_state state;
static axis_x_ipc_inputs inputs;
static axis_x_ipc_outputs outputs;

/* What a scope would show. */
static float highest, lowest; /* velocity of the load [um/s] */
static float largest_fade;    /* change of v_add from cycle to cycle beyond that of the signal that is faded [um/s] */
static unsigned reports;      /* cycles in which the block reported something */

/* v_add = fade * v_add_calculated, so a step of v_add is at most the step of v_add_calculated plus a step of the fade. Where
 * another set is taken over, v_add_calculated jumps, and v_add must not follow it. */
static void watch_steps(const axis_x_ipc_outputs *before)
{
    const float step = fabsf(outputs.v_add - before->v_add);
    const float signal = fabsf(outputs.v_add_calculated - before->v_add_calculated);
    const bool is_same_set = outputs.active_set == before->active_set;
    largest_fade = fmaxf(largest_fade, is_same_set ? step - signal : step);
}

static void interrupt(void)
{
    const axis_x_ipc_outputs before = outputs;
    simulate_axis(&axis, 20000.0f + outputs.v_add); /* um/s: the axis moves */
    inputs.v_motor = axis.v_motor;
    inputs.params = tuning_take();
    axis_x_ipc_step(&state, &inputs, &outputs);
    watch_steps(&before);
    highest = fmaxf(highest, axis.v_load);
    lowest = fminf(lowest, axis.v_load);
    reports += outputs.error_id != 0u ? 1u : 0u;
}

/* --- what happens ------------------------------------------------------------------------------------------------------ */

static void wait(unsigned cycles)
{
    unsigned n;
    highest = -1.0e9f;
    lowest = 1.0e9f;
    for (n = 0u; n < cycles; n++) {
        interrupt();
        tuning_background();
    }
}

/* Waits until the axis has settled; then prints the amplitude of half a second. */
static void show(void)
{
    wait(CYCLES_PER_SECOND);
    wait(CYCLES_PER_SECOND / 2u);
    printf("set %08lx: amplitude %.0f um/s\n", (unsigned long)outputs.active_set, (double)(highest - lowest) / 2.0);
}

/* Writes a parameter, as a user does. Returns whether the result is the expected one, and the set in use accordingly. */
static bool type(uint16_t number, double value, uint32_t expected)
{
    const uint32_t before = outputs.active_set;
    const tuning_parameter *const parameter = tuning_find(number);
    const double old = *parameter->value;
    bool is_kept;

    printf("%u, %s, %g to %g %s: %g -> %g\n", (unsigned)number, parameter->name, parameter->minimum, parameter->maximum,
        parameter->unit, old, value);
    if (tuning_write(number, value) != TUNING_STARTED) {
        return false;
    }
    while (tuning_is_busy()) {
        wait(1u);
    }
    if (tuning_result() != 0u) {
        printf("refused: error %lu, still %g\n", (unsigned long)tuning_result(), *parameter->value);
    }
    show();
    is_kept = outputs.active_set == before && *parameter->value == old;
    return tuning_result() == expected && is_kept == (expected != 0u);
}

int main(void)
{
    const float bound = AXIS_X_IPC_LIMIT / (float)FADE_CYCLES; /* um/s: the largest step of a fade */
    bool is_good = true;

    if (axis_x_ipc_self_test() != 0u || axis_x_set_design_self_test() != 0u) {
        printf("a self-test failed: look at the options for floating-point arithmetic\n");
        return 1;
    }
    axis.cosine = 1.0f;
    axis_x_ipc_init(&state);
    axis_x_ipc_inputs_init(&inputs);
    inputs.task_cycle_ns = AXIS_X_IPC_CYCLE_TIME_NS;
    tuning_init();
    show();

    is_good = type(TUNING_WEIGHT, 3.0, AXIS_X_SET_DESIGN_ERROR_NONE) && is_good;
    is_good = type(TUNING_F0, 53.0, AXIS_X_SET_DESIGN_ERROR_NONE) && is_good;
    is_good = type(TUNING_F0, 9.0, AXIS_X_SET_DESIGN_ERROR_LOW_F0) && is_good;
    is_good = type(TUNING_WEIGHT, 8.0, AXIS_X_SET_DESIGN_ERROR_WEIGHT) && is_good;
    is_good = type(TUNING_WEIGHT, 0.0, AXIS_X_SET_DESIGN_ERROR_WEIGHT) && is_good;

    printf("v_add: fades by %.2f um/s in a cycle, bound %.2f um/s\n", (double)largest_fade, (double)bound);
    is_good = is_good && largest_fade <= bound && reports == 0u;
    is_good = is_good && outputs.active_set == inputs.params->set_id && outputs.active_set != axis_x_ipc_designed.set_id;
    return is_good ? 0 : 1;
}
