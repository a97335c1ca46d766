// SPDX-License-Identifier: MIT
#include "node_array.hpp"

#include <algorithm>
#include <limits>

#include <topobag/error.hpp>

#include "casters.hpp"

namespace python {
namespace {

/// An array with a row for each node, of whose entries `entry(node, i)` gives the i-th.
template <typename Number, typename Entry>
py::array_t<Number> rows_of(const std::vector<Node>& nodes, std::vector<py::ssize_t> shape,
                            const Entry& entry) {
  shape.insert(shape.begin(), static_cast<py::ssize_t>(nodes.size()));
  py::array_t<Number> array(shape);
  Number* out = array.mutable_data();
  const auto width = nodes.empty() ? 0 : array.size() / static_cast<py::ssize_t>(nodes.size());
  for (const Node& node : nodes) {
    for (py::ssize_t i = 0; i < width; ++i) *out++ = static_cast<Number>(entry(node, i));
  }
  return array;
}

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

/// Throws InvalidValue for what is no class id, with the object's row.
topobag::ClassId class_of(std::int64_t number, py::ssize_t row) {
  if (number < std::numeric_limits<std::int32_t>::min() ||
      number > std::numeric_limits<std::int32_t>::max()) {
    throw topobag::InvalidValue("label " + std::to_string(row) + " is " + std::to_string(number) +
                                    ", which is no 32-bit number",
                                static_cast<std::size_t>(row));
  }
  return topobag::ClassId{static_cast<std::int32_t>(number)};
}

/// As many columns as the node of most classes has.
py::ssize_t most_labels(const std::vector<Node>& nodes) {
  std::size_t most = 0;
  for (const Node& node : nodes) most = std::max(most, node.label_weights.size());
  return static_cast<py::ssize_t>(most);
}

}  // namespace

py::array_t<std::int32_t> labels_of(const std::vector<Node>& nodes) {
  return rows_of<std::int32_t>(
      nodes, {}, [](const Node& node, py::ssize_t) { return topobag::value(node.label); });
}
py::array_t<double> positions_of(const std::vector<Node>& nodes) {
  return rows_of<double>(nodes, {3}, [](const Node& node, py::ssize_t i) {
    return node.position ? (*node.position)(i) : absent;
  });
}
py::array_t<double> pixels_of(const std::vector<Node>& nodes) {
  return rows_of<double>(nodes, {2}, [](const Node& node, py::ssize_t i) {
    return node.pixel ? (*node.pixel)(i) : absent;
  });
}
py::array_t<double> depths_of(const std::vector<Node>& nodes) {
  return rows_of<double>(nodes, {}, [](const Node& node, py::ssize_t) { return node.z; });
}
py::array_t<double> sizes_of(const std::vector<Node>& nodes) {
  return rows_of<double>(nodes, {2}, [](const Node& node, py::ssize_t i) { return node.size(i); });
}
py::array_t<double> covariances_of(const std::vector<Node>& nodes) {
  return rows_of<double>(
      nodes, {3, 3}, [](const Node& node, py::ssize_t i) { return node.covariance(i / 3, i % 3); });
}
py::array_t<double> confidences_of(const std::vector<Node>& nodes) {
  return rows_of<double>(nodes, {}, [](const Node& node, py::ssize_t) { return node.confidence; });
}
py::array_t<double> existences_of(const std::vector<Node>& nodes) {
  return rows_of<double>(nodes, {}, [](const Node& node, py::ssize_t) { return node.existence; });
}
py::array_t<std::int8_t> appearances_of(const std::vector<Node>& nodes) {
  std::size_t length = 0;
  for (const Node& node : nodes) length = std::max(length, node.appearance.kind().length());
  return rows_of<std::int8_t>(nodes, {static_cast<py::ssize_t>(length)},
                              [](const Node& node, py::ssize_t i) {
                                return node.appearance.bytes()[static_cast<std::size_t>(i)];
                              });
}

py::array_t<std::int32_t> weighted_labels_of(const std::vector<Node>& nodes) {
  return rows_of<std::int32_t>(nodes, {most_labels(nodes)}, [](const Node& node, py::ssize_t i) {
    const auto k = static_cast<std::size_t>(i);
    return k < node.label_weights.size() ? topobag::value(node.label_weights.label(k)) : -1;
  });
}
py::array_t<double> label_weights_of(const std::vector<Node>& nodes) {
  return rows_of<double>(nodes, {most_labels(nodes)}, [](const Node& node, py::ssize_t i) {
    const auto k = static_cast<std::size_t>(i);
    return k < node.label_weights.size() ? node.label_weights.byte(k) / 255.0 : 0.0;
  });
}

std::vector<topobag::Appearance> appearances_from(const ArrayLike& rows, const py::object& kind,
                                                  py::ssize_t count) {
  const py::array_t<double> given = numbers(rows, "appearances", {any, any});
  require_rows(given, "appearances", count, "labels");
  const auto length = static_cast<std::size_t>(given.shape(1));
  const auto of = py::isinstance<topobag::AppearanceKind>(kind)
                      ? kind.cast<topobag::AppearanceKind>()
                      : topobag::AppearanceKind(kind.cast<std::string>(), length);
  const auto entry = given.unchecked<2>();
  Eigen::VectorXd vector(given.shape(1));
  std::vector<topobag::Appearance> appearances(static_cast<std::size_t>(count));
  for (py::ssize_t i = 0; i < count; ++i) {
    for (py::ssize_t k = 0; k < vector.size(); ++k) vector(k) = entry(i, k);
    if (!vector.isZero(0.0)) {
      appearances[static_cast<std::size_t>(i)] = topobag::Appearance(of, vector);
    }
  }
  return appearances;
}

std::vector<topobag::LabelWeights> label_weights_from(const std::optional<ArrayLike>& labels,
                                                      const std::optional<ArrayLike>& weights,
                                                      py::ssize_t count) {
  std::vector<topobag::LabelWeights> all(static_cast<std::size_t>(count));
  if (!labels && !weights) return all;
  if (!labels || !weights) {
    throw topobag::InvalidValue("weighted_labels and label_weights go together: give both");
  }
  const auto given = whole_numbers(*labels, "weighted_labels", {any, any});
  const auto shares = numbers(*weights, "label_weights", {any, given.shape(1)});
  require_rows(given, "weighted_labels", count, "labels");
  require_rows(shares, "label_weights", count, "labels");
  const auto label = given.unchecked<2>();
  const auto weight = shares.unchecked<2>();
  for (py::ssize_t i = 0; i < count; ++i) {
    std::vector<topobag::WeightedLabel> row;
    for (py::ssize_t k = 0; k < given.shape(1); ++k) {
      row.push_back({class_of(label(i, k), i), weight(i, k)});
    }
    try {
      all[static_cast<std::size_t>(i)] = topobag::LabelWeights(row);
    } catch (const topobag::InvalidValue& error) {
      throw topobag::InvalidValue("object " + std::to_string(i) + ": " + error.what(),
                                  static_cast<std::size_t>(i));
    }
  }
  return all;
}

std::vector<topobag::ClassId> labels_from(const ArrayLike& labels) {
  const py::array_t<std::int64_t> given = whole_numbers(labels, "labels", {any});
  const auto entry = given.unchecked<1>();
  std::vector<topobag::ClassId> ids;
  ids.reserve(static_cast<std::size_t>(given.size()));
  for (py::ssize_t i = 0; i < given.size(); ++i) ids.push_back(class_of(entry(i), i));
  return ids;
}

}  // namespace python
