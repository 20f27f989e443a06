"""The parts of C files that are the same for all kernels, and how they are compiled."""

COMPILE = (
    "cc -std=c99 -O3 -march=native -mprefer-vector-width=512 -fopenmp-simd",
    "-ffp-contract=off -fno-math-errno -fno-trapping-math",
)
PARALLEL = 50_000  # points from which threads are worth their start

HEADER = f"""\
/* Kernels of {{key}} in C99.
   {{mark}}

   Compile with GCC or Clang, and link with -lm:

       {COMPILE[0]} \\
          {COMPILE[1]} -c {{key}}.c

   With -fopenmp besides, threads share arrays from {PARALLEL:,} points on. -mprefer-vector-width is for x86-64 alone.
   GCC takes vector forms of exp, log, pow, atan and the like from glibc (libmvec). Clang calls libm point by point in
   the kernels that have these, and warns that it does not vectorise their loops.

   Why so: -ffp-contract=off rounds each product and each sum by itself, as NumPy does, so that x y - y x is 0.
   -fno-math-errno and -fno-trapping-math change no value; with them roots and choices become vector instructions. Never
   use -ffast-math: it loses infinities and NaN.

   Each function computes n points. Its arrays are contiguous; results share no memory with one another or with
   arguments. n = 1 is one point; for n = 0 nothing is read or written. NaN inputs give NaN outputs. An argument
   that is the same at all points is an array as well: fill a short one, of a thousand numbers, once, and call the
   function for a thousand points at a time. */
#ifndef SYMCHECK_{{guard}}_H
#define SYMCHECK_{{guard}}_H

#include <stddef.h>

#ifdef __cplusplus
#define SYMCHECK_RESTRICT
extern "C" {{{{
#else
#define SYMCHECK_RESTRICT restrict
#endif

{{declarations}}
#ifdef __cplusplus
}}}}
#endif
#undef SYMCHECK_RESTRICT

#endif
"""

SOURCE = """\
/* Kernels of {key} in C99; {key}.h says how to compile and to call them.
   {mark} */
#include "{key}.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#ifdef __GNUC__
#define INLINE inline __attribute__((always_inline)) /* a call would keep a loop from becoming vector instructions */
#else
#define INLINE inline
#endif
"""

VECTORS = """\
/* glibc has these for vectors, in libmvec, but tells GCC so only under -ffast-math. */
#if defined(__x86_64__) && !defined(__clang__) && (__GLIBC__ > 2 || (__GLIBC__ == 2 && __GLIBC_MINOR__ >= 35))
{declarations}
#endif
"""

LOOP = """\
#pragma omp parallel for simd if(parallel: n >= {parallel})
    for (size_t i = 0; i < n; ++i) {{
{body}
    }}
"""

LOOP_AND_REST = """\
    int64_t far = 0; /* whether an angle is too large for the functions above */
#pragma omp parallel for simd if(parallel: n >= {parallel}) reduction(| : far)
    for (size_t i = 0; i < n; ++i)
        far |= {near};
    for (size_t i = 0; far && i < n; ++i)
        if ({near})
            {far};
"""
