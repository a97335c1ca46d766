// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include <topobag/types/appearance.hpp>
#include <topobag/types/bounding_box.hpp>
#include <topobag/types/ids.hpp>
#include <topobag/types/label_weights.hpp>

namespace topobag {
inline namespace v0 {

/// One object that a detector saw in an image.
struct Detection {
  BoundingBox box;          ///< px
  ClassId label{};          ///< class, numbered as in the catalog in use
  double confidence = 1.0;  ///< detector's score in [0, 1]
};

/// Makes a detector's own struct usable as a detection, without a copy. Specialise it with
///
///     static BoundingBox box(const T&);
///     static ClassId label(const T&);
///     static double confidence(const T&);
///
/// and, where the front end knows the object's depth already (stereo, map points, a table),
///
///     static std::optional<double> depth(const T&);   // metres along the optical axis
///     static double depth_deviation(const T&);        // if told: its σ beside the sensor's noise, m
///
/// and, where it describes what the object looks like (a re-identification network, CLIP),
///
///     static Appearance appearance(const T&);         // unknown where it has none
///
/// and, where it says what else the object may be (the best five of its scores),
///
///     static LabelWeights label_weights(const T&);    // none where it is sure
template <typename T>
struct detection_traits {};

/// The library's own detection.
template <>
struct detection_traits<Detection> {
  static const BoundingBox& box(const Detection& d) { return d.box; }
  static ClassId label(const Detection& d) { return d.label; }
  static double confidence(const Detection& d) { return d.confidence; }
};

namespace detail {

/// Orders detections, most confident first. A score that is not finite comes last: NaN has no
/// order.
struct IsSurer {
  template <typename D>
  bool operator()(const D& a, const D& b) const {
    return rank(detection_traits<D>::confidence(a)) > rank(detection_traits<D>::confidence(b));
  }

 private:
  static double rank(double confidence) noexcept {
    return std::isfinite(confidence) ? confidence : std::numeric_limits<double>::lowest();
  }
};

template <typename T, typename = void>
struct is_detection : std::false_type {};

template <typename T>
struct is_detection<
    T, std::enable_if_t<
           std::is_convertible_v<decltype(detection_traits<T>::box(std::declval<const T&>())),
                                 BoundingBox> &&
           std::is_convertible_v<decltype(detection_traits<T>::label(std::declval<const T&>())),
                                 ClassId> &&
           std::is_convertible_v<
               decltype(detection_traits<T>::confidence(std::declval<const T&>())), double>>>
    : std::true_type {};

template <typename T, typename = void>
struct is_ranged_detection : std::false_type {};

template <typename T>
struct is_ranged_detection<
    T, std::enable_if_t<std::is_convertible_v<
           decltype(detection_traits<T>::depth(std::declval<const T&>())), std::optional<double>>>>
    : is_detection<T> {};

template <typename T, typename = void>
struct tells_depth_deviation : std::false_type {};

template <typename T>
struct tells_depth_deviation<
    T, std::enable_if_t<std::is_convertible_v<
           decltype(detection_traits<T>::depth_deviation(std::declval<const T&>())), double>>>
    : is_ranged_detection<T> {};

template <typename T, typename = void>
struct is_described_detection : std::false_type {};

template <typename T>
struct is_described_detection<
    T, std::enable_if_t<std::is_convertible_v<
           decltype(detection_traits<T>::appearance(std::declval<const T&>())), Appearance>>>
    : is_detection<T> {};

template <typename T, typename = void>
struct is_weighted_detection : std::false_type {};

template <typename T>
struct is_weighted_detection<
    T, std::enable_if_t<std::is_convertible_v<
           decltype(detection_traits<T>::label_weights(std::declval<const T&>())), LabelWeights>>>
    : is_detection<T> {};

}  // namespace detail

/// Whether `T` fits the detection concept (C++20: `concept DetectionType`).
template <typename T>
inline constexpr bool is_detection_v = detail::is_detection<T>::value;

/// Does not compile, and says what is missing, unless `T` fits the concept. Asked within a
/// `static_assert`, it speaks before anything that follows it.
template <typename T>
constexpr bool require_detection() {
  static_assert(is_detection_v<T>,
                "topobag: specialise topobag::detection_traits for your detection type: "
                "static box(const T&) -> BoundingBox, label(const T&) -> ClassId, "
                "confidence(const T&) -> double.");
  return is_detection_v<T>;
}

/// Whether `T` is a detection that knows its own depth.
template <typename T>
inline constexpr bool is_ranged_detection_v = detail::is_ranged_detection<T>::value;

/// Whether `T` is a detection that says what its object looks like.
template <typename T>
inline constexpr bool is_described_detection_v = detail::is_described_detection<T>::value;

/// What the detection says of its object's looks; unknown where `T` says nothing.
template <typename T>
Appearance appearance_of(const T& detection) {
  if constexpr (is_described_detection_v<T>) {
    return detection_traits<T>::appearance(detection);
  } else {
    return {};
  }
}

/// Whether `T` is a detection that says what else its object may be.
template <typename T>
inline constexpr bool is_weighted_detection_v = detail::is_weighted_detection<T>::value;

/// What the detection says that its object may be; nothing where `T` says none.
template <typename T>
LabelWeights label_weights_of(const T& detection) {
  if constexpr (is_weighted_detection_v<T>) {
    return detection_traits<T>::label_weights(detection);
  } else {
    return {};
  }
}

/// How far away the detection says that its object is, m; nothing where `T` does not know, and for
/// a number that is no depth: not above 0, not finite.
template <typename T>
std::optional<double> depth_of(const T& detection) {
  if constexpr (is_ranged_detection_v<T>) {
    const std::optional<double> z = detection_traits<T>::depth(detection);
    if (z && std::isfinite(*z) && *z > 0.0) return z;
  }
  return std::nullopt;
}

/// How far off that depth may be beside the sensor's noise, as one σ, m; 0 where `T` does not tell,
/// and for a number that is no deviation: not above 0, not finite.
template <typename T>
double depth_deviation_of(const T& detection) {
  if constexpr (detail::tells_depth_deviation<T>::value) {
    const double deviation = detection_traits<T>::depth_deviation(detection);
    if (std::isfinite(deviation) && deviation > 0.0) return deviation;
  }
  return 0.0;
}

}  // namespace v0
}  // namespace topobag
