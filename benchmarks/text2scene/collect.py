"""Make the tasks: those of the candidates whose own facts can be shown.

    python benchmarks/text2scene/collect.py

writes ``tasks.jsonl`` and ``dropped.jsonl``. Candidates are

- texts of persons, by where they are found, with facts that were noted for this benchmark (``persons.jsonl``);
- texts of ``kept``, ``kept-second``, ``kept-third``, ``kept-fourth`` and ``classes-second`` for which a language model
  filled a situation (``benchmarks/reading/replies.jsonl``) that has the facts which the writer of the text noted: two
  readers agree;
- further texts of ``kept-third`` and ``kept-fourth``, whose facts writer and second reader agree on. What they noted
  has one word for all cars and vans, and one for people of any age: a car is a vehicle here, and texts of children,
  prams and minibuses are left out;
- texts of ``fresh-third`` and ``fresh-fifth``, whose situation one language model filled.

Left-hand traffic is left out. A candidate is a task if our builder's program of its facts is right by ``score.py``
(oracle); else it stands in ``dropped.jsonl``, with why.
"""

from __future__ import annotations

import json
import re
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import click
from score import DRAWS, Outcome, Row, outcome, reasons, watched
from tasks import HERE, ROOT, TASKS, Task, hashed

from chatscene.errors import ChatSceneError
from chatscene.interpret.situation_of import in_a_situation
from chatscene.read.by_model import situation_in
from chatscene.settings import VerifySettings
from chatscene.situations.faults import Malformed
from chatscene.situations.form import to_plain
from chatscene.terms.conclusions import concluded
from chatscene.terms.reading import Verdict
from chatscene.terms.situation import Evidence, Situation
from chatscene.terms.surroundings import Surroundings
from chatscene.terms.vocabulary import UserKind
from chatscene.verdict.said import Asked
from chatscene.verdict.verify import weighed

sys.path.insert(0, str(ROOT / "benchmarks"))

from labelled import labelled
from readers import slots_of
from slots_read import differing

OURS = "Apache-2.0"
PERSONS, DROPPED = HERE / "persons.jsonl", HERE / "dropped.jsonl"
SLOTS = ("kept", "kept-second", "kept-third", "kept-fourth", "classes-second")
TWICE = ("kept-third", "kept-fourth")
FILLED = ("fresh-third", "fresh-fifth")
FINER = re.compile(
    r"\b(?:child|children|kids?|boys?|girls?|lads?|toddlers?|prams?|pushchairs?|minibus)\b", re.IGNORECASE
)
"""Words of kinds for which what was noted had no word of their own."""


def candidates() -> Iterator[Task]:
    """All of them, sources one after the other."""
    if PERSONS.exists():
        yield from (Task(**row) for row in _rows(PERSONS))
    filled = _filled_replies()
    for name in SLOTS:
        yield from _labelled(name, filled)
    for name in FILLED:
        yield from _read_once(name)


def _labelled(name: str, filled: dict[str, dict[str, Any]]) -> Iterator[Task]:
    for number, (style, text, in_scope, said) in enumerate(labelled(name, None)):
        if not in_scope:
            continue
        noted = in_a_situation(concluded(said), (), Surroundings())
        reply = filled.get(f"{name}/{number}")
        twice = _as_coarse(noted) if name in TWICE and not FINER.search(text) else None
        agreed = twice if reply is None else _agreed(noted, reply)
        if agreed is not None:
            at = {"file": f"benchmarks/texts/{name}.jsonl", "row": number}
            yield _task(name, number, style, text, at, agreed, readers=2)


def _as_coarse(noted: Situation) -> Situation:
    """The facts that were noted, with no kind that is finer than what was noted."""
    others = (replace(one, kind=UserKind.VEHICLE) if one.kind is UserKind.CAR else one for one in noted.others)
    return replace(noted, others=tuple(others))


def _agreed(noted: Situation, reply: dict[str, Any]) -> Situation | None:
    """The situation that a language model filled, if it has the facts that were noted."""
    found = _situation(reply)
    if found is None:
        return None
    was, has = slots_of(noted), slots_of(found)
    return found if was is not None and has is not None and not differing(was, has) else None


def _read_once(name: str) -> Iterator[Task]:
    for number, row in enumerate(_rows(ROOT / "benchmarks" / "reading" / f"{name}.jsonl")):
        found = _situation(row["replies"][-1])
        if found is not None:
            at = {"file": f"benchmarks/reading/{name}.jsonl", "row": number}
            yield _task(name, number, row["voice"], row["text"], at, found, readers=1)


def _task(
    split: str, number: int, voice: str, text: str, at: dict[str, Any], facts: Situation, *, readers: int
) -> Task:
    written = to_plain(replace(facts, about="", evidence=Evidence(assumed=facts.evidence.assumed)))
    return Task(
        id=f"{split}-{number:03d}",
        split=split,
        voice=voice,
        by="language model",
        licence=OURS,
        readers=readers,
        at=at,
        sha256=hashed(text),
        situation=written,
    )


def _situation(reply: dict[str, Any]) -> Situation | None:
    """What was filled, if it is a situation and of traffic that keeps to the right."""
    if reply["verdict"] != Verdict.SITUATION:
        return None
    try:
        found = situation_in(reply["situation"])
    except Malformed:
        return None
    return None if found.evidence.mirrored else found


def _filled_replies() -> dict[str, dict[str, Any]]:
    return {row["id"]: row["replies"][-1] for row in _rows(ROOT / "benchmarks" / "reading" / "replies.jsonl")}


def _rows(path: Path) -> Iterator[dict[str, Any]]:
    yield from map(json.loads, path.read_text(encoding="utf-8").splitlines())


def oracle(task: Task, settings: VerifySettings) -> Row:
    """What our builder's own program of the facts comes to."""
    row = Row(id=task.id, split=task.split, by=task.by, outcome=Outcome.REFUSED)
    try:
        found = weighed(watched(task.facts, task.id, settings), task.id, Asked(situation=task.facts), settings)
    except ChatSceneError as error:
        return replace(row, why=(" ".join(str(error).split())[:300],))
    return replace(row, outcome=outcome(found), why=tuple(reasons(found)))


@click.command()
@click.option("--draws", default=DRAWS, show_default=True)
@click.option("--out", type=click.Path(dir_okay=False, path_type=Path), default=TASKS)
@click.option("--dropped", type=click.Path(dir_okay=False, path_type=Path), default=DROPPED)
def main(draws: int, out: Path, dropped: Path) -> None:
    """Make the tasks."""
    counts = Counter[tuple[str, str]]()
    settings = VerifySettings(draws=draws)
    with out.open("w", encoding="utf-8") as kept, dropped.open("w", encoding="utf-8") as left:
        for task in candidates():
            row = oracle(task, settings)
            counts[task.split, row.outcome] += 1
            if row.outcome is Outcome.RIGHT:
                kept.write(json.dumps(asdict(task), ensure_ascii=False) + "\n")
            else:
                why = {"id": task.id, "at": task.at, "outcome": row.outcome, "why": row.why}
                left.write(json.dumps(why, ensure_ascii=False) + "\n")
    for (split, what), number in sorted(counts.items()):
        click.echo(f"{split}: {what} {number}")


if __name__ == "__main__":
    main()
