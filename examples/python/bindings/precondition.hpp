// SPDX-License-Identifier: MIT
#pragma once

// Included before everything else: what the library takes for granted of its caller, Python's
// callers are told by an exception.
#include <string>

#include <topobag/error.hpp>

namespace python {

[[noreturn]] inline void broken_precondition(const char* condition) {
  throw topobag::InvalidValue(
      std::string("a value is outside what is defined; this has to hold: ") + condition);
}

}  // namespace python

#define TOPOBAG_ASSERT(condition) \
  static_cast<void>((condition) || (python::broken_precondition(#condition), false))
