// SPDX-License-Identifier: MIT
#pragma once

namespace python {

/// What the header says of a name such as `LiftOptions.min_depth`. Throws std::out_of_range, and so
/// makes the import fail, for a name that is not documented.
const char* doc(const char* name);

}  // namespace python
