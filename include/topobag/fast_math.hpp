// SPDX-License-Identifier: MIT
#pragma once

/// Warns a program that is compiled as if NaN and infinity did not exist (-ffast-math, -Ofast,
/// -ffinite-math-only): the compiler then takes the checks for them out of the library.
/// Define `TOPOBAG_ALLOW_FAST_MATH` before the first include to silence it.
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ && !defined(TOPOBAG_ALLOW_FAST_MATH)
#warning "topobag: -ffast-math removes the checks for NaN; add -fno-finite-math-only"
#endif
