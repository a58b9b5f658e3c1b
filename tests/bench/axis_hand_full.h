/* Hand-written axis: three stages, each with a third-order band-pass and an all-pass. */
#ifndef AXIS_HAND_FULL_H
#define AXIS_HAND_FULL_H

#include "hand_signals.h"

typedef hand_inputs axis_hand_full_ipc_inputs;
typedef hand_outputs axis_hand_full_ipc_outputs;

typedef struct {
    bool preset;
    uint32_t fade;
    hand_section bp0_0;
    hand_section bp0_1;
    hand_section bp0_2;
    hand_section ap0;
    hand_section osc1;
    hand_section ap1;
    hand_section bp1_0;
    hand_section bp1_1;
    hand_section bp1_2;
    hand_section osc2;
    hand_section bp2_0;
    hand_section bp2_1;
    hand_section bp2_2;
    hand_section ap2;
} axis_hand_full_ipc_state;

void axis_hand_full_ipc_init(axis_hand_full_ipc_state *state);
void axis_hand_full_ipc_inputs_init(axis_hand_full_ipc_inputs *inputs);
void axis_hand_full_ipc_step(
    axis_hand_full_ipc_state *state, const axis_hand_full_ipc_inputs *inputs, axis_hand_full_ipc_outputs *outputs);

#endif
