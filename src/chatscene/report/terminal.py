"""What a person reads in the terminal."""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TextIO, cast

from chatscene.errors import OfferedReading
from chatscene.report.accounting import in_words, parts_of
from chatscene.report.surroundings import surroundings_in_words
from chatscene.terms.coverage import Answer, Catalogue, Covered, Tally
from chatscene.terms.plan import Foreign
from chatscene.terms.scenario import Component, Scenario, grouped
from chatscene.terms.snippet import Match, Retrieval, Snippet

if TYPE_CHECKING:
    from rich.console import Console

    from chatscene.maps.survey import MapDescription
    from chatscene.report.index_columns import Column

_ANSWERS = {Answer.SERVED: "green", Answer.REFUSED: "red", Answer.FAILED: "red", Answer.OUT_OF_REACH: "dim"}
WIDTH = 120  # characters of a line where no terminal says
BAR = 20  # characters of what is done and what is not

_SENTENCE = re.compile(r"(?<=\.) (?=[A-Z])")
_OF_THE_ONE_BEFORE = re.compile(r"(?:It|They|After that|The)\b")


def visible(text: str) -> str:
    """A text that cannot steer a terminal: what nobody can see is shown as its code, but for ends of lines and tabs."""
    return "".join(c if c.isprintable() or c in "\n\t" else c.encode("unicode_escape").decode("ascii") for c in text)


def _plain(text: object) -> str:
    """A text as rich shows it: as it is, not as markup."""
    from rich.markup import escape

    return escape(visible(str(text)))


def print_understanding(console: Console, understood: Any, *, show_program: bool) -> None:
    """What was understood and why: slots, the triple, what else was near, the program."""
    from rich.table import Table

    from chatscene.interpret.otherwise import otherwise

    scenario, retrieval = understood.scenario, understood.retrieval
    words = [one.as_dict() for one in scenario.words]
    for line in otherwise(scenario, retrieval, words):
        console.print(f"[yellow]{_plain(line)}[/]")
    slots = Table("slot", "said", box=None, pad_edge=False, header_style="dim")
    for name, value in scenario.slots.said().items():
        slots.add_row(name, _plain(", ".join(map(str, value)) if isinstance(value, tuple) else value))
    for name, value in scenario.surroundings.said().items():
        slots.add_row(name, value.row.said)
    console.print(slots)
    if words:
        parts = parts_of(scenario.text, words)
        console.print(f"[dim]{_plain(in_words(parts))}[/]")
    if around := surroundings_in_words(scenario.surroundings):
        console.print(f"[yellow]as said[/]  {_plain(around)}")
    _print_doubts(console, scenario, retrieval)
    console.print()
    chosen = Table(box=None, pad_edge=False, header_style="dim")
    for column in ("component", "snippet", "similarity", "facts", "what was heard"):
        chosen.add_column(column, overflow="fold")
    for component in Component:
        match: Match = getattr(retrieval, component.value)
        chosen.add_row(
            component.value,
            f"[bold]{_plain(match.snippet.id)}[/]",
            f"{match.similarity:.2f}",
            f"{match.agreement:.0%}",
            _plain(scenario.parts[component]),
        )
    console.print(chosen)
    console.print(f"\nadversary: [bold]{retrieval.adversary}[/]   confidence: [bold]{retrieval.confidence:.0%}[/]")
    for out in retrieval.ruled_out:
        console.print(f"[dim]ruled out {_plain(out.snippet_id)}: {_plain(out.reason)}[/]")
    if show_program:
        console.print()
        _print_code(console, understood.program.source)


def _print_doubts(console: Console, scenario: Scenario, retrieval: Retrieval) -> None:
    """What was unsure, what was not used, and what else it may say."""
    for note in (*scenario.notes, *retrieval.notes):
        console.print(f"[yellow]note[/]  {_plain(note)}")
    for line in grouped((*scenario.unused, *retrieval.unused)).values():
        console.print(f"[yellow]not used[/]  {_plain(line)}")
    for line in readings_in_words(scenario.readings, also=True):
        console.print(f"[yellow]{_plain(line)}[/]" if line[0] != " " else _plain(line))


def readings_in_words(readings: Sequence[OfferedReading], *, also: bool = False, talk: bool = False) -> list[str]:
    """What a sentence may say, and how to take one of the readings, in lines."""
    if not readings:
        return []
    option = "" if talk else "--"
    ways = " or ".join(f"{option}reading {one.number}" for one in readings)
    if facts := " or ".join(f"{option}set {one.settled_by}" for one in readings if one.settled_by):
        ways += f"; or state what is open: {facts}"
    shared = _shared([one.told for one in readings])
    begins = "It may also say" if also else "It may say"
    return [
        f"{begins}, in each case “{' '.join(shared)}”, and:" if shared else f"{begins}:",
        *(f"  {one.number}  ({one.probability:.0%})  {_without(shared, one.told)}" for one in readings),
        f"If {'one of these' if len(readings) > 1 else 'that'} is meant: {ways}",
    ]


def _shared(told: Sequence[str]) -> list[str]:
    """The sentences that all of some readings have, but for those of which only others say who they are about."""
    if len(told) < 2:
        return []
    first, *rest = (_SENTENCE.split(one) for one in told)
    return [one for one in first if not _OF_THE_ONE_BEFORE.match(one) and all(one in other for other in rest)]


def _without(shared: Sequence[str], told: str) -> str:
    """A reading without what all readings have, as long as anything is left."""
    left = ["…" if one in shared else one for one in _SENTENCE.split(told)]
    shown = [one for i, one in enumerate(left) if one != "…" or (i > 0 and left[i - 1] != "…")]
    return " ".join(shown).removesuffix(" …") if any(one != "…" for one in left) else told


def understanding_text(understood: Any) -> str:
    """What was understood and why, and the program, as plain text."""
    from io import StringIO

    from rich.console import Console

    stream = StringIO()
    console = Console(file=stream, width=WIDTH, color_system=None, highlight=False, emoji=False, force_jupyter=False)
    print_understanding(console, understood, show_program=True)
    return "\n".join(line.rstrip() for line in stream.getvalue().splitlines())


def print_snippet(console: Console, snippet: Snippet) -> None:
    """One snippet, whole."""
    console.print(f"[bold]{_plain(snippet.id)}[/]  {_plain(snippet.description)}")
    for text in snippet.rephrasings:
        console.print(f"  [dim]“{_plain(text)}”[/]")
    facts = {
        **{name: ", ".join(v) if isinstance(v, tuple) else str(v) for name, v in snippet.slots.said().items()},
        "adversaries": ", ".join(snippet.adversaries),
        "requires": ", ".join(snippet.requires),
        "provides": ", ".join(snippet.provides),
        "origin": snippet.origin,
        "file": snippet.file,
    }
    for name, value in facts.items():
        if value:
            console.print(f"{name:<12} {_plain(value)}")
    for p in snippet.parameters:
        console.print(f"{_plain(p.name):<20} {p.low:g} to {p.high:g} {p.unit}   [dim]{_plain(p.meaning)}[/]")
    for line in _plan_in_words(snippet):
        console.print(_plain(line))
    console.print()
    _print_code(console, snippet.source.strip())


def _print_code(console: Console, source: str) -> None:
    """Code, every line whole however narrow the terminal: it may be copied, or go into a file."""
    from rich.syntax import Syntax

    code = Syntax("", "python", theme="ansi_light", background_color="default").highlight(visible(source))
    console.print(code, soft_wrap=True, end="")


def _plan_in_words(snippet: Snippet) -> tuple[str, ...]:
    from chatscene.library.plan_words import describe_plan
    from chatscene.terms.plan_text import plan_of

    if snippet.component is not Component.BEHAVIOR:
        return ()
    plan = plan_of(snippet)
    return (f"no plan: {plan.reason}",) if isinstance(plan, Foreign) else describe_plan(plan)


def print_map(console: Console, description: MapDescription) -> None:
    """What a map offers."""
    from dataclasses import asdict

    for name, value in asdict(description).items():
        if value == {}:
            continue
        if isinstance(value, dict):
            console.print(f"[bold]{name.replace('_', ' ')}[/]")
            for key, count in value.items():
                console.print(f"  {_plain(key):<28} {count}")
        else:
            console.print(f"{name.replace('_', ' '):<20} {_plain(value)}")


def print_coverage(console: Console, catalogue: Catalogue, rows: Sequence[Covered]) -> None:
    """What became of each entry of a catalogue, and how many are served."""
    from rich.table import Table

    egos = list(dict.fromkeys(ego for row in rows for ego in (*(one.ego for one in row.fared), *row.failures)))
    table = Table(box=None, pad_edge=False, header_style="dim", padding=(0, 2, 1, 0))
    table.add_column("entry", overflow="fold", ratio=1)
    table.add_column("answer", no_wrap=True)
    if egos:
        table.add_column("drives that\nshow it", justify="right", no_wrap=True)
    for ego in egos:
        table.add_column(f"{_plain(ego)} crashes\n(a careful\ndriver avoids)", justify="right", no_wrap=True)
    for row in rows:
        said = [f"[bold]{_plain(row.entry.name)}[/]", _plain(row.entry.sentence)]
        parts = " + ".join(row.snippet_ids)
        why = [f"[dim]{_plain(line)}[/]" for line in (parts, *row.reasons) if line]
        why += [f"[yellow]not used[/]  {_plain(line)}" for line in row.unused]
        why += [f"[yellow]{count} do not show[/]  {_plain(failure)}" for failure, count in row.missed[:1]]
        fared = {one.ego: f"{one.collisions} ({one.avoidable})" for one in row.fared}
        fared |= dict.fromkeys(row.failures, "failed")
        table.add_row(
            "\n".join(line for line in (*said, *why) if line),
            f"[{_ANSWERS[row.answer]}]{row.answer}[/]",
            *([f"{row.shown} of {row.scenes}" if row.fared else ""] if egos else []),
            *(fared.get(ego, "") for ego in egos),
        )
    console.print(f"[bold]{_plain(catalogue.title)}[/]\n")
    console.print(table)
    console.print(f"{Tally.of(rows).in_words()}\n")


def progress_line(stream: TextIO | None) -> Callable[[str, int, int], None]:
    """A function that shows what is being done, how far, and how long it will still take.

    It writes one line over and over on a terminal, and a line per change of task elsewhere; what ends with an end of
    line stays on a terminal, too. Where nobody reads, as the stream was closed, it writes nothing more: that is no
    reason to give up the work.
    """
    started = time.monotonic()
    last = [""]
    readers = [] if stream is None else [stream]

    def show(what: str, done: int, total: int) -> None:
        for reader in readers[:]:
            try:
                tell(reader, visible(what), done, total)
            except (OSError, ValueError):  # a pipe that was closed; a stream that was
                readers.clear()

    def tell(stream: TextIO, what: str, done: int, total: int) -> None:
        if not stream.isatty():
            if what != last[0]:
                stream.write(what if what.endswith("\n") else f"{what}\n")
        else:
            line = what
            if total:
                spent = time.monotonic() - started
                left = f", {spent / done * (total - done):.0f} s left" if 0 < done < total else ""
                bar = "#" * (BAR * done // total)
                line = f"{what} [{bar:.<{BAR}}] {done} of {total}{left}"
            stream.write(f"\r\x1b[K{line}" + ("\n" if total and done == total else ""))
        last[0] = what
        stream.flush()

    return show


def print_answer(console: Console, answer: Any) -> None:
    """The rows of an Arrow table, and how many there are; numbers with six digits."""
    from rich.table import Table

    table = Table(box=None, pad_edge=False, header_style="dim")
    columns: list[list[Any]] = [column.to_pylist() for column in answer.columns]
    for name, values in zip(answer.column_names, columns, strict=True):
        numbers = all(isinstance(one, int | float | None) and not isinstance(one, bool) for one in values)
        table.add_column(_plain(name), overflow="fold", justify="right" if numbers and values else "left")
    for row in zip(*columns, strict=True):
        table.add_row(*map(_cell, row))
    console.print(table)
    console.print(f"[dim]{answer.num_rows} row{'s' * (answer.num_rows != 1)}[/]")


def _cell(value: Any) -> str:
    if value is None:
        return "[dim]null[/]"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, list | tuple):
        return _plain(", ".join(map(str, cast("list[object]", value))))
    return _plain(f"{value:.6g}" if isinstance(value, float) else value)


def print_columns(console: Console, rows: Mapping[str, str], tables: Mapping[str, Sequence[Column]]) -> None:
    """Tables with their columns: the type, the unit and what each holds."""
    from rich.table import Table

    for name, columns in tables.items():
        console.print(f"[bold]{name}[/]  {_plain(rows[name])}")
        table = Table("column", "type", "unit", box=None, pad_edge=False, header_style="dim")
        table.add_column("meaning", overflow="fold", ratio=1)
        for one in columns:
            table.add_row(one.name, _plain(one.in_sql), _plain(one.unit), _plain(one.meaning))
        console.print(table)
        console.print()
