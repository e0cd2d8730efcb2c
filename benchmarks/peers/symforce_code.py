"""C++ of a curve's invariants by SymForce: `python symforce_code.py NAME FOLDER`.

Run by an interpreter of its own: SymForce has a fork of symengine, which does not go with the original.
"""

import sys
from pathlib import Path

import symforce

symforce.set_epsilon_to_number(0.0)

import symforce.symbolic as sf  # noqa: E402
from symforce.codegen import Codegen, CppConfig  # noqa: E402
from symforce.values import Values  # noqa: E402

sys.path.insert(0, str(Path(__file__).parent))

from formulas import CURVES, invariants  # noqa: E402


def main(name: str, folder: str) -> None:
    """Write ``invariants.h`` somewhere into the folder."""
    t = sf.Symbol("t")
    x, y = CURVES[name][1](t, sf.sin, sf.cos)
    found = invariants(x, y, lambda f: f.diff(t), sf.sqrt, lambda f: f ** sf.Rational(1, 3))
    outputs = dict(zip(("bend", "affine", "rate"), found))
    code = Codegen(inputs=Values(t=t), outputs=Values(**outputs), config=CppConfig(), name="invariants")
    code.generate_function(output_dir=folder)


if __name__ == "__main__":
    main(*sys.argv[1:])
