"""Libraries that evaluate a curve at arrays: its invariants and frames, or distances of points from it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from osculant.codegen.c.jets import jet_function
from osculant.codegen.c.program import Translation
from osculant.codegen.c.types import DOUBLE, JET, ROW, TABLE, Known
from osculant.compiled.interface import Argument, given, signature
from osculant.compiled.library import HEAD, array_of, end_of, title_of
from osculant.compiled.modules import asked, ctypes_of, head
from osculant.compiled.numbers import UNITS
from osculant.compiled.subject import Subject

#: a call of an evaluator in Python
_EVALUATE = '''

#: {told}
{dtype} = np.dtype([(field, "f8") for field in {fields}])

_{short} = _LIBRARY.{name}_{short}
_{short}.argtypes = {types}


def {short}({signature}):
    """{purpose}

{lines}
    Returns an array of `{dtype}`.  Raises Failure, and ValueError for arguments of the wrong size.
    """
{before}    wanted = _doubles({array}){shaped}
    found = np.empty(wanted.shape[0], dtype={dtype})
    status = _{short}({passed}_pointer(wanted), wanted.shape[0], _pointer(found))
    if status:
        raise Failure(status)
    return found
'''


@dataclass(frozen=True)
class Evaluator:
    """A library with one function over arrays.

    Attributes:
        subject: the curve.
        what: "invariants" or "distance".
    """

    subject: Subject
    what: str

    @property
    def row(self) -> Any:
        """The `NamedTuple` class of a result."""
        from osculant.kernels.standalone import distances, invariants

        plane = self.subject.dimension == 2
        if self.what == "invariants":
            return invariants.PlaneInvariants if plane else invariants.SpaceInvariants
        return distances.Foot if plane else distances.SpaceFoot

    @property
    def purpose(self) -> str:
        """What the function does."""
        if self.what == "invariants":
            return "The invariants and frames of the curve at many parameters."
        return "The distances of many points from the curve, and the nearest points of it that are found."

    @property
    def order(self) -> int:
        """Of the jet."""
        if self.what == "invariants":
            from osculant.kernels.standalone.invariants import PLANE_ORDER, SPACE_ORDER

            return PLANE_ORDER if self.subject.dimension == 2 else SPACE_ORDER
        return self.subject.dimension

    def functions(self) -> list[tuple[str, str, list[Argument]]]:
        """(name, purpose, arguments) of the function that is called."""
        name, dimension = self.subject.name, self.subject.dimension
        of_interval = self.what == "distance"
        which = [
            a for a in given(self.subject, False, self.order) if of_interval or a.name not in ("low", "high")
        ]
        if of_interval:
            array = Argument(
                "const double *points", f"{dimension} coordinates of each point, one after the other"
            )
        else:
            array = Argument("const double *times", "the parameters")
        rest = [Argument("size_t size", "how many"), Argument(f"{name}_piece *out", "as many results")]
        return [(f"{name}_{self.what}", self.purpose, [*which, array, *rest])]

    def source(self, command: str) -> str:
        """The C file."""
        from osculant.kernels import operations
        from osculant.kernels.polygons.records import Chord, SpaceChord
        from osculant.kernels.standalone import distances, invariants

        about = self.subject
        translation = Translation(operations.registered(), operations.operations())
        [(name, _, arguments)] = self.functions()
        columns, plane = len(self.row._fields), about.dimension == 2
        own = about.coordinates is None
        parameters = "parameters" if about.parameters or own else "NULL"
        if self.what == "invariants":
            entry = translation.function(
                invariants.in_the_plane if plane else invariants.in_space, [JET, ROW, TABLE]
            )
            call = (
                f"(row){{(double *)times, (int64_t)size}}, (table){{(double *)out, (int64_t)size, {columns}}}"
            )
        else:
            record = Known(Chord() if plane else SpaceChord())
            entry = translation.function(
                distances.distances, [record, JET, DOUBLE, DOUBLE, ROW, TABLE, TABLE]
            )
            call = (
                f"low, high, (row){{(double *)units, {len(UNITS)}}}, "
                f"(table){{(double *)points, (int64_t)size, {about.dimension}}}, "
                f"(table){{(double *)out, (int64_t)size, {columns}}}"
            )
        jet = [] if own else ["/* The curve and its derivatives. */"]
        if about.coordinates is not None:
            jet.append(jet_function("curve_jet", about.coordinates, self.order, about.parameters) + "\n")
        if self.what == "distance":
            jet.append(array_of("units", [UNITS], flat=True) + "\n")
        body = [
            f"double room[{entry.room}];",
            f"const jet at = {{{'evaluate' if own else 'curve_jet'}, {parameters}}};",
            *([f"const double low = {end_of(about, 0)}, high = {end_of(about, 1)};"]
              if self.what == "distance" and about.ends is not None else []),
            f"return (int){entry.name}(room, &at, {call});",
        ]  # fmt: skip
        function = signature(name, arguments) + "\n{\n" + "\n".join("    " + line for line in body) + "\n}\n"
        parts = [
            title_of(about, self.what, command),
            HEAD.format(name=about.name),
            translation.text(),
            *jet,
            function,
        ]
        return "\n".join(parts)

    def module(self, title: str) -> str:
        """The Python module."""
        about, [(_, purpose, arguments)] = self.subject, self.functions()
        takes, told, before, passed = asked(about)
        if self.what == "invariants" and about.ends is None:
            takes = [each for each in takes if each not in ("low", "high")]
            told = [line for line in told if not line.startswith("low, high")]
            passed = [each for each in passed if each not in ("float(low)", "float(high)")]
        array = "times" if self.what == "invariants" else "points"
        meant = "the parameters." if array == "times" else f"of shape (m, {about.dimension})."
        lines = [*told, f"{array}: {meant}"]
        return head(about, title) + _EVALUATE.format(
            told="what is found, as the header says",
            dtype="INVARIANTS" if array == "times" else "FOOT",
            fields=tuple(self.row._fields),
            short=self.what,
            name=about.name,
            types=ctypes_of(arguments),
            signature=", ".join(
                [*(t for t in takes if "=" not in t), array, *(t for t in takes if "=" in t)]
            ),
            purpose=purpose,
            lines="".join(f"    {line}\n" for line in lines),
            before="".join(f"    {line}\n" for line in before),
            array=array,
            shaped=".ravel()" if array == "times" else f".reshape(-1, {about.dimension})",
            passed="".join(f"{each}, " for each in passed),
        )

    def wrapper(self) -> str:
        """The functions of the header of C++17."""
        about, [(function, purpose, arguments)] = self.subject, self.functions()
        kept = [a for a in arguments if a.name not in ("times", "points", "size", "out")]
        array = "times" if self.what == "invariants" else "points"
        each = 1 if array == "times" else about.dimension
        declared = [*(a.declaration for a in kept), f"const std::vector<double> &{array}"]
        passed = [*(a.name for a in kept), f"{array}.data()", "found.size()", "found.data()"]
        return (
            f"/** {purpose} Throws failure. */\n"
            f"inline std::vector<piece> {self.what}({', '.join(declared)})\n{{\n"
            f"    std::vector<piece> found({array}.size() / {each});\n"
            f"    const int status = {function}({', '.join(passed)});\n"
            f"    if (status != {about.name.upper()}_OK) throw failure(status);\n    return found;\n}}\n"
        )

    def example(self) -> str:
        """A short program of C."""
        from osculant.compiled.examples import own_jet, values_of

        about, [(function, _, arguments)] = self.subject, self.functions()
        numbers = 3 * (1 if self.what == "invariants" else about.dimension)
        points = ", ".join(f"{0.5 + 0.25 * i}" for i in range(numbers))
        before, passed = values_of(
            about, arguments, {"times": "at", "points": "at", "size": "3", "out": "found"}
        )
        shown = ("t", "curvature") if self.what == "invariants" else ("t", "distance")
        lines = "\n".join(f"    {line}" for line in before)
        return f"""\
/* {about.name}_example.c: cc {about.name}_example.c {about.name}.c -lm -o {about.name}_example */
#include "{about.name}.h"

#include <stdio.h>
{own_jet(about, self.order)}
int main(void)
{{
    static const double at[{numbers}] = {{{points}}};
    {about.name}_piece found[3];
{lines}
    const int status = {function}({", ".join(passed)});
    if (status != {about.name.upper()}_OK) {{
        fprintf(stderr, "%s\\n", {about.name}_explain(status));
        return 1;
    }}
    for (int i = 0; i < 3; i++) printf("%.17g %.17g\\n", found[i].{shown[0]}, found[i].{shown[1]});
    return 0;
}}
"""
