/* A thread writes two sets in turn while the block checks them: prints how many were taken, and how many of those were mixed. The test
 * fills in the words in capitals. */
#include "axis_x_ipc.h"
#include <pthread.h>
#include <stdio.h>

static const axis_x_ipc_params other = {VALUES};
static volatile axis_x_ipc_params shared;
static volatile int done;

static void *writer(void *unused)
{
    (void)unused;
    /* A set stays for some time, from none up to much longer than its check takes. */
    uint32_t any = 1;
    while (!done) {
FIRST
        any = any * 1664525u + 1013904223u;
        for (volatile uint32_t left = any >> (11 + (any >> 7) % 12); left > 0 && !done; left--) {
        }
SECOND
        any = any * 1664525u + 1013904223u;
        for (volatile uint32_t left = any >> (11 + (any >> 7) % 12); left > 0 && !done; left--) {
        }
    }
    return 0;
}

static axis_x_ipc_state state;

static int is(const axis_x_ipc_params *of)
{
    return 1
KEPT;
}

int main(void)
{
    axis_x_ipc_inputs inputs;
    axis_x_ipc_outputs outputs;
    pthread_t thread;
    unsigned taken = 0, mixed = 0;
    uint32_t before = 0;
    axis_x_ipc_init(&state);
    axis_x_ipc_inputs_init(&inputs);
    inputs.params = &shared;
    inputs.mode = 0;
    pthread_create(&thread, 0, writer, 0);
    for (long cycle = 0; cycle < 200000000L && taken < CHANGESu; cycle++) {
        state.pause = 0;
        axis_x_ipc_step(&state, &inputs, &outputs);
        if (outputs.active_set != before && outputs.active_set != 0) {
            taken++;
            if (!is(outputs.active_set == other.set_id ? &other : &axis_x_ipc_designed)) {
                mixed++;
            }
        }
        before = outputs.active_set;
    }
    done = 1;
    pthread_join(thread, 0);
    printf("%u %u\n", taken, mixed);
    return 0;
}
