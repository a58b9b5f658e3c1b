/* Hand-written axis: DIRECT 53 Hz and INDIRECT 11 Hz, each with a first-order band-pass. */
#ifndef AXIS_HAND_RACK_AND_PINION_H
#define AXIS_HAND_RACK_AND_PINION_H

#include "hand_signals.h"

typedef hand_inputs axis_hand_rack_and_pinion_ipc_inputs;
typedef hand_outputs axis_hand_rack_and_pinion_ipc_outputs;

typedef struct {
    bool preset;
    uint32_t fade;
    hand_section bp0;
    hand_section osc1;
    hand_section bp1;
} axis_hand_rack_and_pinion_ipc_state;

void axis_hand_rack_and_pinion_ipc_init(axis_hand_rack_and_pinion_ipc_state *state);
void axis_hand_rack_and_pinion_ipc_inputs_init(axis_hand_rack_and_pinion_ipc_inputs *inputs);
void axis_hand_rack_and_pinion_ipc_step(
    axis_hand_rack_and_pinion_ipc_state *state, const axis_hand_rack_and_pinion_ipc_inputs *inputs, axis_hand_rack_and_pinion_ipc_outputs *outputs);

#endif
