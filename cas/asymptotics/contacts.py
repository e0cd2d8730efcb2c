"""How often a cubic meets a short arc: a number that laws need where nothing symbolic is loaded."""

from __future__ import annotations

#: contacts of a cubic with a short arc, three at each end, or six of which it is free
CONTACTS = 6
