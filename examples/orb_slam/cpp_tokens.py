# SPDX-License-Identifier: MIT
"""C++ source as tokens: as much of the language as it takes to find classes, functions and statements."""
import re
from collections import namedtuple

Token = namedtuple("Token", "text start end")

_SKIPPED = re.compile(r"//(?:\\\n|[^\n])*|/\*.*?\*/|\s+", re.S)
_DIRECTIVE = re.compile(r"#(?:\\\n|/\*.*?\*/|[^\n])*", re.S)
_RAW_STRING = re.compile(r'(?:u8|[uUL])?R"([^()\\\s]{0,16})\(.*?\)\1"', re.S)
_TOKEN = re.compile(
    r'(?:u8|[uUL])?"(?:\\.|[^"\\\n])*"'  # strings
    r"|(?:u8|[uUL])?'(?:\\.|[^'\\\n])+'"  # characters
    r"|[A-Za-z_]\w*|\.?\d(?:'?[\w.]|(?<=[eEpP])[+-])*"  # names, numbers
    r"|::|->|&&|\|\||[=!<>]=|\S",
    re.S,
)



def tokens_of(text):
    """The tokens of a source text; comments, blanks and directives are none. Also the directives."""
    found, directives, at = [], [], 0
    at_line_start = True
    while at < len(text):
        skipped = _SKIPPED.match(text, at)
        if skipped:
            at_line_start = at_line_start or "\n" in skipped.group()
            at = skipped.end()
            continue
        if text[at] == "#" and at_line_start:
            directive = _DIRECTIVE.match(text, at)
            directives.append(Token(directive.group(), at, directive.end()))
            at = directive.end()
            continue
        token = _RAW_STRING.match(text, at) or _TOKEN.match(text, at)
        found.append(Token(token.group(), at, token.end()))
        at = token.end()
        at_line_start = False
    return found, directives


def texts(source):
    """The tokens' texts alone."""
    return [token.text for token in tokens_of(source)[0]]


def closing(tokens, opening):
    """The index of the bracket that closes the one at `opening`; None = the file ends before."""
    pairs = {"(": ")", "{": "}", "[": "]"}
    stack = []
    for i in range(opening, len(tokens)):
        text = tokens[i].text
        if text in pairs:
            stack.append(pairs[text])
        elif text in pairs.values():
            if not stack or stack.pop() != text:
                return None
            if not stack:
                return i
    return None


def bodies_of_class(tokens, name):
    """(opening, closing) of the braces of every definition of the class."""
    found = []
    for i, token in enumerate(tokens):
        if token.text not in ("class", "struct") or i + 1 >= len(tokens):
            continue
        if tokens[i + 1].text != name or (i > 0 and tokens[i - 1].text in ("enum", "<", ",")):
            continue
        j = i + 2
        while j < len(tokens) and tokens[j].text not in ("{", ";", "(", ")", "="):
            j += 1
        if j < len(tokens) and tokens[j].text == "{":
            end = closing(tokens, j)
            if end is not None:
                found.append((j, end))
    return found


def bodies_of_function(tokens, qualified):
    """(opening, closing) of the braces of every definition of `Class::function`."""
    wanted = qualified.replace("::", " :: ").split()
    found = []
    for i in range(len(tokens) - len(wanted)):
        if [t.text for t in tokens[i : i + len(wanted)]] != wanted:
            continue
        j = i + len(wanted)
        if tokens[j].text != "(":
            continue
        end = closing(tokens, j)
        if end is None:
            continue
        j = end + 1
        while j < len(tokens) and tokens[j].text in ("const", "noexcept", "override", "final"):
            j += 1
        if j < len(tokens) and tokens[j].text == "{":
            end = closing(tokens, j)
            if end is not None:
                found.append((j, end))
    return found


def occurrences(tokens, sequence, begin, end):
    """Where in tokens[begin:end] the texts of `sequence` follow each other."""
    size = len(sequence)
    return [
        i
        for i in range(begin, end - size + 1)
        if all(tokens[i + k].text == sequence[k] for k in range(size))
    ]


def statement_start(tokens, at, begin):
    """The first token of the statement that holds token `at`, in a body whose brace is `begin`."""
    depth = 0
    for i in range(at - 1, begin, -1):
        text = tokens[i].text
        if text in (")", "]"):
            depth += 1
        elif text in ("(", "["):
            depth -= 1
        elif text in ("{", "}", ";") and depth <= 0:
            return i + 1
    return begin + 1


def statement_end(tokens, at, end):
    """The ';' that ends the plain statement which holds token `at`; None = there is none."""
    depth = 0
    for i in range(at, end):
        text = tokens[i].text
        if text in ("(", "[", "{"):
            depth += 1
        elif text in (")", "]", "}"):
            depth -= 1
        elif text == ";" and depth <= 0:
            return i
    return None


def depth_at(tokens, begin, at):
    """How many blocks of the body that opens at `begin` are open before token `at`."""
    depth = 0
    for token in tokens[begin + 1 : at]:
        depth += {"{": 1, "}": -1}.get(token.text, 0)
    return depth
