/* Hand-written axis: position control in the CNC with conventional feedforward and both stages of hand_rack_and_pinion.c. */
#ifndef AXIS_HAND_X_AXIS_H
#define AXIS_HAND_X_AXIS_H

#include "hand_section.h"

/* Positions in um, velocities in um/s. */
typedef struct {
    double x_command;
    double x_actual;
    double v_interpolator;
    double a_interpolator;
    double v_motor;
    int32_t mode; /* 0 OFF, 1 ON, 2 DRYRUN */
    bool feedforward_active; /* G135 */
    int32_t feedforward_percentage; /* G136 */
    bool position_controlled;
    bool reset;
    uint32_t task_cycle_ns; /* 0: unchecked */
} axis_hand_x_axis_inputs;

typedef struct {
    double v_command;
    double v_feedforward;
    double v_add;
    double v_add_calculated;
    int32_t manipulated_variable;
    /* 0 none, 1 cycle time, 2 mode, 12 v_motor, 14 v_interpolator, 15 a_interpolator, 17 x_command, 18 x_actual */
    uint32_t error_id;
    bool limited;
    bool fault;
} axis_hand_x_axis_outputs;

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
