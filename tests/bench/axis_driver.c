/* Calls the step of the block `axis` of one axis N times with moving inputs, mode ON, feedforward active at 87 %; prints a
 * sum, so that nothing can be left out. No limit is reached.
 *
 * AXIS_HEADER and AXIS come with -D, for example -DAXIS=axis_x -DAXIS_HEADER='"axis_x.h"'.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include AXIS_HEADER

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
#define STATE JOIN(AXIS, _axis_state)
#define INPUTS JOIN(AXIS, _axis_inputs)
#define OUTPUTS JOIN(AXIS, _axis_outputs)
#define INIT JOIN(AXIS, _axis_init)
#define INPUTS_INIT JOIN(AXIS, _axis_inputs_init)
#define STEP JOIN(AXIS, _axis_step)

/* within +-1, both signs */
static double noise(void)
{
    static uint32_t seed = 1u;
    seed = seed * 1664525u + 1013904223u;
    return (double)((int32_t)(seed >> 14) - 131072) / 131072.0;
}

int main(int argc, char **argv)
{
    const long n = argc > 1 ? strtol(argv[1], NULL, 10) : 1000;
    static STATE state;
    static INPUTS inputs;
    static OUTPUTS outputs;
    double sum = 0.0;

    INIT(&state);
    INPUTS_INIT(&inputs);
    inputs.mode = 1;
    inputs.feedforward_active = true;
    inputs.feedforward_percentage = 87;
    for (long i = 0; i < n; i++) {
        inputs.x_command = 1.0e6 * noise();
        inputs.x_actual = inputs.x_command - 1.0e3 * noise();
        inputs.v_interpolator = 1.0e5 * noise();
        inputs.a_interpolator = 1.0e4 * noise(); /* 10^5 would be beyond the 16 bits of the axis T */
        inputs.v_motor = 1.0e5 * noise();
        STEP(&state, &inputs, &outputs);
        if (outputs.limited || outputs.fault) {
            return 1;
        }
        sum += outputs.v_command + outputs.v_feedforward + outputs.v_add + outputs.v_add_calculated;
        sum += outputs.manipulated_variable + outputs.x_drive + outputs.additive_velocity + outputs.additive_torque;
    }
    printf("%.17g\n", sum);
    return 0;
}
