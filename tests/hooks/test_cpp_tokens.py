# SPDX-License-Identifier: MIT
"""C++ sources as tokens."""
import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples", "orb_slam"))
import cpp_tokens  # noqa: E402


class Tokens(unittest.TestCase):
    def test_comments_strings_and_directives_hide_what_is_in_them(self):
        source = '#define A ; \\\n  B\na = "x;\\"y"; // c;\n/* d; */ b = \';\'; e = R"z(f;)")z"; g = 1\'000.5e-3;'
        self.assertEqual(
            cpp_tokens.texts(source),
            ["a", "=", '"x;\\"y"', ";", "b", "=", "';'", ";", "e", "=", 'R"z(f;)")z"', ";", "g", "=", "1'000.5e-3", ";"],
        )

    def test_brackets_that_do_not_match_close_nothing(self):
        tokens, _ = cpp_tokens.tokens_of("{ ( } )")
        self.assertIsNone(cpp_tokens.closing(tokens, 0))


if __name__ == "__main__":
    unittest.main()
