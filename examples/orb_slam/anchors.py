# SPDX-License-Identifier: MIT
"""Where a hook goes: beside an #include, in a class, or at a statement of a function, each there exactly once."""
import cpp_tokens as cpp

CONTROL = ("if", "else", "for", "while", "do", "switch", "case", "default")


class Refused(Exception):
    """Why nothing was changed."""


def one(found, what):
    if len(found) != 1:
        count = "not there" if not found else f"there {len(found)} times"
        raise Refused(f"{what} is {count}; it has to be there exactly once")
    return found[0]


def indent_at(text, at):
    line = text.rfind("\n", 0, at) + 1
    blanks = line
    while blanks < len(text) and text[blanks] in " \t":
        blanks += 1
    return text[line:blanks]


def after_line(text, at):
    """Behind the line that holds position `at`."""
    end = text.find("\n", at)
    return len(text) if end < 0 else end + 1


class Anchor:
    """A place in a source: where a line goes, between which tokens, in which indentation."""

    def __init__(self, position, token, indent, after_text=False):
        self.position, self.token, self.indent, self.after_text = position, token, indent, after_text


def anchor_of_include(source):
    nested, last = 0, None
    first_is_guard = True
    for directive in source.directives:
        word = directive.text[1:].split(None, 1)[0].split('"')[0].split("<")[0] if directive.text[1:].strip() else ""
        if word in ("if", "ifdef", "ifndef"):
            nested += 0 if first_is_guard and word == "ifndef" and last is None else 1
            first_is_guard = False
        elif word == "endif":
            nested -= 1
        elif word == "include" and nested <= 0:
            last = directive
    if last is None:
        raise Refused("there is no #include to stand beside")
    return Anchor(after_line(source.text, last.end), None, "")


def anchor_in_class(source, hook):
    begin, end = one(cpp.bodies_of_class(source.tokens, hook["class"]), f"class {hook['class']}")
    publics = [
        i
        for i in cpp.occurrences(source.tokens, ["public", ":"], begin, end)
        if cpp.depth_at(source.tokens, begin, i) == 0
    ]
    if not publics:
        raise Refused(f"class {hook['class']} has no public part")
    colon = publics[0] + 1
    return begin, end, Anchor(after_line(source.text, source.tokens[colon].end), colon, "    ")


def anchor_in_function(source, hook):
    name = hook["function"]
    begin, end = one(cpp.bodies_of_function(source.tokens, name), f"function {name}")
    if hook["at"] == "start":
        return begin, end, Anchor(after_line(source.text, source.tokens[begin].end), begin, "    ")
    side, _, wanted = hook["at"].partition(" ")
    last = wanted.startswith("last ")
    sequence = cpp.texts(wanted[5:] if last else wanted)
    what = f"'{' '.join(sequence)}' in {name}"
    found = cpp.occurrences(source.tokens, sequence, begin, end)
    if last:
        found = [i for i in found if cpp.depth_at(source.tokens, begin, i) == 0][-1:]
    at = one(found, what)
    start = cpp.statement_start(source.tokens, at, begin)
    if source.tokens[start].text in CONTROL and start != at:
        raise Refused(f"{what} is a part of '{source.tokens[start].text}', not a statement of its own")
    indent = indent_at(source.text, source.tokens[start].start)
    if side == "before":
        line = source.text.rfind("\n", 0, source.tokens[start].start) + 1
        if source.text[line : source.tokens[start].start].strip():
            raise Refused(f"{what} shares its line with another statement")
        return begin, end, Anchor(line, start, indent)
    stop = cpp.statement_end(source.tokens, at, end)
    if stop is None or source.tokens[start].text in CONTROL:
        raise Refused(f"{what} is no statement that ends in ';'")
    following = source.tokens[stop + 1]
    if "\n" not in source.text[source.tokens[stop].end : following.start]:
        raise Refused(f"{what} shares its line with another statement")
    return begin, end, Anchor(after_line(source.text, source.tokens[stop].end), stop, indent)
