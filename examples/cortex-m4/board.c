/* A Cortex-M4F in qemu (machine mps2-an386): vectors, reset, SysTick, and output by semihosting. Another board needs another one of
 * these, and nothing else. */
#include "board.h"

/* the processor's clock */
#define CLOCK 25000000u

/* from the linker script */
extern uint32_t stack_top, data_from, data_begin, data_end, bss_begin, bss_end;

void reset(void);

static uint32_t semihosting(uint32_t operation, const void *argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

void board_put(const char *text)
{
    semihosting(0x04u, text); /* SYS_WRITE0 */
}

void board_put_number(uint32_t number)
{
    char text[11];
    uint32_t at = 10u;
    text[10] = '\0';
    do {
        text[--at] = (char)('0' + number % 10u);
        number /= 10u;
    } while (number > 0u);
    board_put(&text[at]);
}

void board_start_timer(uint32_t per_second)
{
    *(volatile uint32_t *)0xe000e014u = CLOCK / per_second - 1u; /* SYST_RVR */
    *(volatile uint32_t *)0xe000e018u = 0u;                      /* SYST_CVR */
    *(volatile uint32_t *)0xe000e010u = 7u;                      /* SYST_CSR: on, with interrupt, the processor's clock */
}

void board_sleep(void)
{
    __asm__ volatile("wfi");
}

static void leave(uint32_t code)
{
    const uint32_t arguments[2] = {0x20026u, code};
    semihosting(0x20u, arguments); /* SYS_EXIT_EXTENDED */
    for (;;) {
    }
}

static void broken(void)
{
    board_put("a fault of the processor\n");
    leave(3u);
}

void reset(void)
{
    const uint32_t *from = &data_from;
    uint32_t *to;
    for (to = &data_begin; to < &data_end; to++) {
        *to = *from++;
    }
    for (to = &bss_begin; to < &bss_end; to++) {
        *to = 0u;
    }
    *(volatile uint32_t *)0xe000ed88u |= 0xfu << 20; /* CPACR: the floating-point unit */
    __asm__ volatile("dsb\n\tisb" : : : "memory");
    leave((uint32_t)main());
}

/* the last of the first 16 is that of the SysTick */
__attribute__((section(".vectors"), used)) static const void *const vectors[16] = {
    &stack_top,     (void *)reset,  (void *)broken, (void *)broken, (void *)broken, (void *)broken, (void *)broken, (void *)broken,
    (void *)broken, (void *)broken, (void *)broken, (void *)broken, (void *)broken, (void *)broken, (void *)broken, (void *)timer_interrupt,
};
