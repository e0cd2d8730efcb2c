"""Arcs with the arms and errors of their best cubics, to 15 digits, and an independent error of a cubic.

The values were computed with 40 digits of mpmath: Newton's method for the arms and the peaks of the
displacement, from a search over all starts.
"""

import math
from typing import NamedTuple

import numpy as np

SPIRAL, GROWING, BOWL, WAVE = "t*cos(t), t*sin(t)", "t, exp(t)", "t, cosh(t)", "t, sin(t)"
CAYLEY = "4*cos(t/3)^3*cos(t), 4*cos(t/3)^3*sin(t)"
CIRCLE, ELLIPSE, INFLECTED = "cos(t), sin(t)", "2*cos(t), sin(t)", "t, t^3/6+t^4/10"


class Known(NamedTuple):
    """The best cubic of an arc: two of its peaks, where there are but two, fix the arms less well."""

    text: str
    a: float
    b: float
    arm0: float
    arm3: float
    error: float
    peaks: int = 3


KNOWN = (
    Known(SPIRAL, 1, 2, 0.520745217173148, 0.729898960420736, 1.08890102942203e-4),
    Known(SPIRAL, math.pi / 6, 2, 0.662064973939917, 1.10803901851721, 1.31588364823399e-3),
    Known(SPIRAL, 4, 5, 1.47904877014284, 1.66398257381046, 8.12339240663023e-5),
    Known(GROWING, 0, 1, 0.532078189248795, 0.852906673949131, 4.742016307575e-7),
    Known(GROWING, -2, 2, 2.11493367333967, 6.04915805204348, 1.25361560195883e-3),
    Known(CAYLEY, 0, 1, 1.3662901131478, 1.29025728836408, 2.49309059065781e-4),
    Known(CAYLEY, 0, 0.75 * math.pi, 3.6132796976747, 2.68230791903827, 3.70673372007347e-2),
    Known(CIRCLE, 0, math.pi / 2, 0.551915024493511, 0.551915024493511, 1.96076469876878e-4),
    Known(CIRCLE, 0, math.pi, 1.31573974008184, 1.31573974008184, 1.3195194938619e-2),
    Known(ELLIPSE, 0, math.pi / 2, 0.549948081712195, 1.1077686613832, 2.62828612570527e-4),
    Known("t, log(t)", 1, 2, 0.355491730510804, 0.474215509594309, 5.06556770323164e-8),
    Known(BOWL, -1, 1, 0.951488055745134, 0.951488055745134, 4.0517222266156e-4),
    Known(INFLECTED, -0.5, 0.5, 0.43443854533062, 0.28331336969856, 8.90948030741053e-5),
    Known(WAVE, -0.5, 1.5, 0.880618717720193, 0.730220344307483, 1.19505320388634e-4),
    Known(WAVE, -1, 1, 0.784270051162267, 0.784270051162267, 1.21026699101988e-5, 4),
    Known(BOWL, -2.5, 1.1, 7.57616882767447, 0.237148907443285, 1.57164545635739e-2, 2),
    Known("t, t^2/2+t^5/8", -0.3, 0.5, 0.355480753044566, 0.204343825552921, 2.1243487994996e-4, 2),
    Known("t, t^4", -0.5, 1, 0.126048259600455, 1.50427958577854, 5.22969816891013e-2, 2),
)


def bezier(controls, u):
    """Points of a cubic Bézier curve, (m, 2)."""
    v, u = 1 - u[:, None], u[:, None]
    p0, p1, p2, p3 = np.asarray(controls, dtype=float)
    return v**3 * p0 + 3 * v * v * u * p1 + 3 * v * u * u * p2 + u**3 * p3


def displacements(points, tangents, arms):
    """How far the cubic with such arms is from points of a curve along their normals, by bisection; or None.

    Args:
        points: (m, 2), the ends of the arc among them.
        tangents: unit vectors (m, 2).
        arms: both.
    """
    (arm0, arm3), p, t = arms, points[1:-1], tangents[1:-1]
    if not min(arms) > 0:
        return None
    controls = np.array(
        [points[0], points[0] + arm0 * tangents[0], points[-1] - arm3 * tangents[-1], points[-1]]
    )
    relative = controls[None] - p[:, None]
    along = (relative * t[:, None]).sum(2)
    across = relative[..., 1] * t[:, None, 0] - relative[..., 0] * t[:, None, 1]

    def at(rows, u):
        v = 1 - u
        return v**3 * rows[:, 0] + 3 * v * u * (v * rows[:, 1] + u * rows[:, 2]) + u**3 * rows[:, 3]

    low, high = np.zeros(len(p)), np.ones(len(p))
    for _ in range(50):
        middle = (low + high) / 2
        beyond = at(along, middle) > 0
        low, high = np.where(beyond, low, middle), np.where(beyond, middle, high)
    if np.abs(at(along, low)).max() > 1e-9 * np.abs(along).max() or not (np.diff(low) > 0).all():
        return None
    return at(across, low)
