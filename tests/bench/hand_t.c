/* The axis T of examples/feedforward.toml written by hand for speed: the yardstick for its generated block `axis`.
 *
 * Cycle 1 ms. Compile without contraction.
 *   feedforward: ADD_ACC, delay 150 us, weight 1; 16 bits
 *   position control: in the drive, the position command goes there as it is
 *
 * The coefficients are those that the generator prints.
 */
#include "axis_hand_t_axis.h"

#define AXIS(name) axis_hand_t_axis_##name
#define INPUT a_interpolator
#define INPUT_ERROR 15u
#define OUTPUT additive_torque
#define OUTPUT_MIN INT16_MIN
#define OUTPUT_MAX INT16_MAX

static const double now = 0.85; /* delay of 0.15 cycles */
static const double earlier = 0.15;
static const double increments_per_input = 2.412743157956961;
static const double highest = 32767.5; /* rounded beyond the range from here on */
static const double lowest = -32768.5;

#include "hand_additive.h"
