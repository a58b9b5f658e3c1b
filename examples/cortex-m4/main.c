/* A Cortex-M4F damps an axis: SysTick calls the emitted block once per cycle of the position controller.
 *
 * The axis is a simulation of two masses in this file, and so are all numbers that it prints: no machine was measured. On a board of
 * your own simulate_axis goes away: the encoder gives v_motor, and the drive takes v_command + v_add.
 */
#include "axis_x_ipc.h"

#include "board.h"

/* the cycle that the block was designed for */
#define CYCLES_PER_SECOND 4000u
#define SECONDS_OF_PART 1u
/* samples of a line of the trace: 125 ms */
#define WINDOW 500u
/* ticks of a second of simulated time in which nothing is printed: the vibration builds up, or the block fades in */
#define SETTLING (CYCLES_PER_SECOND / 2u)

/* --- the simulated axis ------------------------------------------------------------------------------------------------ */

/* Motor and load, reduced to the motor's side: um/s and s; stiffness and damping per mass. */
typedef struct {
    float v_motor; /* um/s */
    float v_load;  /* um/s */
    float twist;   /* um: motor against load */
    float sine;    /* the ripple that excites the axis at 53 Hz */
    float cosine;
} axis_simulation;

/* One cycle of 250 us, in 10 steps. The drive's velocity controller is a P controller; its motor has a ripple of torque at 53 Hz. */
static void simulate_axis(axis_simulation *axis, float v_command)
{
    const float step = 25.0e-6f;        /* s */
    const float controller = 120.0f;    /* 1/s: of the velocity controller */
    const float of_motor = 55450.0f;    /* 1/s^2: stiffness per mass of the motor; both: (53 Hz * 2 pi)^2 */
    const float of_load = 55450.0f;     /* 1/s^2: stiffness per mass of the load */
    const float friction = 20.0f;       /* 1/s: damping of the coupling per mass */
    const float ripple = 4.0e5f;        /* um/s^2 */
    const float turn = 8.3252205e-3f;   /* rad: 53 Hz in a step */
    uint32_t n;
    for (n = 0u; n < 10u; n++) {
        const float coupling = axis->v_motor - axis->v_load;
        const float spring = axis->twist;
        axis->cosine -= turn * axis->sine;
        axis->sine += turn * axis->cosine;
        axis->v_motor += step * (controller * (v_command - axis->v_motor) - of_motor * spring - friction * coupling
            + ripple * axis->sine);
        axis->v_load += step * (of_load * spring + friction * coupling);
        axis->twist += step * (axis->v_motor - axis->v_load);
    }
}

/* --- the position controller's cycle ----------------------------------------------------------------------------------- */

static axis_simulation axis;
static axis_x_ipc_state state;
static axis_x_ipc_inputs inputs;
static axis_x_ipc_outputs outputs;
/* written by the interrupt, read by the program */
static volatile uint32_t cycles;
static volatile float highest;
static volatile float lowest;
static volatile bool has_fault;

/* The timer's interrupt: the axis moves by one cycle, the block gets the measured velocity. */
void timer_interrupt(void)
{
    const float v_command = 20000.0f; /* um/s: the axis moves */
    simulate_axis(&axis, v_command + outputs.v_add);
    inputs.v_motor = axis.v_motor;
    axis_x_ipc_step(&state, &inputs, &outputs);
    has_fault = has_fault || outputs.fault;
    highest = axis.v_load > highest ? axis.v_load : highest;
    lowest = axis.v_load < lowest ? axis.v_load : lowest;
    cycles++;
}

static void wait_for(uint32_t count)
{
    const uint32_t from = cycles;
    while (cycles - from < count) {
        board_sleep();
    }
}

/* What a scope would show: the amplitude of the load's velocity in windows of 125 ms, as number and bar. Gives the last one. */
static uint32_t trace(const char *title)
{
    uint32_t window;
    uint32_t amplitude = 0u;
    uint32_t bar;
    board_put(title);
    for (window = 0u; window < SECONDS_OF_PART * CYCLES_PER_SECOND / WINDOW; window++) {
        highest = -1.0e9f;
        lowest = 1.0e9f;
        wait_for(WINDOW);
        amplitude = (uint32_t)((highest - lowest) / 2.0f + 0.5f);
        board_put_number(amplitude);
        board_put(" um/s ");
        for (bar = 0u; bar < amplitude / 50u && bar < 70u; bar++) {
            board_put("#");
        }
        board_put("\n");
    }
    return amplitude;
}

int main(void)
{
    uint32_t off;
    uint32_t on;

    if (axis_x_ipc_self_test() != 0u) {
        board_put("the self-test failed: look at the options for floating-point arithmetic\n");
        return 1;
    }
    axis.cosine = 1.0f;
    highest = 0.0f;
    lowest = 0.0f;
    axis_x_ipc_init(&state);
    axis_x_ipc_inputs_init(&inputs);
    inputs.task_cycle_ns = 1000000000u / CYCLES_PER_SECOND;
    board_start_timer(CYCLES_PER_SECOND);

    wait_for(SETTLING);
    off = trace("vibration of the load (a simulation), block OFF:\n");
    inputs.mode = 1; /* ON: it fades in */
    on = trace("block ON:\n");
    board_put("amplitude: OFF ");
    board_put_number(off);
    board_put(" um/s, ON ");
    board_put_number(on);
    board_put(has_fault ? " um/s, with faults\n" : " um/s\n");
    return has_fault ? 1 : 0;
}
