// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include <Eigen/Core>

#include <topobag/error.hpp>
#include <topobag/types/descriptor_kind.hpp>

namespace topobag {
inline namespace v0 {

/// What the numbers of an object's descriptor mean; see `DescriptorKind`.
using AppearanceKind = DescriptorKind<64>;

/// The kind of descriptors that stand together: the one `known` of those before, or else the
/// `added` one's; either may be of no descriptor. Throws InvalidValue, with `index`, when they
/// differ.
/// @param whose  the descriptors that are added
inline AppearanceKind common_kind(AppearanceKind known, AppearanceKind added, const char* whose,
                                  std::optional<std::size_t> index = std::nullopt) {
  if (added.length() == 0 || added == known) return known;
  if (known.length() == 0) return added;
  throw InvalidValue(std::string(whose) + (index ? " " + std::to_string(*index) : "") +
                         " has descriptors of another kind (" + std::to_string(added.length()) +
                         " numbers) than those before it (" + std::to_string(known.length()) +
                         "): describe all objects by one method",
                     index);
}

/// What an object looks like: the direction of a descriptor, one byte a number. A colour histogram,
/// a re-identification network's vector, an embedding of an image or of words.
class Appearance {
 public:
  using Bytes = std::array<std::int8_t, AppearanceKind::max_length>;

  /// Unknown.
  constexpr Appearance() = default;

  /// @param vector  of the kind's length, of any norm; each number is off by at most 1/254 of the
  ///                greatest
  /// Throws InvalidValue for another length, a number that is not finite, or all zeros.
  template <typename Derived>
  Appearance(AppearanceKind kind, const Eigen::MatrixBase<Derived>& vector) : kind_(kind) {
    detail::quantize(vector, kind.length(), bytes_.data());
    require_direction();
  }

  /// Of the bytes of one, of which those beyond the kind's length are passed over. Throws
  /// InvalidValue when they are all zeros.
  Appearance(AppearanceKind kind, const Bytes& bytes) : kind_(kind) {
    std::copy_n(bytes.begin(), kind.length(), bytes_.begin());
    if (kind.length() > 0) require_direction();
  }

  /// Whether there is a descriptor.
  bool known() const noexcept { return kind_.length() > 0; }
  /// Of the descriptor; its length is 0 where that is unknown.
  AppearanceKind kind() const noexcept { return kind_; }
  /// The descriptor's numbers, and zeros up to the greatest length.
  const Bytes& bytes() const noexcept { return bytes_; }

  friend bool operator==(const Appearance& a, const Appearance& b) noexcept {
    return a.kind_ == b.kind_ && a.bytes_ == b.bytes_;
  }
  friend bool operator!=(const Appearance& a, const Appearance& b) noexcept { return !(a == b); }

 private:
  void require_direction() const {
    if (bytes_ == Bytes{}) throw InvalidValue("a descriptor of zeros has no direction");
  }

  AppearanceKind kind_;
  Bytes bytes_{};
};

/// The cosine of the angle between two descriptors, in [-1, 1]. Precondition: both are known, and
/// of one kind. O(1).
inline double cosine_similarity(const Appearance& a, const Appearance& b) noexcept {
  std::int32_t product = 0, square_a = 0, square_b = 0;
  // Over all the bytes: their count is known to the compiler, and zeros add nothing.
  for (std::size_t i = 0; i < AppearanceKind::max_length; ++i) {
    const std::int32_t x = a.bytes()[i], y = b.bytes()[i];
    product += x * y;
    square_a += x * x;
    square_b += y * y;
  }
  return product / std::sqrt(static_cast<double>(square_a) * static_cast<double>(square_b));
}

}  // namespace v0
}  // namespace topobag
