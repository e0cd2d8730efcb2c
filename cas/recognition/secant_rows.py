"""Table 6.1 read by classes: which secant germs of surfaces, with their projections, belong to a class."""

from __future__ import annotations

import re
from functools import lru_cache

from osculant.cas.germs.reference import reference
from osculant.cas.recognition.recognise import recognise


@lru_cache(maxsize=8)
def secant_rows(p: int) -> dict[str, tuple[str, ...]]:
    """The rows of table 6.1, of p components, by the names in table 6.2 of the classes of their secant germs.

    >>> secant_rows(2)["2a"]
    ('3-1', '3-2', '3-3', '3-4+', '3-4-')
    """
    found: dict[str, list[str]] = {}
    for entry in reference("table 6.1").entries:
        if entry.text.count(",") + 1 != p:
            continue
        for signs, values in entry.tried():
            moduli = bool(entry.moduli)
            row = re.sub(r"[{}]", "", entry.name) if moduli else entry.called(signs, **values)
            name = recognise(entry.germ(signs, **values), "A(H)").name
            rows = found.setdefault(str(name), [])
            if row not in rows:
                rows.append(row)
    return {name: tuple(rows) for name, rows in found.items()}
