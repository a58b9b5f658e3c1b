/* From drive parameters to a parameter set: a design in the background, and two buffers between it and the interrupt. */
#include "tuning.h"

#include <stddef.h>

/* --- the parameters ---------------------------------------------------------------------------------------------------- */

static axis_x_set_design_inputs typed;    /* what the user has written */
static axis_x_set_design_inputs accepted; /* the inputs of the last set */

const tuning_parameter tuning_parameters[TUNING_PARAMETERS] = {
    { TUNING_F0, "damping: centre frequency", "Hz", &typed.stage0_filter0_f0, 10.0, 500.0 },
    { TUNING_Q_FACTOR, "damping: quality factor", "1", &typed.stage0_filter0_q_factor, 1.0, 10.0 },
    { TUNING_WEIGHT, "damping: weight", "1", &typed.stage0_weight, 0.0, 7.0 },
    { TUNING_LIMIT, "damping: largest additive velocity", "um/s", &typed.limit, 0.0, AXIS_X_IPC_LIMIT },
};

/* --- the two buffers --------------------------------------------------------------------------------------------------- */

/* Volatile, so that a compiler writes the set before the pointer to it. Processors with several cores need a barrier, too. */
static volatile axis_x_ipc_params buffers[2];
static unsigned next_buffer;
static const volatile axis_x_ipc_params *volatile offered; /* written in the background */
static const volatile axis_x_ipc_params *volatile taken;   /* written by the interrupt: step reads this set */

const volatile axis_x_ipc_params *tuning_take(void)
{
    const volatile axis_x_ipc_params *const set = offered;
    taken = set;
    return set;
}

/* While the offered set is the one that was taken, step does not read the other buffer. */
static void offer(const axis_x_ipc_params *set)
{
    buffers[next_buffer] = *set;
    offered = &buffers[next_buffer];
    next_buffer = 1u - next_buffer;
}

/* --- the design -------------------------------------------------------------------------------------------------------- */

static axis_x_set_design_state state;
static axis_x_set_design_inputs inputs; /* a copy of what was typed: it must not change during a design */
static axis_x_set_design_outputs outputs;
static bool is_written;

/* A drive that stores its parameters copies them to `typed` here, and sets is_written: until the first design is complete, the
 * axis has the set that the block was generated with. */
void tuning_init(void)
{
    axis_x_set_design_init(&state);
    axis_x_set_design_inputs_init(&typed);
    accepted = typed;
    inputs = typed;
    offered = &axis_x_ipc_designed;
    taken = offered;
}

bool tuning_is_busy(void)
{
    return is_written || outputs.active || taken != offered;
}

uint32_t tuning_result(void)
{
    return outputs.error_id;
}

const tuning_parameter *tuning_find(uint16_t number)
{
    size_t n;
    for (n = 0u; n < TUNING_PARAMETERS; n++) {
        if (tuning_parameters[n].number == number) {
            return &tuning_parameters[n];
        }
    }
    return NULL;
}

tuning_answer tuning_write(uint16_t number, double value)
{
    const tuning_parameter *const parameter = tuning_find(number);
    if (parameter == NULL) {
        return TUNING_UNKNOWN;
    }
    if (tuning_is_busy()) {
        return TUNING_BUSY;
    }
    *parameter->value = value;
    is_written = true;
    return TUNING_STARTED;
}

void tuning_background(void)
{
    if (!is_written && !outputs.active) {
        return;
    }
    if (is_written) {
        inputs = typed;
    }
    inputs.execute = is_written; /* a rising edge: TRUE in one call */
    axis_x_set_design_step(&state, &inputs, &outputs);
    is_written = false;
    if (outputs.designed) {
        accepted = typed;
        offer(&outputs.params);
    } else if (outputs.fault) {
        typed = accepted; /* the parameters show the set in use again */
    }
}
