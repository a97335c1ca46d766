// SPDX-License-Identifier: MIT
#pragma once

#include <topobag/bag/entry_info.hpp>
#include <topobag/recognition/recognition_options.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "keyframe.hpp"
#include "recognition_run.hpp"

namespace program {

/// What a front end knows of a key frame of its map.
topobag::EntryInfo info_of(const Keyframe& keyframe);

/// The program's options for a run, with the decision that it was calibrated for. A map of objects
/// was seen by no camera, so that it has no direction that one would look in again.
topobag::RecognitionOptions options_of(const RecognitionRun& run);

/// The map of a run; its ids are positions in it.
topobag::Relocalizer<> relocalizer_of(const RecognitionRun& run);

}  // namespace program
