/* Calls the step of the block `axis` of one axis N times with moving inputs, mode ON, feedforward active at 87 %; prints a
 * sum, so that nothing can be left out. No limit is reached.
 *
 * AXIS_HEADER and AXIS come with -D, for example -DAXIS=axis_x -DAXIS_HEADER='"axis_x_axis.h"', and READS_ with the name of
 * each input that not all axes read.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include AXIS_HEADER
#include "counted.h"

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
#ifdef READS_MODE
    inputs.mode = 1;
#endif
    inputs.feedforward_active = true;
    inputs.feedforward_percentage = 87;
    for (long i = 0; i < n; i++) {
        (void)counts_from(i);
        inputs.x_command = 1.0e6 * noise();
#ifdef READS_X_ACTUAL
        inputs.x_actual = inputs.x_command - 1.0e3 * noise();
#endif
#ifdef READS_V_INTERPOLATOR
        inputs.v_interpolator = 1.0e5 * noise();
#endif
#ifdef READS_A_INTERPOLATOR
        inputs.a_interpolator = 1.0e4 * noise(); /* 10^5 would be beyond the 16 bits of the axis T */
#endif
#ifdef READS_V_MOTOR
        inputs.v_motor = 1.0e5 * noise();
#endif
        STEP(&state, &inputs, &outputs);
        if (outputs.limited || outputs.fault) {
            return 1;
        }
#ifdef READS_V_MOTOR
        sum += outputs.v_add + outputs.v_add_calculated;
#endif
#if defined(READS_X_ACTUAL)
        sum += outputs.v_command + outputs.v_feedforward + outputs.manipulated_variable;
#elif defined(READS_V_INTERPOLATOR)
        sum += outputs.x_drive + outputs.additive_velocity;
#else
        sum += outputs.x_drive + outputs.additive_torque;
#endif
    }
    printf("%.17g\n", sum);
    return 0;
}
