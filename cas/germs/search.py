"""How long a question is pursued: orders of jets as long as they are cheap, and the geometry beside them.

Memory bounds the number of columns of a matrix, `Patience` the time: an order is not begun if it is expected
to take longer than what is left.
"""

from __future__ import annotations

import time
from collections.abc import Iterator

from osculant.cas.germs.geometry import Degeneration, Geometry
from osculant.cas.germs.polynomials import LARGEST
from osculant.cas.germs.processes import processor_time
from osculant.cas.germs.tangent import JetSpace

#: seconds of processor time that a question may take by default
SECONDS = 10.0
#: columns of the largest matrix made
COLUMNS = 60000
#: columns above which weights of the variables are used where the germ has some
GRADED = 3000
#: a proof of "infinite" is looked for when the codimension has grown in so many orders one after the other,
#: or is not settled after so many orders, or after so many seconds
GROWTH, LATE, SOON = 6, 8, 0.4
#: the share of the time after which it is looked for where orders are light
SHARE = 0.25
#: after so many seconds, or `LATE` orders, its answer is waited for, once, for so many seconds
SLOW, FIRST = 1.0, 1.0
#: seconds after which a wait looks at the time that the other process took
GLANCE = 0.25


class Patience:
    """A number of seconds of processor time, of this process and those that help it, which pass from now on.

    >>> Patience(3600).left() > 3500
    True
    """

    def __init__(self, seconds: float = SECONDS) -> None:
        self.seconds, self.begun = seconds, processor_time()

    def spent(self) -> float:
        """The seconds that are over."""
        return processor_time() - self.begun

    def left(self) -> float:
        """The seconds that are left."""
        return self.seconds - self.spent()

    def wait(self, geometry: Geometry, seconds: float = float("inf")) -> Degeneration | None:
        """Wait for the geometry so many seconds, and no longer than there is time."""
        until = time.monotonic() + min(seconds, self.left())
        found = geometry.result(0)
        while not geometry.over and (rest := min(until - time.monotonic(), self.left())) > 0:
            found = geometry.result(min(rest, GLANCE))
        return found


class Search:
    """The orders of jets tried for one question, and the proof that the answer is "infinite".

    Args:
        n: the number of variables of the jets.
        p: the number of their components.
        geometry: the search for that proof; None if there is none.
        patience: the time.
        weights: of the variables; without, orders count degrees.

    Attributes:
        order: the last order tried.
        proof: that the answer is "infinite", once it is found.
        cost: the seconds that the last order took; who finds it known already tells what it took then.
        least: no order below is worth a try.
        light: whether orders are seen modulo a prime: a wider one takes little more, and geometry can wait.
    """

    def __init__(
        self, n: int, p: int, geometry: Geometry | None, patience: Patience, weights: tuple[int, ...] = ()
    ) -> None:
        self.n, self.p, self.geometry, self.patience, self.weights = n, p, geometry, patience, weights
        self.order, self.next, self.least, self.expected = 0, 1, 1, 0.0
        self.proof: Degeneration | None = None
        self.light = False
        self.last, self.times, self.seen, self.asked, self.cost = -1, 0, 0, False, 0.0

    def orders(self, limit: int = COLUMNS, highest: int = LARGEST) -> Iterator[int]:
        """Orders, further and further apart, while time, the limit of columns and the proof allow."""
        order = self.next
        while order + max(self.weights, default=1) <= highest:
            columns = JetSpace(self.n, self.p, order, self.weights).columns
            if columns > limit or self.expected > self.patience.left():
                return
            begun, self.cost = time.process_time(), 0.0
            yield order
            self.order = order
            if self.proof is not None:
                return
            self.cost = max(self.cost, time.process_time() - begun)
            following = max(order + max(1, order // 6), self.least)
            wider = JetSpace(self.n, self.p, following, self.weights).columns / columns
            self.next = following
            beside = 2 if self.geometry is not None and self.geometry.running else 1  # it takes as much
            self.expected = self.cost * (wider if self.light else wider**2) * beside
            order = following

    def grown(self, codimension: int) -> bool:
        """Take notice of the codimension in one more order; whether it is proved infinite by now."""
        self.times = self.times + 1 if codimension > self.last else 0
        self.last, self.seen = codimension, self.seen + 1
        if self.geometry is None or self.geometry.over:
            return self.proof is not None
        spent = self.patience.spent()
        soon = SHARE * self.patience.seconds if self.light else 0.0
        if self.times >= GROWTH or self.seen >= LATE or spent > max(SOON, soon):
            self.geometry.start()
        if self.seen >= LATE or spent > max(SLOW, soon):
            # as long as the last order took, the first time longer
            wait = max(self.cost, 0.0 if self.asked else FIRST)
            self.proof = self.patience.wait(self.geometry, wait)
            self.asked = True
        return self.proof is not None
