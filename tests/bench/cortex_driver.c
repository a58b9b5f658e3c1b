/* Calls step of a block as often as FEW or MANY says, in a program without a library: what is counted by `cortex_m4`. */
#include AXIS_HEADER

#define JOIN(a, b) a##b
#define NAME(a, b) JOIN(a, b)

static NAME(AXIS, _ipc_state) state;
static NAME(AXIS, _ipc_inputs) inputs;
static NAME(AXIS, _ipc_outputs) outputs;

void _start(void)
{
    register int code __asm__("r0") = 0;
    register int call __asm__("r7") = 1; /* exit */
    unsigned n;
    NAME(AXIS, _ipc_init)(&state);
    NAME(AXIS, _ipc_inputs_init)(&inputs);
    for (n = 0; n < CYCLES; n++) {
        inputs.v_motor = (n & 8u) != 0u ? 1000.0f : -1000.0f;
        NAME(AXIS, _ipc_step)(&state, &inputs, &outputs);
    }
    __asm__ volatile("svc 0" : : "r"(code), "r"(call));
    for (;;) {
    }
}
