/* What a drive does once at start-up: 0 if this build computes the bits of the reference. */
#include "axis_x_ipc.h"

int main(void)
{
    return axis_x_ipc_self_test() == 0 ? 0 : 1;
}
