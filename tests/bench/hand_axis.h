/* Signals of the hand-written whole axes, the same names and types as in generated code, and what the axes share. */
#ifndef HAND_AXIS_H
#define HAND_AXIS_H

#include "hand_signals.h"

#include <math.h>

/* Positions in um, velocities in um/s. */
typedef struct {
    double x_command;
    double x_actual;
    double v_interpolator;
    double a_interpolator;
    double j_interpolator;
    double v_motor;
    double v_direct;
    double v_add_master;
    int32_t mode; /* 0 OFF, 1 ON, 2 DRYRUN */
    bool feedforward_active; /* G135 */
    int32_t feedforward_percentage; /* G136 */
    bool position_controlled;
    bool reset;
    uint32_t task_cycle_ns; /* 0: unchecked */
} hand_axis_inputs;

typedef struct {
    double v_command;
    double v_feedforward;
    double v_add;
    double v_add_calculated;
    double x_drive;
    int32_t manipulated_variable;
    int32_t xerr;
    int32_t additive_torque;
    int32_t additive_velocity;
    uint32_t error_id; /* 0 none, 1 cycle time, 2 mode, 12 v_motor, 14 v_, 15 a_interpolator, 17 x_command, 18 x_actual */
    bool limited;
    bool fault;
} hand_axis_outputs;

/* Part of every cycle, and not. */
#define OFTEN static inline __attribute__((always_inline))
#define SELDOM static __attribute__((noinline, cold))

#define CYCLE_TIME_NS 1000000u
#define MODE_OFF 0
#define MODE_ON 1
#define MODE_DRYRUN 2

static inline void hand_axis_inputs_init(hand_axis_inputs *inputs, int32_t mode)
{
    *inputs = (hand_axis_inputs){ .mode = mode, .feedforward_percentage = 100, .position_controlled = true };
}

/* A NaN is not. */
OFTEN bool in_range(double sample)
{
    return fabs(sample) <= 1.0e15;
}

/* G135 and G136; the weight of the whole feedforward is 1 in all axes here. */
OFTEN double feedforward_gain(const hand_axis_inputs *inputs)
{
    if (!inputs->feedforward_active || inputs->feedforward_percentage <= 0) {
        return 0.0;
    }
    if (inputs->feedforward_percentage >= 100) {
        return 1.0;
    }
    return 0.01 * (double)inputs->feedforward_percentage;
}

/* To the nearest integer, a half away from zero; of a number that fits. What is added is the largest double below 1/2: 1/2
 * itself would bring that very double to 1. From a half on, the sum rounds to the next integer or lies beyond it. */
OFTEN int32_t nearest(double x)
{
    return (int32_t)(x + copysign(0.49999999999999994, x));
}

#endif
