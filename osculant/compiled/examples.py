"""A short program of C that calls a library."""

from __future__ import annotations

from collections.abc import Sequence

from osculant.compiled.interface import Argument
from osculant.compiled.subject import Subject

#: values for arguments in examples
_VALUES = {"low": "0.5", "high": "2.5", "tolerance": "1e-3", "splits": "NULL", "split_count": "0"}


def example(subject: Subject, function: str, arguments: Sequence[Argument]) -> str:
    """A program that prints the knots and errors of the pieces for one tolerance."""
    name, passed, before = subject.name, [], []
    for argument in arguments:
        if argument.name == "parameters":
            size = max(1, len(subject.parameters))
            values = ", ".join(str(float(size - i)) for i in range(size))
            before.append(f"    const double parameters[{size}] = {{{values}}};")
            passed.append("parameters")
        elif argument.name == "evaluate":
            passed.append("power")
        elif argument.name == "pieces":
            passed.append("pieces")
        elif argument.name in ("capacity", "count"):
            passed.append("1000" if argument.name == "capacity" else "&count")
        else:
            passed.append(_VALUES[argument.name])
    given = "\n".join(before) + "\n" if before else ""
    return f"""\
/* {name}_example.c: cc {name}_example.c {name}.c -lm -o {name}_example */
#include "{name}.h"

#include <stdio.h>
{_own_jet(subject)}
int main(void)
{{
    static {name}_piece pieces[1000];
    size_t count = 0;
{given}    const int status = {function}({", ".join(passed)});
    if (status != {name.upper()}_OK) {{
        fprintf(stderr, "%s\\n", {name}_explain(status));
        return 1;
    }}
    for (size_t i = 0; i < count; i++)
        printf("%.17g %.17g %.17g\\n", pieces[i].a, pieces[i].b, pieces[i].error);
    return 0;
}}
"""


def _own_jet(subject: Subject) -> str:
    """A curve for a library that has none: powers of t."""
    if subject.coordinates is not None:
        return ""
    rows = ["t, 1.0, 0.0", "t * t * t, 3.0 * t * t, 6.0 * t"]
    if subject.dimension == 3:
        rows = ["t, 1.0, 0.0, 0.0", "t * t, 2.0 * t, 2.0, 0.0", "t * t * t, 3.0 * t * t, 6.0 * t, 6.0"]
    size = (subject.dimension + 1) * subject.dimension
    return f"""
static void power(double t, const double *parameters, double *out)
{{
    const double jet[{size}] = {{{", ".join(rows)}}};
    (void)parameters;
    for (int i = 0; i < {size}; i++) out[i] = jet[i];
}}
"""


__all__ = ["example"]
