// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// The sample data: two sequences of one desk, and the options that fit them.
inline const std::string sample_map = TOPOBAG_SOURCES "/examples/data/fr1_xyz";
inline const std::string sample_query = TOPOBAG_SOURCES "/examples/data/fr1_rpy";
inline const std::string sample_options =
    " --camera 517.3,516.5,318.6,255.3 --keyframe-interval 0 ";
