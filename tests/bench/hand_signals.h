/* Signals of the hand-written axes; the same names and types as in generated code. */
#ifndef HAND_SIGNALS_H
#define HAND_SIGNALS_H

#include <stdbool.h>
#include <stdint.h>

/* Velocities in um/s. */
typedef struct {
    double v_command;
    double v_motor;
    double v_direct;
    int32_t mode; /* 0 OFF, 1 ON, 2 DRYRUN */
    bool position_controlled;
    bool reset;
    uint32_t task_cycle_ns; /* 0: unchecked */
} hand_inputs;

typedef struct {
    double v_add;
    double v_add_calculated;
    bool limited;
    bool fault;
    uint32_t error_id; /* 0 none, 1 cycle time, 2 mode, 11 v_command, 12 v_motor */
} hand_outputs;

/* State of a second-order section in transposed direct form II. */
typedef struct {
    double s1;
    double s2;
} hand_section;

#endif
