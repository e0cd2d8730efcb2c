"""The changes of the target that were done one after the other, composed."""

from __future__ import annotations

from collections.abc import Sequence

from osculant.cas.germs.jets_of_maps import MapJet
from osculant.cas.recognition.jets import graded_jet, identity, identity_jet, matrix_jet, terms_of


def composed(changes: Sequence[MapJet], f: MapJet) -> MapJet:
    """The composite of changes of the target, the first one innermost, without terms that f makes 0.

    Args:
        changes: jets of maps of the target.
        f: the germ after the changes.

    The linear changes at the beginning are put together as matrices. For the others degrees of the target
    coordinates are found that all of them respect and that are at most the orders of the components of f: a
    term of a weighted degree above the order of the jets is 0 on f before the changes as well as after.
    """
    p, order = len(f.components), f.order
    first, rest = identity(p), list(changes)
    while rest and all(sum(m) == 1 for m, _ in terms_of(rest[0])):
        first = rest.pop(0).linear_part() * first
    degrees = _respected(rest, f)
    total = graded_jet(identity_jet(p, order), degrees)
    for change in rest:
        total = graded_jet(change, degrees).compose(total)
    return _plain(total).compose(matrix_jet(first, order))


def _respected(changes: Sequence[MapJet], f: MapJet) -> list[int]:
    """Degrees d, as large as they come, with β·d ≥ dⱼ for all terms Y^β in component j of the changes."""
    degrees = [next((d for d, part in enumerate(g) if not part.is_zero()), f.order) for g in f.components]
    terms = [column for change in changes for column in terms_of(change)]
    changing = True
    while changing:
        changing = False
        for beta, j in terms:
            least = sum(d * e for d, e in zip(degrees, beta))
            if least < degrees[j]:
                degrees[j], changing = least, True
    return degrees


def _plain(jet: MapJet) -> MapJet:
    return graded_jet(jet, [1] * jet.source)
