"""The class of a germ in the lists: candidates by their keys, then an explicit equivalence as the proof.

A row of a list is determined by its jet of degree k. If the k-jet of a germ is equivalent to that of the row,
so is the germ. No determinacy of the germ need be known for that, nor its codimension: both follow.
That a germ is on none of the lists is told only where every row is excluded, by exact parts of keys that
differ or by an equivalence that fails, among those with the codimension of the germ, which is proved too.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Literal

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import exact
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version, group
from osculant.cas.germs.linear import rank
from osculant.cas.germs.search import Patience
from osculant.cas.germs.tangent import JetSpace
from osculant.cas.germs.tangent_space import tangent
from osculant.cas.recognition.answer import Recognition
from osculant.cas.recognition.catalogue import catalogue, forms_up_to
from osculant.cas.recognition.equivalence import Equivalence, NotEquivalent, equivalence
from osculant.cas.recognition.forms import Form
from osculant.cas.recognition.keys import Key, part, parts, version_of
from osculant.cas.recognition.members import arranged, members, special_members
from osculant.cas.recognition.names import called

#: orders of jets, and their columns, in which keys are compared at most
ORDER, COLUMNS = 40, 800
#: seconds for the codimension of a germ that is known to be in no list
SHORT = 1.0
#: order of the jets by which rows are excluded
LOW = 6
#: columns of the jets in which equivalences are sought at most
REACH = 3000
#: after so many orders in each of which the codimension has grown, it is asked for as a whole
GROWTH = 8


def recognise(germ: Germ, name: str | Group | None = None, patience: Patience | None = None) -> Recognition:
    """The class of a germ in the lists for a group.

    Args:
        germ: the germ.
        name: the group; by default A, for a function R, with (H) if there is a boundary variable.
        patience: the time that it may take; `search.SECONDS` by default.

    Raises DomainError for an (H) group without a boundary variable. What is not decided in time is told so.

    >>> recognise(Germ("x, y**2 + x**2, y**3 + x**2*y + y**4", "x y")).name
    'S1+'
    >>> recognise(Germ("x, x*y + y**6", "x y")).name
    'xy+y^6'
    """
    if name is None:
        name = ("R" if germ.p == 1 else "A") + ("" if germ.boundary is None else "(H)")
    g = group(name)
    if g.source == "boundary":
        germ.boundary_index  # noqa: B018  (refuses a germ without H)
    return _Question(germ, g, patience or Patience()).answer()


@dataclass
class _Question:
    germ: Germ
    group: Group
    patience: Patience
    alike: list[Form] = field(default_factory=list)
    unbuilt: list[Form] = field(default_factory=list)
    seen: set[Form] = field(default_factory=set)
    order: int = 2
    size: int | None = None
    unclear: str = ""

    def answer(self) -> Recognition:
        self.listings = catalogue(self.group, self.germ.n, self.germ.p)
        if not self.listings:
            return self._none(
                f"There is no list for {self.group.name} of germs of {self.germ.n} variable"
                f"{'s' * (self.germ.n > 1)} with "
                f"{self.germ.p} component{'s' * (self.germ.p > 1)}."
            )
        regular = _regular(self.germ, self.group)
        if regular is not None:
            return self._none(regular, size=0)
        try:
            return self._met() or self._refused()
        except UndecidedError as error:
            return self._none(str(error), undecided=True)

    def _met(self) -> Recognition | None:
        """The class that is found on the way up the orders of jets, as long as they are cheap.

        ``self.size`` is then the codimension, if it is settled, or a bound that the lists do not reach.
        """
        grown, last = 0, -1
        for order in self._orders():
            self.order = order
            sizes = part(self.germ, self.group, "orbit", order)
            grown, last = (grown + 1 if sizes[order] > last else 0), sizes[order]
            if sizes[order] == sizes[order - 1]:
                found = self._among(sizes[order])
                if found is not None:
                    return found
                if self._settled():
                    self.size = sizes[order]
                    return self._among(self.size, any_moduli=True)
            elif self._beyond(sizes[order]) or grown >= GROWTH:
                break
        return None

    def _orders(self) -> Iterator[int]:
        order = 2
        while order <= ORDER and JetSpace(self.germ.n, self.germ.p, order).columns <= COLUMNS:
            if self.patience.left() < 0:
                return
            yield order
            order += max(1, order // 6)

    def _settled(self) -> bool:
        """Whether the codimension in the jets is that of the germ (`osculant.cas.germs.codimension`)."""
        g, version, bound = self.group, version_of(self.germ, self.group), 1
        if g.target == "left":
            contact = Group(g.name, g.source, "contact", g.fields)
            found = tangent(self.germ, contact, Version.EXTENDED, self.order)
            if not found.settled(1):
                return False
            bound = found.depth + 1
        return tangent(self.germ, g, version, self.order).settled(bound)

    def _beyond(self, size: int) -> bool:
        """Whether the lists are finite and no row has an orbit of that codimension or more."""
        return all(listing.finite for listing in self.listings) and all(
            entry.value(listing.size) < size for listing in self.listings for entry in listing.entries
        )

    def _among(self, size: int, any_moduli: bool = False) -> Recognition | None:
        """The class among those with orbits of that size; with any moduli, whatever the key of others is."""
        every = [form for listing in self.listings for form in listing.forms(size, self.germ.n)]
        fitting = self._fitting([form for form in every if form not in self.seen])
        if any_moduli:
            fitting += [f for f in every if special_members(f) and f not in {*self.seen, *fitting}]
        for form in fitting:
            self.seen.add(form)
            try:
                if JetSpace(self.germ.n, self.germ.p, form.order).columns > REACH:
                    raise UndecidedError(f"An equivalence of jets of order {form.order} is out of reach.")
                found = equivalence(arranged(self.germ, form), form)
            except NotEquivalent as obstruction:
                if self._same_key(form):  # no proof that it is another class
                    self.alike.append(form)
                    self.unclear = f"No equivalence is known: {obstruction}"
            except (UndecidedError, DomainError) as error:
                self.alike.append(form)
                self.unbuilt.append(form)
                self.unclear = f"No equivalence is known: {error}"
            else:
                return self._told(form, found, size)
        return None

    def _fitting(self, forms: list[Form]) -> list[Form]:
        """The forms whose keys are the germ's; parts are compared only while several are left."""
        left = [form for form in forms if self._agrees(form, "orbit")]
        for title in parts(self.germ, self.group):
            if title != "orbit" and len(left) > 1:
                left = [form for form in left if self._agrees(form, title)]
        return left

    def _same_key(self, form: Form) -> bool:
        return all(self._agrees(form, title) for title in parts(self.germ, self.group))

    def _agrees(self, form: Form, title: str) -> bool:
        """Whether a part of the key is that of a member, in these jets and in those that tell the form."""
        return all(self._agrees_in(order, form, title) for order in sorted({self.order, form.order}))

    def _agrees_in(self, order: int, form: Form, title: str) -> bool:
        if order < self.order or JetSpace(self.germ.n, self.germ.p, order).columns > COLUMNS:
            return True
        try:
            mine = part(self.germ, self.group, title, order)
            return any(part(member, self.group, title, order) == mine for member in members(form))
        except (DomainError, UndecidedError):
            return True

    def _refused(self) -> Recognition:
        """No class was found: none there is if that is proved, else it is undecided."""
        sizes = part(self.germ, self.group, "orbit", self.order)
        if self._beyond(sizes[self.order]):
            return self._none(f"Its codimension is {sizes[self.order]} or more, beyond the lists.")
        if self.size is None:
            extended = version_of(self.germ, self.group) is Version.EXTENDED
            apart = self._apart()
            left = max(self.patience.left(), 0.0)
            try:
                whole = codimension(
                    self.germ, self.group, extended, Patience(min(left, SHORT) if apart else left)
                )
            except UndecidedError as error:
                if apart:
                    return self._none("No class has the codimensions of its jets of low orders.")
                return self._none(f"No class was found, and {_lowered(error)}", undecided=True)
            if not isinstance(whole.value, int):
                return self._none(f"Its codimension is infinite: {whole.proof}.", size=whole.value)
            assert whole.tangent is not None
            self.size, self.order = whole.value, max(self.order, 1 + whole.tangent.plain_depth)
            found = self._among(self.size, any_moduli=True)
            if found is not None:
                return found
        if self.alike:
            return self._by_key() or self._none(self.unclear, undecided=True, size=self.size)
        names = " or ".join(listing.name for listing in self.listings)
        return self._none(
            f"Every class of {names} with its codimension, if there is one, is another.", size=self.size
        )

    def _apart(self) -> bool:
        """Whether the codimensions in the jets already exclude every row, whatever its integers.

        Integers are exponents: rows with larger ones than the order have the same jets.
        """
        order = min(self.order, LOW)
        mine = part(self.germ, self.group, "orbit", order)
        for listing in self.listings:
            for entry in listing.entries:
                rows = forms_up_to(entry, order, self.germ.n)
                if rows is None:
                    return False
                for form in rows:
                    if special_members(form):
                        if mine[-1] <= entry.value(listing.size, **dict(form.integers), **form.entry.usual):
                            return False
                    elif any(part(m, self.group, "orbit", order) == mine for m in members(form)):
                        return False
        return True

    def _by_key(self) -> Recognition | None:
        """A function with the key of rows of one name over ℂ, to one of which no equivalence is built."""
        left = [form for form in self.alike if self._same_key(form)]
        names = {called(form, None, None) for form in left}
        if len(names) != 1 or not set(left) & set(self.unbuilt) or self.germ.p > 1 or self.size is None:
            return None
        form = next((form for form in left if not form.entry.complex), left[0])
        size = self._plain(self.size)
        return Recognition(
            self.germ, self.group, self._names(), form, None, size, self._key(), self.unclear, False
        )

    def _told(self, form: Form, found: Equivalence, size: int) -> Recognition:
        return Recognition(
            self.germ, self.group, self._names(), form, found, self._plain(size), self._key(), "", False
        )

    def _none(
        self, reason: str, undecided: bool = False, size: int | Literal["infinite"] | None = None
    ) -> Recognition:
        return Recognition(
            self.germ,
            self.group,
            self._names(),
            codimension=size if isinstance(size, str) else self._plain(size),
            key=self._key(),
            reason=reason,
            undecided=undecided,
            alike=tuple(called(form, None, None) for form in self.alike),
        )

    def _names(self) -> tuple[str, ...]:
        return tuple(listing.name for listing in self.listings)

    def _plain(self, size: int | None) -> int | None:
        """The codimension of T G f in Mθ from that in the key."""
        if size is None or version_of(self.germ, self.group) is not Version.EXTENDED or size == 0:
            return size
        return size + self.germ.n - (2 if self.group.source == "boundary" else 1)

    def _key(self) -> Key | None:
        known = ((k, v) for k, v in self.germ.known.items() if isinstance(k, tuple) and k[0] == "key")
        found = {k[2]: v for k, v in known if k[1] == self.group and k[3] == self.order}
        return Key(self.group.name, self.order, found) if found else None


def _lowered(error: Exception) -> str:
    text = str(error)
    return text[:1].lower() + text[1:]


def _regular(germ: Germ, g: Group) -> str | None:
    """What a germ without singularity is; None for others, and where lists have such germs."""
    n, p = germ.n, germ.p
    if g.name == "A" and germ.rank == min(n, p):
        kind = "a diffeomorphism" if n == p else "an immersion" if n < p else "a submersion"
        return f"It is {kind}: the lists name singular germs alone."
    if p > 1 or g.target == "left":
        return None
    place = germ.boundary_index if g.source == "boundary" else None
    slopes = [exact(germ.jet(1)[0].get(poly.variable(i, n), 0)) for i in range(n) if i != place]
    if slopes and rank([slopes], len(slopes)):
        where = "" if place is None else " on H"
        return f"It has no critical point{where}: the lists name singular germs alone."
    return None
