"""A walk over the registry of fits: nothing is half attached."""

import ast
import importlib
import inspect
import textwrap

import pytest

from osculant.kernels import jit, operations
from osculant.kernels.conics.records import Conic
from osculant.kernels.operations import SHAPE, Rules

for path in jit.ROOM.glob("**/*.py"):
    parts = [part for part in path.relative_to(jit.ROOM).with_suffix("").parts if part != "__init__"]
    importlib.import_module(".".join([jit.PACKAGE, *parts]))

RECORDS = list(operations.registered())
EACH = pytest.mark.parametrize("record", RECORDS, ids=lambda record: record.__name__)
#: operations without a default body that a fit may leave out if it does the other one
UNLESS = {"density": "content"}


def has_body(stub):
    """Whether a stub does something where a fit does not: there is more than its docstring."""
    (function,) = ast.parse(textwrap.dedent(inspect.getsource(stub))).body
    return len(function.body) > 1


def parameters(function):
    """The parameters of a stub, or of a kernel's function."""
    return list(inspect.signature(getattr(function, "__wrapped__", function)).parameters.values())


def test_stubs_with_a_default_are_seen():
    defaults = {name for name, stub in operations.operations().items() if has_body(stub)}
    assert defaults == {"renew", "resume", "settle", "content"}
    assert {*UNLESS, *UNLESS.values()} <= set(operations.operations())


def owner(stub):
    """The family whose own an operation is, None of those of generic kernels."""
    family = jit.family_of(stub.__module__)
    return None if family == "generic" else family


def family(record):
    """The family of a record."""
    return record.__module__.split(".")[-2]


def test_every_family_is_there():
    families = {path.parent.name for path in jit.ROOM.glob("*/records.py")}
    assert families == {family(record) for record in RECORDS}
    assert {"conics", "biarcs", "bihelices", "polygons", "cubics"} <= families


@EACH
def test_what_has_no_default_is_done(record):
    done = operations.registered()[record]
    every = operations.operations()
    needed = {name for name, stub in every.items() if owner(stub) is None and not has_body(stub)}
    needed -= {name for name, other in UNLESS.items() if other in done}
    assert len(needed) >= 10
    assert needed <= set(done) <= set(every)
    assert {owner(every[name]) for name in done} <= {None, family(record)}


def test_what_is_a_familys_own_is_done_in_it():
    for name, stub in operations.operations().items():
        if owner(stub) is not None:
            does = {family(record) for record in RECORDS if name in operations.registered()[record]}
            assert does == {owner(stub)}


@EACH
def test_operations_are_given_their_arguments(record):
    for name, does in operations.registered()[record].items():
        takes = parameters(operations.operations()[name])
        if not callable(does):  # what is always the same can depend on nothing but the fit
            assert len(takes) == 1, name
            continue
        has = parameters(does)
        assert len(has) == len(takes), name
        assert all(parameter.default is inspect.Parameter.empty for parameter in has), name
        assert has[0].name == "fit", name


@EACH
def test_rules_are_rules(record):
    rules = operations.registered()[record]["rules"]
    found = rules(record()) if callable(rules) else rules
    assert type(found) is Rules
    assert found.order >= 2.0 and 0.0 < found.aim < 1.0 and found.stride > 1.0
    assert 1 <= found.checked <= found.careful
    assert found.turning <= operations.TURNING


@EACH
def test_records_are_named_tuples_that_the_cache_can_name(record):
    assert issubclass(record, tuple) and hasattr(record, "_fields")
    assert getattr(importlib.import_module(record.__module__), record.__name__) is record
    assert jit.family_of(record.__module__) == family(record)
    assert record.__doc__


@EACH
def test_rows_have_room_for_a_shape(record):
    columns = operations.columns(record)
    assert columns > SHAPE
    row = getattr(importlib.import_module(record.__module__), "Row", None)
    if row is not None:
        assert len(row._fields) == columns
        assert row._fields[:SHAPE] == ("a", "b", "error", "reason")


def test_doubles_are_refused():
    before = operations.registered()[Conic]
    with pytest.raises(ValueError, match=r"^The fit Conic is registered already\.$"):
        operations.register(Conic, 13, **{**before, "rules": Rules(1.0, 1.0)})
    assert operations.registered()[Conic] is before


def test_the_registry_cannot_be_written_from_outside():
    for view in (operations.registered(), operations.operations()):
        with pytest.raises(TypeError):
            view["conic"] = None
