/* The loop of a block `ipc` with the ideal drive, whose motor does what was commanded one cycle before: noise for 2 s,
   then 6 s without a command; the last second against the first one of them, rms. Infinite where the last second is as
   large as the limit makes it. The test puts the blocks before this text, and `main` after it. */
#include <math.h>
#include <stdio.h>
static uint32_t seed = 1u;
static double noise(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 17;
    seed ^= seed << 5;
    return (double)(seed % 2001u) - 1000.0;
}
static double growth(double first, double last)
{
    return last > 1000.0 * 300000.0 * 300000.0 ? HUGE_VAL : sqrt(last / first);
}
#define GROWTH(B) { \
    B##_state state; B##_inputs in; B##_outputs out; \
    double v_motor = 0.0; double first = 0.0; double last = 0.0; int n; \
    B##_init(&state); B##_inputs_init(&in); in.mode = 1; \
    for (n = 0; n < 8000; n++) { \
        double v_command = n < 2000 ? noise() : 0.0; \
        in.v_motor = v_motor; \
        B##_step(&state, &in, &out); \
        v_motor = v_command + out.v_add; \
        if (n >= 2000 && n < 3000) { first += v_motor * v_motor; } \
        if (n >= 7000) { last += v_motor * v_motor; } \
    } \
    printf("%.17g\n", growth(first, last)); \
}
