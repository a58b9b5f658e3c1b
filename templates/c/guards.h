/* The constants below require IEEE 754 arithmetic in which every operation is rounded once. */
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) \
    || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || defined(__NO_SIGNED_ZEROS__)
#error "this block needs exact arithmetic: compile it without -ffast-math and its parts"
#endif
#include <float.h>
#if FLT_EVAL_METHOD != 0
#error "this block needs arithmetic in the declared type: on x86 compile it with -mfpmath=sse"
#endif
/* A fused multiply-add rounds once where the reference rounds twice. */
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize ("fp-contract=off")
#else
#pragma STDC FP_CONTRACT OFF
#endif
/* No library calls: without this pragma clang calls memset to store several zeros. */
#if defined(__clang__)
#if __has_attribute(no_builtin)
#pragma clang attribute push(__attribute__((no_builtin("memset", "memcpy", "memmove"))), apply_to = function)
#endif
#endif
