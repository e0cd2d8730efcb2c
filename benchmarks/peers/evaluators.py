"""Who evaluates derivatives and invariants at many parameters: osculant, C by hand, and generators."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
import tempfile
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import osculant as osc
from benchmarks.peers.contest import AbsentError, Job, installed
from benchmarks.peers.formulas import CURVES, invariants
from osculant.codegen.blocks import compile_blocks
from osculant.codegen.c.jets import jet_function
from osculant.codegen.jets import compile_jet
from osculant.kernels.curves.invariants import COLUMNS, invariants_at
from osculant.kernels.curves.jets import sample_many

#: derivatives, and parameters: few enough for the second cache
ORDER, COUNT = 5, 4000
FLAGS = ("-O3", "-march=native", "-shared", "-fPIC", "-lm")
#: of what invariants are compared, the columns that osculant has
COMPARED = ("curvature", "affine_curvature", "affine_curvature_slope")

#: jets of order 5 as one would write them by hand: one sine and one cosine
BY_HAND = {
    "spiral": """
    double s = sin(t), c = cos(t), a = t * s, b = t * c;
    double x[6] = {b, c - a, -2 * s - b, -3 * c + a, 4 * s + b, 5 * c - a};
    double y[6] = {a, s + b, 2 * c - a, -3 * s - b, -4 * c + a, 5 * s + b};
""",
    "sextic": """
    double s1 = sin(2 * t / 3), c1 = cos(2 * t / 3);
    double s2 = 2 * s1 * c1, c2 = c1 * c1 - s1 * s1, s3 = s1 * c2 + c1 * s2, c3 = c1 * c2 - s1 * s2;
    double x[6], y[6], f = 2.0 / 3, p = 0.375, q = 0.375, r = 0.125;
    x[0] = r + p * c1 + q * c2 + r * c3; y[0] = p * s1 + q * s2 + r * s3;
    p *= f; q *= 2 * f; r *= 3 * f;
    x[1] = -p * s1 - q * s2 - r * s3; y[1] = p * c1 + q * c2 + r * c3;
    p *= f; q *= 2 * f; r *= 3 * f;
    x[2] = -p * c1 - q * c2 - r * c3; y[2] = -p * s1 - q * s2 - r * s3;
    p *= f; q *= 2 * f; r *= 3 * f;
    x[3] = p * s1 + q * s2 + r * s3; y[3] = -p * c1 - q * c2 - r * c3;
    p *= f; q *= 2 * f; r *= 3 * f;
    x[4] = p * c1 + q * c2 + r * c3; y[4] = p * s1 + q * s2 + r * s3;
    p *= f; q *= 2 * f; r *= 3 * f;
    x[5] = -p * s1 - q * s2 - r * s3; y[5] = p * c1 + q * c2 + r * c3;
""",
}
HAND = """#include <math.h>
void many(long n, const double *at, double *out) {{
  for (long i = 0; i < n; i++) {{
    double t = at[i];{body}
    for (int k = 0; k < 6; k++) {{ out[k * n + i] = x[k]; out[(k + 6) * n + i] = y[k]; }}
  }}
}}
"""
EMITTED = """#include <math.h>
{jet}
void many(long n, const double *at, double *out) {{
  for (long i = 0; i < n; i++) {{
    double row[12];
    jet(at[i], 0, row);
    for (int k = 0; k < 12; k++) out[k * n + i] = row[k];
  }}
}}
"""
CASADI = """#include "{file}"
void many(long n, const double *at, double *out) {{
  double w[4096];
  casadi_int iw[256];
  for (long i = 0; i < n; i++) {{
    const double *arg[1] = {{at + i}};
    double *res[3] = {{out + 3 * i, out + 3 * i + 1, out + 3 * i + 2}};
    f(arg, res, iw, w, 0);
  }}
}}
"""
SYMFORCE = """#include <cmath>
#include "{file}"
extern "C" void many(long n, const double *at, double *out) {{
  for (long i = 0; i < n; i++) {{
    double *row = out + 3 * i;
    sym::Invariants<double>(at[i], row, row + 1, row + 2);
  }}
}}
"""


def curve(name: str) -> Any:
    """One of the curves."""
    return osc.curve(*CURVES[name][0])


def times(name: str) -> Any:
    """Parameters of a curve."""
    return np.linspace(*curve(name).interval, COUNT)


def compiled(source: str, compiler: str, folder: Path, *flags: str) -> Callable[[Any, Any], None]:
    """The function ``many`` of a source: (parameters, what it writes); AbsentError without a compiler."""
    if shutil.which(compiler) is None:
        raise AbsentError(f"there is no {compiler}")
    suffix = ".cpp" if compiler == "c++" else ".c"
    (folder / f"many{suffix}").write_text(source)
    library = folder / "many.so"
    command = [compiler, str(folder / f"many{suffix}"), "-o", str(library), f"-I{folder}", *FLAGS, *flags]
    subprocess.run(command, check=True, capture_output=True)
    many = ctypes.CDLL(str(library)).many
    many.argtypes = [ctypes.c_long, ctypes.c_void_p, ctypes.c_void_p]
    return lambda at, out: many(len(at), at.ctypes.data, out.ctypes.data)


def _timed(many: Callable[[Any, Any], None], name: str, width: int) -> Job:
    at, out = times(name), np.empty((COUNT, width))

    def run() -> Any:
        many(at, out)
        return out

    return Job(run, lambda found: found.copy())


def our_jet(name: str) -> Job:
    """osculant's compiled jet, called by a kernel."""
    jet = compile_jet(curve(name).coordinates, ORDER)
    return _timed(lambda at, out: sample_many(jet.address, at, out), name, 2 * ORDER + 2)


def our_blocks(name: str) -> Job:
    """osculant's derivatives of several parameters at once, in columns, its own sines among them."""
    blocks, at = compile_blocks(curve(name).coordinates, ORDER), times(name)
    return Job(lambda: blocks(at), lambda found: found.reshape(-1, COUNT).T.copy())


def emitted(name: str) -> Job:
    """The C that osculant emits for a jet, a column for each derivative."""
    jet = jet_function("jet", curve(name).coordinates, ORDER)
    many = compiled(EMITTED.format(jet=jet), "cc", Path(tempfile.mkdtemp()))
    at, out = times(name), np.empty((2 * ORDER + 2, COUNT))

    def run() -> Any:
        many(at, out)
        return out

    return Job(run, lambda found: found.T.copy())


def by_hand(name: str, flags: str = "-O3") -> Job:
    """C by hand, a column for each derivative, so that several parameters may be taken at once."""
    many = compiled(HAND.format(body=BY_HAND[name]), "cc", Path(tempfile.mkdtemp()), flags)
    at, out = times(name), np.empty((2 * ORDER + 2, COUNT))

    def run() -> Any:
        many(at, out)
        return out

    return Job(run, lambda found: found.T.copy())


def heyoka(name: str) -> Job:
    """heyoka's compiled function of the derivatives, which takes several parameters at once."""
    installed("heyoka")
    import heyoka as hy

    t = hy.make_vars("t")
    outputs = []
    for formula in CURVES[name][1](t, hy.sin, hy.cos):
        for _ in range(ORDER + 1):
            outputs.append(formula)
            formula = hy.diff(formula, t)
    function = hy.cfunc(outputs, [t])
    at, out = times(name)[None, :].copy(), np.empty((len(outputs), COUNT))
    return Job(lambda: function(at, outputs=out), lambda found: found.T.copy())


def our_invariants(name: str) -> Job:
    """`tabulate`, which gives six invariants."""
    whole, at = curve(name), times(name)
    return Job(lambda: whole.tabulate(at), lambda found: np.stack([found[key] for key in COMPARED], axis=1))


def our_invariants_kernel(name: str) -> Job:
    """Its kernel alone."""
    jet = compile_jet(curve(name).coordinates, ORDER)
    at, out = times(name), np.empty((COUNT, len(COLUMNS)))

    def run() -> Any:
        invariants_at(jet.address, at, out)
        return out

    return Job(run, lambda found: found[:, [COLUMNS.index(key) for key in COMPARED]])


def casadi(name: str) -> Job:
    """C that CasADi generates."""
    installed("casadi")
    import casadi as ca

    t = ca.SX.sym("t")
    x, y = CURVES[name][1](t, ca.sin, ca.cos)
    found = invariants(x, y, lambda f: ca.jacobian(f, t), ca.sqrt, lambda f: f ** (1 / 3))
    folder = Path(tempfile.mkdtemp())
    ca.Function("f", [t], list(found)).generate("casadi.c", {"with_header": False})
    shutil.move("casadi.c", folder / "casadi.c")
    return _timed(compiled(CASADI.format(file="casadi.c"), "cc", folder), name, 3)


def symforce(name: str, python: str) -> Job:
    """C++ that SymForce generates, by an interpreter that has it."""
    folder = Path(tempfile.mkdtemp())
    script = str(Path(__file__).with_name("symforce_code.py"))
    made = subprocess.run([python, script, name, str(folder)], capture_output=True, text=True, check=False)
    if made.returncode:
        raise AbsentError(f"symforce cannot be imported by {python}")
    (header,) = folder.rglob("invariants.h")
    (folder / "Eigen").mkdir()
    (folder / "Eigen" / "Core").write_text("// functions of scalars use nothing of Eigen\n")
    shutil.copy(header, folder / "invariants.h")
    return _timed(compiled(SYMFORCE.format(file="invariants.h"), "c++", folder), name, 3)


#: by what is compared, who does it
FAMILIES: dict[str, dict[str, Callable[[str], Job]]] = {
    "jets of order 5": {
        "osculant": our_jet,
        "osculant, several at once": our_blocks,
        "its C": emitted,
        "C by hand": by_hand,
        "C by hand, -ffast-math": partial(by_hand, flags="-ffast-math"),
        "heyoka": heyoka,
    },
    "invariants": {
        "osculant": our_invariants,
        "its kernel": our_invariants_kernel,
        "CasADi": casadi,
    },
}
