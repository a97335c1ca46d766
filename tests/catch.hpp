// SPDX-License-Identifier: MIT
#pragma once

// Catch2 v2 (Debian 12) and v3 behind one include.
#ifdef TOPOBAG_CATCH2_V3
#include <catch2/catch_approx.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif
