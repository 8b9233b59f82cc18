"""What becomes of replies that language models once gave: read, built, driven, and held against what people wrote down.

    python benchmarks/recorded_replies.py --drives 4 [--each]
    python benchmarks/recorded_replies.py --texts FOLDER/texts.jsonl --replies FOLDER/replies.jsonl --drives 4
    python benchmarks/recorded_replies.py --sent-back FILE

Without files, the replies are those of `reading/replies.jsonl`, to texts of `texts/`: a line has an `id` (the name of a
set and the line of the text, from 0) and the `replies` of each round, in order. No model is asked: each reply is said
again by `scripted`, read by `ModelReader` and built, as for a user's text. A reply that the product sends back has the
next one of its line for an answer; where there is none, the same again. `--sent-back` writes these with the message,
for a model that is to answer it. Prints for each set what was accepted at once, sent back and
why, refused and why, in how many of four drives (`idm`, seeds 0 to 3) our own judge sees all that was said, and in
which slots a reading differs from the facts that people wrote down. `--each` prints a line for each text.
"""

from __future__ import annotations

import json
import re
from collections import Counter, defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import click
from building import outcome
from labelled import TEXTS
from pydantic import TypeAdapter
from slots_read import differing

from chatscene.build.build import build
from chatscene.build.in_part import build_in_part
from chatscene.build.place import at_junction
from chatscene.errors import LanguageModelError, NotBuilt
from chatscene.interpret.slots_of import facts_of, parties_of
from chatscene.models.language.checked import CheckedModel
from chatscene.models.language.scripted import Scripted
from chatscene.read.by_model import LIMITS, ModelReader
from chatscene.terms.conclusions import concluded
from chatscene.terms.reading import Verdict
from chatscene.terms.scenario import Place, Slots
from chatscene.terms.situation import Situation

REPLIES = Path(__file__).parent / "reading" / "replies.jsonl"
_SLOTS = TypeAdapter(Slots)
_SENT_BACK = re.compile(r"That reply cannot be used: (.*)\.\n", re.DOTALL)


@dataclass(frozen=True, slots=True, kw_only=True)
class Recorded:
    """A text, and what a model replied to it, round by round."""

    id: str
    text: str
    replies: tuple[Any, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Replay:
    """What a user meets.

    Attributes:
        outcome: ``built``, ``built in part``, ``not built``, ``no reading``, or the verdict.
        why: Why not, or what is left out, in the words that the user reads.
        sent_back: The message of each round that the product sent back.
        situation: What was read, if anything, without what is left out.
    """

    outcome: str
    why: str
    sent_back: tuple[str, ...]
    situation: Situation | None


def recorded(replies: Path = REPLIES, texts: Path | None = None) -> Iterator[Recorded]:
    """The replies of a file, each with its text.

    Args:
        replies: Lines with an `id` and `replies`, or one `reply`.
        texts: Lines with an `id` and a `text`; None for the texts of this repository.
    """
    rows = [json.loads(line) for line in replies.read_text().splitlines()]
    if texts is not None:
        told = {row["id"]: row["text"] for row in map(json.loads, texts.read_text().splitlines())}
    else:
        names = {row["id"].split("/")[0] for row in rows}
        told = {
            f"{name}/{i}": json.loads(line)["text"]
            for name in names
            for i, line in enumerate((TEXTS / f"{name}.jsonl").read_text().splitlines())
        }
    for row in rows:
        yield Recorded(id=row["id"], text=told[row["id"]], replies=tuple(row.get("replies") or [row["reply"]]))


def replayed(one: Recorded) -> Replay:
    """A text read by the model that gave these replies, and built."""
    last = [one.replies[-1]] * (1 + LIMITS.reasks - len(one.replies))
    script = Scripted([*one.replies, *last])
    reader = ModelReader(CheckedModel(script, limits=LIMITS), why_not_built)

    def met(outcome: str, why: object = "", situation: Situation | None = None) -> Replay:
        told = [found[1] for asked in script.asked[1:] if (found := _SENT_BACK.match(asked[-1].text))]
        return Replay(outcome=outcome, why=str(why), sent_back=tuple(told), situation=situation)

    try:
        read = reader.read(one.text)
    except LanguageModelError as error:
        return met("no reading", error)
    if read.verdict is not Verdict.SITUATION:
        return met("no situation", f"{read.reader} says that {read.verdict.said}: “{read.reason}”")
    situation = read.ranked[0].situation
    try:
        made, _ = build_in_part(situation)
    except NotBuilt as error:
        return met("not built", error, situation)
    return met("built" if made is situation else "built in part", "; ".join(made.evidence.unbuilt), made)


def why_not_built(situation: Situation) -> str:
    """Why a situation is not built; empty if it is."""
    try:
        build(situation)
    except NotBuilt as error:
        return str(error)
    return ""


def labels() -> dict[str, tuple[bool, Slots]]:
    """Whether a text is in scope, and its facts, by the ids of texts."""
    found: dict[str, tuple[bool, Slots]] = {}
    for file in TEXTS.glob("*.jsonl"):
        for i, row in enumerate(map(json.loads, file.read_text().splitlines())):
            if "in_scope" in row:
                name = f"nar/{row['id']}" if file.stem == "narratives" else f"{file.stem}/{i}"
                found[name] = row["in_scope"], _SLOTS.validate_python(row.get("slots") or {})
    return found


def coarse(situation: Situation) -> Slots:
    """A situation in the slots that people labelled: what an edit in words could name of it."""
    parties = parties_of(situation)
    assert parties is not None  # who fills a situation is asked for somebody who meets the ego
    slots = concluded(facts_of(situation, parties).slots)
    return replace(slots, place=slots.place or (Place.JUNCTION if at_junction(situation) else Place.ROAD))


def general(reason: str) -> str:
    """A reason as a kind: without names, numbers and what comes after the first fault."""
    first = re.split(r"; |\. If the text", reason.removeprefix("it cannot be built: "))[0]
    words = re.sub(r"others\.\w+\.(?:does\.\d+\.)?|does\.\d+\.|route '[\w-]+'|\d+(?:\.\d+)?", "", first)
    return " ".join(words.split())[:100]


@click.command()
@click.option("--texts", type=click.Path(path_type=Path, exists=True, dir_okay=False), default=None)
@click.option("--replies", type=click.Path(path_type=Path, exists=True, dir_okay=False), default=REPLIES)
@click.option("--drives", default=0, show_default=True, help="Drives of each that is built.")
@click.option("--ego", default="idm", show_default=True)
@click.option("--sent-back", type=click.Path(path_type=Path, dir_okay=False), default=None)
@click.option("--each", is_flag=True)
def main(texts: Path | None, replies: Path, drives: int, ego: str, sent_back: Path | None, each: bool) -> None:
    """Replay recorded replies."""
    became: defaultdict[str, Counter[str]] = defaultdict(Counter)
    why: defaultdict[str, Counter[str]] = defaultdict(Counter)
    facts, again = labels(), list[dict[str, Any]]()
    for one in recorded(replies, texts):
        met, name = replayed(one), one.id.split("/")[0]
        count, reasons = became[name], why[name]
        count["texts"] += 1
        count["accepted at once" if not met.sent_back else "sent back"] += 1
        count[met.outcome] += 1
        if met.sent_back:
            reasons[f"sent back: {general(met.sent_back[0])}"] += 1
        if met.sent_back and met.outcome in ("not built", "no reading"):
            message = met.sent_back[len(one.replies) - 1]
            again.append({"id": one.id, "text": one.text, "replies": one.replies, "sent_back": message})
        shown, unseen = "", list[str]()
        if drives and met.outcome in ("built", "built in part") and met.situation is not None:
            shown, unseen, _ = outcome(met.situation, drives, ego)
            count[f"driven: {shown}"] += 1
            reasons.update(f"{shown}: {kind}" for kind in {general(reason) for reason in unseen})
        slots = held(count, facts.get(one.id), met)
        reasons.update(f"slot: {slot}" for slot in slots)
        if each:
            click.echo(
                "\t".join((one.id, met.outcome, met.why, shown, "; ".join(sorted(set(unseen))), ",".join(slots)))
            )
    for name, count in became.items():
        click.echo(f"{name}: " + ", ".join(f"{what} {number}" for what, number in count.items()))
        for reason, number in why[name].most_common():
            click.echo(f"  {number}  {reason}")
    if sent_back is not None:
        sent_back.write_text("".join(f"{json.dumps(row, ensure_ascii=False)}\n" for row in again))


def held(count: Counter[str], label: tuple[bool, Slots] | None, met: Replay) -> tuple[str, ...]:
    """The slots in which a reading differs from a label, counted."""
    if label is None:
        return ()
    in_scope, said = label
    if not in_scope:
        count["out of scope"] += 1
        count["of them refused by the model"] += met.outcome == "no situation"
        return ()
    if met.situation is None:
        return ()
    slots = differing(said, coarse(met.situation))
    count["as labelled" if not slots else "not as labelled"] += 1
    return slots


if __name__ == "__main__":
    main()
