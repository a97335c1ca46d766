// SPDX-License-Identifier: MIT
#pragma once

#include <topobag/recognition/loop_detector.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "map.hpp"

namespace python {

using Relocalizer = topobag::Relocalizer<SharedMap>;
using LoopDetector = topobag::LoopDetector<SharedMap>;

}  // namespace python
