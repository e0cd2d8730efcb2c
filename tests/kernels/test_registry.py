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


def test_every_family_is_there():
    families = {path.parent.name for path in jit.ROOM.glob("*/records.py")}
    assert families == {record.__module__.split(".")[-2] for record in RECORDS}
    assert {"conics", "biarcs", "bihelices"} <= families


@EACH
def test_what_has_no_default_is_done(record):
    done = operations.registered()[record]
    needed = {name for name, stub in operations.operations().items() if not has_body(stub)}
    needed -= {name for name, other in UNLESS.items() if other in done}
    assert needed <= set(done)
    assert set(done) <= set(operations.operations())


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
    assert jit.family_of(record.__module__) == record.__module__.split(".")[-2]
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
