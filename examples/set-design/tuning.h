/* The damping of an axis as parameters of a drive: what a user writes becomes a parameter set for the block axis_x_ipc. */
#ifndef TUNING_H
#define TUNING_H

#include "axis_x_ipc.h"
#include "axis_x_set_design.h"

/* A parameter as a field bus and an operating tool see it. Nothing relies on the tool to keep to the range: the block set_design
 * refuses what is outside, and a weight of 0. */
typedef struct {
    uint16_t number;
    const char *name;
    const char *unit;
    double *value;
    double minimum;
    double maximum;
} tuning_parameter;

#define TUNING_PARAMETERS 4u
#define TUNING_F0 101u
#define TUNING_Q_FACTOR 102u
#define TUNING_WEIGHT 103u
#define TUNING_LIMIT 104u
extern const tuning_parameter tuning_parameters[TUNING_PARAMETERS];

/* The answer to a write access. */
typedef enum {
    TUNING_STARTED, /* tuning_result has the result when tuning_is_busy is false */
    TUNING_UNKNOWN, /* no parameter has this number */
    TUNING_BUSY     /* the result of another write access is pending: repeat this one later */
} tuning_answer;

/* Call each of these in the background. */
void tuning_init(void);
const tuning_parameter *tuning_find(uint16_t number); /* NULL: no parameter has this number */
tuning_answer tuning_write(uint16_t number, double value);
void tuning_background(void); /* one piece of a design; call it again and again */
bool tuning_is_busy(void);
uint32_t tuning_result(void); /* of the last write access: AXIS_X_SET_DESIGN_ERROR_..., 0 if there is a set */

/* Call it in the interrupt, before axis_x_ipc_step: the set for the input params. */
const volatile axis_x_ipc_params *tuning_take(void);

#endif
