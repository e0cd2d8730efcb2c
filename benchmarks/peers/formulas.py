"""Curves and invariants for whatever symbols: no imports, so that any interpreter can load it."""

#: name → (text, ends, formula of t, sin, cos); on these intervals the curves bend to the left
CURVES = {
    "spiral": (
        ("t*cos(t), t*sin(t)", "pi/6", "2*pi"),
        lambda t, sin, cos: (t * cos(t), t * sin(t)),
    ),
    "sextic": (
        ("cos(t/3)^3*cos(t), cos(t/3)^3*sin(t)", -2, 2),
        lambda t, sin, cos: (cos(t / 3) ** 3 * cos(t), cos(t / 3) ** 3 * sin(t)),
    ),
}


def invariants(x, y, slope, sqrt, cbrt):  # noqa: ANN001, ANN201
    """(κ, k, dk/dr) of a curve from its formulas, their derivative, and the roots of what is positive.

    For any parameter, with φ³ = [α̇, α̈]: k = (4[α̈, α⃛] + [α̇, α⁗])/3φ⁵ − 5[α̇, α⃛]²/9φ⁸, dr = φ dt.
    """
    xs, ys = [x], [y]
    for _ in range(4):
        xs.append(slope(xs[-1]))
        ys.append(slope(ys[-1]))

    def bracket(i, j):  # noqa: ANN001, ANN202
        return xs[i] * ys[j] - xs[j] * ys[i]

    bend, speed = bracket(1, 2), sqrt(xs[1] * xs[1] + ys[1] * ys[1])
    phi = cbrt(bend)
    square = bracket(1, 3) * bracket(1, 3)
    affine = (4 * bracket(2, 3) + bracket(1, 4)) / (3 * bend * phi * phi)
    affine = affine - 5 * square / (9 * bend * bend * phi * phi)
    return bend / (speed * speed * speed), affine, slope(affine) / phi
