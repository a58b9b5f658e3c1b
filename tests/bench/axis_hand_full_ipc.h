/* Hand-written axis: three stages, each with a third-order band-pass and an all-pass. */
#ifndef AXIS_HAND_FULL_IPC_H
#define AXIS_HAND_FULL_IPC_H

#include "hand_section.h"

/* Velocities in um/s. */
typedef struct {
    double v_command;
    double v_motor;
    int32_t mode; /* 0 OFF, 1 ON, 2 DRYRUN */
    bool position_controlled;
    bool reset;
    uint32_t task_cycle_ns; /* 0: unchecked */
} axis_hand_full_ipc_inputs;

typedef struct {
    double v_add;
    double v_add_calculated;
    bool limited;
    bool fault;
    uint32_t error_id; /* 0 none, 1 cycle time, 2 mode, 11 v_command, 12 v_motor */
} axis_hand_full_ipc_outputs;

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
