"""Classification at the front door: `classify` and its answer."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import DomainError
from osculant.cas.germs.groups import group as group_of

if TYPE_CHECKING:
    from osculant.cas.classification.classify import Classified


@dataclass(frozen=True)
class GermClass:
    """A class of germs.

    Attributes:
        id: its name, "2.1" for the first one of codimension 2.
        germ: the components of its first real form, as text.
        codimension: the codimension of the orbit in the jets without constants.
        determinacy: a degree of determinacy, proved.
        sharp: whether no smaller one will do; None if that is not known.
        real_forms: the components of each real form; over ℂ they are one class.
        different: why the real forms are different classes; "" if that is not proved.
    """

    id: str
    germ: tuple[str, ...]
    codimension: int
    determinacy: int
    sharp: bool | None
    real_forms: tuple[tuple[str, ...], ...]
    different: str


@dataclass(frozen=True)
class ModalStratum:
    """A family of orbits: the ``germ`` with parameters, the codimension of their union, and the moduli."""

    germ: tuple[str, ...]
    codimension: int
    moduli: int


@dataclass(frozen=True)
class Classification:
    """All classes up to a codimension; `classify` makes it.

    Attributes:
        source: the number of variables x1, x2, … and, with H = {u = 0}, u, the last.
        target: the number of components.
        group: the name of the group.
        codimension: the bound.
        classes: the classes, by codimension.
        strata: the families whose orbits have larger codimensions than the bound, but not their unions.
        adjacencies: pairs (B, A) of names, the class B in the closure of A; what follows from others is left
            out. All are proved; there may be more.
    """

    source: int
    target: int
    group: str
    codimension: int
    classes: tuple[GermClass, ...]
    strata: tuple[ModalStratum, ...]
    adjacencies: tuple[tuple[str, str], ...]
    exact: Classified

    def tree(self) -> list[dict[str, Any]]:
        """Every branch of the trees: its depth, what is decided, the codimension so far, and its fate.

        >>> classify(4, 5, "A(H)", 0).tree()[0]["fate"]
        '0.1: x1, x2, x3, u, 0'
        """
        from osculant.cas.classification.outline import outline

        return [
            {"depth": b.depth, "branch": b.text, "codimension": b.codimension, "kind": b.kind, "fate": b.fate}
            for b in outline(self.exact)
        ]

    def draw(self, path: str | Path) -> None:
        """Write the trees as an SVG file. Raises OSError if it cannot be written."""
        from osculant.germs.tree_drawing import drawing

        title = f"{self.group}: {self.source} to {self.target} dimensions, codimension {self.codimension}"
        Path(path).write_text(drawing(self.tree(), title), encoding="utf-8")

    def data(self) -> dict[str, Any]:
        """All of it as plain data, for JSON."""
        second = self.exact.second
        return {
            "source": self.source,
            "target": self.target,
            "group": self.group,
            "codimension": self.codimension,
            "classes": [
                {
                    "id": c.id,
                    "germ": list(c.germ),
                    "codimension": c.codimension,
                    "determinacy": c.determinacy,
                    "sharp": c.sharp,
                    "real_forms": [list(f) for f in c.real_forms],
                    "different": c.different or None,
                }
                for c in self.classes
            ],
            "strata": [
                {"germ": list(s.germ), "codimension": s.codimension, "moduli": s.moduli} for s in self.strata
            ],
            "adjacencies": [list(pair) for pair in self.adjacencies],
            "second_route": None
            if second is None
            else {
                "codimension": second.codimension,
                "classes": second.classes,
                "real_forms": second.forms,
                "genotypes": list(second.genotypes),
                "agrees": second.agrees,
            },
            "tree": self.tree(),
        }


def classify(
    source: int,
    target: int,
    group: str = "A(H)",
    codimension: int = 3,
    progress: Callable[[float], None] | None = None,
) -> Classification:
    """All classes of germs up to a codimension, derived from nothing: no list is read.

    Args:
        source: the number of variables.
        target: the number of components.
        group: the group, "A(H)", "A" or "R".
        codimension: the largest codimension of an orbit in the jets without constants. The extended one is
            max(0, codimension − source + 1) for A(H), max(0, codimension − source) for A; the Milnor number
            of a function is codimension − source + 1.
        progress: is told the part of the work that is done, 0…1.

    Over ℂ the list is complete, and no class is twice in it: that is proved. Every real germ is one of the
    real forms; where `GermClass.different` is empty, two of them may be equivalent.

    Raises DomainError for what is no whole number or no group, and beyond what is built and tested;
    UndecidedError where a step is not proved.

    >>> found = classify(source=4, target=3, group="A(H)", codimension=1)
    >>> [(c.id, c.real_forms[-1]) for c in found.classes]
    [('0.1', ('x1', 'x2', 'x3')), ('1.1', ('x1', 'x2', 'u - x3**2'))]
    """
    from osculant.cas.classification.classify import classified

    for name, value in (("source", source), ("target", target), ("codimension", codimension)):
        if isinstance(value, bool) or not isinstance(value, int):
            raise DomainError(f"{name}: {value!r} is no whole number.", argument=name)
    made = classified(source, target, group, codimension, progress or (lambda part: None))
    classes = []
    for name, orbit in zip(made.names, made.orbits):
        forms = tuple(_components(orbit.text(signs)) for signs in orbit.forms)
        degree = orbit.determinacy.degree
        assert degree != "infinite"
        classes.append(
            GermClass(name, forms[0], orbit.codimension, degree, orbit.determinacy.sharp, forms, orbit.apart)
        )
    strata = tuple(
        ModalStratum(_components(s.text), s.codimension, s.moduli) for f in made.found for s in f.strata
    )
    return Classification(
        source,
        target,
        group_of(group).name,
        codimension,
        tuple(classes),
        strata,
        made.adjacencies,
        made,
    )


def _components(text: str) -> tuple[str, ...]:
    return tuple(text.split(", "))
