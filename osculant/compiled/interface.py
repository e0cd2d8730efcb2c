"""The functions of a library: their arguments, and what they say when it goes wrong."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from osculant.compiled.subject import Subject

#: what the functions return, by name: the numbers of `osculant.kernels.standalone.stretches`, and a sentence
STATUSES = {
    "OK": "Everything is written.",
    "ARRAY_TOO_SMALL": "The array is too small: count says how many pieces there are.",
    "BELOW_FLOOR": "The tolerance is below what double numbers can carry: choose a larger one.",
    "UNDEFINED": "The curve is undefined, infinite, a single point or without a tangent somewhere.",
    "NOT_FOUND": "No piece within the tolerance was found from some point on: choose a larger tolerance.",
    "TOO_MUCH": "There are too many pieces, special points or features: take a shorter interval.",
    "BAD_ARGUMENT": "An argument makes no sense: a tolerance, an interval or special points.",
    "TOO_FEW": "Fewer pieces are asked for than there must be: count says how many that are.",
}
#: stands for a blank at which no line ends
GLUE = "\0"


@dataclass(frozen=True)
class Argument:
    """One argument of a function of C: its declaration, and what it is."""

    declaration: str
    meaning: str

    @property
    def name(self) -> str:
        """What it is called."""
        return self.declaration.replace("*", " ").split("[")[0].split()[-1].split(")")[0]


def given(subject: Subject, splits: bool = True, order: int | None = None) -> list[Argument]:
    """The arguments that say which curve it is: nothing of a fixed one.

    Args:
        subject: the curve.
        splits: whether special points may be given.
        order: of a jet of the caller's own; as many as coordinates if None.
    """
    found = []
    if subject.coordinates is None:
        found.append(
            Argument(
                f"{subject.name}_jet evaluate",
                f"writes the derivatives 0 ... {order or subject.dimension} of each coordinate into out",
            )
        )
    if subject.ends is None:
        found += [
            Argument("double low", "where the curve begins"),
            Argument("double high", "and where it ends"),
        ]
    if subject.parameters:
        size = len(subject.parameters)
        found.append(Argument(f"const double parameters[{size}]", ", ".join(subject.parameters)))
    elif subject.coordinates is None:
        found.append(Argument("const double *parameters", "what jet is given"))
    if splits and not subject.fixed:
        found += [
            Argument(
                "const double *splits", "special points, increasing, to split at; NULL: found at run time"
            ),
            Argument("size_t split_count", "how many"),
        ]
    return found


def wrapped(text: str, width: int = 100, first: str = "", then: str = " * ") -> str:
    """Text in lines of comments."""
    words, lines, line = text.split(), [], first
    for word in words:
        if len(line) + len(word) + 1 > width and line.strip(" *"):
            lines.append(line.rstrip())
            line = then
        line += word + " "
    return "\n".join([*lines, line.rstrip()])


def signature(name: str, arguments: Sequence[Argument]) -> str:
    """``int name(arguments)``."""
    inside = ", ".join(argument.declaration.replace(" ", GLUE) for argument in arguments) or "void"
    return wrapped(f"int {name}({inside})", then="    ").replace(GLUE, " ")


def comment(purpose: str, arguments: Sequence[Argument]) -> str:
    """The comment above a function."""
    lines = ["/*", wrapped(purpose, first=" * "), " *"]
    lines += [
        wrapped(f"{argument.name}: {argument.meaning}", first=" *   ", then=" *       ")
        for argument in arguments
    ]
    return "\n".join([*lines, " */"])
