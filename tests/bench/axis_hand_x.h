/* Hand-written axis: position control in the CNC with conventional feedforward and both stages of hand_rack_and_pinion.c. */
#ifndef AXIS_HAND_X_H
#define AXIS_HAND_X_H

#include "hand_axis.h"

typedef hand_axis_inputs axis_hand_x_axis_inputs;
typedef hand_axis_outputs axis_hand_x_axis_outputs;

typedef struct {
    bool preset;
    uint32_t fade; /* above 0 only while preset */
    hand_section bp0;
    hand_section osc1;
    hand_section bp1;
} axis_hand_x_axis_state;

void axis_hand_x_axis_init(axis_hand_x_axis_state *state);
void axis_hand_x_axis_inputs_init(axis_hand_x_axis_inputs *inputs);
void axis_hand_x_axis_step(
    axis_hand_x_axis_state *state, const axis_hand_x_axis_inputs *inputs, axis_hand_x_axis_outputs *outputs);

#endif
