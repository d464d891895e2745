// Functions on SIMD vectors, compiled for two instruction sets with the same results.
#pragma once

// Function multiversioning: marked functions are compiled for AVX2 too and dispatched when the
// program starts; the functions that they call must be inlined. AVX2 alone has no fused
// multiply-add, so the results are bitwise equal everywhere.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__)
#define KUSABI_ALSO_FOR_AVX2 __attribute__((target_clones("avx2", "default")))
#else
#define KUSABI_ALSO_FOR_AVX2
#endif
#define KUSABI_INLINE [[gnu::always_inline]] inline
