// SPDX-License-Identifier: MIT
// Of the library topobag::compiled: what TOPOBAG_COMPILED keeps other files from instantiating.
#include <topobag/recognition/relocalizer.hpp>

namespace topobag {
inline namespace v0 {

template class Relocalizer<>;

}  // namespace v0
}  // namespace topobag
