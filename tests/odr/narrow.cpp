// SPDX-License-Identifier: MIT
#include <topobag/bag/entry_info.hpp>

std::size_t wide_size();

int main() { return sizeof(topobag::EntryInfo) == wide_size() ? 0 : 1; }
