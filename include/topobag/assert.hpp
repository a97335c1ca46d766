// SPDX-License-Identifier: MIT
#pragma once

/// Checks a precondition that the caller owes (not bad data: that throws `topobag::Error`).
/// Define `TOPOBAG_ASSERT(condition)` before the first include to replace it; off under NDEBUG.
#ifndef TOPOBAG_ASSERT
#include <cassert>
#define TOPOBAG_ASSERT(condition) assert(condition)
#endif
