/* The parts that the drivers of `cortex_m4` share: names from an axis and a block, and calls of Linux without a library. */
#define JOIN(a, b) a##b
#define NAME(a, b) JOIN(a, b)

static void called(int number, int first, unsigned second, unsigned third)
{
    register int r7 __asm__("r7") = number;
    register int r0 __asm__("r0") = first;
    register unsigned r1 __asm__("r1") = second;
    register unsigned r2 __asm__("r2") = third;
    __asm__ volatile("svc 0" : "+r"(r0) : "r"(r7), "r"(r1), "r"(r2) : "memory");
}
