"""Answers of our own to the tasks: a folder that ``score.py`` scores.

    python benchmarks/text2scene/answers.py oracle FOLDER
    python benchmarks/text2scene/answers.py reader FOLDER --clones CLONES
    python benchmarks/text2scene/answers.py mutants:sides FOLDER

- ``oracle``: what our builder makes of the task's own facts.
- ``reader``: what chatscene makes of the text: its situation. There is no file where it refuses. ``reader:paper``: the
  program of the paper's way (``chatscene run --reader paper``).
- ``mutants:KIND``: what our builder makes of facts one of which was changed, as ``benchmarks/mutants.py`` changes them:
  sides, kinds, orders, left_out, added, changed, lights, speeds, contacts, timings. There is no file where the facts
  cannot be changed so, or nothing is built of it, or where only a deed is missing that nearly everybody does.

``--as scenic`` writes programs in the place of situations.
"""

from __future__ import annotations

import json
import random
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

import click
from score import first_of_each
from tasks import ROOT, NoTextError, Task, tasks, text_of

import chatscene
from chatscene.build.build import Built, build
from chatscene.errors import ChatSceneError, NotBuilt
from chatscene.report.stated import Stated
from chatscene.situations.form import to_plain
from chatscene.terms.situation import Situation

sys.path.insert(0, str(ROOT / "benchmarks"))

import mutants

Answer = tuple[Situation | None, Callable[[], str]]
"""A situation, if there is one, and how its program is made."""


def oracle(task: Task) -> Answer:
    """The facts themselves."""
    return task.facts, lambda: build(task.facts, name=task.id).program.source


def read(task: Task, reader: str, clones: Path | None) -> Answer:
    """What a reader makes of the text.

    Raises:
        ChatSceneError: It refuses the text, or nothing is built of it.
        NoTextError: There is no text.
    """
    made = chatscene.explain(text_of(task, clones), reader=reader or None)
    if isinstance(made, Stated):
        return made.situation, lambda: made.built.program.source
    return None, lambda: made.program.source


def mutated(task: Task, kind: str, seed: int) -> Answer | None:
    """The facts with one changed; None where there is no such change."""
    rng = random.Random(f"{seed}/{task.id}/{kind}")
    facts = mutants.stated(task.facts)
    truth = mutants.Truth(source=task.split, situation=facts, built=build(facts, name=task.id))
    known = {one.__name__: one for one in mutants.MUTATIONS}
    if kind not in known:
        raise click.UsageError(f"there is no kind of mutant {kind!r}; there are {', '.join(known)}")
    mutation = known[kind]
    made = [one for one in mutation(truth, rng) if mutants.is_claim(one) and told_apart(facts, one.situation)]
    if not made:
        return None
    one = rng.choice(made)
    if one.built is not truth.built:  # the same facts, and a program in which adversaries come too late
        return None, lambda: one.built.program.source
    built: Built = build(one.situation, name=task.id)
    return one.situation, lambda: built.program.source


def told_apart(facts: Situation, other: Situation) -> bool:
    """Whether a deed is missing in other facts that not nearly everybody does: who brakes goes straight on as well."""
    done = Counter(deed.act for one in facts.others for deed in one.does)
    missing = done - Counter(deed.act for one in other.others for deed in one.does)
    return not missing or not missing.keys() <= mutants.GENERAL


def answered(asked: list[Task], by: str, clones: Path | None, seed: int) -> Iterator[tuple[Task, Answer | str]]:
    """An answer to each task, or why there is none."""
    way, _, name = by.partition(":")
    for task in asked:
        try:
            if way == "oracle":
                yield task, oracle(task)
            elif way == "reader":
                yield task, read(task, name, clones)
            else:
                yield task, mutated(task, name, seed) or "nothing to change"
        except NoTextError:
            yield task, "no text: its clone is missing"
        except NotBuilt:
            yield task, "not built"
        except ChatSceneError as error:
            yield task, type(error).__name__


def write(answer: Answer, at: Path, as_what: str) -> None:
    """An answer as a file."""
    situation, program = answer
    if situation is None or as_what == "scenic":
        at.with_name(f"{at.name}.scenic").write_text(program(), encoding="utf-8")
    else:
        written = json.dumps(to_plain(situation), ensure_ascii=False, indent=1)
        at.with_name(f"{at.name}.json").write_text(written, encoding="utf-8")


@click.command()
@click.argument("by")
@click.argument("folder", type=click.Path(file_okay=False, path_type=Path))
@click.option("--clones", type=click.Path(exists=True, file_okay=False, path_type=Path))
@click.option("--split", "splits", multiple=True, help="Only tasks of this source; may be given several times.")
@click.option("--limit", type=click.IntRange(1), help="Only that many tasks of each source, the first.")
@click.option("--seed", default=7, show_default=True, help="Of what mutants change.")
@click.option("--as", "as_what", type=click.Choice(("situation", "scenic")), default="situation", show_default=True)
def main(
    by: str, folder: Path, clones: Path | None, splits: tuple[str, ...], limit: int | None, seed: int, as_what: str
) -> None:
    """Write answers to FOLDER."""
    if by.partition(":")[0] not in ("oracle", "reader", "mutants"):
        raise click.UsageError(f"{by!r} is none of oracle, reader:NAME, mutants:KIND")
    folder.mkdir(parents=True, exist_ok=True)
    asked = [task for task in tasks() if not splits or task.split in splits]
    if limit is not None:
        asked = first_of_each(asked, limit)
    counts = Counter[str]()
    for task, answer in answered(asked, by, clones, seed):
        if isinstance(answer, str):
            counts[answer] += 1
        else:
            write(answer, folder / task.id, as_what)
            counts["written"] += 1
    for what, number in counts.most_common():
        click.echo(f"{what}: {number}")


if __name__ == "__main__":
    main()
