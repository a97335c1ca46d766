// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/evaluation/number_text.hpp>
#include <topobag/evaluation/place_protocol.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

/// The whole text as a number; throws InvalidValue naming the key.
template <typename Number>
Number number_of(std::string_view key, std::string_view text) {
  Number number{};
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (status != std::errc{} || end != text.data() + text.size()) {
    throw InvalidValue("protocol: '" + std::string(text) + "' is not a number for '" +
                       std::string(key) + "'");
  }
  return number;
}

/// The shortest text that reads back as the same number.
template <typename Number>
std::string text_of(Number number) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

/// `fx:fy:cx:cy:width:height:near:far`.
inline DepthFrustum frustum_of(std::string_view text) {
  std::array<std::string_view, 8> parts;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t colon = text.find(':');
    if ((colon == std::string_view::npos) != (i + 1 == parts.size())) {
      throw InvalidValue("protocol: a frustum is fx:fy:cx:cy:width:height:near:far");
    }
    parts[i] = text.substr(0, colon);
    if (colon != std::string_view::npos) text.remove_prefix(colon + 1);
  }
  const auto real = [&](std::size_t i) { return number_of<double>("frustum", parts[i]); };
  const auto whole = [&](std::size_t i) { return number_of<int>("frustum", parts[i]); };
  return {{real(0), real(1), real(2), real(3), whole(4), whole(5)}, real(6), real(7)};
}

inline std::string text_of(const DepthFrustum& frustum) {
  const PinholeCamera<double>& c = frustum.camera;
  return text_of(c.fx) + ':' + text_of(c.fy) + ':' + text_of(c.cx) + ':' + text_of(c.cy) + ':' +
         text_of(c.width) + ':' + text_of(c.height) + ':' + text_of(frustum.near_m) + ':' +
         text_of(frustum.far_m);
}

inline void set_protocol_key(PlaceProtocol& protocol, std::string_view key,
                             std::string_view value) {
  if (key == "distance") {
    protocol.distance_m = number_of<double>(key, value);
  } else if (key == "angle") {
    protocol.angle_deg = number_of<double>(key, value);
  } else if (key == "negative-distance") {
    protocol.negative_distance_m = number_of<double>(key, value);
  } else if (key == "negative-angle") {
    protocol.negative_angle_deg = number_of<double>(key, value);
  } else if (key == "covisibility") {
    protocol.covisibility = number_of<double>(key, value);
  } else if (key == "negative-covisibility") {
    protocol.negative_covisibility = number_of<double>(key, value);
  } else if (key == "frustum") {
    protocol.frustum = frustum_of(value);
  } else if (key == "exclude-seconds") {
    protocol.exclude_seconds = number_of<double>(key, value);
  } else if (key == "exclude-frames") {
    protocol.exclude_frames = number_of<std::size_t>(key, value);
  } else if (key == "past-only" && value.empty()) {
    protocol.past_only = true;
  } else {
    throw InvalidValue(
        "protocol: '" + std::string(key) +
        "' is not one of distance=, angle=, negative-distance=, negative-angle=, covisibility=, "
        "negative-covisibility=, frustum=, exclude-seconds=, exclude-frames=, past-only");
  }
}

}  // namespace detail

/// A protocol from its text, `distance=0.5,angle=30,negative-distance=1,exclude-seconds=5`: metres,
/// degrees and seconds, keys as the members of `PlaceProtocol`, the frustum as
/// `fx:fy:cx:cy:width:height:near:far`, each key once. Throws InvalidValue.
inline PlaceProtocol parse_protocol(std::string_view text) {
  PlaceProtocol protocol;
  std::vector<std::string_view> keys;
  for (bool more = true; more;) {
    const std::size_t comma = text.find(',');
    const std::string_view item = text.substr(0, comma);
    more = comma != std::string_view::npos;
    if (more) text.remove_prefix(comma + 1);
    const std::size_t equals = std::min(item.find('='), item.size());
    const std::string_view value = item.substr(std::min(equals + 1, item.size()));
    const std::string_view key = trimmed(item.substr(0, equals));
    detail::set_protocol_key(protocol, key, trimmed(value));
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) {
      throw InvalidValue("protocol: '" + std::string(key) + "' is there twice");
    }
    keys.push_back(key);
  }
  protocol.validate();
  return protocol;
}

/// The text of a protocol, which `parse_protocol` turns back into the same one: to be written
/// beside every number that depends on it.
inline std::string to_string(const PlaceProtocol& protocol) {
  std::string text;
  const auto add = [&](const char* key, const auto& value) {
    text += (text.empty() ? "" : ",") + std::string(key) + '=' + detail::text_of(value);
  };
  const auto add_if_given = [&](const char* key, const auto& value) {
    if (value) add(key, *value);
  };
  add_if_given("distance", protocol.distance_m);
  add_if_given("angle", protocol.angle_deg);
  add_if_given("negative-distance", protocol.negative_distance_m);
  add_if_given("negative-angle", protocol.negative_angle_deg);
  add_if_given("covisibility", protocol.covisibility);
  add_if_given("negative-covisibility", protocol.negative_covisibility);
  add_if_given("frustum", protocol.frustum);
  if (protocol.exclude_seconds > 0.0) add("exclude-seconds", protocol.exclude_seconds);
  if (protocol.exclude_frames > 0) add("exclude-frames", protocol.exclude_frames);
  if (protocol.past_only) text += ",past-only";
  return text;
}

}  // namespace v0
}  // namespace topobag
