/* Calls step of a block CYCLES times, in a program without a library: what is counted by `cortex_m4`. It writes a digest of the outputs. */
#include AXIS_HEADER

#include "driver.h"

static NAME(AXIS, _ipc_state) state;
static NAME(AXIS, _ipc_inputs) inputs;
static NAME(AXIS, _ipc_outputs) outputs;

void _start(void)
{
    unsigned n, digest = 2166136261u;
    NAME(AXIS, _ipc_init)(&state);
    NAME(AXIS, _ipc_inputs_init)(&inputs);
    for (n = 0; n < CYCLES; n++) {
        inputs.v_motor = (n & 8u) != 0u ? 1000.0f : -1000.0f;
        NAME(AXIS, _ipc_step)(&state, &inputs, &outputs);
        union {
            float real;
            unsigned bits;
        } v_add = { outputs.v_add };
        digest = (digest ^ v_add.bits) * 16777619u;
    }
    called(4, 1, (unsigned)&digest, sizeof digest); /* write */
    called(1, 0, 0u, 0u); /* exit */
    for (;;) {
    }
}
