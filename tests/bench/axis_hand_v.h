/* Hand-written axis: the drive controls the position; the velocity goes there as an additive command, delayed by 0.15 cycles. */
#ifndef AXIS_HAND_V_H
#define AXIS_HAND_V_H

#include "hand_axis.h"

typedef hand_axis_inputs axis_hand_v_axis_inputs;
typedef hand_axis_outputs axis_hand_v_axis_outputs;

typedef struct {
    bool preset; /* whether the delay has been filled */
    double before; /* what the delay got in the last cycle */
    double x_held; /* the last position command of the drive */
} axis_hand_v_axis_state;

void axis_hand_v_axis_init(axis_hand_v_axis_state *state);
void axis_hand_v_axis_inputs_init(axis_hand_v_axis_inputs *inputs);
void axis_hand_v_axis_step(
    axis_hand_v_axis_state *state, const axis_hand_v_axis_inputs *inputs, axis_hand_v_axis_outputs *outputs);

#endif
