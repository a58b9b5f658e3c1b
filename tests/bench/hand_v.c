/* The axis V of examples/feedforward.toml written by hand for speed: the yardstick for its generated block `axis`.
 *
 * Cycle 1 ms. Compile without contraction.
 *   feedforward: ADD_VEL, delay 150 us, weight 1; 10000 increments are 3333 um/min, 32 bits
 *   position control: in the drive, the position command goes there as it is
 *
 * The coefficients are those that the generator prints.
 */
#include "axis_hand_v_axis.h"

#define AXIS(name) axis_hand_v_axis_##name
#define INPUT v_interpolator
#define INPUT_ERROR 14u
#define OUTPUT additive_velocity
#define OUTPUT_MIN INT32_MIN
#define OUTPUT_MAX INT32_MAX

static const double now = 0.85; /* delay of 0.15 cycles */
static const double earlier = 0.15;
static const double increments_per_input = 180.01800180018003;
static const double highest = 2147483647.5; /* rounded beyond the range from here on */
static const double lowest = -2147483648.5;

#include "hand_additive.h"
