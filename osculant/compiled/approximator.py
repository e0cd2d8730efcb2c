"""`compile_approximator`, `compile_evaluator`: a curve as a library of its own."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

from osculant.approximation.request import check_split
from osculant.cas.errors import DomainError, OsculantError
from osculant.compiled.building import build, compiler, flags_for
from osculant.compiled.evaluators import Evaluator
from osculant.compiled.examples import example
from osculant.compiled.header import approximating, explaining, header, wrapper
from osculant.compiled.library import Approximator, source
from osculant.compiled.modules import module
from osculant.compiled.numbers import Numbers, numbers
from osculant.compiled.subject import Subject, subject
from osculant.primitives.table import USUAL, choose, usual_first

#: what may stand beside a library: "c" is headers and an example, "python" a module besides
LANGUAGES = ("c", "python")
#: what `compile_evaluator` compiles
WHAT = ("invariants", "distance")


@dataclass(frozen=True)
class Compiled:
    """A library on disk.

    Attributes:
        name: that its functions begin with.
        library: its path.
        files: all files that were written, the library among them.
        splits: the special points at which a fixed curve is split, None if they are found at run time.
        undecided: those of them that were not decided.
    """

    name: str
    library: Path
    files: tuple[Path, ...]
    splits: tuple[float, ...] | None = None
    undecided: tuple[float, ...] = ()

    @property
    def folder(self) -> Path:
        """Where the files are."""
        return self.library.parent

    def load(self) -> ModuleType:
        """Import the Python module beside the library; raises OsculantError if there is none."""
        import importlib.util

        path = self.folder / f"{self.name}.py"
        spec = importlib.util.spec_from_file_location(self.name, path)
        if path not in self.files or spec is None or spec.loader is None:
            raise OsculantError(f"There is no module {path.name} beside the library: compile for python.")
        found = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(found)
        return found


def compile_approximator(
    formulas: Any,
    primitive: str | None = None,
    low: Any = None,
    high: Any = None,
    *,
    parameters: Any = (),
    folder: str | os.PathLike[str],
    name: str = "curve",
    metric: str = "hausdorff",
    rule: str | None = None,
    split: str = "theory",
    split_at: Sequence[Any] = (),
    language: str = "python",
    cpu: str | None = None,
    jet: int = 0,
) -> Compiled:
    """Write and compile a library that approximates a curve by itself: C that needs libm alone.

    Args:
        formulas: of two or three coordinates, as for `osculant.curve`; None with ``jet``.
        primitive: of the pieces, as for `osculant.approximate`; "conic" or, in space, "bihelix" if None.
        low: one end of the interval; None if the interval is an argument at run time.
        high: the other end.
        parameters: names of constants in the formulas that are arguments at run time, such as "a b".
        folder: where to write; it is made if only it is missing.
        name: of the library, ``libname.so``, and the beginning of its functions' names.
        metric: "hausdorff" or "area", as for `osculant.approximate`; a tolerance is one of the areas' sum.
        rule: how a piece is chosen, as there.
        split: "theory" or "never", as there.
        split_at: parameters that shall be knots of a fixed curve besides.
        language: "c": the library, its source, headers for C and C++17 and an example; "python" (the
            default): a module as well, for numpy and ctypes alone.
        cpu: the processor to compile for, as the compiler calls it; any of the machine's kind if None.
        jet: 2 or 3: there is no formula, but the caller's function ``jet(t, parameters, out)``, which writes
            the derivatives 0 … 2 (of three coordinates 0 … 3) of each coordinate.

    Returns where everything is.  The library's functions take the caller's array and allocate nothing, keep
    no state, and tell a status; `name.h` says how they are called.

    Of a curve with nothing free the special points are found now, and proved as `osculant.approximate` does;
    the greedy pieces are then those of osculant bit for bit, where libm is the same.  Else special points are
    given by the caller, or found at run time by changes of sign, which proves nothing; knots are those of
    osculant for the same constants all the same. Of a jet of the caller's only cusps are found, and what the
    curve does on less than a 64th of its interval may be missed.

    The ends of the interval are knots, also of closed curves; no small arc is passed over, curves that are
    arcs of such pieces themselves are treated as others, and one greedy piece fewer is never tried for.

    Raises FormulaError and DomainError for a curve or a choice that makes no sense, OsculantError where
    there is no compiler or the folder cannot be written to; then nothing is written.

    >>> import tempfile
    >>> folder = tempfile.TemporaryDirectory()
    >>> made = compile_approximator("a*cos(t), b*sin(t)", "biarc", 0, "pi/2", parameters="a b",
    ...                             folder=folder.name, name="quarter")
    >>> sorted(path.name for path in made.files)  # doctest: +NORMALIZE_WHITESPACE
    ['libquarter.so', 'quarter.c', 'quarter.h', 'quarter.hpp', 'quarter.py', 'quarter_example.c']
    >>> [len(made.load().approximate(a, 1.0, 1e-3)) for a in (1.5, 2.0, 4.0)]
    [3, 3, 4]
    """
    about = subject(formulas, low, high, parameters, name, jet)
    check_split(split)
    if primitive == "best":
        raise DomainError(
            "The best primitive is that for one tolerance, and a library is for all: choose one of "
            f"{', '.join(usual_first(about.dimension))}; `osculant.approximate` tells which for one."
        )
    fit = choose(
        primitive or USUAL[about.dimension], metric, rule, dimension=about.dimension, curve=about.text
    )
    if split_at and not about.fixed:
        raise _splits_at_run_time(about)
    command = _command(name, language, cpu)
    known = numbers(about.curve, fit, split, split_at) if about.fixed else None
    wanted = Approximator(about, fit, split, known)
    title = f"{fit.primitive.plural.capitalize()} for the curve {about.text}{_interval(about)}."
    functions = wanted.functions()
    texts = {
        f"{name}.c": source(wanted, command) + "\n" + explaining(name),
        f"{name}.h": header(about, title, functions, wanted.piece),
        f"{name}.hpp": wrapper(about, [approximating(about, *function) for function in functions]),
        f"{name}_example.c": example(about, functions[0][0], functions[0][2]),
        f"{name}.py": module(about, title, functions, wanted.fields),
    }
    return _built(folder, name, texts, language, cpu, known)


def compile_evaluator(
    formulas: Any,
    what: str,
    low: Any = None,
    high: Any = None,
    *,
    parameters: Any = (),
    folder: str | os.PathLike[str],
    name: str = "curve",
    language: str = "python",
    cpu: str | None = None,
    jet: int = 0,
) -> Compiled:
    """Write and compile a library that evaluates a curve at arrays: C that needs libm alone.

    Args:
        formulas: as for `compile_approximator`.
        what: "invariants": speed, curvature, torsion, …, and frames at many parameters; or "distance": the
            distances of many points from the curve, and the nearest points of it.
        low: one end of the interval, which distances take; None if it is an argument at run time.
        high: the other end.
        parameters: as for `compile_approximator`, like all that follow.
        folder: where to write.
        name: of the library.
        language: "c" or "python".
        cpu: the processor to compile for.
        jet: 2 or 3: the caller's function writes the derivatives 0 … 2 (of three coordinates 0 … 3) of each
            coordinate for distances, and 0 … 5 (0 … 3) for invariants.

    The distance is that of the nearest point found from samples of the curve: nothing proves that there is no
    nearer one between two of them.  Raises what `compile_approximator` does.

    >>> import tempfile
    >>> folder = tempfile.TemporaryDirectory()
    >>> circle = compile_evaluator("cos(t), sin(t)", "distance", 0, "pi", folder=folder.name).load()
    >>> circle.distance([[0.0, 3.0], [0.0, 0.5]])["distance"].tolist()
    [2.0, 0.5]
    """
    about = subject(formulas, low, high, parameters, name, jet)
    if what not in WHAT:
        raise DomainError(f"{what!r} is nothing to compile: choose {' or '.join(WHAT)}.")
    command = _command(name, language, cpu)
    if about.fixed:
        about.curve.check_finite()
    wanted = Evaluator(about, what)
    title = f"{what.capitalize()} of the curve {about.text}{_interval(about)}."
    texts = {
        f"{name}.c": wanted.source(command) + "\n" + explaining(name),
        f"{name}.h": header(about, title, wanted.functions(), wanted.row),
        f"{name}.hpp": wrapper(about, [wanted.wrapper()]),
        f"{name}_example.c": wanted.example(),
        f"{name}.py": wanted.module(title),
    }
    return _built(folder, name, texts, language, cpu, None)


def _splits_at_run_time(about: Subject) -> DomainError:
    """What to say of split points of a curve that is not known before run time."""
    if about.coordinates is None:
        why = "the curve is known at run time"
    elif about.parameters:
        why = f"the values of {' and '.join(about.parameters)} are known at run time"
    else:
        why = "the interval is known at run time, unless you give both ends"
    return DomainError(
        f"split_at is for a fixed curve, and here {why}, as split points are: leave it out.",
        argument="split_at",
    )


def _command(name: str, language: str, cpu: str | None) -> str:
    """The compiler's command; raises DomainError for an unknown language, OsculantError if there is none."""
    if language not in LANGUAGES:
        raise DomainError(f"The language {language!r} is unknown: choose {' or '.join(LANGUAGES)}.")
    return " ".join([*compiler(), *flags_for(cpu), f"-o lib{name}.so {name}.c -lm"])


def _built(
    folder: str | os.PathLike[str],
    name: str,
    texts: dict[str, str],
    language: str,
    cpu: str | None,
    known: Numbers | None,
) -> Compiled:
    if language == "c":
        del texts[f"{name}.py"]
    library = build(folder, name, texts, cpu)
    files = tuple(sorted(library.parent / file for file in (*texts, library.name)))
    if known is None:
        return Compiled(name, library, files)
    return Compiled(name, library, files, known.splits, known.undecided)


def _interval(about: Subject) -> str:
    from osculant.cas.formulas.expression import to_text

    return "" if about.ends is None else f", t from {to_text(about.ends[0])} to {to_text(about.ends[1])}"
