/* The interface of the axes that are written by hand in single precision: the one that a generated block has. AXIS is what the names
 * begin with. */
#ifndef HAND_SINGLE_H
#define HAND_SINGLE_H

#include <stdbool.h>
#include <stdint.h>

#define HAND_JOIN(a, b) a##b
#define HAND_NAME(a, b) HAND_JOIN(a, b)
#define HAND_STATE HAND_NAME(AXIS, _ipc_state)
#define HAND_INPUTS HAND_NAME(AXIS, _ipc_inputs)
#define HAND_OUTPUTS HAND_NAME(AXIS, _ipc_outputs)

/* Velocities in um/s. */
typedef struct {
    float v_motor;
    int32_t mode; /* 0 OFF, 1 ON, 2 DRYRUN */
    bool position_controlled;
    bool reset;
    uint32_t task_cycle_ns; /* 0: unchecked */
} HAND_INPUTS;

typedef struct {
    float v_add;
    float v_add_calculated;
    bool limited;
    bool fault;
    uint32_t error_id; /* 0 none, 1 cycle time, 2 mode, 3 state, 12 v_motor */
} HAND_OUTPUTS;

typedef struct {
    float s1;
    float p; /* of a section behind another one: the low-pass part */
} hand_section;

typedef struct {
    bool preset;
    bool disturbed;
    uint32_t fade;
    float before;
    hand_section section[SECTIONS];
} HAND_STATE;

void HAND_NAME(AXIS, _ipc_init)(HAND_STATE *state);
void HAND_NAME(AXIS, _ipc_inputs_init)(HAND_INPUTS *inputs);
void HAND_NAME(AXIS, _ipc_step)(HAND_STATE *state, const HAND_INPUTS *inputs, HAND_OUTPUTS *outputs);

#endif
