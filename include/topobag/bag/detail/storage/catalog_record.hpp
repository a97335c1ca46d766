// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <topobag/bag/described_catalog.hpp>
#include <topobag/bag/detail/codec/bit_reader.hpp>
#include <topobag/bag/detail/codec/bit_writer.hpp>
#include <topobag/bag/detail/storage/class_traits.hpp>
#include <topobag/bag/detail/storage/entry_record.hpp>
#include <topobag/error.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

inline constexpr unsigned says_lookalikes = 1, says_sizes = 2;

/// The catalog as bytes: which of look-alikes and sizes are said, and of each class id, name,
/// dynamics and these.
inline std::vector<std::uint8_t> to_bytes(const DescribedCatalog& classes) {
  BitWriter writer;
  writer.put((classes.lookalikes ? says_lookalikes : 0) | (classes.sizes ? says_sizes : 0), 8);
  writer.put(classes.catalog.size(), 32);
  for (const ClassId id : classes.catalog.ids()) {
    const std::string& name = classes.catalog.name(id);
    const ClassTraits traits = traits_of(classes, id);
    writer.put(static_cast<std::uint32_t>(value(id)), 32);
    writer.put(name.size(), 32);
    for (const char letter : name) writer.put(static_cast<std::uint8_t>(letter), 8);
    writer.put(static_cast<std::uint64_t>(traits.dynamics), 8);
    if (traits.lookalike) writer.put(static_cast<std::uint32_t>(value(*traits.lookalike)), 32);
    if (traits.size) {
      for (const double side : *traits.size) put_double(writer, side);
    }
  }
  return writer.take();
}

/// Throws FormatError.
inline DescribedCatalog catalog_of(const std::vector<std::uint8_t>& bytes) {
  BitReader reader(bytes.data(), bytes.size());
  const auto id_of = [&] {
    return ClassId{static_cast<std::int32_t>(static_cast<std::uint32_t>(reader.get(32)))};
  };
  const std::uint64_t said = reader.get(8), count = reader.get(32);
  if (said > (says_lookalikes | says_sizes)) throw FormatError("it says what no catalog does");
  DescribedCatalog classes;
  std::vector<ClassTraits> traits;
  std::vector<ClassId> ids;
  for (std::uint64_t i = 0; i < count; ++i) {
    ids.push_back(id_of());
    const std::uint64_t length = reader.get(32);
    if (length > reader.bits_left() / 8) throw FormatError("a class's name is cut off");
    std::string name;
    for (std::uint64_t k = 0; k < length; ++k) name += static_cast<char>(reader.get(8));
    try {
      classes.catalog.add(ids.back(), std::move(name), Dynamics::low);
    } catch (const Error& error) {
      throw FormatError(error.what());
    }
    traits.emplace_back();
    traits.back().dynamics = static_cast<std::int64_t>(reader.get(8));
    if ((said & says_lookalikes) != 0) traits.back().lookalike = id_of();
    if ((said & says_sizes) != 0) {
      const double width = get_double(reader), height = get_double(reader);
      traits.back().size = {width, height};
    }
  }
  if (reader.bits_left() != 0) throw FormatError("it goes on after its last class");
  for (std::size_t i = 0; i < ids.size(); ++i) describe_class(classes, ids[i], traits[i]);
  return classes;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
