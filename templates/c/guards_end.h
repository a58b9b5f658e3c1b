#if defined(__clang__)
#if __has_attribute(no_builtin)
#pragma clang attribute pop
#endif
#endif
