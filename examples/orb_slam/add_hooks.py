#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Puts a semantic map's hooks into an ORB-SLAM's sources, where classes and functions say, not lines.

    add_hooks.py HOOKS.json ORB_SLAM            puts them in, and shows what it did
    add_hooks.py HOOKS.json ORB_SLAM --dry-run  shows what it would do
    add_hooks.py HOOKS.json ORB_SLAM --remove   takes them out again

Every anchor has to be there exactly once; else nothing is changed, and the reason is told. A hook that
is there already, at its anchor, stays. Ends with 0, or with 1 when it refused.
"""
import argparse
import json
import os
import sys

import cpp_tokens as cpp
from anchors import Refused, after_line, anchor_in_class, anchor_in_function, anchor_of_include

class Source:
    """A file of the host's, and the edits that it gets."""

    def __init__(self, root, name):
        self.name, self.path = name, os.path.join(root, name)
        try:
            with open(self.path, newline="", encoding="utf-8", errors="surrogateescape") as file:
                self.text = file.read()
        except OSError as error:
            raise Refused(f"the file cannot be read: {error.strerror}") from error
        self.newline = "\r\n" if "\r\n" in self.text else "\n"
        self.edits = []  # (begin, end, what stands there then)
        self.parse()

    def parse(self):
        self.tokens, self.directives = cpp.tokens_of(self.text)

    def standing(self, hook, begin, end):
        """Where the hook stands: (first position, behind the last), token index or None."""
        if "include" in hook:
            return [
                (d.start, d.end, None)
                for d in self.directives
                if "".join(d.text.split()) == f'#include"{hook["include"]}"'
            ]
        sequence = cpp.texts(hook["line"])
        return [
            (self.tokens[i].start, self.tokens[i + len(sequence) - 1].end, i)
            for i in cpp.occurrences(self.tokens, sequence, begin, end)
        ]

    def plan(self, hook, remove):
        """What is done about the hook: (what, line number, line)."""
        if "include" in hook:
            line, begin, end = f'#include "{hook["include"]}"', 0, len(self.tokens)
            anchor = anchor_of_include(self)
        else:
            line = hook["line"]
            find = anchor_in_class if "class" in hook else anchor_in_function
            begin, end, anchor = find(self, hook)
        there = self.standing(hook, begin, end)
        if len(there) > 1:
            raise Refused(f"'{line}' is there {len(there)} times already")
        if remove:
            return self.remove(there, line)
        if there:
            self.require_place(hook, there[0], begin, anchor, line)
            return "is there", self.line_number(there[0][0]), line
        self.edits.append((anchor.position, anchor.position, anchor.indent + line + self.newline))
        return "added", self.line_number(anchor.position), line

    def require_place(self, hook, there, begin, anchor, line):
        """Refuses a hook that was put somewhere else before."""
        if "include" in hook:
            return
        index = there[2]
        fits = index < anchor.token if hook.get("at", "").startswith("before") else index > anchor.token
        same_block = cpp.depth_at(self.tokens, begin, index) == cpp.depth_at(
            self.tokens, begin, anchor.token
        )
        if hook.get("at") == "start" or "class" in hook:
            same_block = cpp.depth_at(self.tokens, begin, index) == 0
        if not fits or not same_block:
            raise Refused(f"'{line}' is there already, but not where it belongs")

    def remove(self, there, line):
        if not there:
            return "is not there", 0, line
        start = self.text.rfind("\n", 0, there[0][0]) + 1
        end = after_line(self.text, there[0][1])
        if self.text[start:end].strip() != self.text[there[0][0] : there[0][1]].strip():
            raise Refused(f"'{line}' shares its line with something else")
        self.edits.append((start, end, ""))
        return "removed", self.line_number(start), line

    def line_number(self, position):
        return self.text.count("\n", 0, position) + 1

    def write(self):
        text = self.text
        # From the end, so that positions hold; of hooks at one place the first listed stands first.
        for _, (begin, end, new) in sorted(enumerate(self.edits), key=lambda e: (-e[1][0], -e[0])):
            text = text[:begin] + new + text[end:]
        with open(self.path, "w", newline="", encoding="utf-8", errors="surrogateescape") as file:
            file.write(text)


def plan_copy(folder, name, root, remove):
    """A header of ours that goes into the host's include folder."""
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        ours = file.read()
    target = os.path.join("include", os.path.basename(name))
    path = os.path.join(root, target)
    old = None
    if os.path.exists(path):
        with open(path, encoding="utf-8", errors="surrogateescape") as file:
            old = file.read()
        if "topobag_hooks" not in old:
            raise Refused(f"{target} is there, and is none of topobag's")
    if remove:
        return ("removed" if old is not None else "is not there"), target, path, None
    return ("is there" if old == ours else "added" if old is None else "renewed"), target, path, ours


def add_hooks(list_path, root, remove=False, dry_run=False, out=print):
    """Does it, or raises Refused and changes nothing."""
    try:
        with open(list_path, encoding="utf-8") as file:
            wanted = json.load(file)
    except OSError as error:
        raise Refused(f"{list_path} cannot be read: {error.strerror}") from error
    except ValueError as error:
        raise Refused(f"{list_path} is no list of hooks, which is JSON: {error}") from error
    if not os.path.isdir(root):
        raise Refused(f"{root} is not there, or no folder; name the host's source folder")
    folder = os.path.dirname(os.path.abspath(list_path))
    sources, report, refused = {}, [], []
    copies = []
    for name in wanted["copies"]:
        try:
            copies.append(plan_copy(folder, name, root, remove))
        except Refused as why:
            refused.append(str(why))
    for hook in wanted["hooks"]:
        name = hook["file"]
        try:
            source = sources.setdefault(name, None) or Source(root, name)
            sources[name] = source
            report.append((name, *source.plan(hook, remove)))
        except Refused as why:
            refused.append(f"{name}: {why}")
    if refused:
        raise Refused("\n".join(dict.fromkeys(refused)))  # each reason once
    for what, target, path, content in copies:
        out(f"{what:12} {target}")
        if dry_run or what in ("is there", "is not there"):
            continue
        if content is None:
            os.remove(path)
        else:
            with open(path, "w", encoding="utf-8") as file:
                file.write(content)
    for name, what, number, line in report:
        out(f"{what:12} {name}:{number}  {line}")
    if not dry_run:
        for source in sources.values():
            if source.edits:
                source.write()


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("hooks", help="the list of hooks, a JSON file")
    parser.add_argument("root", help="the host's source folder")
    parser.add_argument("--dry-run", action="store_true", help="show, change nothing")
    parser.add_argument("--remove", action="store_true", help="take the hooks out again")
    given = parser.parse_args(arguments)
    try:
        add_hooks(given.hooks, given.root, given.remove, given.dry_run)
    except Refused as why:
        print(f"Nothing was changed:\n{why}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
