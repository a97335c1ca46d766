// SPDX-License-Identifier: MIT
// Warned about under -ffast-math, but for who defines TOPOBAG_ALLOW_FAST_MATH.
#include <topobag/error.hpp>

int main() {}
