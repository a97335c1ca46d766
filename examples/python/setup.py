# SPDX-License-Identifier: MIT
"""Builds the compiled part with CMake, whose further arguments the variable CMAKE_ARGS may hold."""

import os
import pathlib
import re
import shlex
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = pathlib.Path(__file__).resolve().parent
(HERE / "../../build").resolve().mkdir(exist_ok=True)  # where setup.cfg puts what is made


def version():
    """Of the library, as its header states it."""
    text = (HERE / "../../include/topobag/version.hpp").read_text(encoding="utf-8")
    return ".".join(re.findall(r"define TOPOBAG_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", text))


class CMakeBuild(build_ext):
    """Puts what CMake makes where setuptools looks for it."""

    def build_extension(self, ext):
        folder = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve().parent
        build = pathlib.Path(self.build_temp).resolve()
        cmake = [
            "cmake", "-S", str(HERE), "-B", str(build), "-DCMAKE_BUILD_TYPE=Release",
            f"-DPython_EXECUTABLE={sys.executable}", f"-DCMAKE_LIBRARY_OUTPUT_DIRECTORY={folder}",
            *shlex.split(os.environ.get("CMAKE_ARGS", "")),
        ]  # fmt: skip
        subprocess.run(cmake, check=True)
        jobs = str(os.cpu_count() or 1)
        subprocess.run(["cmake", "--build", str(build), "--parallel", jobs], check=True)


setup(
    version=version(),
    ext_modules=[Extension("topobag._topobag", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)
