"""Functions that sympy lacks and the derivations need."""

from __future__ import annotations

import sympy as sp


class copysign(sp.Function):  # type: ignore[misc]
    """copysign(x, y): |x| with the sign of y; symbolic, printed as the C function of that name."""

    nargs = 2
