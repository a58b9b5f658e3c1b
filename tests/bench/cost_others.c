/* Other ways to compute three stages of two sections, in single precision, once per cycle, for `cost` to count: what a caller writes
 * around a filter of a library. Sections only: no check of the input, no limit, no fade. */
#include <stdint.h>

#define STAGES 3u
#define SECTIONS 2u
#define REPEATED 16u

uint32_t runner_cycles(void);
void runner_put(const char *text);
uint32_t others_runner(void);

static const float weight[STAGES] = {1.0f, 0.5f, 0.25f};

#if defined(CMSIS)
#include "dsp/filtering_functions.h"

static float coefficients[STAGES][5 * SECTIONS];
static float states[STAGES][2 * SECTIONS];
static arm_biquad_cascade_df2T_instance_f32 stages[STAGES];

static void begin(void)
{
    uint32_t n;
    for (n = 0u; n < STAGES; n++) {
        uint32_t k;
        for (k = 0u; k < SECTIONS; k++) {
            /* CMSIS has the denominator with the other sign */
            const float section[5] = {0.02f, 0.0f, -0.02f, 1.8f, -0.9f};
            uint32_t i;
            for (i = 0u; i < 5u; i++) {
                coefficients[n][5u * k + i] = section[i];
            }
        }
        stages[n].numStages = SECTIONS;
        stages[n].pCoeffs = coefficients[n];
        stages[n].pState = states[n];
    }
}

__attribute__((noinline)) static float step(float x)
{
    float sum = 0.0f;
    uint32_t n;
    for (n = 0u; n < STAGES; n++) {
        float y;
        arm_biquad_cascade_df2T_f32(&stages[n], &x, &y, 1u);
        sum -= weight[n] * y;
    }
    return sum;
}
#else
/* generic_cascade.c is compiled with the other real type too, in a file of its own: the number of sections is known at run time */
#define double float
#include "generic_cascade.h"
#undef double

static generic_coefficients coefficients[STAGES][SECTIONS];
static generic_state states[STAGES][SECTIONS];

static void begin(void)
{
    uint32_t n;
    for (n = 0u; n < STAGES * SECTIONS; n++) {
        const generic_coefficients section = {0.02f, 0.0f, -0.02f, -1.8f, 0.9f};
        coefficients[n / SECTIONS][n % SECTIONS] = section;
    }
}

__attribute__((noinline)) static float step(float x)
{
    float sum = 0.0f;
    uint32_t n;
    for (n = 0u; n < STAGES; n++) {
        sum -= weight[n] * generic_cascade(coefficients[n], states[n], SECTIONS, x);
    }
    return sum;
}
#endif

__attribute__((noinline)) static float nothing(float x)
{
    __asm__ volatile("" : "+r"(x));
    return x;
}

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
    runner_put("\n");
}

uint32_t others_runner(void)
{
    float (*volatile called)(float) = step;
    float (*volatile empty)(float) = nothing;
    volatile float result;
    uint32_t rounds = 500u;
    uint32_t sum = 0u;
    uint32_t before;
    uint32_t with;
    uint32_t n;
    begin();
    for (n = 0u; n < REPEATED; n++) {
        before = runner_cycles();
        result = called(100.0f);
        with = runner_cycles() - before;
        before = runner_cycles();
        result = empty(100.0f);
        sum += with - (runner_cycles() - before);
    }
    (void)result;
    before = runner_cycles();
    __asm__ volatile(".syntax unified\n1:\tsubs %0, %0, #1\n\tbne 1b" : "+l"(rounds) : : "cc");
    with = runner_cycles() - before;
    before = runner_cycles();
    with -= runner_cycles() - before;
    runner_put("thousand ");
    put_number(with);
    runner_put("path ");
    put_number(sum / REPEATED);
    return 0u;
}
