# SPDX-License-Identifier: MIT
"""What is given to the program that puts hooks in and cannot be meant is told in one sentence."""
import contextlib
import io
import json
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples", "orb_slam"))
import add_hooks  # noqa: E402


class AddHooksInputs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def said(self, *arguments):
        out = io.StringIO()
        with contextlib.redirect_stderr(out):
            self.assertEqual(add_hooks.main(list(arguments)), 1)
        return out.getvalue()

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def test_a_list_that_is_not_there(self):
        path = os.path.join(self.folder, "hooks.json")
        self.assertEqual(
            self.said(path, self.folder), f"Nothing was changed:\n{path} cannot be read: No such file or directory\n"
        )

    def test_a_list_that_is_none(self):
        path = self.write("README.md", "# hooks\n")
        self.assertIn(f"{path} is no list of hooks, which is JSON: ", self.said(path, self.folder))

    def test_a_root_that_is_no_folder(self):
        hooks = self.write("hooks.json", json.dumps({"copies": [], "hooks": [{"file": "a.cc", "include": "b.h"}]}))
        for root in (os.path.join(self.folder, "absent"), hooks):
            self.assertEqual(
                self.said(hooks, root),
                f"Nothing was changed:\n{root} is not there, or no folder; name the host's source folder\n",
            )

    def test_a_file_that_several_hooks_lack_is_named_once(self):
        lines = [{"file": "a.cc", "function": "f", "at": "start", "line": f"g({i});"} for i in range(3)]
        hooks = self.write("hooks.json", json.dumps({"copies": [], "hooks": lines}))
        self.assertEqual(
            self.said(hooks, self.folder),
            "Nothing was changed:\na.cc: the file cannot be read: No such file or directory\n",
        )


if __name__ == "__main__":
    unittest.main()
