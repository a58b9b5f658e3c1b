/* From which cycle on callgrind counts: with -DUNCOUNTED=N what it has counted in the first N cycles, which start a block and fade
 * it in, is forgotten. */
#include <stdbool.h>

#ifdef UNCOUNTED
#include <valgrind/callgrind.h>
#endif

/* Whether counting begins with this cycle. */
static inline bool counts_from(long cycle)
{
#ifdef UNCOUNTED
    if (cycle == UNCOUNTED) {
        CALLGRIND_ZERO_STATS;
        return true;
    }
#else
    (void)cycle;
#endif
    return false;
}
