/* Calls step of a block `set_design` until its set is complete, in a program without a library: what is counted by `cortex_m4`. It
 * writes the number of the set, and the number of calls. */
#include AXIS_HEADER

#include "driver.h"

static NAME(AXIS, _set_design_state) state;
static NAME(AXIS, _set_design_inputs) inputs;
static NAME(AXIS, _set_design_outputs) outputs;

void _start(void)
{
    unsigned answer[2] = { 0u, 0u };
    NAME(AXIS, _set_design_init)(&state);
    NAME(AXIS, _set_design_inputs_init)(&inputs);
    inputs.execute = true;
    do {
        NAME(AXIS, _set_design_step)(&state, &inputs, &outputs);
        answer[1]++;
    } while (outputs.active);
    answer[0] = outputs.params.set_id;
    called(4, 1, (unsigned)answer, sizeof answer); /* write */
    called(1, 0, 0u, 0u); /* exit */
    for (;;) {
    }
}
