// SPDX-License-Identifier: MIT
// Of the library topobag::compiled: what TOPOBAG_COMPILED keeps other files from instantiating.
#include <topobag/recognition/loop_detector.hpp>

namespace topobag {
inline namespace v0 {

template class LoopDetector<>;

}  // namespace v0
}  // namespace topobag
