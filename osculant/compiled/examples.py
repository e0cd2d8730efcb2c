"""Short programs of C that call a library."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from osculant.compiled.interface import Argument
from osculant.compiled.subject import Subject

#: values for arguments in examples
VALUES = {
    "low": "0.5", "high": "2.5", "tolerance": "1e-3", "splits": "NULL", "split_count": "0",
    "pieces": "pieces", "capacity": "1000", "count": "&count", "evaluate": "power",
}  # fmt: skip


def values_of(
    subject: Subject, arguments: Sequence[Argument], more: Mapping[str, str] | None = None
) -> tuple[list[str], list[str]]:
    """(lines before a call in an example, what it passes on)."""
    before, passed, known = [], [], {**VALUES, **(more or {})}
    for argument in arguments:
        if argument.name == "parameters":
            size = max(1, len(subject.parameters))
            values = ", ".join(str(float(size - i)) for i in range(size))
            before.append(f"const double parameters[{size}] = {{{values}}};")
        passed.append(known.get(argument.name, argument.name))
    return before, passed


def example(subject: Subject, function: str, arguments: Sequence[Argument]) -> str:
    """A program that prints the knots and errors of the pieces for one tolerance."""
    name = subject.name
    before, passed = values_of(subject, arguments)
    given = "".join(f"    {line}\n" for line in before)
    return f"""\
/* {name}_example.c: cc {name}_example.c {name}.c -lm -o {name}_example */
#include "{name}.h"

#include <stdio.h>
{own_jet(subject, subject.dimension)}
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


def own_jet(subject: Subject, order: int) -> str:
    """A curve for a library that has none: powers of t, with so many derivatives."""
    if subject.coordinates is not None:
        return ""
    rows = ["t, 1.0, 0.0", "t * t * t, 3.0 * t * t, 6.0 * t"]
    if subject.dimension == 3:
        rows.insert(1, "t * t, 2.0 * t, 2.0")
    longer = {"t, 1.0, 0.0": ", 0.0", "t * t, 2.0 * t, 2.0": ", 0.0", rows[-1]: ", 6.0"}
    filled = [row + (longer[row] if order > 2 else "") + ", 0.0" * (order - 3) for row in rows]
    size = (order + 1) * subject.dimension
    return f"""
static void power(double t, const double *parameters, double *out)
{{
    const double jet[{size}] = {{{", ".join(filled)}}};
    (void)parameters;
    for (int i = 0; i < {size}; i++) out[i] = jet[i];
}}
"""
