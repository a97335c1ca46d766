// SPDX-License-Identifier: MIT
#include "report/html_text.hpp"

#include <cstdint>
#include <random>

#include "catch.hpp"

using program::base64;
using program::escaped;

namespace {

/// Base64 by the bit: every six bits a digit.
std::string plain_base64(const std::string& bytes) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bits;
  for (const char c : bytes) {
    for (int i = 7; i >= 0; --i) bits += (static_cast<unsigned char>(c) >> i & 1) != 0 ? '1' : '0';
  }
  while (bits.size() % 6 != 0) bits += '0';
  std::string text;
  for (std::size_t i = 0; i < bits.size(); i += 6) {
    text += digits[std::stoul(bits.substr(i, 6), nullptr, 2)];
  }
  while (text.size() % 4 != 0) text += '=';
  return text;
}

}  // namespace

TEST_CASE("escaped text has no character with a meaning in HTML", "[examples][report]") {
  CHECK(escaped("a < b & c > \"d\" 'e'") == "a &lt; b &amp; c &gt; &quot;d&quot; &#39;e&#39;");
  CHECK(escaped("") == "");
  CHECK(escaped("3 °") == "3 °");
}

TEST_CASE("base64 is that of the bits", "[examples][report]") {
  CHECK(base64("Man") == "TWFu");
  std::mt19937 random(7);
  for (std::size_t size = 0; size < 40; ++size) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(random() & 255U);
    CHECK(base64(bytes) == plain_base64(bytes));
  }
}

TEST_CASE("numbers for readers", "[examples][report]") {
  CHECK(program::fixed_text(1.0 / 3.0, 2) == "0.33");
  CHECK(program::short_text(0.5) == "0.5");
  CHECK(program::short_text(12.3456) == "12.35");
}
