"""The curves of the thesis that claims are tried on, as formulas in t; arcs with both ends."""

from __future__ import annotations

#: Archimedes' spiral, and the arc of it in the tables
SPIRAL = "t*cos(t), t*sin(t)"
SPIRAL_ARC = (SPIRAL, "pi/6", "2*pi")
#: Cayley's sextic, and the half of it in the tables, from its sextactic point on
SEXTIC = "4*cos(t/3)^3*cos(t), 4*cos(t/3)^3*sin(t)"
HALF_SEXTIC = (SEXTIC, "0", "3*pi/4")
#: affine spirals with a fixed end and the last end tried; k has both signs on the third
AFFINE_SPIRALS = ((SPIRAL, "1", "3"), ("t, exp(t)", "-1", "1"), ("t, t^2/2 + t^5/400", "-1", "1"))
#: the conical spiral and the moment curve
CONICAL, MOMENT = "t*cos(t), t*sin(t), t", "t, t^2, t^3"
