// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <topobag/error.hpp>
#include <topobag/matching/appearance_model.hpp>
#include <topobag/recognition/recognition_options.hpp>
#include <topobag/types/appearance.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The one kind of a bag's looks; of length 0 where there are none, or the bag does not tell.
template <typename Bag>
auto appearance_kind_of(const Bag& bag, int) -> decltype(AppearanceKind(bag.appearance_kind())) {
  return bag.appearance_kind();
}
template <typename Bag>
AppearanceKind appearance_kind_of(const Bag&, long) {
  return {};
}

/// Throws InvalidValue when the bag's looks are of another kind than those that were learnt.
template <typename Bag>
void require_kind_of(const Bag& bag, const AppearanceKind& learnt) {
  const AppearanceKind kind = appearance_kind_of(bag, 0);
  if (kind.length() == 0 || kind == learnt) return;
  throw InvalidValue("the calibration learnt looks by descriptors of another kind (" +
                     std::to_string(learnt.length()) + " numbers) than the map's (" +
                     std::to_string(kind.length()) + " numbers): calibrate this map anew");
}

/// What the options' calibration says of looks; null where it says nothing. Throws as above.
template <typename Bag>
const AppearanceModel* learnt_looks(const Bag& bag, const RecognitionOptions& options) {
  const auto& calibration = options.decision.calibration;
  if (!calibration || !calibration->appearance()) return nullptr;
  require_kind_of(bag, calibration->appearance()->kind);
  return &*calibration->appearance();
}

/// Options whose matching judges looks as `appearance_model` says; copied only where that is
/// learnt.
class LearntLooks {
 public:
  /// @param options  are referred to. Throws as `learnt_looks`
  template <typename Bag>
  LearntLooks(const Bag& bag, const RecognitionOptions& options) : given_(options) {
    const AppearanceModel* learnt = learnt_looks(bag, options);
    if (learnt == nullptr) return;
    with_looks_ = options;
    with_looks_->matching.chance.appearance = *learnt;
  }

  const RecognitionOptions& options() const noexcept { return with_looks_ ? *with_looks_ : given_; }

 private:
  const RecognitionOptions& given_;
  std::optional<RecognitionOptions> with_looks_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
