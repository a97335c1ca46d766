// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// A semantic class: the label number of a `ClassCatalog`.
enum class ClassId : std::int32_t {};

/// A key frame, numbered by the front end. Ids carry no time: any 64-bit number will do.
enum class KeyframeId : std::uint64_t {};

/// A node's position in its graph's node list.
enum class NodeIndex : std::uint32_t {};

/// The label number behind a class id (the paper's c in eq. 1).
constexpr std::int32_t value(ClassId id) noexcept { return static_cast<std::int32_t>(id); }
/// The front end's number.
constexpr std::uint64_t value(KeyframeId id) noexcept { return static_cast<std::uint64_t>(id); }

/// A node index as a subscript.
constexpr std::size_t value(NodeIndex index) noexcept { return static_cast<std::size_t>(index); }

/// A subscript as a node index. Precondition: i < 2³².
constexpr NodeIndex node_index(std::size_t i) noexcept { return static_cast<NodeIndex>(i); }

}  // namespace v0
}  // namespace topobag
