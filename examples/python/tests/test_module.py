# SPDX-License-Identifier: MIT
"""What the module is made of: docstrings, types, plain structs that print, copy and pickle."""

import ast
import copy
import importlib.util
import inspect
import pathlib
import pickle
import re

import pytest
import topobag
import topobag._topobag as core
from conftest import ROOT

CLASSES = {name: value for name, value in vars(core).items() if inspect.isclass(value)}
PLAIN = {name: value for name, value in CLASSES.items() if hasattr(value, "__fields__")}
PACKAGE = pathlib.Path(topobag.__file__).parent


@pytest.mark.parametrize("name", sorted(vars(core)))
def test_everything_says_what_it_is(name):
    value = getattr(core, name)
    if name.startswith("_"):
        return
    assert value.__doc__ and len(value.__doc__) > 10
    if inspect.isclass(value):
        for member, inside in vars(value).items():
            if isinstance(inside, property) and not hasattr(value, "__members__"):
                assert inside.__doc__, f"{name}.{member}"


def test_what_the_headers_say_is_what_python_says():
    assert core.LiftOptions.max_image_share.__doc__.startswith("share of the image's area")
    assert "No three objects" not in core.Verdict.__doc__
    assert "Mirror images fall out in the rigid fit" in core.match_graphs.__doc__


#: Those that hold a catalog, groups or weights of classes, which do not pickle.
HOLD_CLASSES = {
    "AffinityCosine", "AlignOptions", "ChangeOptions", "ClassHistogram", "ClassPairDistanceHistogram", "ConsistencyOptions",
    "DescribedCatalog", "LabelWalks", "LoopOptions", "MatchOptions", "RecognitionOptions", "SurroundingLabels",
}  # fmt: skip


def text(value):
    """As it prints, but for where in memory a part is."""
    return re.sub(r" at 0x[0-9a-f]+", "", repr(value))


@pytest.mark.parametrize("name", PLAIN)
def test_plain_structs_print_copy_and_pickle(name):
    value = PLAIN[name]()
    assert repr(value).startswith(name + "(")
    assert text(copy.deepcopy(value)) == text(value)
    if name in HOLD_CLASSES:
        with pytest.raises(TypeError, match="cannot pickle 'topobag._topobag.Class"):
            pickle.dumps(value)
    else:
        assert text(pickle.loads(pickle.dumps(value))) == text(value)


def test_a_copy_is_a_value_of_its_own():
    options = topobag.MatchOptions()
    other = copy.deepcopy(options)
    other.chance.fill = 9.0
    assert options.chance.fill == 1.5


def test_the_stubs_are_the_module_s():
    spec = importlib.util.spec_from_file_location("stubs", ROOT / "examples" / "python" / "stubs.py")
    stubs = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(stubs)
    text = (PACKAGE / "_topobag.pyi").read_text(encoding="utf-8")
    assert text == stubs.stubs(), "run examples/python/stubs.py examples/python/src/topobag/_topobag.pyi"
    known = {node.name for node in ast.parse(text).body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    assert known == {name for name in vars(core) if not name.startswith("_")}
    assert (PACKAGE / "py.typed").exists()


def test_the_version_is_the_library_s():
    header = (ROOT / "include" / "topobag" / "version.hpp").read_text(encoding="utf-8")
    for number, name in zip(topobag.__version__.split("."), ("MAJOR", "MINOR", "PATCH")):
        assert f"define TOPOBAG_VERSION_{name} {number}" in header
