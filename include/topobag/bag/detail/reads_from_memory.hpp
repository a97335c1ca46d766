// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include <topobag/bag/bag_reader.hpp>
#include <topobag/bag/detail/present_view.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The reading side of a bag that is kept elsewhere as well: every call is answered by a bag in
/// memory that holds the same.
template <typename Bag_>
class ReadsFromMemory : public BagReader<ReadsFromMemory<Bag_>, PresentView<Bag_>> {
 public:
  using Bag = Bag_;
  using Graph = typename Bag::Graph;

  /// The bag in memory.
  const Bag& bag() const noexcept { return bag_; }

  /// To be dereferenced: a view of the bag in memory where it has one, which never changes, else
  /// that bag itself.
  auto view() const { return present_view(bag_, 0); }

 protected:
  explicit ReadsFromMemory(Bag bag) : bag_(std::move(bag)) {}
  ~ReadsFromMemory() = default;
  ReadsFromMemory(ReadsFromMemory&&) = default;
  ReadsFromMemory& operator=(ReadsFromMemory&&) = default;

  Bag bag_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
