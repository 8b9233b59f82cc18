"""How the packaged reader, or another file of what was learned, reads texts of others, with nothing refused.

    python benchmarks/readers.py kept kept-second fresh-second
    python benchmarks/readers.py --weights FILE fresh-second --limit 60

Of texts with slots: a reader's situation is turned back into slots, and so are the slots that people wrote down, by
the same table, so that what a situation has no place for counts against nobody; a text is right if no fact differs
(`slots_read.differing`). Prints how many are right, how many are right when as many are refused as leaves
six of a hundred wrong, and how often what is right is trusted more than what is wrong (AUC).
Of texts with situations that a language model filled: how many facts are read that it has, how many of those read it
has not, how many texts have the same main facts (`chatscene.situations.main_facts`), how many if as many are refused as
leaves six of a hundred wrong, and how many of those that are served, whole or in part, have the same main facts, only
such, and others; whether what is served can be built is not looked at. Others are matched as suits best.
"""

from __future__ import annotations

import json
import sys
import time
from collections import Counter
from collections.abc import Iterator
from itertools import permutations
from pathlib import Path

import click
from labelled import TEXTS, auc, labelled
from slots_read import differing

from chatscene.errors import ChatSceneError
from chatscene.interpret.known import taken_in_part
from chatscene.interpret.situation_of import in_a_situation
from chatscene.interpret.slots_of import facts_of, parties_of
from chatscene.read.by_model import situation_in
from chatscene.read.learned.numbers import same
from chatscene.read.learned.reader import LearnedReader
from chatscene.read.learned.weights import PACKAGED
from chatscene.read.reader import Reader
from chatscene.report.filled import lacked
from chatscene.settings import RetrievalSettings
from chatscene.situations.facts import said_in
from chatscene.situations.faults import Malformed
from chatscene.situations.main_facts import same_in_the_main, within_the_main
from chatscene.terms.amount import Acceleration, Duration, Length, Share, Speed
from chatscene.terms.conclusions import concluded
from chatscene.terms.reading import SituationReading, Verdict
from chatscene.terms.scenario import Slots
from chatscene.terms.situation import Situation
from chatscene.terms.surroundings import Surroundings

sys.path.insert(0, str(Path(__file__).parents[1]))

from making.reader.sequence import with_plain_names

WRONG = 0.06  # of all, that may be wrong
READING = Path(__file__).parent / "reading"
MOST = 5  # others that are matched in every way


def slots_of(situation: Situation) -> Slots | None:
    """What of a situation has a slot."""
    parties = parties_of(situation)
    return concluded(facts_of(situation, parties).slots) if parties is not None else None


def read(reader: Reader, text: str) -> SituationReading | None:
    """What a reader makes of a text; None if it refuses it with an error."""
    try:
        return reader.read(text)
    except ChatSceneError:
        return None


def of_labels(reader: Reader, name: str, limit: int) -> None:
    """Compare with slots."""
    sure, kept_out, facts = list[tuple[float, bool]](), Counter[str](), Counter[str]()
    rows = list(labelled(name, None))[:limit]
    for _, text, in_scope, said in rows:
        made = read(reader, text)
        first = made.ranked[0] if made is not None and made.ranked else None
        if not in_scope:
            kept_out["of them refused"] += first is None
            kept_out["out of scope"] += 1
            continue
        was = slots_of(in_a_situation(concluded(said), (), Surroundings()))
        found = slots_of(first.situation) if first is not None else None
        wrong = differing(was, found) if was is not None and found is not None else ("all",)
        facts.update(wrong)
        sure.append((first.probability if first is not None else 0.0, not wrong))
    right = sum(is_right for _, is_right in sure)
    both = {is_right for _, is_right in sure} == {True, False}
    click.echo(
        f"{name}: right {right} of {len(sure)}; at {WRONG:.0%} wrong {at_wrong(sure)}; "
        f"AUC {auc(sure) if both else 1.0:.2f}; {dict(kept_out)}; wrong {dict(facts.most_common(12))}"
    )


def at_wrong(sure: list[tuple[float, bool]]) -> int:
    """How many are right of the surest of which that share of all is wrong."""
    best = right = wrong = 0
    for _, is_right in sorted(sure, key=lambda one: -one[0]):
        right, wrong = right + is_right, wrong + (not is_right)
        if wrong <= WRONG * len(sure):
            best = right
    return best


def facts(situation: Situation) -> dict[str, object]:
    """The facts with plain names, amounts as such."""
    return dict(said_in(with_plain_names(situation)))


def alike(one: object, other: object) -> bool:
    """Whether two values are the same, amounts but for rounding."""
    if one == other:
        return True
    for kind in (Speed, Length, Duration, Acceleration, Share):
        try:
            return same(kind.of(one), kind.of(other))
        except ValueError:
            continue
    return False


def matched(said: Situation, found: Situation) -> tuple[int, int, int, Counter[str]]:
    """How many facts both have, how many each, and of which fields those are that differ, others in the best order."""
    wanted, best = facts(said), (-1, 0, 0, Counter[str]())
    orders = permutations(found.others) if len(found.others) <= MOST else (found.others,)
    for order in orders:
        has = facts(_in_order(found, order))
        both = {path for path, value in wanted.items() if path in has and alike(value, has[path])}
        if len(both) > best[0]:
            missed = Counter(f"-{field_of(path)}" for path in wanted if path not in both)
            added = Counter(f"+{field_of(path)}" for path in has if path not in both)
            best = len(both), len(wanted), len(has), missed + added
    return best


def _in_order(situation: Situation, order: tuple[object, ...]) -> Situation:
    from dataclasses import replace

    return replace(situation, others=order)  # type: ignore[arg-type]


def field_of(path: str) -> str:
    """A path without names and numbers."""
    return ".".join(step for step in path.split(".") if not step.isdigit() and len(step) > 1)


def of_situations(reader: Reader, name: str, limit: int) -> None:
    """Compare with situations."""
    both = wanted = has = right = texts = kept_out = refused = 0
    sure, wrong, given = list[tuple[float, bool]](), Counter[str](), Counter[str]()
    for text, said in filled(name, limit):
        made = read(reader, text)
        first = made.ranked[0] if made is not None and made.ranked else None
        given[graded(said, served(made) if made is not None else None)] += 1
        if said is None:
            kept_out, refused = kept_out + 1, refused + (first is None)
            continue
        texts += 1
        if first is None:
            wanted += len(facts(said))
            sure.append((0.0, False))
            continue
        same_, its, found, differ = matched(said, first.situation)
        both, wanted, has = both + same_, wanted + its, has + found
        right += same_ == its == found
        sure.append((first.probability, same_in_the_main(said, first.situation)))
        wrong += differ
    main = sum(is_right for _, is_right in sure)
    click.echo(
        f"{name}: of {wanted} facts {both} read ({both / wanted:.1%}), of {has} read {both} right ({both / has:.1%}); "
        f"F1 {2 * both / (wanted + has):.3f}; main facts right {main} of {texts}, at {WRONG:.0%} wrong "
        f"{at_wrong(sure)}, AUC {auc(sure) if 0 < main < texts else 0.0:.2f}; served {given['right']} right, "
        f"{given['in part']} in part, {given['wrong']} wrong; all right {right}; "
        f"no situation {kept_out}, refused {refused}; differing {dict(wrong.most_common(14))}"
    )


def served(made: SituationReading) -> Situation | None:
    """What of a reading is served, as far as that depends on how sure it is."""
    settings = RetrievalSettings()
    first = made.ranked[0] if made.ranked else None
    if first is not None and first.probability >= settings.refuse_below and not lacked(made, first):
        return first.situation
    part = taken_in_part(made, lambda situation: situation, settings)
    return part.situation if part is not None else None


def graded(said: Situation | None, found: Situation | None) -> str:
    """How the main facts of what is served are those of what was said."""
    if found is None:
        return "refused"
    if said is None or not within_the_main(found, said):
        return "wrong"
    return "right" if same_in_the_main(found, said) else "in part"


def filled(name: str, limit: int) -> Iterator[tuple[str, Situation | None]]:
    """Texts with the situation that a language model filled last, or that they tell; None where there is none."""
    for line in file_of(name).read_text(encoding="utf-8").splitlines()[:limit]:
        row = json.loads(line)
        reply = row["replies"][-1] if "replies" in row else row
        text = row["text"] if "text" in row else text_of(row["id"])
        if reply.get("verdict", Verdict.SITUATION) != Verdict.SITUATION:
            yield text, None
            continue
        try:
            situation = situation_in(reply["situation"])
        except Malformed:
            continue
        if not situation.evidence.mirrored:
            yield text, situation


def file_of(name: str) -> Path:
    """Where the texts of a set are."""
    labels = TEXTS / f"{name}.jsonl"
    return labels if labels.exists() else READING / f"{name}.jsonl"


def has_slots(name: str) -> bool:
    """Whether the texts of a set have slots and no situation."""
    first = json.loads(file_of(name).read_text(encoding="utf-8").partition("\n")[0])
    return not {"situation", "replies"} & {*first}


def text_of(at: str) -> str:
    """The text of a labelled set by its name and line."""
    name, _, line = at.rpartition("/")
    rows = (TEXTS / f"{name}.jsonl").read_text(encoding="utf-8").splitlines()
    return str(json.loads(rows[int(line)])["text"])


@click.command()
@click.argument("names", nargs=-1, required=True)
@click.option("--weights", type=click.Path(path_type=Path), default=PACKAGED)
@click.option("--limit", default=10_000, help="Texts of each set.")
def main(names: tuple[str, ...], weights: Path, limit: int) -> None:
    """Measure what was learned."""
    reader = LearnedReader(weights)
    begun = time.process_time()
    for name in names:
        (of_labels if has_slots(name) else of_situations)(reader, name, limit)
    click.echo(f"{time.process_time() - begun:.0f} s of processor time")


if __name__ == "__main__":
    main()
