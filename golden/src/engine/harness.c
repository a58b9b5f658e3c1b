/* Runs an emitted block: packed samples from standard input to standard output. layout.h names the block and its signals.
 * Exit code 0: done; 2: the self-test failed, its answer is on standard error; 3: a read or a write failed. */
#include LAYOUT
#include <stdio.h>

#define GET(type, member) \
    { \
        union { type value; unsigned char bytes[sizeof(type)]; } view; \
        size_t i; \
        for (i = 0; i < sizeof(type); i++) view.bytes[i] = in[at + i]; \
        member = view.value; \
        at += sizeof(type); \
    }
#define GET_BOOL(member) member = in[at++] != 0;
#define PUT(type, member) \
    { \
        union { type value; unsigned char bytes[sizeof(type)]; } view; \
        size_t i; \
        view.value = outputs.member; \
        for (i = 0; i < sizeof(type); i++) out[at + i] = view.bytes[i]; \
        at += sizeof(type); \
    }
#define PUT_BOOL(member) out[at++] = outputs.member ? 1 : 0;

int main(void)
{
    static BLOCK(state) state;
    static BLOCK(inputs) inputs;
    static BLOCK(outputs) outputs;
#ifdef HAS_SET
    static BLOCK(params) params;
#endif
    unsigned char in[IN_FRAME], out[OUT_FRAME];
    uint32_t differs = BLOCK(self_test)();
    if (differs != 0u) {
        fprintf(stderr, "%lu\n", (unsigned long)differs);
        return 2;
    }
    BLOCK(init)(&state);
    BLOCK(inputs_init)(&inputs);
#ifdef HAS_SET
    inputs.params = &params;
#endif
    while (fread(in, 1, IN_FRAME, stdin) == IN_FRAME) {
        size_t at = 0;
        GET_INPUTS
        BLOCK(step)(&state, &inputs, &outputs);
        at = 0;
        PUT_OUTPUTS
        if (fwrite(out, 1, OUT_FRAME, stdout) != OUT_FRAME) {
            return 3;
        }
    }
    return ferror(stdin) || fflush(stdout) ? 3 : 0;
}
