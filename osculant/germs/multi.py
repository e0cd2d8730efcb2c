"""Multigerms at the front door: several branches with one target, for A-equivalence."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Literal

from osculant.cas.errors import DomainError, FormulaError
from osculant.germs.invariants import answered
from osculant.germs.map_germ import MapGerm, germ

if TYPE_CHECKING:
    from osculant.cas.germs.multigerm import MultiDeterminacy
    from osculant.cas.germs.search import Patience

Size = int | Literal["infinite"]
#: seconds that a question has at least
LEAST = 1.0


def multigerm(formulas: Any, source: Any, *, patience: float = 10.0) -> MultiMapGerm:
    """A multigerm from the formulas of its branches, all in the same variables, with one target.

    Args:
        formulas: text with a semicolon between branches, such as ``"x, y, 0; x, y, x^2 + y^2"``, or a
            sequence of branches, each as for `osculant.germ`.
        source: the source variables, as for `osculant.germ`.
        patience: seconds of processor time for a question.

    Raises the errors of `osculant.germ` for a branch; DomainError for branches of different dimensions,
    FormulaError for an empty branch.

    >>> planes = multigerm("x, y, 0; x, 0, y; x, y, y + x^2", "x y")
    >>> planes.codimension(extended=True), planes.is_stable(), planes.determinacy().degree
    (1, False, 2)
    """
    parts = formulas.split(";") if isinstance(formulas, str) else list(formulas)
    for i, part in enumerate(parts, start=1):
        if isinstance(part, str) and not part.strip():
            raise FormulaError(
                f"Branch {i} of the multigerm is empty: write its components between semicolons."
            )
    return MultiMapGerm([germ(part, source, patience=patience) for part in parts], patience)


class MultiMapGerm:
    """A multigerm; `multigerm` makes it. Answers are exact, "infinite" where proved, or UndecidedError.

    Attributes:
        branches: the germs.
        seconds: of processor time for one question.

    >>> multigerm("t, 0; 0, t; t, t", "t").branches[2].components
    ('t', 't')
    """

    def __init__(self, branches: Sequence[MapGerm], patience: float = 10.0) -> None:
        from osculant.cas.germs.multigerm import MultiGerm

        self.branches = tuple(branches)
        self.exact = MultiGerm([branch.exact for branch in self.branches])
        self.seconds = patience
        self.clock: Patience | None = None

    @property
    def patience(self) -> Patience:
        """The time that a question asked now may take."""
        from osculant.cas.germs.search import Patience

        left = self.seconds if self.clock is None else max(self.clock.left(), min(LEAST, self.seconds))
        return Patience(left)

    def codimension(self, *, extended: bool = False) -> Size:
        """The codimension of T A f in Mθ, or with ``extended`` that of T A_e f in θ.

        >>> multigerm("t^2, t^3; 0, t", "t").codimension(extended=True)
        2
        """
        from osculant.cas.germs.multigerm import codimension

        return codimension(self.exact, extended, self.patience).value

    def is_stable(self) -> bool:
        """Whether the extended codimension is 0.

        >>> multigerm("x, y^2; y^2, x", "x y").is_stable()
        True
        """
        return self.codimension(extended=True) == 0

    def determinacy(self) -> MultiDeterminacy:
        """A degree of determinacy that is proved, and whether one less is refuted.

        >>> multigerm("x, y, 0; x, y, x^2 + y^3", "x y").determinacy().degree
        3
        """
        from osculant.cas.germs.multigerm import determinacy

        return determinacy(self.exact, self.patience)

    @property
    def delta(self) -> int:
        """δ of a curve with several branches; DomainError for other sources and for infinite codimension.

        >>> multigerm("t, 0; 0, t; t, t", "t").delta
        3
        """
        from osculant.cas.germs.delta import relative_delta

        if self.exact.n != 1:
            raise DomainError(f"δ is that of a curve; these germs have {self.exact.n} source variables.")
        if self.codimension(extended=True) == "infinite":
            raise DomainError("δ is infinite or unknown: the multigerm is not finitely determined.")
        return relative_delta(self.exact.branches, patience=self.patience)

    def report(self) -> dict[str, Any]:
        """All answers as plain data.

        Keys: ``source``, ``target``, ``branches`` (lists of components), ``group`` ("A"), ``ranks``,
        ``codimension``, ``extended_codimension``, ``determinacy``, ``sharp``, ``sharpness``, ``stable``, for
        curves ``delta`` and, for p = 2, ``image_milnor`` = δ − r + 1; null where there is no answer, with
        ``reason`` and ``undecided``.

        >>> multigerm("t, 0; t, t^2", "t").report()["image_milnor"]
        1
        """
        from osculant.cas.germs.search import Patience

        first = self.branches[0]
        told = {
            "source": list(first.source),
            "target": first.target,
            "branches": [list(branch.components) for branch in self.branches],
            "group": "A",
            "ranks": [branch.rank for branch in self.branches],
        }
        questions: dict[str, Any] = {
            "codimension": self.codimension,
            "extended_codimension": lambda: self.codimension(extended=True),
            "determinacy": self.determinacy,
            "stable": self.is_stable,
        }
        if self.exact.n == 1:
            questions["delta"] = lambda: self.delta
            if self.exact.p == 2:
                questions["image_milnor"] = lambda: self.delta - len(self.branches) + 1
        self.clock = Patience(self.seconds)
        try:
            data = answered(questions)
        finally:
            self.clock = None
        found = data["determinacy"]
        data["determinacy"] = None if found is None else found.degree
        data["sharp"], data["sharpness"] = (None, None) if found is None else (found.sharp, found.reason)
        return told | data

    def __repr__(self) -> str:
        return "<MultiMapGerm " + "; ".join(", ".join(b.components) for b in self.branches) + ">"
