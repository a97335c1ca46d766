// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include <Eigen/Core>

#include <topobag/error.hpp>
#include <topobag/types/detail/one_alignment.hpp>

namespace topobag {
inline namespace v0 {

/// What the numbers of a descriptor mean: which method gave them, and how many there are. Those of
/// different kinds never mix.
template <std::size_t MaxLength>
class DescriptorKind {
 public:
  static constexpr std::size_t max_length = MaxLength;  ///< of a descriptor

  /// Of no descriptor.
  constexpr DescriptorKind() = default;

  /// @param name    of the method and its settings; another one is another kind
  /// @param length  numbers in a descriptor
  /// Throws InvalidValue for a length that is not 1 to `max_length`.
  constexpr DescriptorKind(std::string_view name, std::size_t length)
      : DescriptorKind(number_of(name), length) {}

  /// With the number of a kind, as a file holds it. Throws as above.
  constexpr DescriptorKind(std::uint32_t number, std::size_t length)
      : number_(number), length_(static_cast<Length>(length)) {
    if (length < 1 || length > max_length) {
      throw InvalidValue("a descriptor of " + std::to_string(length) + " numbers; it holds 1 to " +
                         std::to_string(max_length));
    }
  }

  /// Which the name stands for: two names share it by one chance in 2^32. The same on every
  /// machine.
  constexpr std::uint32_t number() const noexcept { return number_; }
  /// Numbers in a descriptor; 0 = no descriptor.
  constexpr std::size_t length() const noexcept { return length_; }

  /// Whether descriptors of both may be compared.
  friend constexpr bool operator==(DescriptorKind a, DescriptorKind b) noexcept {
    return a.number_ == b.number_ && a.length_ == b.length_;
  }
  /// Whether they may not.
  friend constexpr bool operator!=(DescriptorKind a, DescriptorKind b) noexcept {
    return !(a == b);
  }

 private:
  using Length = std::conditional_t<(MaxLength < 256), std::uint8_t, std::uint32_t>;

  /// FNV-1a.
  static constexpr std::uint32_t number_of(std::string_view name) noexcept {
    std::uint32_t hash = 0x811c9dc5;
    for (const char letter : name) {
      hash = (hash ^ static_cast<std::uint8_t>(letter)) * 0x01000193U;
    }
    return hash;
  }

  std::uint32_t number_ = 0;
  Length length_ = 0;
};

namespace detail {

/// The direction of a vector, a byte a number: the greatest becomes ±127. Zeros stay zeros.
/// Throws InvalidValue for another length than `length`, and a number that is not finite.
/// @param bytes  room for that many
template <typename Derived>
void quantize(const Eigen::MatrixBase<Derived>& vector, std::size_t length, std::int8_t* bytes) {
  if (static_cast<std::size_t>(vector.size()) != length) {
    throw InvalidValue("a descriptor of " + std::to_string(vector.size()) +
                       " numbers; its kind has " + std::to_string(length));
  }
  double greatest = 0.0;
  for (Eigen::Index i = 0; i < vector.size(); ++i) {
    const double magnitude = std::abs(static_cast<double>(vector(i)));
    if (!std::isfinite(magnitude)) {
      throw InvalidValue("a descriptor holds a number that is not finite");
    }
    greatest = std::max(greatest, magnitude);
  }
  for (Eigen::Index i = 0; i < vector.size() && greatest > 0.0; ++i) {
    bytes[i] =
        static_cast<std::int8_t>(std::lround(static_cast<double>(vector(i)) / greatest * 127.0));
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
