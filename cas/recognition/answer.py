"""What is told of a germ's class: its row of a list and the equivalence that proves it, or what hinders."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group
from osculant.cas.recognition.equivalence import Equivalence
from osculant.cas.recognition.forms import Form
from osculant.cas.recognition.keys import Key
from osculant.cas.recognition.names import called


@dataclass(frozen=True)
class Recognition:
    """The class of a germ, or why it has no name.

    Attributes:
        germ: the germ.
        group: of the equivalences.
        lists: the names of the lists that were looked through.
        form: the row of a list with its integers; None without a name.
        equivalence: the germ's with the form, which proves the name; None without one: then a function has
            the name over ℂ of the rows with its key, and signs and moduli are not known.
        codimension: of T G f in Mθ, where it is known: a number or "infinite".
        key: what was computed of the germ's key.
        reason: why there is no name, or no equivalence, as a sentence; empty if there is one.
        undecided: whether there may be a name.
        alike: names of classes with which an equivalence was neither found nor excluded.
    """

    germ: Germ
    group: Group
    lists: tuple[str, ...]
    form: Form | None = None
    equivalence: Equivalence | None = None
    codimension: int | Literal["infinite"] | None = None
    key: Key | None = None
    reason: str = ""
    undecided: bool = False
    alike: tuple[str, ...] = ()

    @property
    def name(self) -> str | None:
        """The name of the real class, with signs and moduli; that over ℂ if there is no equivalence."""
        if self.form is None:
            return None
        if self.equivalence is None:
            return called(self.form, None, None)
        return called(self.form, self.equivalence.signs, self.equivalence.moduli)

    @property
    def complex(self) -> str | None:
        """The name of the class over ℂ; with the values of moduli where those of the real class are its own.

        Where a sign is −, the form that is all + has other moduli, and their names stand there.
        """
        if self.form is None:
            return None
        found = self.equivalence
        if found is None or self.form.entry.complex:  # moduli of another normal form
            return called(self.form, None, None)
        own = all(s > 0 for s in found.signs) or not any(found.moduli.values())
        return called(self.form, None, found.moduli if own else None)
