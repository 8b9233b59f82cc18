"""Figures of a reproduction: how a search and a fine-tuning went."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from pathlib import Path

from matplotlib import rc_context
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure

from chatscene.runs.atomic import write_bytes

Curve = Sequence[tuple[float, float, float]]  # x, collision rate, another number in [0, 1]


def two_curves(path: Path, curves: Mapping[str, Curve], *, x: str, second: str) -> None:
    """Draw the collision rate, and another number beside it, of several methods, as an SVG file.

    The same curves give the same bytes.

    Raises:
        RunError: The file system refuses.
    """
    figure = Figure(figsize=(9, 3.6), layout="constrained")
    for number, (axes, name) in enumerate(zip(figure.subplots(1, 2), ("collision rate", second), strict=True), 1):
        for method, curve in curves.items():
            axes.plot([point[0] for point in curve], [point[number] for point in curve], marker=".", label=method)
        axes.set(xlabel=x, ylabel=name, ylim=(0.0, 1.02))
        axes.grid(alpha=0.3)
    figure.axes[0].legend(fontsize="small")
    sink = io.BytesIO()
    with rc_context({"svg.hashsalt": "chatscene"}):  # else every file has other ids
        FigureCanvasSVG(figure).print_svg(sink, metadata={"Date": None})
    write_bytes(path, sink.getvalue())
