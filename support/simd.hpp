// Functions on SIMD vectors, compiled for two instruction sets with the same results.
#pragma once

#include <cstddef>  // __GLIBC__

// Function multiversioning: marked functions are compiled for AVX2 too and dispatched when the
// program starts; the functions that they call must be inlined. AVX2 alone has no fused
// multiply-add, and the build forms none of a product and a sum (-ffp-contract=off), so the results
// are bitwise equal.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__)
#define KUSABI_ALSO_FOR_AVX2 __attribute__((target_clones("avx2", "default")))
#else
#define KUSABI_ALSO_FOR_AVX2
#endif
// Inlines a function into those compiled for both instruction sets; a call would leave them.
#define KUSABI_INLINE [[gnu::always_inline]] inline
