"""The lists of the literature as plain data."""

from __future__ import annotations

from typing import Any


def listed(name: str) -> dict[str, Any]:
    """A list of the literature as plain data, capitals aside.

    Keys: ``version`` 1, ``list``, ``title``, ``source`` and ``rows``, each with ``id``, ``name`` (``{…}``
    stands for a number, ± for a sign), ``normal_form``, ``variables``, ``boundary``, ``group``, ``integers``
    with their least values, ``moduli``, ``codimension`` (of T G f in Mθ) and ``determinacy`` as formulas in
    the integers.

    Raises DomainError for a list that does not exist.

    >>> found = listed("Mond")
    >>> found["rows"][0]["name"], found["rows"][0]["normal_form"], found["rows"][0]["codimension"]
    ('S{k}±', ['x', 'y**2', 'y**3 ± x**(k + 1)*y'], 'k + 2')
    """
    from osculant.cas.germs.reference import reference

    found = reference(name)
    return {
        "version": 1,
        "list": found.name,
        "title": found.title,
        "source": found.source,
        "rows": [
            {
                "id": entry.id,
                "name": entry.name,
                "normal_form": [part.strip() for part in entry.text.split(",")],
                "variables": list(entry.variables),
                "boundary": entry.even or entry.boundary,
                "group": entry.group,
                "integers": {p.name: p.least for p in entry.integers},
                "moduli": [p.name for p in entry.moduli],
                "codimension": entry.values.get("cod"),
                "determinacy": entry.values.get("determinacy"),
            }
            for entry in found.entries
        ],
    }
