// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// What the numbers of a descriptor mean: which method gave them, and how many there are. Those of
/// different kinds never mix.
class AppearanceKind {
 public:
  static constexpr std::size_t max_length = 64;  ///< of a descriptor

  /// Of no descriptor.
  constexpr AppearanceKind() = default;

  /// @param name    of the method and its settings; another one is another kind
  /// @param length  numbers in a descriptor
  /// Throws InvalidValue for a length that is not 1 to 64.
  constexpr AppearanceKind(std::string_view name, std::size_t length)
      : AppearanceKind(number_of(name), length) {}

  /// With the number of a kind, as a file holds it. Throws as above.
  constexpr AppearanceKind(std::uint32_t number, std::size_t length)
      : number_(number), length_(static_cast<std::uint8_t>(length)) {
    if (length < 1 || length > max_length) {
      throw InvalidValue("a descriptor of " + std::to_string(length) +
                         " numbers; an appearance holds 1 to " + std::to_string(max_length));
    }
  }

  /// Which the name stands for: two names share it by one chance in 2^32. The same on every
  /// machine.
  constexpr std::uint32_t number() const noexcept { return number_; }
  /// Numbers in a descriptor; 0 = no descriptor.
  constexpr std::size_t length() const noexcept { return length_; }

  /// Whether descriptors of both may be compared.
  friend constexpr bool operator==(AppearanceKind a, AppearanceKind b) noexcept {
    return a.number_ == b.number_ && a.length_ == b.length_;
  }
  /// Whether they may not.
  friend constexpr bool operator!=(AppearanceKind a, AppearanceKind b) noexcept {
    return !(a == b);
  }

 private:
  /// FNV-1a.
  static constexpr std::uint32_t number_of(std::string_view name) noexcept {
    std::uint32_t hash = 0x811c9dc5;
    for (const char letter : name) {
      hash = (hash ^ static_cast<std::uint8_t>(letter)) * 0x01000193U;
    }
    return hash;
  }

  std::uint32_t number_ = 0;
  std::uint8_t length_ = 0;
};

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
    if (static_cast<std::size_t>(vector.size()) != kind.length()) {
      throw InvalidValue("a descriptor of " + std::to_string(vector.size()) +
                         " numbers; its kind has " + std::to_string(kind.length()));
    }
    double greatest = 0.0;
    for (Eigen::Index i = 0; i < vector.size(); ++i) {
      const double magnitude = std::abs(static_cast<double>(vector(i)));
      if (!std::isfinite(magnitude)) {
        throw InvalidValue("a descriptor holds a number that is not finite");
      }
      greatest = std::max(greatest, magnitude);
    }
    if (!(greatest > 0.0)) throw InvalidValue("a descriptor of zeros has no direction");
    for (Eigen::Index i = 0; i < vector.size(); ++i) {
      bytes_[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(
          std::lround(static_cast<double>(vector(i)) / greatest * max_byte));
    }
  }

  /// Of the bytes of one, of which those beyond the kind's length are passed over. Throws
  /// InvalidValue when they are all zeros.
  Appearance(AppearanceKind kind, const Bytes& bytes) : kind_(kind) {
    std::copy_n(bytes.begin(), kind.length(), bytes_.begin());
    if (kind.length() > 0 && bytes_ == Bytes{}) {
      throw InvalidValue("a descriptor of zeros has no direction");
    }
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
  static constexpr double max_byte = 127.0;

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
