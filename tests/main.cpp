// SPDX-License-Identifier: MIT
#ifndef TOPOBAG_CATCH2_V3  // v3 brings its own main
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
#endif
