/* The generic alternative: any number of sections in transposed direct form II, the number known at run time only. */
#include "generic_cascade.h"

double generic_cascade(
    const generic_coefficients *restrict coefficients, generic_state *restrict state, uint32_t sections, double x)
{
    for (uint32_t i = 0u; i < sections; i++) {
        const double y = coefficients[i].b0 * x + state[i].s1;
        state[i].s1 = coefficients[i].b1 * x - coefficients[i].a1 * y + state[i].s2;
        state[i].s2 = coefficients[i].b2 * x - coefficients[i].a2 * y;
        x = y;
    }
    return x;
}
