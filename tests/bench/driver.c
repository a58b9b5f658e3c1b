/* Calls the step of one axis N times with a moving input, mode ON; prints a sum, so that nothing can be left out.
 *
 * AXIS_HEADER and AXIS come with -D, for example -DAXIS=axis_full -DAXIS_HEADER='"axis_full_ipc.h"', and READS_V_COMMAND
 * where the axis reads it.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include AXIS_HEADER
#include "counted.h"

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
#define STATE JOIN(AXIS, _ipc_state)
#define INPUTS JOIN(AXIS, _ipc_inputs)
#define OUTPUTS JOIN(AXIS, _ipc_outputs)
#define INIT JOIN(AXIS, _ipc_init)
#define INPUTS_INIT JOIN(AXIS, _ipc_inputs_init)
#define STEP JOIN(AXIS, _ipc_step)

int main(int argc, char **argv)
{
    const long n = argc > 1 ? strtol(argv[1], NULL, 10) : 1000;
    static STATE state;
    static INPUTS inputs;
    static OUTPUTS outputs;
    uint32_t seed = 1u;
    double sum = 0.0;

    INIT(&state);
    INPUTS_INIT(&inputs);
    inputs.mode = 1;
    for (long i = 0; i < n; i++) {
        (void)counts_from(i);
        /* within +-131072 um/s: no limit is reached, both signs occur */
        seed = seed * 1664525u + 1013904223u;
        inputs.v_motor = (double)((int32_t)(seed >> 14) - 131072);
#ifdef READS_V_COMMAND
        seed = seed * 1664525u + 1013904223u;
        inputs.v_command = (double)((int32_t)(seed >> 14) - 131072);
#endif
        STEP(&state, &inputs, &outputs);
        sum += outputs.v_add;
    }
    printf("%.17g\n", sum);
    return 0;
}
