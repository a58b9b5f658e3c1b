/* A section of the hand-written axes. */
#ifndef HAND_SECTION_H
#define HAND_SECTION_H

#include <stdbool.h>
#include <stdint.h>

/* State of a second-order section in transposed direct form II. */
typedef struct {
    double s1;
    double s2;
} hand_section;

#endif
