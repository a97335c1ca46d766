# SPDX-License-Identifier: MIT
"""Writes the headers' own comments as a table for the bindings: docstrings.py FOLDER OUT.

A key is a name as C++ has it without namespaces, `LiftOptions.min_depth` or `match_graphs`.
"""

import pathlib
import re
import sys

SCOPE = re.compile(r"^( *)(?:struct|class|enum class) (?:\[\[\w+\]\] )?(\w+)[^;]*$")
ENUMERATOR = re.compile(r"^ *(\w+)(?: = \w+)?,? *(?:///|$)")


def name_of(statement):
    """The name that a declaration introduces, or nothing."""
    code = re.sub(r"<[^<>]*>", "", re.sub(r"<[^<>]*>", "", statement))
    called = re.match(r"[^={]*?(\w+)\(", code)
    if called:
        return called.group(1)
    if code.count("{") > code.count("}"):  # an initialiser that goes on
        return None
    found = re.search(r"(\w+) *(?:=[^=].*|\{.*)?[;{]", code)
    return found.group(1) if found else None


def comments_of(text):
    """Yields (name, comment, whether it goes on with the one before) of what a header documents."""
    scopes, pending, statement, last = [], [], "", None
    for line in text.splitlines():
        code, _, comment = line.partition("///")
        indent = len(line) - len(line.lstrip())
        while scopes and line.strip() and indent <= scopes[-1][0] and line.lstrip()[0] == "}":
            scopes.pop()
        if line.lstrip().startswith("///") and not comment.startswith("<"):
            pending.append(comment[1:])
            continue
        if comment.startswith("<") and not code.strip():  # goes on with the line before
            if last:
                yield last, comment[1:].strip(), True
            continue
        path = ".".join(scope for _, scope in scopes)
        opened = SCOPE.match(code.rstrip()) if not statement.strip() else None
        if opened:
            last = f"{path}.{opened.group(2)}" if path else opened.group(2)
            if "{" in code:
                scopes.append((indent, opened.group(2)))
            if pending:
                yield last, "\n".join(pending), False
            pending = []
            continue
        statement += " " + code.strip() if code.strip() else ""
        if statement.lstrip().startswith("template"):
            statement = "" if statement.count("<") == statement.count(">") else statement
            continue
        if not code.strip():
            pending = [] if not comment else pending
            statement = ""
            continue
        enumerator = ENUMERATOR.match(line) if scopes and comment.startswith("<") else None
        name = enumerator.group(1) if enumerator and "," in code else name_of(statement)
        if not name:
            continue
        last = f"{path}.{name}" if path else name
        if pending:
            yield last, "\n".join(pending), False
        if comment.startswith("<"):
            yield last, comment[1:].strip(), False
        pending, statement = [], ""


def table_of(folder):
    """All comments below a folder by name; of overloads the first one's."""
    table = {}
    for header in sorted(pathlib.Path(folder).rglob("*.hpp")):
        for name, comment, goes_on in comments_of(header.read_text(encoding="utf-8")):
            if name not in table:
                table[name] = comment
            elif goes_on:
                table[name] += " " + comment
    return table


def main(folder, out):
    rows = [f'{{"{name}", R"doc({text})doc"}},\n' for name, text in sorted(table_of(folder).items())]
    pathlib.Path(out).write_text("".join(rows), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
