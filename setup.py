"""Building wheels: the kernels' libraries are compiled into them where there is a C compiler.

Where there is none the wheel is a pure one, and numba compiles the kernels when they are first called.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from setuptools import setup
from setuptools.command.bdist_wheel import bdist_wheel
from setuptools.command.build_py import build_py

LIBRARIES = Path("osculant", "kernels", "libraries")


class BuildWithKernels(build_py):
    """Copies the package, and compiles its kernels into the copy."""

    def run(self) -> None:
        """Copy and compile; no library without a compiler."""
        super().run()
        if not self.editable_mode:
            folder = Path(self.build_lib).resolve() / LIBRARIES
            command = [sys.executable, "-m", "osculant.compiled.prebuilt", str(folder)]
            subprocess.run(command, cwd=Path(__file__).resolve().parent, check=True)


class WheelWithKernels(bdist_wheel):
    """A wheel of this machine's kind if there are libraries in it, for every Python 3."""

    def run(self) -> None:
        """Build first: only then is known what the wheel is."""
        self.run_command("build")
        built = Path(self.get_finalized_command("build").build_lib) / LIBRARIES
        if any(built.glob("*.so")):
            self.root_is_pure = False
            self.distribution.has_ext_modules = lambda: True
        super().run()

    def get_tag(self) -> tuple[str, str, str]:
        """Libraries are loaded by ctypes: they do not depend on the version of Python."""
        python, abi, platform = super().get_tag()
        return (python, abi, platform) if self.root_is_pure else ("py3", "none", platform)


setup(cmdclass={"build_py": BuildWithKernels, "bdist_wheel": WheelWithKernels})
