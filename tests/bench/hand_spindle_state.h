/* What the hand-written spindles keep from cycle to cycle. */
#ifndef HAND_SPINDLE_STATE_H
#define HAND_SPINDLE_STATE_H

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    int32_t kind; /* 0 STOP, 1 TURN, 2 POSITION, 3 RELEASE, 4 HOME */
    double speed;
    double position;
} hand_job;

typedef struct {
    int32_t control; /* 0 POSITION, 1 TO_VELOCITY, 2 VELOCITY, 3 BRAKE, 4 TO_POSITION */
    uint32_t cycles; /* in TO_VELOCITY, BRAKE or TO_POSITION, this one included */
    uint32_t settled;
    uint32_t missing; /* cycles in a row without a sample */
    uint32_t lasting_error;
    bool asks_velocity;
    bool returns; /* a reset leads back to position control */
    bool is_moving; /* the block moves the spindle; not at the start */
    bool catches; /* a spindle that was caught waits for the drive to display velocity control */
    uint32_t samples; /* of the actual velocity in a row at the start, up to 3 */
    uint32_t slow; /* slow ones of them */
    double v_last; /* the last sample */
    double v_older; /* the one before */
    double v_middle; /* the median of the last three */
    bool takes_over; /* the interpolator has to go on from x; while a sample is missing, too */
    bool turns_fast; /* the job is TURN with more than Von */
    bool was_true; /* a request was TRUE in the last cycle */
    bool m3, m4, m5, m19, putax, g74; /* of the last cycle */
    double x;
    double x_start;
    double v;
    hand_job job;
    uint32_t jobs;
    uint32_t queued;
    hand_job request[4]; /* the first one first */
} hand_spindle;

#endif
