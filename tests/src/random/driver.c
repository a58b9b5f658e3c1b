/* Runs every program of a translation unit on the words of a file and compares: outputs, and the state that the program
 * keeps. UNIT is the unit, REAL its real type, BITS the unsigned integer of the same size.
 * For each program that differs one line: its number, run, sample, scalar, the bits found, the bits that Rust has. */
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

struct leaf {
    size_t at;
    char kind;
    const char *path;
};

struct block {
    unsigned number;
    size_t state, outputs, inputs;
    size_t state_size, outputs_size, inputs_size;
    const struct leaf *leaves;
    void (*init)(void *state);
    void (*step)(void *state, const void *inputs, void *outputs);
};

/* by the size of the real type */
#define NEARLY_HALF (sizeof(REAL) == sizeof(float) ? (REAL)0.49999997f : (REAL)0.49999999999999994)

static REAL block_magnitude(REAL value)
{
    return value < (REAL)0 ? -value : value;
}

static bool block_is_zero(REAL value)
{
    return value == (REAL)0;
}

static int32_t block_nearest(REAL value)
{
    return (int32_t)(value < (REAL)0 ? value - NEARLY_HALF : value + NEARLY_HALF);
}

#include UNIT

static FILE *file;

static uint64_t next(void)
{
    uint64_t word = 0u;
    if (fread(&word, sizeof word, 1, file) != 1) {
        puts("the words have ended");
    }
    return word;
}

static void put(void *memory, const struct leaf *leaf, uint64_t word)
{
    unsigned char *to = (unsigned char *)memory + leaf->at;
    if (leaf->kind == 'b') {
        const bool value = word != 0u;
        memcpy(to, &value, sizeof value);
    } else if (leaf->kind == 'r') {
        const BITS value = (BITS)word;
        memcpy(to, &value, sizeof value);
    } else {
        const uint32_t value = (uint32_t)word;
        memcpy(to, &value, sizeof value);
    }
}

static uint64_t get(const void *memory, const struct leaf *leaf)
{
    const unsigned char *from = (const unsigned char *)memory + leaf->at;
    if (leaf->kind == 'b') {
        bool value;
        memcpy(&value, from, sizeof value);
        return value;
    } else if (leaf->kind == 'r') {
        BITS value;
        memcpy(&value, from, sizeof value);
        return value;
    } else {
        uint32_t value;
        memcpy(&value, from, sizeof value);
        return value;
    }
}

static bool is_nan(uint64_t word)
{
    const BITS bits = (BITS)word;
    REAL value;
    memcpy(&value, &bits, sizeof value);
    return value != value;
}

static bool same(const struct leaf *leaf, uint64_t found, uint64_t expected)
{
    return found == expected || (leaf->kind == 'r' && is_nan(found) && is_nan(expected));
}

/* Room for any state, outputs or inputs. */
union memory {
    uint64_t aligned;
    double real;
    unsigned char bytes[65536];
};

static union memory state, outputs, inputs;

static void run(const struct block *block)
{
    static uint64_t start[8192];
    const size_t kept = block->state + block->outputs;
    const size_t runs = (size_t)next(), samples = (size_t)next();
    bool differs = false;
    size_t i, r, s;
    if (block->state_size > sizeof state || block->outputs_size > sizeof outputs || block->inputs_size > sizeof inputs
        || kept > sizeof start / sizeof start[0]) {
        printf("%u does not fit\n", block->number);
        return;
    }
    for (i = 0; i < kept; i++) {
        start[i] = next();
    }
    for (r = 0; r < runs; r++) {
        for (i = 0; i < kept; i++) {
            put(i < block->state ? &state : &outputs, &block->leaves[i], start[i]);
        }
        block->init(&state);
        for (s = 0; s < samples; s++) {
            for (i = 0; i < block->inputs; i++) {
                put(&inputs, &block->leaves[kept + i], next());
            }
            block->step(&state, &inputs, &outputs);
            for (i = 0; i < kept; i++) {
                /* the answers begin with the outputs */
                const size_t at = i < block->outputs ? block->state + i : i - block->outputs;
                const struct leaf *leaf = &block->leaves[at];
                const uint64_t found = get(at < block->state ? &state : &outputs, leaf), expected = next();
                if (!differs && !same(leaf, found, expected)) {
                    differs = true;
                    printf("%u\trun %u, sample %u: %s has the bits %llx, in Rust it has %llx\n", block->number,
                        (unsigned)r, (unsigned)s, leaf->path, (unsigned long long)found, (unsigned long long)expected);
                }
            }
        }
    }
}

int main(int argc, char **argv)
{
    const size_t count = sizeof blocks / sizeof blocks[0] - 1;
    size_t i;
    file = argc == 2 ? fopen(argv[1], "rb") : NULL;
    if (file == NULL) {
        return 1;
    }
    for (i = 0; i < count; i++) {
        run(&blocks[i]);
    }
    printf("%u programs have run\n", (unsigned)count);
    return fclose(file) == 0 ? 0 : 1;
}
