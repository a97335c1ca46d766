// SPDX-License-Identifier: MIT
// Of the library topobag::compiled: what TOPOBAG_COMPILED keeps other files from instantiating.
#include <topobag/bag/indexed_bag.hpp>

namespace topobag {
inline namespace v0 {

template class BasicBagView<ClassPairDistanceHistogram>;
template class BasicIndexedBag<ClassPairDistanceHistogram>;

}  // namespace v0
}  // namespace topobag
