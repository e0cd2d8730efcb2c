"""Pictures of splines in the plane and in space, by means of matplotlib."""

from __future__ import annotations

import io
from pathlib import Path
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import OsculantError
from osculant.files.writing import not_installed, write_whole

if TYPE_CHECKING:
    import os

    from osculant.pieces.piece import Floats

#: points on each piece
DRAWN_POINTS = 65


def draw(points: Floats, title: str, path: str | os.PathLike[str] | None, axes: Any) -> Any:
    """Draw pieces in alternating colours with the knots marked.

    Args:
        points: `DRAWN_POINTS` on each piece, knots once, shape (n(DRAWN_POINTS − 1) + 1, 2) or (…, 3).
        title: of the picture.
        path: a file to draw to, of any kind that matplotlib knows by its suffix, or None.
        axes: matplotlib axes to draw in, in space of the projection "3d"; None makes new ones.

    Returns:
        The axes.

    Raises:
        OsculantError: matplotlib is not installed, or does not know the suffix, or cannot write the file.
    """
    try:
        from matplotlib.figure import Figure
    except ImportError as error:
        raise not_installed("Drawing", "matplotlib", "plot") from error
    if axes is None:
        flat = points.shape[1] == 2
        frame = {"layout": "constrained"} if flat else {}
        if path is None:
            import matplotlib.pyplot as plt

            figure = plt.figure(**frame)  # type: ignore[arg-type]
        else:
            figure = Figure(**frame)  # type: ignore[arg-type]  # no window, no global state
        axes = figure.add_subplot(**({} if flat else {"projection": "3d"}))
    step = DRAWN_POINTS - 1
    for i in range(len(points) // step):
        part = points[i * step : (i + 1) * step + 1]
        axes.plot(*part.T, color=("tab:blue", "tab:orange")[i % 2], linewidth=1.5)
    axes.plot(*points[::step].T, "k.", markersize=4)
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_title(title)
    if path is not None:
        picture = io.BytesIO()
        try:
            axes.figure.savefig(picture, format=Path(path).suffix[1:].lower() or "png")
        except ValueError as error:
            raise OsculantError(f"Cannot draw to {Path(path)}: {error}.") from error
        write_whole(path, picture.getvalue())
    return axes
