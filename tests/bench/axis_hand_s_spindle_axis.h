/* Hand-written spindle: a SERCOS drive controls the position, and changes to velocity control and back. */
#ifndef AXIS_HAND_S_SPINDLE_AXIS_H
#define AXIS_HAND_S_SPINDLE_AXIS_H

#include "hand_spindle_state.h"

/* Positions in 0.001 deg, velocities in 0.001 deg/s. */
typedef struct {
    double x_command;
    double x_actual;
    double v_interpolator;
    double v_actual;
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
    int32_t operation_mode_display; /* S-0-0135 */
    bool reset;
    uint32_t task_cycle_ns; /* 0: unchecked */
} axis_hand_s_spindle_axis_inputs;

typedef struct {
    double x_spindle;
    double v_spindle;
    double job_speed;
    double job_position;
    double x_drive;
    int32_t spindle_state;
    int32_t job;
    uint32_t job_number;
    uint32_t waiting;
    int32_t operation_mode; /* S-0-0134 */
    int32_t velocity_command; /* S-0-0036 */
    uint32_t error_id; /* as in docs/spindle.md */
    bool loop_closed;
    bool limited;
    bool fault;
} axis_hand_s_spindle_axis_outputs;

typedef struct {
    hand_spindle spindle;
} axis_hand_s_spindle_axis_state;

void axis_hand_s_spindle_axis_init(axis_hand_s_spindle_axis_state *state);
void axis_hand_s_spindle_axis_inputs_init(axis_hand_s_spindle_axis_inputs *inputs);
void axis_hand_s_spindle_axis_step(
    axis_hand_s_spindle_axis_state *state,
    const axis_hand_s_spindle_axis_inputs *inputs,
    axis_hand_s_spindle_axis_outputs *outputs);

#endif
