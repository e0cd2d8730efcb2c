"""What the groups do in the target, by name, and germs before any change."""

from __future__ import annotations

from osculant.cas.germs.groups import Group
from osculant.cas.germs.jets_of_maps import MapJet
from osculant.cas.recognition.contact import CONTACT
from osculant.cas.recognition.jets import identity_jet
from osculant.cas.recognition.moves import LEFT, NONE, Moved, TargetPart

#: the target parts of groups, by `Group.target`
TARGETS: dict[str, TargetPart] = {"none": NONE, "left": LEFT, "contact": CONTACT}


def unmoved(f: MapJet, group: Group) -> Moved:
    """A germ before any change."""
    part = TARGETS[group.target]
    return Moved(f, identity_jet(f.source, f.order), part.identity, part)
