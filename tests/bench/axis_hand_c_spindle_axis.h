/* Hand-written spindle: the CNC controls the position, with feedforward of the velocity and one stage of improved position control. */
#ifndef AXIS_HAND_C_SPINDLE_AXIS_H
#define AXIS_HAND_C_SPINDLE_AXIS_H

#include "hand_section.h"
#include "hand_spindle_state.h"

/* Positions in 0.001 deg, velocities in 0.001 deg/s. */
typedef struct {
    double x_command;
    double x_actual;
    double v_interpolator;
    double v_actual;
    double v_motor;
    double s_word;
    double s_position;
    bool m3;
    bool m4;
    bool m5;
    bool m19;
    bool putax;
    bool g74;
    bool job_done;
    bool drive_on;
    int32_t mode; /* 0 OFF, 1 ON, 2 DRYRUN */
    bool feedforward_active; /* G135 */
    int32_t feedforward_percentage; /* G136 */
    bool reset;
    uint32_t task_cycle_ns; /* 0: unchecked */
} axis_hand_c_spindle_axis_inputs;

typedef struct {
    double x_spindle;
    double v_spindle;
    double job_speed;
    double job_position;
    double v_command;
    double v_feedforward;
    double v_add;
    double v_add_calculated;
    int32_t spindle_state;
    int32_t job;
    uint32_t job_number;
    uint32_t waiting;
    int32_t manipulated_variable;
    uint32_t error_id; /* 2 mode, 12 v_motor, else as in docs/spindle.md */
    bool loop_closed;
    bool limited;
    bool fault;
} axis_hand_c_spindle_axis_outputs;

typedef struct {
    hand_spindle spindle;
    bool preset;
    uint32_t fade; /* above 0 only while preset */
    hand_section bp0;
    double lag; /* of the last cycle with a closed loop */
    double v_held; /* the last command without v_add: goes on while a sample is missing */
} axis_hand_c_spindle_axis_state;

void axis_hand_c_spindle_axis_init(axis_hand_c_spindle_axis_state *state);
void axis_hand_c_spindle_axis_inputs_init(axis_hand_c_spindle_axis_inputs *inputs);
void axis_hand_c_spindle_axis_step(
    axis_hand_c_spindle_axis_state *state,
    const axis_hand_c_spindle_axis_inputs *inputs,
    axis_hand_c_spindle_axis_outputs *outputs);

#endif
