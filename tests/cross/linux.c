/* What an emitted runner needs on Linux: the standard output. RUNS is a list of runners, RUN(axis_x_ipc) each; FLUSH: the processor
 * replaces subnormal numbers by 0 and every NaN by its own. */
#include <float.h>
#include <stdint.h>
#include <stdio.h>

void runner_put(const char *text);

#define RUN(prefix) uint32_t prefix##_runner(void);
RUNS
#undef RUN

void runner_put(const char *text)
{
    fputs(text, stdout);
}

int main(void)
{
    uint32_t failed = 0u;
#if defined(FLUSH)
    volatile double smallest = DBL_MIN;
#endif
#if defined(FLUSH) && defined(__aarch64__)
    __asm__ volatile("msr fpcr, %0" : : "r"((uint64_t)3u << 24)); /* FZ, DN */
    if (smallest * 0.5 != 0.0) {
        puts("subnormal numbers are not flushed");
        return 2;
    }
#elif defined(FLUSH)
#error "how this processor flushes subnormal numbers is not known here"
#endif
#define RUN(prefix) failed += prefix##_runner();
    RUNS
    return failed == 0u ? 0 : 1;
}
