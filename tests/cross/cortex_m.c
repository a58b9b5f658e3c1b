/* What a Cortex-M needs around an emitted runner in qemu: vectors, reset, output by semihosting. No library, no header of a vendor.
 *
 * RUNS is a list of runners, RUN(axis_x_ipc) each; FLUSH: the floating-point unit replaces subnormal numbers by 0 and every NaN by its
 * own; RUNNER_CYCLES: the SysTick counts. */
#include <stdint.h>

/* from the linker script */
extern uint32_t stack_top, data_from, data_begin, data_end, bss_begin, bss_end;

void reset(void);
static void broken(void);
void runner_put(const char *text);

#define RUN(prefix) uint32_t prefix##_runner(void);
RUNS
#undef RUN

#if defined(FLUSH)
#define KEEPS_SUBNORMALS 0
#else
#define KEEPS_SUBNORMALS 1
#endif

static uint32_t semihosting(uint32_t operation, const void *argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

void runner_put(const char *text)
{
    semihosting(0x04u, text); /* SYS_WRITE0 */
}

/* SYS_EXIT_EXTENDED with ADP_Stopped_ApplicationExit and a code */
static void leave(uint32_t code)
{
    const uint32_t arguments[2] = {0x20026u, code};
    semihosting(0x20u, arguments);
    for (;;) {
    }
}

static void broken(void)
{
    runner_put("a fault of the processor\n");
    leave(3u);
}

#if defined(RUNNER_CYCLES)
/* 24 bits, counting down, at the processor's clock: a step takes less than one turn. */
uint32_t runner_cycles(void)
{
    static uint32_t last, turns;
    uint32_t now;
    *(volatile uint32_t *)0xe000e014u = 0xffffffu; /* SYST_RVR */
    *(volatile uint32_t *)0xe000e010u = 5u;        /* SYST_CSR: on, the processor's clock */
    now = 0xffffffu - *(volatile uint32_t *)0xe000e018u;
    turns += now < last ? 0x1000000u : 0u;
    last = now;
    return turns + now;
}
#endif

#if defined(__ARM_FP)
/* Whether half of the smallest normal number is a number other than 0. */
static int keeps_subnormals(void)
{
    volatile float smallest = 0x1p-126f;
    volatile float half = smallest * 0.5f;
    const volatile uint32_t *bits = (const volatile uint32_t *)&half;
    return *bits != 0u;
}
#endif

void reset(void)
{
    const uint32_t *from = &data_from;
    uint32_t *to;
    uint32_t failed = 0u;
    for (to = &data_begin; to < &data_end; to++) {
        *to = *from++;
    }
    for (to = &bss_begin; to < &bss_end; to++) {
        *to = 0u;
    }
#if defined(__ARM_FP)
    *(volatile uint32_t *)0xe000ed88u |= 0xfu << 20; /* CPACR: the floating-point unit */
    __asm__ volatile("dsb\n\tisb" : : : "memory");
#if defined(FLUSH)
    __asm__ volatile("vmsr fpscr, %0" : : "r"(3u << 24)); /* FZ, DN */
#endif
    if (keeps_subnormals() != KEEPS_SUBNORMALS) {
        runner_put("subnormal numbers are not as asked for\n");
        leave(2u);
    }
#endif
#define RUN(prefix) failed += prefix##_runner();
    RUNS
    leave(failed == 0u ? 0u : 1u);
}

__attribute__((section(".vectors"), used)) static const void *const vectors[16] = {
    &stack_top,     (void *)reset,  (void *)broken, (void *)broken, (void *)broken, (void *)broken, (void *)broken, (void *)broken,
    (void *)broken, (void *)broken, (void *)broken, (void *)broken, (void *)broken, (void *)broken, (void *)broken, (void *)broken,
};
