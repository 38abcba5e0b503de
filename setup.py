"""Builds the compiled module of the Python package with CMake; the rest says pyproject.toml.

BOXBEAM_BUILD: a folder in which CMake has built it before, and goes on.
CMAKE_ARGS: more of what CMake is given, "-DCMAKE_CXX_COMPILER_LAUNCHER=ccache".
"""
import os
import pathlib
import re
import shlex
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
VERSION = re.search(r"project\(boxbeam VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


def pybind11_folder():
    """That of PyPI where it is there: arrays of numpy 2 want 2.12, which Debian 12 has not."""
    try:
        import pybind11
    except ImportError:
        return []
    return ["-Dpybind11_DIR=" + pybind11.get_cmake_dir()]


class CMakeBuild(build_ext):
    """One extension, built by the project's own CMake lists."""

    def build_extension(self, ext):
        build = pathlib.Path(os.environ.get("BOXBEAM_BUILD") or self.build_temp).resolve()
        target = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve()
        build.mkdir(parents=True, exist_ok=True)
        subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        f"-DPython3_EXECUTABLE={sys.executable}", "-DBOXBEAM_PYTHON=ON", "-DBOXBEAM_TESTS=OFF",
                        "-DBOXBEAM_BENCH=OFF", "-DBOXBEAM_CHARTS=OFF", "-DBOXBEAM_PRECOMPILE=ON", "-DBOXBEAM_BATCHES=ON",
                        *pybind11_folder(), *shlex.split(os.environ.get("CMAKE_ARGS", ""))],
                       check=True)
        subprocess.run(["cmake", "--build", build, "--target", "boxbeam_python"], check=True)
        target.parent.mkdir(parents=True, exist_ok=True)
        built = list((build / "python/boxbeam").glob("_core*.so"))
        if len(built) != 1:
            raise RuntimeError(f"{len(built)} modules were built in {build}")
        self.copy_file(built[0], target)


setup(version=VERSION, ext_modules=[Extension("boxbeam._core", [])], cmdclass={"build_ext": CMakeBuild})
