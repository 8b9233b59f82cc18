"""How well sentences are understood, measured against facts that people wrote down for them.

A sentence is right on a component if the snippet found does every fact that was said of it and contradicts none, and
brings nothing that stands or drives about unasked. Whether the program then *means* the sentence is judged from its
tracks, against the facts written down, not against those that were read.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from functools import lru_cache
from importlib.resources import files
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter

from chatscene.ego.policy import load_ego
from chatscene.errors import ChatSceneError, MeansSomethingElse, NothingFits, SettingsError
from chatscene.files.bounded import parse_json
from chatscene.library.bind import distances
from chatscene.maps.network import resolve_map
from chatscene.measure.score import wilson
from chatscene.program.check import unshown
from chatscene.runs.executor import ONE, Workers
from chatscene.runs.parallel import spread
from chatscene.runs.progress import Progress
from chatscene.search.climb import climb, simulator_of
from chatscene.search.generator import Written
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings, Settings
from chatscene.simulate.simulator import Simulator
from chatscene.studies.facts import differing
from chatscene.terms.acts import BRINGS, TURNS, Action
from chatscene.terms.conclusions import concluded
from chatscene.terms.results import Cell, ResultTable
from chatscene.terms.scenario import Component, Maneuver, Position, Scenario, Side, Slots, includes
from chatscene.terms.slots import SLOTS, slots_of
from chatscene.terms.snippet import Snippet

HELD_OUT = "held-out"
_OPPOSITES = (
    (Maneuver.LEFT_TURN, Maneuver.RIGHT_TURN),
    (Maneuver.LANE_CHANGE_LEFT, Maneuver.LANE_CHANGE_RIGHT),
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Sentence:
    """A sentence and what it says, written down by hand.

    Attributes:
        text: The sentence.
        style: How it is written.
        slots: What it says.
        behavior: The snippet it was written for; None for one that nothing can serve.
        in_scope: Whether a library of driving scenarios can serve it.
    """

    text: str
    style: str
    slots: Slots = Slots()  # noqa: RUF009 - frozen
    behavior: str | None = None
    in_scope: bool = True


@dataclass(frozen=True, slots=True, kw_only=True)
class Judged:
    """What became of one sentence.

    Attributes:
        sentence: The sentence.
        refusal: Why nothing was found, or what no drive of the program showed; empty if neither.
        slots: What was read.
        first: Per component, whether the snippet found is right.
        among_three: Per component, whether one of the best three is.
        same_behavior: Whether the behavior is the very one that the sentence was written for.
        chosen: The ids found.
        flipped: Left for right or right for left, somewhere.
        ran: Whether the program compiled, was placed and ran.
        failures: What the program's drives never showed of what was said; None where it was not run.
    """

    sentence: Sentence
    refusal: str = ""
    slots: Slots
    first: Mapping[Component, bool]
    among_three: Mapping[Component, bool]
    same_behavior: bool = False
    chosen: tuple[str, ...] = ()
    flipped: bool = False
    ran: bool | None = None
    failures: tuple[str, ...] | None = None


def load_sentences(name: str | Path) -> tuple[Sentence, ...]:
    """Sentences from a packaged set or a file of JSON lines.

    Raises:
        SettingsError: There is no such file, or a line is not a sentence with its facts.
    """
    packaged = files("chatscene.studies").joinpath("sentences", f"{name}.jsonl")
    try:
        content = (packaged if packaged.is_file() else Path(name)).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise SettingsError(f"the sentences {name} cannot be read: {error}") from error
    known = {field.name for field in fields(Sentence)}
    adapter = TypeAdapter(Sentence)
    found: list[Sentence] = []
    for number, line in enumerate(content.splitlines(), 1):
        if line.strip():
            try:
                row = parse_json(line)
                sentence = adapter.validate_python({key: row[key] for key in row if key in known})
                found.append(replace(sentence, slots=concluded(sentence.slots)))
            except (ValueError, TypeError) as error:
                raise SettingsError(f"{name}, line {number} is not a sentence with its facts: {error}") from error
    if not found:
        raise SettingsError(f"{name} has no sentence; write one a line, as JSON with its facts")
    return tuple(found)


# What is right


def beside(spawn: Snippet, geometry: Snippet) -> Snippet:
    """A spawn in "the neighbouring lane", with the side on which a geometry has that lane, if it is one side."""
    sides = [side for side in Side if f"{side}Lane" in geometry.provides]
    if "adjacentLane" not in spawn.requires or len(sides) != 1:
        return spawn
    return replace(spawn, slots=replace(spawn.slots, side=sides[0]))


def right(snippet: Snippet, sentence: Sentence, component: Component) -> bool:
    """Whether a snippet serves a sentence, or is the very one that the sentence was written for.

    A few words for what is done cannot tell all that a snippet's code does, and a writer who had it before him may have
    named a thing that its header leaves out.
    """
    return snippet.id == sentence.behavior or serves(snippet, sentence.slots, component)


def serves(snippet: Snippet, said: Slots, component: Component) -> bool:
    """Whether a snippet does every fact said of its component, contradicts none and brings nothing unasked."""
    does = snippet.slots
    if component is Component.BEHAVIOR:
        return essential(said) == essential(replace(does, position=does.position or said.position))
    for name in slots_of(component):
        wanted, given = getattr(said, name), getattr(does, name)
        if name == "place" and component is Component.SPAWN:
            continue
        if wanted is None or wanted is False:
            if SLOTS[name].about and given:
                return False
        elif name == "distance" and given is None and wanted in distances(snippet):
            continue
        elif given != wanted and not (name == "place" and given is not None and includes(wanted, given)):
            return False
    return True


def essential(slots: Slots) -> frozenset[Action]:
    """Actions without those that others bring along: whoever cuts in changes lanes, whoever stops has braked."""
    actions = {Action.STOP if action is Action.BLOCK else action for action in slots.actions}
    if slots.position is Position.ONCOMING or Action.WRONG_WAY in actions:
        actions -= {Action.ONCOMING}
    actions = actions.difference(*(BRINGS[action] for action in actions))
    if len(actions) > 1 or slots.position is Position.ONCOMING:
        actions -= {Action.FOLLOW}
    return frozenset(actions)


def flipped(said: Slots, found: Sequence[Snippet]) -> bool:
    """Whether left became right somewhere."""
    sides = {snippet.slots.side for snippet in found if snippet.slots.side is not None}
    if said.side is not None and sides and said.side not in sides:
        return True
    turns = {snippet.slots.maneuver for snippet in found}
    if any(said.maneuver in pair and turns & (set(pair) - {said.maneuver}) for pair in _OPPOSITES):
        return True
    done = {action for snippet in found for action in snippet.slots.actions}
    wanted = TURNS.keys() & set(said.actions)
    return len(wanted) == 1 and bool(done & TURNS.keys()) and not wanted & done


# The measurement


def judge(sentence: Sentence, settings: RetrievalSettings, *, drive: bool) -> Judged:
    """Read a sentence, find its triple, and climb the ladder with its program as a run does."""
    generator = Retrieved()
    ran, failures = None, None
    scenario: Scenario | None = None
    try:
        scenario = generator.read(sentence.text, settings)
        written = generator.write(scenario, settings)
        if drive and sentence.in_scope:
            written, ran, failures = _driven(sentence, scenario, written, settings)
    except (NothingFits, MeansSomethingElse) as refusal:
        nothing = dict.fromkeys(Component, False)
        read = scenario.slots if scenario is not None else Slots()
        return Judged(sentence=sentence, refusal=str(refusal), slots=read, first=nothing, among_three=nothing)
    retrieval = written.retrieval
    assert retrieval is not None  # whoever retrieves says so
    chosen = dict(zip(Component, retrieval.snippets, strict=True))
    found = {c: [chosen[c], *(match.snippet for match in retrieval.candidates[c][:2])] for c in Component}
    found[Component.SPAWN] = [beside(spawn, chosen[Component.GEOMETRY]) for spawn in found[Component.SPAWN]]
    return Judged(
        sentence=sentence,
        slots=scenario.slots,
        first={c: right(found[c][0], sentence, c) for c in Component},
        among_three={c: any(right(snippet, sentence, c) for snippet in found[c]) for c in Component},
        same_behavior=retrieval.behavior.snippet.id == sentence.behavior,
        chosen=tuple(s.id for s in retrieval.snippets),
        flipped=flipped(sentence.slots, [snippets[0] for snippets in found.values()]),
        ran=ran,
        failures=failures,
    )


@lru_cache(maxsize=1)
def _simulator(settings: RetrievalSettings) -> Simulator:
    return simulator_of(Retrieved(), resolve_map("town"), Settings(retrieval=settings))


def _driven(
    sentence: Sentence, scenario: Scenario, first: Written, settings: RetrievalSettings
) -> tuple[Written, bool, tuple[str, ...]]:
    """What climbed the ladder, whether it ran, and what its drives never showed of what was written down."""
    simulator = _simulator(settings)
    ego = load_ego("rule-based")
    try:
        written, checked = climb(Retrieved(), scenario, first, settings=settings, simulator=simulator, ego=ego)
    except MeansSomethingElse:
        raise
    except ChatSceneError as error:
        return first, False, (f"{type(error).__name__}: {error}",)
    route = simulator.route(written.program, 0)
    return written, True, unshown(sentence.slots, checked.episodes, route)


@dataclass(frozen=True, slots=True)
class _Setup:
    settings: RetrievalSettings
    drive: bool


class _Judge:
    def __init__(self, setup: _Setup) -> None:
        self._setup = setup

    def __call__(self, numbered: tuple[int, Sentence]) -> tuple[int, Judged]:
        number, sentence = numbered
        return number, judge(sentence, self._setup.settings, drive=self._setup.drive)


def measure(
    sentences: Sequence[Sentence],
    *,
    settings: RetrievalSettings,
    drive: bool = True,
    workers: Workers = ONE,
    progress: Progress,
) -> tuple[Judged, ...]:
    """Judge sentences, in their order."""
    setup = _Setup(settings, drive)
    judged: dict[int, Judged] = {}
    for number, one in spread(_Judge, setup, list(enumerate(sentences)), workers=workers):
        judged[number] = one
        progress("sentences", len(judged), len(sentences))
    return tuple(judged[i] for i in range(len(sentences)))


# Tables


def _rate(hits: Iterable[bool]) -> Cell:
    found = list(hits)
    if not found:
        return Cell(None)
    return Cell(sum(found) / len(found), *wilson(sum(found), len(found)))


def summary_table(judged: Sequence[Judged]) -> ResultTable:
    """Rates over all sentences and per style."""
    groups = {"all": list(judged)} | {
        style: [j for j in judged if j.sentence.style == style]
        for style in sorted({j.sentence.style for j in judged if j.sentence.in_scope})
    }
    return ResultTable(
        title="How well sentences are understood",
        columns=(
            "in scope", "refused", "behavior", "geometry", "spawn", "behavior top 3", "geometry top 3", "spawn top 3",
            "very behavior", "flips", "runs", "means it", "out of scope refused", "every fact", "a wrong fact",
        ),
        rows=tuple((name, _summary(group)) for name, group in groups.items()),
        notes=(
            "rates of the sentences in scope; behavior, geometry, spawn, flips, runs and means it: of those that were "
            "not refused; intervals: Wilson, 95 %",
            "very behavior: the snippet that the sentence was written for, where others may do the same",
            "every fact, a wrong fact: served with all facts read as they were written down, or with one that is not",
        ),
    )  # fmt: skip


def _summary(group: Sequence[Judged]) -> tuple[Cell, ...]:
    inside = [j for j in group if j.sentence.in_scope]
    served = [j for j in inside if not j.refusal]
    ran = [j for j in served if j.ran is not None]
    return (
        Cell(float(len(inside))),
        _rate(bool(j.refusal) for j in inside),
        *(_rate(j.first[c] for j in served) for c in Component),
        *(_rate(j.among_three[c] for j in served) for c in Component),
        _rate(j.same_behavior for j in served),
        _rate(j.flipped for j in served),
        _rate(bool(j.ran) for j in ran),
        _rate(j.failures == () for j in ran),
        _rate(bool(j.refusal) for j in group if not j.sentence.in_scope),
        _rate(not j.refusal and not differing(j.sentence.slots, j.slots) for j in inside),
        _rate(not j.refusal and bool(differing(j.sentence.slots, j.slots)) for j in inside),
    )


def slot_table(judged: Sequence[Judged]) -> ResultTable:
    """Per slot: how often what was said was read, and how often something was read that was not said."""
    inside = [j for j in judged if j.sentence.in_scope]
    rows: list[tuple[str, tuple[Cell, ...]]] = []
    for name in (field.name for field in fields(Slots)):
        pairs = [(_plain(j.sentence.slots, name), _plain(j.slots, name)) for j in inside]
        rows.append(
            (
                name,
                (
                    _rate(wanted == got for wanted, got in pairs if wanted),
                    _rate(bool(got) for wanted, got in pairs if not wanted),
                ),
            )
        )
    return ResultTable(
        title="Facts read",
        columns=("right where said", "read where not said"),
        rows=tuple(rows),
        notes=("intervals: Wilson, 95 %",),
    )


def _plain(slots: Slots, name: str) -> object:
    return essential(slots) if name == "actions" else getattr(slots, name)


def confusions(judged: Sequence[Judged], count: int = 20) -> list[tuple[str, int]]:
    """The commonest wrong readings: slot, what was said, what was read."""
    found: Counter[str] = Counter()
    for j in judged:
        if j.sentence.in_scope:
            for name in (field.name for field in fields(Slots)):
                wanted, got = _plain(j.sentence.slots, name), _plain(j.slots, name)
                if wanted and wanted != got:
                    found[f"{name}: {_shown(wanted)} read as {_shown(got)}"] += 1
    return found.most_common(count)


def _shown(value: object) -> str:
    return ", ".join(sorted(map(str, value))) if isinstance(value, frozenset) else str(value) if value else "nothing"


def as_rows(judged: Sequence[Judged]) -> list[dict[str, Any]]:
    """Every sentence with what became of it, for a file."""
    return [
        {
            "text": j.sentence.text,
            "style": j.sentence.style,
            "in_scope": j.sentence.in_scope,
            "said": {name: _json(value) for name, value in j.sentence.slots.said().items()},
            "read": {name: _json(value) for name, value in j.slots.said().items()},
            "behavior": j.sentence.behavior,
            "chosen": list(j.chosen),
            "right": {c.value: j.first[c] for c in Component},
            "flipped": j.flipped,
            "refusal": j.refusal,
            "ran": j.ran,
            "failures": None if j.failures is None else list(j.failures),
        }
        for j in judged
    ]


def _json(value: object) -> object:
    return [str(item) for item in value] if isinstance(value, tuple) else value
