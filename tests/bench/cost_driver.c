/* Goes each way through a block and counts: the second half of what `cost` writes. On a Cortex-M it prints the counter's ticks for
 * each way; on the host it takes the number of a way, whose calls of `measured_step` callgrind counts. */
#define WAYS 8u
/* behind these the block is faded in */
#define CYCLES 2000u
#define REPEATED 16u

#if defined(__arm__)
uint32_t runner_cycles(void);
void runner_put(const char *text);
uint32_t RUNNER(void);
uint32_t paths_runner(void);

static uint64_t sums[WAYS];
static uint32_t calls[WAYS];

__attribute__((noinline)) static void nothing(STATE *at, const INPUTS *from, OUTPUTS *to)
{
    __asm__ volatile("" : : "r"(at), "r"(from), "r"(to));
}

/* The ticks of 1000 instructions. */
static uint32_t of_thousand(void)
{
    uint32_t rounds = 500u;
    uint32_t before = runner_cycles();
    uint32_t with;
    __asm__ volatile(".syntax unified\n1:\tsubs %0, %0, #1\n\tbne 1b" : "+l"(rounds) : : "cc");
    with = runner_cycles() - before;
    before = runner_cycles();
    return with - (runner_cycles() - before);
}

static void counted(uint32_t way)
{
    void (*volatile step)(STATE *, const INPUTS *, OUTPUTS *) = STEP;
    void (*volatile empty)(STATE *, const INPUTS *, OUTPUTS *) = nothing;
    uint32_t before;
    uint32_t with;
    before = runner_cycles();
    step(&state, &inputs, &outputs);
    with = runner_cycles() - before;
    before = runner_cycles();
    empty(&state, &inputs, &outputs);
    sums[way] += with - (runner_cycles() - before);
    calls[way]++;
}
#else
#include <stdio.h>
#include <stdlib.h>
static uint32_t wanted;
static uint32_t calls;

__attribute__((noinline)) static void measured_step(void)
{
    STEP(&state, &inputs, &outputs);
}

static void counted(uint32_t way)
{
    if (way == wanted) {
        measured_step();
        calls++;
    } else {
        STEP(&state, &inputs, &outputs);
    }
}
#endif

static void go_all_ways(void)
{
    uint32_t n;
    INIT(&state);
    usual();
    counted(0u);
    for (n = 0u; n < REPEATED; n++) {
        usual();
        counted(1u);
    }
    for (n = 0u; n < CYCLES; n++) {
        usual();
        STEP(&state, &inputs, &outputs);
    }
    for (n = 0u; n < REPEATED; n++) {
        usual();
        counted(2u);
    }
    /* a narrow band-pass takes its time until its output is large */
    for (n = 0u; n < CYCLES; n++) {
        limited();
        STEP(&state, &inputs, &outputs);
    }
    for (n = 0u; n < REPEATED; n++) {
        limited();
        counted(3u);
    }
    for (n = 0u; n < COUNT_OF_REALS; n++) {
        bad(n);
        counted(4u);
        usual();
        counted(5u);
    }
    for (n = 0u; n < CYCLES; n++) {
        usual();
        STEP(&state, &inputs, &outputs);
    }
    reset_input();
    counted(6u);
    for (n = 0u; n < CYCLES; n++) {
        usual();
        STEP(&state, &inputs, &outputs);
    }
    for (n = 0u; n < REPEATED; n++) {
        off();
        counted(7u);
    }
}

#if defined(__arm__)
static void put_number(uint32_t number)
{
    char text[11];
    uint32_t at = 10u;
    text[10] = '\0';
    do {
        text[--at] = (char)('0' + number % 10u);
        number /= 10u;
    } while (number > 0u);
    runner_put(&text[at]);
}

uint32_t paths_runner(void)
{
    uint32_t way;
    go_all_ways();
    runner_put("thousand ");
    put_number(of_thousand());
    runner_put("\n");
    for (way = 0u; way < WAYS; way++) {
        runner_put("path ");
        put_number((uint32_t)(sums[way] / calls[way]));
        runner_put("\n");
    }
    return RUNNER();
}
#else
int main(int argc, char **argv)
{
    wanted = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 0u;
    go_all_ways();
    printf("calls %u\n", (unsigned)calls);
    return 0;
}
#endif
