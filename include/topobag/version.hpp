// SPDX-License-Identifier: MIT
#pragma once

#include <topobag/cxx17.hpp>

/// The library's version. This file is the only place that states it: CMake reads it from here.
#define TOPOBAG_VERSION_MAJOR 0
#define TOPOBAG_VERSION_MINOR 2
#define TOPOBAG_VERSION_PATCH 0
