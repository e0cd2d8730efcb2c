"""All invariants of a plane jet at once."""

from __future__ import annotations

from osculant.cas.jets.jet import real_root
from osculant.cas.jets.plane import INVARIANTS, PlaneJet


def invariants_at(x, y, root=real_root):
    """By name, from derivatives 0…5 as in `PlaneJet`; None where undefined."""
    jet = PlaneJet(x, y, root)
    return {invariant.name: invariant.of(jet) for invariant in INVARIANTS}
