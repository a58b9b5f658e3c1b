/* Runs the block BLOCK with the set that it was generated with, offers SET, then a damaged one with another number;
   writes the bytes of SET if the block did with them what it says. The test replaces the names BLOCK and SET. */
#include <stdio.h>
#include "BLOCK.h"
extern const BLOCK_params SET;

static BLOCK_state state;
static BLOCK_inputs inputs;
static BLOCK_outputs outputs;

static int runs(const volatile BLOCK_params *params, uint32_t active, uint32_t error_id)
{
    int cycle;
    inputs.params = params;
    for (cycle = 0; cycle < 400; cycle++) {
        inputs.v_motor = (cycle % 20) * 100;
        BLOCK_step(&state, &inputs, &outputs);
    }
    return outputs.active_set == active && outputs.error_id == error_id && !outputs.fault;
}

int main(void)
{
    BLOCK_params damaged = SET;
    damaged.set_id += 1u;
    BLOCK_init(&state);
    BLOCK_inputs_init(&inputs);
    inputs.mode = 1;
    if (!runs(inputs.params, BLOCK_designed.set_id, 0u)) return 2;
    if (!runs(&SET, SET.set_id, 0u) || SET.set_id == BLOCK_designed.set_id) return 3;
    if (!runs(&damaged, SET.set_id, 8u)) return 4;
    damaged.structure += 1u;
    if (!runs(&damaged, SET.set_id, 6u)) return 5;
    return fwrite(&SET, sizeof SET, 1, stdout) == 1 ? 0 : 1;
}
