# SPDX-License-Identifier: MIT
"""The program that puts hooks into a host's sources, on small sources made up for it."""
import contextlib
import io
import json
import os
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "examples", "orb_slam"))
import add_hooks  # noqa: E402

HEADER = """\
#ifndef SHELF_H
#define SHELF_H
#include <vector>
#include "Book.h"

class Book;
enum class Shelf_kind { open };

/* class Shelf { public: int wrong; }; */
class Shelf : public Furniture {
  struct Inner {
   public:
    int x;
  };

 public:
  void put(Book* book);  // class Shelf {
 private:
  const char* text = "class Shelf { public: ";
};
#endif
"""

SOURCE = """\
#include "Shelf.h"
#include <mutex>
#ifdef TIMES
#include <chrono>
#endif

void Shelf::put(Book* book) {
    std::unique_lock<std::mutex> lock(mutex_);
    for (int i = 0; i < 3; ++i) { use(i); }  // Shelf::put(book) {
    books = find(
        book, [&] { return 1; });
    const char* s = R"(Shelf::put() { ; })";
    if (lost) book = nullptr;
    Track();
    if (!done)
    {
        again();
        if (!done) { never(); }
    }

    if(! done)
        return;
}

void Shelf::other() { find(book); Track(); }
"""

HOOKS = [
    {"file": "Shelf.cc", "include": "Hooks.h"},
    {"file": "Shelf.h", "class": "Shelf", "line": "Hooks hooks;"},
    {"file": "Shelf.cc", "function": "Shelf::put", "at": "start", "line": "hooks.Put(book);"},
    {"file": "Shelf.cc", "function": "Shelf::put", "at": "after books = find(", "line": "hooks.Found(books);"},
    {"file": "Shelf.cc", "function": "Shelf::put", "at": "before Track()", "line": "hooks.Ready();"},
    {"file": "Shelf.cc", "function": "Shelf::put", "at": "before last if (!done", "line": "done = done || hooks.Done();"},
]


class AddHooks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = folder.name
        os.mkdir(self.path("include"))
        self.write("Shelf.h", HEADER)
        self.write("Shelf.cc", SOURCE)
        self.write("Hooks.h", "// topobag_hooks\n")
        self.hooks = HOOKS

    def path(self, name):
        return os.path.join(self.root, name)

    def write(self, name, text):
        with open(self.path(name), "w", newline="", encoding="utf-8") as file:
            file.write(text)

    def read(self, name):
        with open(self.path(name), newline="", encoding="utf-8") as file:
            return file.read()

    def run_it(self, *options):
        """(exit code, what was said)."""
        self.write("hooks.json", json.dumps({"copies": ["Hooks.h"], "hooks": self.hooks}))
        said = io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            code = add_hooks.main([self.path("hooks.json"), self.root, *options])
        return code, said.getvalue()

    def refused_for(self, reason):
        before = self.read("Shelf.h"), self.read("Shelf.cc")
        code, said = self.run_it()
        self.assertEqual(code, 1, said)
        self.assertIn("Nothing was changed", said)
        self.assertIn(reason, said)
        self.assertEqual((self.read("Shelf.h"), self.read("Shelf.cc")), before)
        self.assertFalse(os.path.exists(self.path("include/Hooks.h")))

    def test_each_line_stands_where_its_anchor_is(self):
        code, said = self.run_it()
        self.assertEqual(code, 0, said)
        lines = self.read("Shelf.cc").split("\n")
        self.assertEqual(lines[2], '#include "Hooks.h"')
        at = lines.index("    hooks.Put(book);")
        self.assertEqual(lines[at - 1], "void Shelf::put(Book* book) {")
        at = lines.index("    hooks.Found(books);")
        self.assertEqual(lines[at - 1], "        book, [&] { return 1; });")
        at = lines.index("    hooks.Ready();")
        self.assertEqual(lines[at + 1], "    Track();")
        at = lines.index("    done = done || hooks.Done();")
        self.assertEqual(lines[at + 1], "    if(! done)")
        header = self.read("Shelf.h").split("\n")
        at = header.index("    Hooks hooks;")
        self.assertEqual(header[at - 1], " public:")
        self.assertEqual(header[at + 1], "  void put(Book* book);  // class Shelf {")
        self.assertEqual(said.count("added"), 7)
        self.assertIn("Shelf.cc:14  hooks.Ready();", said)
        self.assertEqual(self.read("include/Hooks.h"), self.read("Hooks.h"))

    def test_nothing_but_whole_lines_is_added(self):
        for newline in ("\n", "\r\n"):
            source = SOURCE.replace("\n", newline)
            self.write("Shelf.cc", source)
            self.assertEqual(self.run_it()[0], 0)
            added = [hook.get("line", '#include "Hooks.h"') for hook in HOOKS if hook["file"] == "Shelf.cc"]
            kept = [l for l in self.read("Shelf.cc").split(newline) if l.strip() not in added]
            self.assertEqual(newline.join(kept), source)

    def test_lines_added_before_do_not_matter(self):
        self.write("Shelf.cc", "// a port\n#include <unistd.h>\n" * 7 + SOURCE.replace("    Track", "    a();\n    Track"))
        self.assertEqual(self.run_it()[0], 0)
        lines = self.read("Shelf.cc").split("\n")
        self.assertEqual(lines[lines.index("    hooks.Ready();") - 1], "    a();")
        self.assertEqual(lines[lines.index("    hooks.Ready();") + 1], "    Track();")

    def test_a_second_run_changes_nothing(self):
        self.run_it()
        before = self.read("Shelf.h"), self.read("Shelf.cc")
        code, said = self.run_it()
        self.assertEqual(code, 0, said)
        self.assertNotIn("added", said)
        self.assertEqual(said.count("is there"), 7)
        self.assertEqual((self.read("Shelf.h"), self.read("Shelf.cc")), before)

    def test_a_half_hooked_tree_gets_the_rest(self):
        whole = HOOKS
        self.hooks = whole[:3]
        self.run_it()
        self.hooks = whole
        code, said = self.run_it()
        self.assertEqual((code, said.count("added"), said.count("is there")), (0, 3, 4), said)
        at_once = self.read("Shelf.cc")
        self.write("Shelf.cc", SOURCE)
        self.run_it()
        self.assertEqual(self.read("Shelf.cc"), at_once)

    def test_removing_gives_the_file_back(self):
        self.run_it()
        code, said = self.run_it("--remove")
        self.assertEqual(code, 0, said)
        self.assertEqual((self.read("Shelf.h"), self.read("Shelf.cc")), (HEADER, SOURCE))
        self.assertFalse(os.path.exists(self.path("include/Hooks.h")))

    def test_a_dry_run_changes_nothing(self):
        code, said = self.run_it("--dry-run")
        self.assertEqual((code, said.count("added")), (0, 7))
        self.assertEqual((self.read("Shelf.h"), self.read("Shelf.cc")), (HEADER, SOURCE))

    def test_a_missing_anchor_is_refused(self):
        self.write("Shelf.cc", SOURCE.replace("    Track();\n    if", "    if"))
        self.refused_for("'Track ( )' in Shelf::put is not there; it has to be there exactly once")

    def test_an_anchor_that_is_there_twice_is_refused(self):
        self.write("Shelf.cc", SOURCE.replace("    Track();", "    Track();\n    Track();"))
        self.refused_for("'Track ( )' in Shelf::put is there 2 times")

    def test_a_function_that_is_missing_or_overloaded_is_refused(self):
        self.write("Shelf.cc", SOURCE.replace("Shelf::put(Book* book) {", "Shelf::place(Book* book) {"))
        self.refused_for("function Shelf::put is not there")
        self.write("Shelf.cc", SOURCE + "void Shelf::put(int) const {\n}\n")
        self.refused_for("function Shelf::put is there 2 times")

    def test_a_class_that_is_there_twice_is_refused(self):
        self.write("Shelf.h", HEADER + HEADER)
        self.refused_for("class Shelf is there 2 times")

    def test_the_only_statement_of_an_if_is_refused(self):
        self.write("Shelf.cc", SOURCE.replace("    Track();\n    if", "    if (x)\n        Track();\n    if"))
        self.refused_for("is a part of 'if', not a statement of its own")

    def test_a_statement_that_shares_its_line_is_refused(self):
        self.write("Shelf.cc", SOURCE.replace("    Track();\n    if", "    a(); Track();\n    if"))
        self.refused_for("shares its line with another statement")

    def test_a_hook_in_a_wrong_place_is_refused(self):
        # As a patch without context leaves it where a line was added before.
        self.write("Shelf.cc", SOURCE.replace("    Track();\n    if", "    Track();\n    hooks.Ready();\n    if"))
        self.refused_for("'hooks.Ready();' is there already, but not where it belongs")

    def test_a_hook_that_is_there_twice_is_refused(self):
        self.run_it()
        os.remove(self.path("include/Hooks.h"))
        self.write("Shelf.cc", self.read("Shelf.cc").replace("    hooks.Ready();", "    hooks.Ready();\n    hooks.Ready();"))
        self.refused_for("'hooks.Ready();' is there 2 times already")

    def test_a_missing_file_is_refused(self):
        self.hooks = HOOKS + [{"file": "None.cc", "include": "Hooks.h"}]
        self.refused_for("None.cc: the file cannot be read: ")

    def test_a_header_of_somebody_else_is_not_overwritten(self):
        self.write("include/Hooks.h", "int theirs;\n")
        self.assertEqual(self.run_it()[0], 1)
        self.assertEqual(self.read("include/Hooks.h"), "int theirs;\n")
        self.write("include/Hooks.h", "// topobag_hooks of before\n")
        code, said = self.run_it()
        self.assertEqual(code, 0, said)
        self.assertIn("renewed", said)

    def test_other_bytes_of_the_host_stay(self):
        with open(self.path("Shelf.cc"), "wb") as file:
            file.write(SOURCE.encode().replace(b"again", b"\xe9\xff"))
        self.assertEqual(self.run_it()[0], 0)
        with open(self.path("Shelf.cc"), "rb") as file:
            self.assertIn(b"\xe9\xff();", file.read())


if __name__ == "__main__":
    unittest.main()
