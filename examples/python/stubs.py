# SPDX-License-Identifier: MIT
"""Writes the types of the compiled part, as the module itself tells them: stubs.py OUT."""

import inspect
import pathlib
import re
import sys

import topobag._topobag as module

HEAD = '''# SPDX-License-Identifier: MIT
# Written by stubs.py from the module itself.
import enum
from typing import Any, Callable, Iterator, Optional, Union, overload

import numpy
import numpy.typing

__version__: str
'''

TYPES = [
    (r"topobag\._topobag\.|_topobag\.", ""),
    (r"numpy\.ndarray\[numpy\.(\w+)(?:\[[^\]]*\])?(?:, flags[^\]]*)?\]", r"numpy.typing.NDArray[numpy.\1]"),
    (r"\bList\[", "list["), (r"\bDict\[", "dict["), (r"\bTuple\[", "tuple["), (r"\bSet\[", "set["),
    (r"Annotated\[list\[(\w+)\], FixedSize\(\d+\)\]", r"list[\1]"),
    (r"\b(list)\[(\w+)\[\d+\]\]", r"list[\2]"),
    (r"\bobject\b(?=[,)\]]| =|$)", "Any"),
    (r"\b(args|kwargs)(?=[,)])", r"\1"),
]  # fmt: skip


def typed(text):
    """A signature of pybind11 in Python's own words; a default is an ellipsis."""
    text = re.sub(r" = (?:\[\]|[^,()]*(?:\([^()]*\))?)(?=[,)])", " = ...", text)
    for pattern, replacement in TYPES:
        text = re.sub(pattern, replacement, text)
    return text.replace("std::monostate", "None").replace("(self: ", "(self: ")


def signatures(function):
    """Those of a function, from the first lines of what it says of itself."""
    lines = (function.__doc__ or "").splitlines()
    name = function.__name__
    overloads = [line.split(". ", 1)[1] for line in lines if re.match(rf"\d+\. {re.escape(name)}\(", line)]
    found = overloads or [line for line in lines[:1] if line.startswith(name + "(")]
    return [re.sub(r"\(self: [\w.]+", "(self", typed(line)) for line in found]


def write_function(out, function, indent, static=False):
    found = signatures(function)
    for signature in found:
        if len(found) > 1:
            out.append(f"{indent}@overload")
        if static:
            out.append(f"{indent}@staticmethod")
        out.append(f"{indent}def {signature}: ...")


def property_type(prop):
    line = (prop.fget.__doc__ or "").splitlines()[:1]
    told = re.search(r"-> (.*)$", typed(line[0])) if line else None
    return told.group(1) if told else "Any"


def write_class(out, name, cls):
    bases = [base.__name__ for base in cls.__bases__ if base.__module__ == cls.__module__]
    if hasattr(cls, "__members__"):
        out.append(f"\nclass {name}(enum.Enum):")
        out += [f"    {member} = {int(value)}" for member, value in cls.__members__.items()]
        return
    if issubclass(cls, Exception):
        python = [b.__name__ for b in cls.__bases__ if b.__module__ == "builtins"]
        ours = [b.__name__ for b in cls.__bases__ if b.__module__ == "topobag"]
        out.append(f"\nclass {name}({', '.join(ours + python)}):\n    index: Optional[int]")
        return
    out.append(f"\nclass {name}({', '.join(bases)}):" if bases else f"\nclass {name}:")
    start = len(out)
    fields = vars(cls).get("__fields__")
    if fields is not None:
        arguments = "".join(f", {field}: {property_type(getattr(cls, field))} = ..." for field in fields)
        out.append(f"    def __init__(self{arguments}) -> None: ...")
    for member, value in sorted(vars(cls).items()):
        if isinstance(value, property):
            if value.fset is None:
                out.append("    @property")
                out.append(f"    def {member}(self) -> {property_type(value)}: ...")
            else:
                out.append(f"    {member}: {property_type(value)}")
        elif isinstance(value, staticmethod):
            write_function(out, getattr(cls, member), "    ", static=True)
        elif callable(value) and member not in ("__getstate__", "__setstate__", "__repr__", "__str__", "__hash__"):
            if member != "__init__" or fields is None:
                write_function(out, value, "    ")
    if len(out) == start:
        out.append("    ...")


def stubs():
    """The text of the stubs."""
    out = [HEAD]
    classes = {n: v for n, v in vars(module).items() if inspect.isclass(v)}
    for name, cls in classes.items():
        write_class(out, name, cls)
    out.append("")
    for name, value in sorted(vars(module).items()):
        if not inspect.isclass(value) and callable(value):
            write_function(out, value, "")
    return "\n".join(out) + "\n"


if __name__ == "__main__":
    pathlib.Path(sys.argv[1]).write_text(stubs(), encoding="utf-8")
