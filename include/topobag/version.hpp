// SPDX-License-Identifier: MIT
#pragma once

// Said in one sentence, before a compiler of an earlier standard says it in hundreds.
#if defined(_MSVC_LANG)
#define TOPOBAG_STANDARD _MSVC_LANG
#else
#define TOPOBAG_STANDARD __cplusplus
#endif
#if TOPOBAG_STANDARD < 201703L
#error topobag needs C++17: compile with -std=c++17 or later (CMake: CMAKE_CXX_STANDARD 17), and so whatever holds Eigen types with it.
// The compiler stops here, and does not go on to what it cannot know.
#include <topobag_needs_cxx17>
#endif
#undef TOPOBAG_STANDARD

/// The library's version. This file is the only place that states it: CMake reads it from here.
#define TOPOBAG_VERSION_MAJOR 0
#define TOPOBAG_VERSION_MINOR 2
#define TOPOBAG_VERSION_PATCH 0
