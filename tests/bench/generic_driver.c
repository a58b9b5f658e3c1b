/* Calls the generic cascade N times with as many sections as the second argument says. */
#include <stdio.h>
#include <stdlib.h>

#include "generic_cascade.h"
#include "counted.h"

#define MOST_SECTIONS 64

int main(int argc, char **argv)
{
    const long n = argc > 1 ? strtol(argv[1], NULL, 10) : 1000;
    const long sections = argc > 2 ? strtol(argv[2], NULL, 10) : 3;
    static generic_coefficients coefficients[MOST_SECTIONS];
    static generic_state state[MOST_SECTIONS];
    uint32_t seed = 1u;
    double sum = 0.0;

    if (sections < 1 || sections > MOST_SECTIONS) {
        return 2;
    }
    for (long i = 0; i < sections; i++) {
        /* all-passes: any number of them stays within the range of normal numbers */
        coefficients[i].b0 = 0.9;
        coefficients[i].b1 = -1.8;
        coefficients[i].b2 = 1.0;
        coefficients[i].a1 = -1.8;
        coefficients[i].a2 = 0.9;
    }
    for (long i = 0; i < n; i++) {
        (void)counts_from(i);
        seed = seed * 1664525u + 1013904223u;
        sum += generic_cascade(coefficients, state, (uint32_t)sections, (double)((int32_t)(seed >> 14) - 131072));
    }
    printf("%.17g\n", sum);
    return 0;
}
