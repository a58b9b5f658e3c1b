/* A run-time cascade of second-order sections, as signal processing libraries offer it. */
#ifndef GENERIC_CASCADE_H
#define GENERIC_CASCADE_H

#include <stdint.h>

typedef struct {
    double b0;
    double b1;
    double b2;
    double a1;
    double a2;
} generic_coefficients;

typedef struct {
    double s1;
    double s2;
} generic_state;

double generic_cascade(
    const generic_coefficients *coefficients, generic_state *state, uint32_t sections, double x);

#endif
