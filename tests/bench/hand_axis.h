/* What the hand-written whole axes share. */
#ifndef HAND_AXIS_H
#define HAND_AXIS_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

/* Part of every cycle, and not. */
#define OFTEN static inline __attribute__((always_inline))
#define SELDOM static __attribute__((noinline, cold))

#define CYCLE_TIME_NS 1000000u
#define MODE_OFF 0
#define MODE_ON 1
#define MODE_DRYRUN 2

/* A NaN is not. */
OFTEN bool in_range(double sample)
{
    return fabs(sample) <= 1.0e15;
}

/* G135 and G136; the weight of the whole feedforward is 1 in all axes here. */
OFTEN double feedforward_gain(bool active, int32_t percentage)
{
    if (!active || percentage <= 0) {
        return 0.0;
    }
    if (percentage >= 100) {
        return 1.0;
    }
    return 0.01 * (double)percentage;
}

/* To the nearest integer, a half away from zero; of a number that fits. What is added is the largest double below 1/2: 1/2
 * itself would bring that very double to 1. From a half on, the sum rounds to the next integer or lies beyond it. */
OFTEN int32_t nearest(double x)
{
    return (int32_t)(x + copysign(0.49999999999999994, x));
}

#endif
