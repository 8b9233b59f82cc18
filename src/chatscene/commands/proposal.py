"""The command line, continued: what a language model proposes, and what becomes of it."""

from __future__ import annotations

import json
import sys
from collections.abc import Generator, Sequence
from contextlib import contextmanager
from dataclasses import asdict, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Unpack

import click

from chatscene.commands.library import COMPONENT
from chatscene.commands.options import JSON, MANY, READING, SEEDS, Reading
from chatscene.commands.output import progress, say
from chatscene.settings import OFFLINE

if TYPE_CHECKING:
    from chatscene.grow.review import MakeJudge
    from chatscene.models.language.protocol import LanguageModel, Spending
    from chatscene.terms.description import Description, Diversity

BASES = click.Choice([
    "straight-obstacle", "turning-obstacle", "lane-changing", "vehicle-passing", "red-light-running",
    "unprotected-left-turn", "right-turn", "crossing-negotiation",
])  # fmt: skip
FOLDER = click.option(
    "--library",
    "own",
    required=True,
    metavar="DIR",
    type=click.Path(path_type=Path, file_okay=False),
    help="Folder of your own snippets; created if it does not exist.",
)
SCENES = click.option("--scenes", default=10, show_default=True, type=MANY, help="Scenes per program.")
PROPOSAL = click.argument("proposal_id", metavar="ID")


@click.command()
@click.option("--component", type=COMPONENT, default=None, help="What to propose; goes with --base.")
@click.option("--base", type=BASES, default=None, help="For which base scenario.")
@click.option("--rephrase", default=None, metavar="ID", help="Propose wordings of this snippet of yours.")
@click.option("--n", "count", default=5, show_default=True, type=MANY, help="How many to ask for.")
@click.option("--language-model", required=True, metavar="NAME", help="openai:MODEL or gguf:FILE.")
@FOLDER
@SCENES
@JSON
def propose(
    component: str | None,
    base: str | None,
    rephrase: str | None,
    count: int,
    language_model: str,
    own: Path,
    scenes: int,
    as_json: bool,
) -> None:
    """Have a language model propose snippets; those that pass every check wait in DIR/proposed for you to review.

    A model's code runs only in the sandbox. Rejected proposals are counted by reason.

    \b
    chatscene library propose --component behavior --base straight-obstacle --n 20 \\
        --language-model openai:MODEL --library my-snippets
    chatscene library propose --rephrase behavior/mine --n 5 --language-model openai:MODEL --library my-snippets
    """
    if rephrase is None and (component is None or base is None):
        raise click.UsageError("nothing to propose: give --component and --base, or --rephrase ID")
    if rephrase is not None and (component or base):
        raise click.UsageError("--rephrase ID does not go with --component and --base; leave them out")
    model = _model(language_model)
    if rephrase is not None:
        _rephrase(model, rephrase, count, own, as_json)
    else:
        _propose(model, str(component), str(base), count, own, scenes, as_json)


def _propose(
    model: LanguageModel, component: str, base: str, count: int, own: Path, scenes: int, as_json: bool
) -> None:
    from chatscene.grow.propose import propose as ask
    from chatscene.grow.shelf import Shelf
    from chatscene.terms.scenario import BaseScenario, Component

    shelf = Shelf(own)
    with _judges(scenes) as make_judge:
        summary = ask(
            model,
            Component(component),
            BaseScenario(base),
            count,
            shelf=shelf,
            judge=make_judge(shelf.with_queue()),
            progress=progress(),
        )
    if as_json:
        kept = [{"id": k.id, "file": str(k.path), "attempts": k.attempts} for k in summary.kept]
        refused = [asdict(one) for one in summary.refused]
        spent = asdict(summary.spending)
        say(json.dumps({"kept": kept, "refused": refused, "reasons": summary.reasons, "spending": spent}))
        return
    for one in summary.refused:
        say(f"refused: {one.name}: {one.reason}: {one.message}")
    for one in summary.kept:
        say(f"waits: {one.id}: {one.path}")
    _say_counts(len(summary.kept), summary.reasons, summary.spending)


def _rephrase(model: LanguageModel, snippet_id: str, count: int, own: Path, as_json: bool) -> None:
    from chatscene.grow.shelf import Shelf
    from chatscene.grow.wordings import rephrase as ask
    from chatscene.models.encoders.embedding import load_embedder

    found = ask(model, snippet_id, count, shelf=Shelf(own), embedder=load_embedder())
    if as_json:
        say(json.dumps(asdict(found)))
        return
    for one in found.refused:
        say(f"refused: {one.name}: {one.reason}: {one.message}")
    for text in found.kept:
        say(f"waits: {text}")
    reasons: dict[str, int] = {}
    for one in found.refused:
        reasons[one.reason] = reasons.get(one.reason, 0) + 1
    _say_counts(len(found.kept), reasons, found.spending)


def _say_counts(kept: int, reasons: dict[str, int], spent: Spending) -> None:
    why = f" ({', '.join(f'{count} {reason}' for reason, count in reasons.items())})" if reasons else ""
    say(f"{kept} wait for review, {sum(reasons.values())} refused{why}")
    dollars = "price not known" if spent.dollars is None else f"{spent.dollars:.4f} dollars"
    say(f"{spent.calls} calls, {spent.tokens_in} + {spent.tokens_out} tokens, {spent.seconds:.1f} s, {dollars}")


@click.command()
@FOLDER
@JSON
def pending(own: Path, as_json: bool) -> None:
    """List the proposals in DIR/proposed that wait for review. Runs nothing.

    \b
    chatscene library pending --library my-snippets
    """
    from chatscene.errors import SnippetError
    from chatscene.grow.review import pending as waiting
    from chatscene.grow.shelf import Shelf

    if not own.is_dir():
        raise SnippetError(f"there is no folder {own}; proposals wait where `library propose --library DIR` put them")
    found = waiting(Shelf(own))
    if as_json:
        say(json.dumps([{**asdict(one), "path": str(one.path)} for one in found], indent=1))
        return
    for one in found:
        say(f"{one.id:<48} {one.says}")
        say(f"    {one.path}, by {one.model or 'nobody known'} {one.date}".rstrip())
        if one.fault:
            say(f"    cannot be accepted: {one.fault}")
    say(f"{len(found)} wait")


@click.command()
@PROPOSAL
@FOLDER
@SCENES
def accept(proposal_id: str, own: Path, scenes: int) -> None:
    """Check a proposal again, and move it into your library. Read it first: from then on, runs may use it.

    \b
    chatscene library accept behavior/wave-and-go --library my-snippets
    """
    from chatscene.grow import review
    from chatscene.grow.shelf import Shelf
    from chatscene.models.encoders.embedding import load_embedder

    with _judges(scenes) as make_judge:
        path = review.accept(Shelf(own), proposal_id, make_judge=make_judge, embedder=load_embedder)
    say(f"accepted: {path}")


@click.command()
@PROPOSAL
@click.option("--why", required=True, help="The reason; models see it with later requests.")
@FOLDER
def reject(proposal_id: str, why: str, own: Path) -> None:
    """Remove a proposal.

    \b
    chatscene library reject behavior/wave-and-go --why "nobody does that" --library my-snippets
    """
    from chatscene.grow import review
    from chatscene.grow.shelf import Shelf

    review.reject(Shelf(own), proposal_id, why)
    say(f"rejected: {proposal_id}")


@click.command()
@PROPOSAL
@FOLDER
@SCENES
def edit(proposal_id: str, own: Path, scenes: int) -> None:
    """Open a proposal in $EDITOR, and check it again afterwards.

    \b
    chatscene library edit behavior/wave-and-go --library my-snippets
    """
    from chatscene.grow import review
    from chatscene.grow.shelf import Shelf
    from chatscene.models.encoders.embedding import load_embedder

    shelf = Shelf(own)
    text = click.edit(review.text_of(shelf, proposal_id), extension=".scenic")
    if text is None:
        say("nothing was changed")
        return
    with _judges(scenes) as make_judge:
        faults = review.edit(shelf, proposal_id, text, make_judge=make_judge, embedder=load_embedder)
    for fault in faults:
        say(str(fault))
    if faults:
        sys.exit(1)
    say(f"passes; accept it with: chatscene library accept {proposal_id} --library {own}")


@click.command()
@click.option("--base", type=BASES, default=None, help="Only scenarios of this base scenario.")
@click.option("--n", "count", default=10, show_default=True, type=MANY, help="How many.")
@click.option("--instruction", default="", metavar="TEXT", help="What the sentences are about.")
@click.option("--seed", default=0, show_default=True, type=SEEDS, help="Seed; another seed gives other sentences.")
@READING
@JSON
def describe(
    base: str | None, count: int, instruction: str, seed: int, as_json: bool, **reading: Unpack[Reading]
) -> None:
    """Make up sentences for `chatscene run`, each about a different combination of snippets.

    \b
    chatscene describe --base right-turn --n 20
    chatscene describe --instruction "dangerous cyclists at junctions"
    chatscene describe --base right-turn --language-model openai:MODEL
    """
    from chatscene.models.encoders.embedding import load_embedder
    from chatscene.sentences.describe_with_model import describe_for
    from chatscene.settings import RetrievalSettings
    from chatscene.terms.scenario import BaseScenario

    settings = RetrievalSettings(**reading)
    embedder = load_embedder(settings.embedder)
    wanted = BaseScenario(base) if base else None
    unaided = replace(settings, language_model=OFFLINE)
    offline = describe_for(unaided, wanted, count, seed=seed, instruction=instruction).descriptions
    if settings.language_model == OFFLINE:
        _say_described(offline, {"offline": offline}, embedder, as_json)
        return
    told = describe_for(settings, wanted, count, seed=seed, instruction=instruction)
    sets = {"language model": told.by_model, "kept": told.descriptions, "offline": offline}
    refused = [asdict(one) for one in told.unserved]
    _say_described(told.descriptions, sets, embedder, as_json, topped_up=len(told.topped_up), refused=refused)
    if not as_json:
        for one in told.unserved:
            say(f"not kept: {one.reason}: {one.text!r}: {one.message}", err=True)
        why = ", ".join(f"{times} {reason}" for reason, times in told.reasons.items())
        say(f"by {settings.language_model}: {len(told.by_model)} kept, {len(told.unserved)} not ({why or 'none'})")
        say(f"written offline for those that were missing: {len(told.topped_up)}")


def _say_described(
    kept: Sequence[Description],
    sets: dict[str, tuple[Description, ...]],
    embedder: Any,
    as_json: bool,
    **more: Any,
) -> None:
    """Print sentences, and how different they are from each other."""
    from chatscene.sentences.describe import diversity

    measured = {name: diversity(some, embedder) for name, some in sets.items() if len(some) > 1}
    if as_json:
        rows = [
            {
                "text": d.text,
                "base": d.base,
                "adversary": d.adversary,
                "snippets": d.snippet_ids,
                "slots": d.slots.said(),
            }
            for d in kept
        ]
        spread = {name: asdict(one) for name, one in measured.items()}
        say(json.dumps({"descriptions": rows, "diversity": spread, **more}, indent=1))
        return
    for description in kept:
        say(description.text)
    for name, one in measured.items():
        say(f"diversity, {name}: {_in_words(one, len(sets[name]))}", err=True)


def _in_words(one: Diversity, count: int) -> str:
    return (
        f"{count} sentences, {one.behaviors} behaviors, {one.geometries} geometries, {one.spawns} spawns, "
        f"{one.kinds} kinds, distinct-2 {one.distinct_2:.2f}, mean cosine distance {one.distance:.2f}"
    )


def _model(name: str) -> LanguageModel:
    """A model whose replies may be as long as a snippet."""
    from chatscene.errors import SettingsError
    from chatscene.files.caches import cache_folder
    from chatscene.models.language.protocol import Limits, load_language_model

    if name == OFFLINE:
        raise SettingsError("proposals need a language model; give --language-model openai:MODEL or gguf:FILE")
    return load_language_model(name, limits=Limits(reply_tokens=2048), cache=cache_folder("replies"))


@contextmanager
def _judges(scenes: int) -> Generator[MakeJudge]:
    """Judges that run everything in confined processes, which end with the block."""
    from chatscene.ego.policy import load_ego
    from chatscene.grow.trying import Judge
    from chatscene.maps.network import resolve_map
    from chatscene.settings import SimulationSettings
    from chatscene.simulate.confined.simulator import ConfinedSimulator

    with ConfinedSimulator(resolve_map("town"), SimulationSettings()) as simulator:
        ego = load_ego("rule-based")
        yield lambda library: Judge(library, simulator, ego, scenes=scenes)


COMMANDS: tuple[click.Command, ...] = (propose, pending, accept, reject, edit)
"""What belongs in the group `library`."""
