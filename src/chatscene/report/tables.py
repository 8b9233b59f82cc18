"""Result tables as text, Markdown, CSV and LaTeX."""

from __future__ import annotations

import csv
import io
import re
import textwrap
from collections.abc import Iterable, Mapping
from pathlib import Path

from chatscene.runs.atomic import write_bytes
from chatscene.terms.results import Cell, ResultTable

DASH = "\N{EN DASH}"  # for what is missing, and between the ends of an interval
WIDTH = 12  # characters of a column of text, as wide as an interval
GAP = "  "

_LATEX = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "&": r"\&", "%": r"\%", "$": r"\$", "#": r"\#", "_": r"\_",
    "~": r"\textasciitilde{}", "^": r"\textasciicircum{}", "<": r"\textless{}", ">": r"\textgreater{}",
    "|": r"\textbar{}", DASH: "--",
}  # fmt: skip


def as_text(table: ResultTable) -> str:
    """The table for a terminal: each number over its interval, as the columns of the paper are too many for a line."""
    heads = [textwrap.wrap(column, WIDTH) for column in table.columns]
    height = max((len(head) for head in heads), default=0)
    label = max((len(name) for name, _ in table.rows), default=0)

    def line(first: str, rest: Iterable[str]) -> str:
        return GAP.join([first.ljust(label), *(each.rjust(WIDTH) for each in rest)]).rstrip()

    lines = [table.title, ""]
    lines += [line("", level) for level in zip(*([""] * (height - len(head)) + head for head in heads), strict=True)]
    lines += ["-" * (label + len(table.columns) * (WIDTH + len(GAP)))]
    for name, cells in table.rows:
        lines.append(line(name, [_value(cell) for cell in cells]))
        if any(cell.low is not None or cell.by_selection for cell in cells):
            lines.append(line("", [_interval(cell) for cell in cells]))
    return "\n".join([*lines, "", *table.notes]) + "\n"


def as_markdown(table: ResultTable) -> str:
    """The table in GitHub's Markdown, a number and its interval in a cell."""
    head = ["", *map(_markdown, table.columns)]
    lines = [f"**{_markdown(table.title)}**", "", _pipes(head), _pipes(["---", *["---:"] * len(table.columns)])]
    lines += [_pipes([_markdown(name), *map(_inline, cells)]) for name, cells in table.rows]
    return "\n".join([*lines, "", *(f"- {_markdown(note)}" for note in table.notes)]) + "\n"


def as_csv(table: ResultTable) -> str:
    """The numbers alone, each with its low and high in columns of their own; nothing stands for what is missing."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(["row", *(f"{column}{end}" for column in table.columns for end in ("", " low", " high"))])
    for name, cells in table.rows:
        ends = (end for cell in cells for end in (cell.value, cell.low, cell.high))
        writer.writerow([name, *("" if end is None else f"{end:.6g}" for end in ends)])
    return stream.getvalue()


def as_latex(table: ResultTable) -> str:
    """The table as a LaTeX float; it needs the package booktabs."""
    lines = [
        r"\begin{table*}[t]",
        r"\centering",
        rf"\caption{{{_latex(table.title)}}}",
        rf"\begin{{tabular}}{{l{'c' * len(table.columns)}}}",
        r"\toprule",
        _ampersands(["", *map(_latex, table.columns)]),
        r"\midrule",
        *(_ampersands([_latex(name), *(_latex(_inline(cell)) for cell in cells)]) for name, cells in table.rows),
        r"\bottomrule",
        r"\end{tabular}",
        *(rf"\par\footnotesize {_latex(note)}" for note in table.notes),
        r"\end{table*}",
    ]
    return "\n".join(lines) + "\n"


RENDERINGS = {".txt": as_text, ".md": as_markdown, ".csv": as_csv, ".tex": as_latex}


def write_tables(folder: Path, tables: Mapping[str, ResultTable]) -> None:
    """Write ``<name>.txt``, ``.md``, ``.csv`` and ``.tex`` of each table.

    Raises:
        RunError: The file system refuses.
    """
    for name, table in sorted(tables.items()):
        for suffix, render in RENDERINGS.items():
            write_bytes(folder / f"{name}{suffix}", render(table).encode())


def _value(cell: Cell) -> str:
    return DASH if cell.value is None else f"{cell.value:.3f}"


def _interval(cell: Cell) -> str:
    if cell.by_selection:
        return "by selection"
    return DASH if cell.low is None or cell.high is None else f"{cell.low:.3f}{DASH}{cell.high:.3f}"


def _inline(cell: Cell) -> str:
    return _value(cell) if cell.low is None and not cell.by_selection else f"{_value(cell)} ({_interval(cell)})"


def _pipes(cells: list[str]) -> str:
    return f"| {' | '.join(cells)} |"


def _ampersands(cells: list[str]) -> str:
    return rf"{' & '.join(cells)} \\"


def _markdown(text: str) -> str:
    return re.sub(r"([\\`*_\[\]<>|])", r"\\\1", text)


def _latex(text: str) -> str:
    return "".join(_LATEX.get(character, character) for character in text)
