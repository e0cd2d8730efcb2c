"""The reference lists: every number in them is computed again; families, signs and errors."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest

from osculant.cas.errors import DomainError, FormulaError, OsculantError
from osculant.cas.germs import reference as module
from osculant.cas.germs.codimension import codimension, contact_bound
from osculant.cas.germs.determinacy import determinacy
from osculant.cas.germs.entry import halved, instance
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import group
from osculant.cas.germs.local_algebra import milnor_number, q_algebra
from osculant.cas.germs.reference import NAMES, entries, reference
from osculant.cas.germs.unfolding import is_stable
from osculant.cas.germs.weights import weights
from tests.cas.germs.oracles import tjurina_number


def cases(*names):
    return [
        pytest.param(entry, signs, parameters, id=f"{entry.list}: {entry.formula(signs, **parameters)}")
        for name in names
        for entry in reference(name).entries
        for signs, parameters in entry.tried()
    ]


@pytest.mark.parametrize("entry, signs, parameters", cases(*NAMES))
def test_codimensions_and_degrees_of_determinacy(entry, signs, parameters):
    germ, n = entry.germ(signs, **parameters), len(entry.variables)
    ordinary = codimension(germ, entry.group).value
    extended = codimension(germ, entry.group, extended=True).value
    known = {"cod": ordinary, "cod_e": extended}
    for name in known.keys() & entry.values.keys():
        assert known[name] == entry.value(name, **parameters), name
    # the relations between both codimensions; u∂/∂u vanishes at 0 for the groups that preserve H
    moving = n - 1 if "(H)" in entry.group else n
    if entry.group[0] == "A":
        assert extended == max(0, ordinary - moving)
        assert is_stable(germ, entry.group) == entry.stable(**parameters)
    else:  # the constants and the translations, which are independent where f is singular
        assert ordinary == extended + moving - germ.p
    found = determinacy(germ, entry.group)
    assert found.degree == entry.value("determinacy", **parameters) and found.sharp


@pytest.mark.parametrize("entry, signs, parameters", cases("thom", "simple functions", "unimodal functions"))
def test_functions(entry, signs, parameters):
    germ = entry.germ(signs, **parameters)
    tjurina = entry.value("tjurina" if "tjurina" in entry.values else "cod_e", **parameters)
    assert milnor_number(germ) == entry.value("cod_e", **parameters)
    assert codimension(germ, "K", extended=True).value == tjurina
    assert tjurina_number(germ) == tjurina


@pytest.mark.parametrize("entry, signs, parameters", cases("boundary functions"))
def test_boundary_functions(entry, signs, parameters):
    # μ(f) + μ(f on H), of which the first is 0 where f is regular, is the codimension for R(H)_e
    germ = entry.germ(signs, **parameters)
    assert codimension(germ, "K(H)", extended=True).value == entry.value("tjurina", **parameters)
    others = [name for name in entry.variables if name != entry.boundary]
    restricted = instance(entry.formula(signs, **parameters), None, {entry.boundary: "0"})
    numbers = [germ, Germ(restricted, others)]
    regular = any(germ.jet(1))
    assert sum(map(milnor_number, numbers[regular:])) == entry.value("cod_e", **parameters)


@pytest.mark.parametrize("entry, signs, parameters", cases("simple icis"))
def test_milnor_numbers_of_complete_intersections(entry, signs, parameters):
    germ, milnor = entry.germ(signs, **parameters), entry.value("milnor", **parameters)
    if germ.n == germ.p:
        assert q_algebra(germ).dimension == milnor + 1
    else:  # of curves that are quasi-homogeneous: Greuel
        assert codimension(germ, "K", extended=True).value == milnor and weights(germ) is not None


@pytest.mark.parametrize("entry, signs, parameters", cases("table 6.2"))
def test_stable_germs(entry, signs, parameters):
    germ = entry.germ(signs, **parameters)
    assert is_stable(germ, "A(H)")
    assert contact_bound(germ, group("A(H)")) == entry.value("bound")


@pytest.mark.parametrize("entry, signs, parameters", cases("table 6.1"))
def test_secant_germs(entry, signs, parameters):
    listed, made = entry.projected(signs, **parameters), entry.projected_secant(signs, **parameters)
    assert is_stable(entry.germ(signs, **parameters), "A(H)")
    wanted = entry.value("cod_projection", **parameters)
    assert codimension(listed, "A").value == codimension(made, "A").value == wanted


@pytest.mark.parametrize("entry", reference("table 6.1").entries, ids=lambda e: e.id)
def test_strata_of_secant_germs_occur_generically(entry):
    n = int(entry.id.split("-")[0])
    codimension_of_stratum = entry.value("cod_projection", **dict(next(entry.tried())[1])) - (n - 2)
    moduli = sum(parameter.least is None for parameter in entry.parameters)
    assert codimension_of_stratum - moduli <= 3 == 2 + 1  # points of the surface and directions at them


def test_pitfalls():
    stalled = Germ("x, x*y + y**6", "x y")
    found = codimension(stalled, "A", extended=True)
    assert found.value == 6 and found.certificate()["kind"] == "annihilator"
    assert codimension(Germ("x, y**2, 0", "x y"), "A", extended=True).value == "infinite"
    assert determinacy(Germ("x, y**2, 0", "x y"), "A").degree == "infinite"


@pytest.mark.parametrize("c", ["0", "1/2", "1", "3/2"])
def test_excluded_values_of_a_modulus(c):
    entry = reference("table 6.1")["4-P_3"]
    with pytest.raises(DomainError, match="degenerates"):
        entry.germ(c=c)


def test_a_germ_between_two_values_of_the_list():
    assert codimension(reference("rieger")["4_k"].germ((-1,), k=9), "A", extended=True).value == 8
    assert codimension(reference("plane curves")["A_2k"].germ(k=12), "A", extended=True).value == 12


@pytest.mark.parametrize("n", [1, 2, 3])
def test_adding_squares_keeps_the_milnor_number(n):
    text, names = "x**4", ["x", "y", "z"][:n]
    germ = Germ(" + ".join([text, *(f"{name}**2" for name in names[1:])]), names)
    assert codimension(germ, "R", extended=True).value == 3
    assert codimension(germ, "R").value == 3 + n - 1


def test_every_list_has_title_source_and_entries():
    assert len(entries()) == sum(len(reference(name).entries) for name in NAMES) >= 270
    germs = {(e.list, e.formula(None, **parameters)) for e in entries() for _, parameters in e.tried()}
    assert len(germs) >= 440  # without their signs
    for name in NAMES:
        found = reference(name)
        assert found.title and re.search(r"\b(19|20)\d\d\b", found.source)
        identifiers = [entry.id for entry in found.entries]
        assert len(set(identifiers)) == len(identifiers)
        assert reference(name.replace(" ", "_").upper()) is found


def test_every_germ_has_its_numbers():
    for entry in entries():
        assert {"cod", "cod_e", "determinacy"} <= entry.values.keys(), entry.id
        assert set(entry.computed) <= entry.values.keys(), entry.id
        assert set(entry.printed_values) <= entry.values.keys(), entry.id


@pytest.mark.parametrize("name", NAMES)
def test_every_germ_of_a_list_has_its_own_name(name):
    owners = {}
    for entry in reference(name).entries:
        for signs, parameters in entry.tried():
            called = entry.called(signs, **parameters)
            assert not set(called) & set("{}±_ ") or "_" in entry.id, called
            assert owners.setdefault(called, (entry.id, parameters)) == (entry.id, parameters)


def test_names():
    names = reference("unimodal functions")["X_9+k"]
    assert names.called((1, -1), k=2, a="-4/2") == "X11+-(-2)"
    assert reference("space curves")["3,3k+1,3l+2"].called(k=2, l=3) == "3,7,11"
    assert reference("simple functions")["A_k"].called((1, -1), k=3) == "A3"  # no signs in the name
    with pytest.raises(DomainError, match="takes 1 signs"):
        reference("mond")["S_k"].called((1, 1), k=1)


def test_every_file_of_data_is_a_list():
    files = {path.stem for path in Path(module.__file__).parent.joinpath("data").glob("*.toml")}
    assert files == {re.sub(r"[ .]", "_", name) for name in NAMES} and len(set(NAMES)) == len(NAMES)


def test_nothing_is_decided_by_the_lists():
    own = {"reference.py", "entry.py"}
    for path in Path(module.__file__).parent.glob("*.py"):
        text = path.read_text("utf-8")
        assert path.name in own or not re.search(r"germs(\.| import )(reference|entry)\b", text), path.name


def test_lists_without_a_source_or_with_doubles_are_refused():
    found = reference("thom")
    with pytest.raises(DomainError, match="'thom' has no source"):
        replace(found, source=" ")
    with pytest.raises(DomainError, match=f"two entries {found.entries[0].id!r}"):
        replace(found, entries=(*found.entries, found.entries[0]))
    with pytest.raises(DomainError, match="two entries called 'A2': rename one"):
        replace(found, entries=(*found.entries, replace(found.entries[0], id="fold")))


def test_tables_list_what_is_printed():
    printed = {e.id: e.printed for e in reference("table 6.2").entries if e.printed}
    assert printed.keys() == {"3a", "3f", "3g"}
    for identifier, text in printed.items():
        assert text != reference("table 6.2")[identifier].text
        for signs in [(1,) * text.count("±"), (-1,) * text.count("±")]:
            Germ(instance(text, signs, {}), "x1 x2 x3 u")
    assert sum(e.value("classes") for e in reference("table 6.2").entries if e.id[0] in "23456") == 33


def test_families():
    s = reference("mond")["S_k"]
    assert s.signs == ((1,), (-1,))
    assert s.germ((-1,), k=2).jet(4) == Germ("x, y^2, y^3 - x^3*y", "x y").jet(4)
    assert s.value("cod", k=7) == 9
    modular = reference("rieger")["8"]
    expected = Germ("x, x*y + y^6 - y^8 + 2/3*y^9", "x y")
    assert modular.germ((-1,), alpha="2/3").jet(9) == expected.jet(9)


def test_only_whole_names_are_replaced():
    assert instance("k*k1 + xk ± kk", (1,), {"k": "(2)"}) == "(2)*k1 + xk + kk"


@pytest.mark.parametrize(
    "make, message",
    [
        (lambda: reference("riegel"), "no reference list 'riegel'"),
        (lambda: reference("rieger")["99"], "no entry '99'"),
        (lambda: reference("simple functions")["D_k"].germ(k=3), "from 4"),
        (lambda: reference("simple functions")["D_k"].germ(k="9/2"), "from 4"),
        (lambda: reference("simple functions")["D_k"].germ(k="four"), "not a rational"),
        (lambda: reference("simple functions")["D_k"].germ(), "takes k; given: none"),
        (lambda: reference("simple functions")["E_8"].germ(k=8), "takes no parameters; given: k"),
        (lambda: reference("simple functions")["D_k"].germ((1, 1), k=4), "takes 1 signs"),
        (lambda: reference("simple functions")["D_k"].germ((2,), k=4), "each 1 or -1"),
        (lambda: reference("rieger")["5"].value("milnor"), "no 'milnor'"),
        (lambda: reference("simple functions")["E_8"].stable(), "a list for R: only germs for A"),
        (lambda: reference("space curves")["3,3k+1,3l+2"].germ(k=2, l=4), "k = 2, l = 4 is out of the range"),
        (lambda: reference("plane curves")["E_6k,p"].value("cod", k=3, p=2), "k - 2 - p must be at least 0"),
        (lambda: reference("rieger")["5"].projected(), "no projections"),
        (lambda: reference("rieger")["5"].projected_secant(), "no secant germ"),
        (lambda: halved(Germ("v, l**3", "v l"), "l"), "which is odd in l: a germ even"),
        (lambda: halved(Germ("v, cos(l) - 1", "v l"), "l"), "must be a polynomial of degree"),
    ],
)
def test_errors(make, message):
    with pytest.raises(DomainError, match=message):
        make()


def test_text_in_parameters_is_never_run():
    with pytest.raises(OsculantError):
        reference("rieger")["8"].germ(alpha="__import__('os')")
    with pytest.raises(FormulaError):
        Germ(instance("x*k", None, {"k": "(open(x))"}), "x")


def test_halving():
    found = halved(Germ("v, l**4 + v*l**2", "l v"), "l")
    assert found.source == ("u", "v") and found.boundary == "u"
    assert found.jet(4) == Germ("v, u**2 + v*u", "u v").jet(4)
