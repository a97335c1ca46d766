// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <topobag/error.hpp>
#include <topobag/types/descriptor_kind.hpp>

namespace topobag {
inline namespace v0 {

/// What the numbers of an image's descriptor mean; see `DescriptorKind`.
using ImageKind = DescriptorKind<65535>;

/// The kind of images' descriptors that stand together: the one `known` of those before, or else
/// the `added` one's; either may be of no descriptor. Throws InvalidValue when they differ.
/// @param whose  the descriptor that is added
inline ImageKind common_kind(ImageKind known, ImageKind added, const char* whose) {
  if (added.length() == 0 || added == known) return known;
  if (known.length() == 0) return added;
  throw InvalidValue(std::string(whose) + " has an image's descriptor of another kind (" +
                     std::to_string(added.length()) + " numbers) than those in the bag (" +
                     std::to_string(known.length()) + "): describe all images by one method");
}

/// What an image as a whole looks like: the direction of a descriptor of yours, one byte a number.
/// A place recognition network's vector, a thumbnail's colours. Copies share the numbers.
class ImageDescriptor {
 public:
  using Bytes = std::vector<std::int8_t>;

  /// Unknown.
  ImageDescriptor() = default;

  /// @param vector  of the kind's length, of any norm; each number is off by at most 1/254 of the
  ///                greatest
  /// Throws InvalidValue for another length, a number that is not finite, or all zeros.
  template <typename Derived>
  ImageDescriptor(ImageKind kind, const Eigen::MatrixBase<Derived>& vector)
      : ImageDescriptor(kind, quantized(vector, kind.length())) {}

  /// Of the bytes of one. Throws InvalidValue for another length than the kind's, or all zeros.
  ImageDescriptor(ImageKind kind, Bytes bytes) : kind_(kind) {
    if (bytes.size() != kind.length()) {
      throw InvalidValue("a descriptor of " + std::to_string(bytes.size()) +
                         " numbers; its kind has " + std::to_string(kind.length()));
    }
    for (const std::int32_t x : bytes) square_ += x * x;
    if (square_ == 0 && kind.length() > 0) {
      throw InvalidValue("a descriptor of zeros has no direction");
    }
    bytes_ = std::make_shared<const Bytes>(std::move(bytes));
  }

  /// Whether there is a descriptor.
  bool known() const noexcept { return kind_.length() > 0; }
  /// Of the descriptor; its length is 0 where that is unknown.
  ImageKind kind() const noexcept { return kind_; }
  /// The descriptor's numbers. Precondition: it is known.
  const Bytes& bytes() const noexcept { return *bytes_; }
  /// The sum of their squares.
  std::int32_t squared_norm() const noexcept { return square_; }

  friend bool operator==(const ImageDescriptor& a, const ImageDescriptor& b) noexcept {
    return a.kind_ == b.kind_ && (!a.known() || *a.bytes_ == *b.bytes_);
  }
  friend bool operator!=(const ImageDescriptor& a, const ImageDescriptor& b) noexcept {
    return !(a == b);
  }

 private:
  template <typename Derived>
  static Bytes quantized(const Eigen::MatrixBase<Derived>& vector, std::size_t length) {
    Bytes bytes(length, 0);
    detail::quantize(vector, length, bytes.data());
    return bytes;
  }

  ImageKind kind_;
  std::int32_t square_ = 0;  // at most 65535 · 128²
  std::shared_ptr<const Bytes> bytes_;
};

/// The cosine of the angle between two descriptors, in [-1, 1]. Precondition: both are known, and
/// of one kind. O(length).
inline double cosine_similarity(const ImageDescriptor& a, const ImageDescriptor& b) noexcept {
  const std::int8_t* const x = a.bytes().data();
  const std::int8_t* const y = b.bytes().data();
  std::int32_t product = 0;
  for (std::size_t i = 0, n = a.bytes().size(); i < n; ++i) {
    product += std::int32_t{x[i]} * std::int32_t{y[i]};
  }
  return product /
         std::sqrt(static_cast<double>(a.squared_norm()) * static_cast<double>(b.squared_norm()));
}

}  // namespace v0
}  // namespace topobag
