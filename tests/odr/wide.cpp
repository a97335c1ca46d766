// SPDX-License-Identifier: MIT
// Compiled for wider vector instructions than narrow.cpp, which makes Eigen align poses otherwise.
#include <topobag/bag/entry_info.hpp>

std::size_t wide_size() { return sizeof(topobag::EntryInfo); }
