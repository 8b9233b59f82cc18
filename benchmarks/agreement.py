"""Whether somebody who only watches the tracks says of a drive what the judge says: agreement, fact by fact.

    python benchmarks/agreement.py make FOLDER --count 100 --seed 0
    python benchmarks/agreement.py compare FOLDER READER.jsonl OTHER.jsonl

`make` draws tasks of text2scene. One half are driven as their facts say; of the other half one fact was changed first
(`benchmarks/mutants.py`), and they are asked for the facts as they were. FOLDER gets a file per drive: the facts, each
with a number, and where everybody is, twice a second (`benchmarks/watched.py` says how); and `verdicts.jsonl`, what the
judge says, which readers do not see. A reader writes a line per drive: `id`, and `shown`, which says of each number
whether the drive shows it: true, false, or null where that cannot be told. `compare` prints how often each reader, and
both where they agree, say what the judge says, by the last step of the fact's path, and each fact of which they do not.
"""

from __future__ import annotations

import json
import random
import sys
from collections import Counter, defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import click
from watched import seen

sys.path.insert(0, str(Path(__file__).parent / "text2scene"))

import answers
from score import watched
from tasks import TASKS, Task, tasks

from chatscene.errors import ChatSceneError
from chatscene.settings import VerifySettings
from chatscene.situations.words import told
from chatscene.terms.situation import Situation
from chatscene.verdict.said import Asked
from chatscene.verdict.verify import weighed

CHANGED = ("sides", "kinds", "orders", "left_out", "added", "changed", "speeds", "contacts", "lights")


def driven(task: Task, situation: Situation, seed: int) -> tuple[list[str], dict[str, Any]] | None:
    """What a reader sees of one drive, and what the judge says of it; None if it cannot be driven."""
    settings = VerifySettings(draws=1, seed=seed)
    try:
        watching = watched(situation, task.id, settings)
    except ChatSceneError:
        return None
    found = weighed(watching, task.id, Asked(situation=task.facts), settings)
    facts = [one for one in found.facts if one.seen and not one.untold]
    if not facts or not watching.drives:
        return None
    episode = watching.drives[0].episode
    around = episode.surroundings
    lines = [
        f"said: {told(task.facts)}",
        f"who is who: {', '.join(f'{who} is {name}' for who, name in found.who.items())}",
        f"drive: ends with {episode.ending}; {around.light}, {around.weather}, {around.surface}",
        *(f"event: {one.kind} at {one.step * episode.dt:.1f} s, {one.other} {one.side}" for one in episode.events),
        *seen(episode),
        "facts:",
        *(f"{number}. {one.path}: {one.said}" for number, one in enumerate(facts, 1)),
    ]
    verdict = [
        {"path": one.path, "said": one.said, "shown": one.seen[0].shown, "told": one.seen[0].told} for one in facts
    ]
    return lines, {"facts": verdict, "status": found.status}


@click.group()
def main() -> None:
    """Compare the judge with readers of tracks."""


@main.command()
@click.argument("folder", type=click.Path(path_type=Path, file_okay=False))
@click.option("--count", default=100, show_default=True)
@click.option("--seed", default=0, show_default=True)
def make(folder: Path, count: int, seed: int) -> None:
    """Drive scenes, and write what readers see of them."""
    folder.mkdir(parents=True)
    rng = random.Random(seed)
    several = list(tasks(TASKS))
    rng.shuffle(several)
    done = 0
    with (folder / "verdicts.jsonl").open("w", encoding="utf-8") as verdicts:
        for task in several:
            if done == count:
                break
            change = rng.choice(CHANGED) if done % 2 else ""
            try:
                answer = answers.mutated(task, change, seed) if change else answers.oracle(task)
            except ChatSceneError:
                continue
            made = driven(task, answer[0], seed) if answer is not None and answer[0] is not None else None
            if made is None:
                continue
            done += 1
            name = f"{done:03d}"
            (folder / f"{name}.txt").write_text("\n".join(made[0]) + "\n", encoding="utf-8")
            verdicts.write(json.dumps({"id": name, "task": task.id, "changed": change, **made[1]}) + "\n")


@main.command()
@click.argument("folder", type=click.Path(path_type=Path, exists=True))
@click.argument("readers", nargs=-1, type=click.Path(path_type=Path, exists=True))
def compare(folder: Path, readers: tuple[Path, ...]) -> None:
    """Compare what readers say with what the judge says."""
    verdicts = {row["id"]: row for row in _rows(folder / "verdicts.jsonl")}
    said = [{row["id"]: row["shown"] for row in _rows(path)} for path in readers]
    kinds: dict[str, Counter[str]] = defaultdict(Counter)
    for name, row in verdicts.items():
        for number, fact in enumerate(row["facts"], 1):
            kind = fact["path"].rpartition(".")[2]
            answered = [one[name].get(str(number)) if name in one else None for one in said]
            for i, one in enumerate(answered):
                kinds[f"reader {i + 1}"][_word(one, fact["shown"])] += 1
            if None not in answered and len(set(answered)) == 1:
                kinds["all readers, where they agree"][_word(answered[0], fact["shown"])] += 1
                kinds[kind][_word(answered[0], fact["shown"])] += 1
                if answered[0] is not fact["shown"]:
                    click.echo(f"{name} {row['task']} {fact['path']}: {fact['said']}; judge {fact['shown']}"
                               f" ({fact['told']}), readers {answered[0]}")  # fmt: skip
            elif None not in answered:
                kinds["readers apart"]["facts"] += 1
    for kind, counts in kinds.items():
        told_apart = counts["same"] + counts["other"]
        share = f"{counts['same'] / told_apart:.1%} of {told_apart}" if told_apart else ""
        click.echo(f"{kind}: {share} {dict(counts)}")


def _word(reader: bool | None, judge: bool | None) -> str:
    if reader is None or judge is None:
        return "not told"
    return "same" if reader is judge else "other"


def _rows(path: Path) -> Iterator[dict[str, Any]]:
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.strip():
            yield json.loads(line)


if __name__ == "__main__":
    main()
