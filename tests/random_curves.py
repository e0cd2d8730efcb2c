"""Random curves with much in them, approximated and held against an independent distance.

Many turns, uneven parametrisations, waves, bumps and loops whose size is a few tolerances, near-cusps,
control points that nearly coincide, coordinates far from the origin.  Each seed makes one curve.

    python -m tests.random_curves tests/data/random-curves.txt 2000 2

goes on with a record where it ends, a line for each curve, up to so many, in two processes, and prints what
it says in all; the exit status is 1 if an error is beyond its tolerance, or beyond what was reported.
"""

from __future__ import annotations

import math
import random
import sys
import time
import traceback
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path

import osculant as osc
from tests.hausdorff import Formula, GaveUpError, distance

#: an error is in excess if it is more than so many tolerances; a report too small if the error is more than
#: so many times as large
EXCESS, HONEST = 1 + 1e-6, 1 + 1e-5
#: reports resolve errors to this part of the tolerance: of much smaller ones they tell fewer digits
UNRESOLVED = 1e-5
#: passed over: so many rounding units of the largest coordinate, of pieces that are said to be parts of the
#: curve itself the floor of tolerances, and parts of the tolerance, as the distance has an error of its own
ROUNDING, FLOOR, SLACK = 32, 1000, 1e-7
#: the curve's parts are polynomials to within this part of the tolerance
RESOLVED = 1e-3
#: verdicts that are defects of the tool
FAILURES = ("EXCESS", "UNTOLD", "TRACEBACK")
#: distances that come out nearer than this, in parts, to a limit, and the largest of each curve, are measured
#: again, with so many times as many samples, until they are within it
NEAR, AGAIN = 5e-7, (6, 24, 96)
#: primitives, with their share of the curves, and of those how many have another parametrisation than the
#: plain one: special points take their time
PLANE = {"parabola": (1, 0.1), "conic": (1, 0.1), "cubic": (1, 0.1), "biarc": (2, 0.3), "polygon": (2, 0.5)}
SPACE = {"bihelix": (3, 0.2), "polygon": (2, 0.6)}


@dataclass(frozen=True)
class Case:
    """A curve and what is asked for."""

    seed: int
    kind: str
    text: str
    low: str
    high: str
    primitive: str
    tolerance: float

    @property
    def question(self) -> str:
        """One line that tells it all."""
        return f"{self.text} from {self.low} to {self.high} {self.primitive} {self.tolerance:g}"


def digits(x: float, count: int = 4) -> str:
    """A decimal as a formula has it."""
    return f"({x:.{count}g})" if x < 0 else f"{x:.{count}g}"


class Draw:
    """One random curve: a shape, features of a few tolerances on it, and a parametrisation."""

    def __init__(self, seed: int) -> None:
        self.chance = random.Random(seed)
        self.seed = seed
        self.space = self.chance.random() < 0.5
        primitives = SPACE if self.space else PLANE
        weights = [share for share, _ in primitives.values()]
        self.primitive = self.chance.choices(list(primitives), weights)[0]
        self.reparametrised = primitives[self.primitive][1]
        exponents = (-2.7, -1.3) if self.primitive == "polygon" else (-4.5, -1.3)
        self.tolerance = float(f"{10 ** self.chance.uniform(*exponents):.3g}")

    def between(self, low: float, high: float) -> float:
        """A number in between."""
        return self.chance.uniform(low, high)

    def scaled(self, low: float, high: float) -> float:
        """A number in between, its logarithm even."""
        return float(math.exp(self.chance.uniform(math.log(low), math.log(high))))

    def case(self) -> Case:
        """The curve."""
        shapes = [self.spiral, self.archimedean, self.trochoid, self.bezier, self.lissajous, self.near_cusp]
        shapes += [self.graph, self.circle, self.line, self.bump_on_nothing]
        shape = self.chance.choice(shapes)
        coordinates, low, high = shape()
        names = [shape.__name__]
        for feature in (self.bump, self.wave, self.loops):
            if self.chance.random() < 0.3:
                coordinates = feature(coordinates, low, high)
                names.append(feature.__name__)
        if self.chance.random() < 0.15:
            coordinates = [f"{digits(self.between(-1e3, 1e3))} + {c}" for c in coordinates]
            names.append("far")
        inner, low_text, high_text, name = self.parametrisation(low, high)
        if name:
            names.append(name)
        text = ", ".join(c.replace("S", inner) for c in coordinates)
        kind = "+".join(names)
        return Case(self.seed, kind, text, low_text, high_text, self.primitive, self.tolerance)

    # shapes, about 1 large: coordinates in S, and an interval of S

    def third(self, text: str) -> list[str]:
        """The third coordinate, in space."""
        return [text] if self.space else []

    def spiral(self) -> tuple[list[str], float, float]:
        turns = self.scaled(0.3, 12)
        rate = digits(self.between(-1, 1) * min(0.5, 3 / turns))
        grows = f"exp({rate}*S)"
        start = self.between(-1, 1)
        coordinates = [
            f"{grows}*cos(S)",
            f"{grows}*sin(S)",
            *self.third(f"{digits(self.between(0.02, 1))}*S"),
        ]
        return coordinates, start, start + 2 * math.pi * turns

    def archimedean(self) -> tuple[list[str], float, float]:
        low = self.between(0.1, 2)
        high = low + self.scaled(1, 40)
        size = digits(1 / high)
        z = f"{digits(self.between(0.1, 1))}*S*S*{digits(high**-2)}"
        return [f"{size}*S*cos(S)", f"{size}*S*sin(S)", *self.third(z)], low, high

    def trochoid(self) -> tuple[list[str], float, float]:
        k, d = self.chance.choice([2, 3, 5, 7, 11]), digits(self.scaled(0.02, 0.9))
        ends = sorted(self.between(0, 6.28) for _ in range(2))
        coordinates = [f"cos(S) - {d}*cos({k}*S)", f"sin(S) - {d}*sin({k}*S)"]
        return [*coordinates, *self.third(f"{digits(self.between(0, 1))}*sin(2*S)")], ends[0], ends[1] + 0.1

    def bezier(self) -> tuple[list[str], float, float]:
        dimension = 3 if self.space else 2
        points = [[self.between(-1, 1) for _ in range(dimension)] for _ in range(4)]
        close = self.chance.choice([None, (0, 1), (1, 2), (2, 3)])
        if close is not None:
            near = self.scaled(1e-9, 1e-1)
            points[close[1]] = [x + near * self.between(-1, 1) for x in points[close[0]]]
        weights = ["(1-S)^3", "3*(1-S)^2*S", "3*(1-S)*S^2", "S^3"]
        columns = zip(*points, strict=True)
        return [" + ".join(f"{digits(x, 12)}*{w}" for x, w in zip(c, weights)) for c in columns], 0.0, 1.0

    def lissajous(self) -> tuple[list[str], float, float]:
        j, k, m = (self.chance.choice([1, 2, 3, 4]) for _ in range(3))
        shift = digits(self.between(0, 3))
        low = self.between(0, 3)
        coordinates = [f"cos({j}*S)", f"sin({k}*S + {shift})", *self.third(f"sin({m}*S)")]
        return coordinates, low, low + self.between(0.5, 4)

    def near_cusp(self) -> tuple[list[str], float, float]:
        off = digits(self.chance.choice([-1, 1]) * self.scaled(1e-8, 1e-1))
        coordinates = ["S^2", f"S^3 - {off}*S", *self.third(f"S^4 + {digits(self.between(-1, 1))}*S^2")]
        return coordinates, -self.between(0.2, 1), self.between(0.2, 1)

    def graph(self) -> tuple[list[str], float, float]:
        w, k = digits(self.scaled(1e-4, 1)), digits(self.scaled(1, 1e3))
        a = digits(self.between(-0.7, 0.7))
        y = self.chance.choice([f"tanh({k}*(S-{a}))", f"1/(1+((S-{a})/{w})^2)", f"sqrt((S-{a})^2 + {w}^2)"])
        return ["S", y, *self.third(f"S^2*{digits(self.between(-1, 1))}")], -1.0, 1.0

    def circle(self) -> tuple[list[str], float, float]:
        high = self.between(0.3, 6)
        return ["cos(S)", "sin(S)", *self.third(f"{digits(self.between(-1, 1))}*S")], 0.0, high

    def line(self) -> tuple[list[str], float, float]:
        bend = self.chance.choice(["0", digits(self.scaled(1e-6, 1))])
        return ["S", f"{digits(self.between(-1, 1))}*S + {bend}*S^2", *self.third("S/2")], -1.0, 1.0

    def bump_on_nothing(self) -> tuple[list[str], float, float]:
        return self.bump(["S", "0.3*S*S", *self.third("0.1*S")], -1.0, 1.0), -1.0, 1.0

    # features, a few tolerances large

    def onto(self, coordinates: list[str], more: str) -> list[str]:
        """The coordinates, one of them with something more."""
        found = list(coordinates)
        i = self.chance.randrange(len(found))
        found[i] = f"{found[i]} + {more}"
        return found

    def size(self) -> float:
        """A part of the tolerance, or many."""
        return self.tolerance * self.chance.choice(
            [0.5, 0.9, 1.1, 1.5, self.scaled(1, 1e3), self.scaled(1, 10)]
        )

    def bump(self, coordinates: list[str], low: float, high: float) -> list[str]:
        """With a bump, down to a millionth of the interval."""
        width, at = (high - low) * self.scaled(1e-6, 1e-1), low + (high - low) * self.between(0.02, 0.98)
        return self.onto(coordinates, f"{digits(self.size())}*exp(-((S-{digits(at, 6)})/{digits(width)})^2)")

    def wave(self, coordinates: list[str], low: float, high: float) -> list[str]:
        """With a wave all along."""
        rate = self.scaled(3, 100) / (high - low)
        return self.onto(coordinates, f"{digits(self.size())}*sin({digits(rate)}*S)")

    def loops(self, coordinates: list[str], low: float, high: float) -> list[str]:
        """With small circles added: loops, if they are fast enough."""
        rate, size = digits(self.scaled(3, 60) / (high - low)), digits(self.size())
        first = [f"{coordinates[0]} + {size}*cos({rate}*S)", f"{coordinates[1]} + {size}*sin({rate}*S)"]
        return [*first, *coordinates[2:]]

    # parametrisations: S as a formula in t, both ends, and what it is called

    def parametrisation(self, low: float, high: float) -> tuple[str, str, str, str]:
        if self.chance.random() > self.reparametrised:
            return "t", digits(low, 6).strip("()"), digits(high, 6).strip("()"), ""
        k = self.chance.choice([2, 3, 5, 9])
        speed = digits(self.scaled(0.5, 8))
        kinds = [
            (f"t^{k}", 0.1, 1.0, lambda t: t**k),
            ("exp(exp(t))", -1.0, self.between(0.5, 1.4), lambda t: math.exp(math.exp(t))),
            (f"tanh({speed}*t)", -1.0, 1.0, lambda t: math.tanh(float(speed) * t)),
            (f"atan({speed}*t)", -1.0, 3.0, lambda t: math.atan(float(speed) * t)),
            ("1/t", 0.05, 1.0, lambda t: 1 / t),
            ("(t + 0.99*sin(t))", 0.0, 9.0, lambda t: t + 0.99 * math.sin(t)),
            ("log(t)", 0.01, 1.0, math.log),
            ("(t^3 + 0.001*t)", -1.0, 1.0, lambda t: t**3 + 0.001 * t),
        ]
        text, a, b, value = self.chance.choice(kinds)
        b = float(f"{b:.4g}")
        first, last = value(a), value(b)
        slope = float(f"{(high - low) / (last - first):.6g}")
        start = low - slope * first
        return f"({digits(start, 6)} + {digits(slope, 6)}*{text})", f"{a:g}", f"{b:g}", text


def draw(seed: int) -> Case:
    """The curve of a seed.

    >>> draw(1) == draw(1)
    True
    """
    return Draw(seed).case()


@dataclass(frozen=True)
class Outcome:
    """What became of a curve.

    Attributes:
        verdict: "within", or what is wrong, or why there is nothing to measure.
        pieces: how many.
        excess: the largest true error in tolerances.
        untold: the largest true error in reported ones.
        seconds: CPU seconds that the approximation took.
        sentence: of a refusal or a failure.
    """

    verdict: str
    pieces: int = 0
    excess: float = math.nan
    untold: float = math.nan
    seconds: float = 0.0
    sentence: str = ""

    @property
    def fails(self) -> bool:
        """Whether something is wrong with the tool."""
        return self.verdict in FAILURES


def try_out(case: Case) -> Outcome:
    """Approximate a curve and measure every piece."""
    began = time.process_time()
    try:
        spline = osc.approximate(osc.curve(case.text, case.low, case.high), case.primitive, case.tolerance)
    except osc.OsculantError as error:
        return Outcome("refused", seconds=time.process_time() - began, sentence=str(error))
    except Exception:
        return Outcome("TRACEBACK", sentence=traceback.format_exc().splitlines()[-1])
    spent = time.process_time() - began
    return measured(case, spline.to_json()["segments"], spent)


def measured(case: Case, segments: list[dict], spent: float) -> Outcome:
    """What became of a curve with these pieces."""
    formula = Formula(case.text, case.low, case.high)
    a, b = segments[0]["interval"][0], segments[-1]["interval"][1]
    try:
        edges = formula.parts(a, b, RESOLVED * case.tolerance)
    except GaveUpError:
        return Outcome("unmeasured", len(segments), seconds=spent, sentence="too many parts")
    unit = math.ulp(float(abs(formula.points(edges)).max()))

    def errors(segment: dict, density: int) -> tuple[float, float]:
        """The error in tolerances and in reported errors."""
        told = segment["error"]
        slack = (ROUNDING if told else FLOOR) * unit + SLACK * case.tolerance
        found = max(0.0, distance(formula, segment, edges, density) - slack)
        beyond = max(0.0, found - UNRESOLVED * case.tolerance) if told else found
        return found / case.tolerance, beyond / told if told else (math.inf if found else 0.0)

    seen = [errors(segment, 1) for segment in segments]
    doubtful = {max(range(len(seen)), key=lambda i: seen[i][which]) for which in (0, 1)}
    doubtful |= {i for i, (one, other) in enumerate(seen) if one > EXCESS - NEAR or other > HONEST - NEAR}
    for i in doubtful:
        for density in AGAIN:
            seen[i] = errors(segments[i], density)
            if seen[i][0] <= EXCESS and seen[i][1] <= HONEST:
                break
    excess, untold = (max(found[which] for found in seen) for which in (0, 1))
    verdict = "EXCESS" if excess > EXCESS else "UNTOLD" if untold > HONEST else "within"
    return Outcome(verdict, len(segments), excess, untold, spent)


def line_of(case: Case, outcome: Outcome) -> str:
    """A line of the record."""
    numbers = f"{outcome.pieces:5d} {outcome.excess:11.8f} {outcome.untold:11.8f} {outcome.seconds:6.2f}"
    shown = f"{case.seed:6d} {outcome.verdict:10s} {numbers} {case.primitive:8s} {case.kind}"
    if outcome.fails:
        shown += f"\n       {case.question}"
    return shown + (f"\n       {outcome.sentence}" if outcome.sentence else "")


def warm() -> None:
    """Compile the kernels, which is nobody's time."""
    for primitives, text in ((PLANE, "t, t^2 + t^3"), (SPACE, "t, t^2, t^3")):
        for primitive in primitives:
            osc.approximate(osc.curve(text, 1, 2), primitive, 1e-2)


def recorded(path: Path) -> list[list[str]]:
    """The words of a record's lines, one line for each curve."""
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    return [line.split() for line in lines if line[:6].strip().isdigit()]


def summary(path: Path) -> str:
    """What a record says in all."""
    rows = recorded(path)
    verdicts = Counter(row[1] for row in rows)
    measured_rows = [row for row in rows if row[3] != "nan"]
    worst, untold = (max(float(row[column]) for row in measured_rows) for column in (3, 4))
    told = ", ".join(f"{count} {verdict}" for verdict, count in verdicts.most_common())
    return (
        f"{len(rows)} curves, {sum(int(row[2]) for row in rows)} pieces: {told}; largest error {worst:.8f} "
        f"tolerances and {untold:.8f} times what was reported"
    )


def tried(seed: int) -> str:
    """The line of a seed."""
    case = draw(seed)
    return line_of(case, try_out(case))


def main(path: Path, last: int, processes: int = 1) -> int:
    """Go on with a record up to the seed ``last`` − 1; returns the exit status."""
    seeds = range(len(recorded(path)), last)
    workers = ProcessPoolExecutor(processes, get_context("spawn"), initializer=warm)
    with path.open("a", encoding="utf-8") as record, workers as pool:
        for line in pool.map(tried, seeds):
            record.write(line + "\n")
            record.flush()
    print(summary(path))
    return int(any(row[1] in FAILURES for row in recorded(path)))


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), *map(int, sys.argv[2:])))
