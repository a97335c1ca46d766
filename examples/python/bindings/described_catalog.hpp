// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>

#include <topobag/bag/described_catalog.hpp>
#include <topobag/types/class_catalog.hpp>

#include "object_classes.hpp"

namespace python {

/// Classes as an argument: their catalog will do.
using ClassesArgument = std::variant<topobag::ClassCatalog, topobag::DescribedCatalog>;

/// As maps keep and check them.
topobag::DescribedCatalog described(const ClassesArgument& classes);
/// The same; nothing of nothing.
std::optional<topobag::DescribedCatalog> described(const std::optional<ClassesArgument>& classes);

/// As tables are read: what the classes leave unsaid is the program's default.
program::ObjectClasses object_classes(const ClassesArgument& classes);

}  // namespace python
