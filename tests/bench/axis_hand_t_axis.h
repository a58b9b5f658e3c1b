/* Hand-written axis: the drive controls the position; the acceleration goes there as an additive torque, delayed by 0.15 cycles. */
#ifndef AXIS_HAND_T_AXIS_H
#define AXIS_HAND_T_AXIS_H

#include <stdbool.h>
#include <stdint.h>

/* Positions in um, accelerations in um/s^2. */
typedef struct {
    double x_command;
    double a_interpolator;
    bool feedforward_active; /* G135 */
    int32_t feedforward_percentage; /* G136 */
    bool position_controlled;
    bool reset;
    uint32_t task_cycle_ns; /* 0: unchecked */
} axis_hand_t_axis_inputs;

typedef struct {
    double x_drive;
    int32_t additive_torque;
    uint32_t error_id; /* 0 none, 1 cycle time, 15 a_interpolator, 17 x_command */
    bool limited;
    bool fault;
} axis_hand_t_axis_outputs;

typedef struct {
    bool preset; /* whether the delay has been filled */
    double before; /* what the delay got in the last cycle */
    double before_copy; /* the same again: what has been overwritten differs */
    double x_held; /* the last position command of the drive */
    double x_held_copy; /* the same again */
} axis_hand_t_axis_state;

void axis_hand_t_axis_init(axis_hand_t_axis_state *state);
void axis_hand_t_axis_inputs_init(axis_hand_t_axis_inputs *inputs);
void axis_hand_t_axis_step(
    axis_hand_t_axis_state *state, const axis_hand_t_axis_inputs *inputs, axis_hand_t_axis_outputs *outputs);

#endif
