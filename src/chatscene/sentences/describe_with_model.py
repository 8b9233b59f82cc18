"""Step 1 of 9 by a language model: its sentences, as far as the library serves them, and the offline ones for the rest.

Paper: section 3.3, step i, and its appendix on prompts (whose words are not used here). What a model writes is read
and served by the same steps that serve a user's sentence; what they refuse is counted and not handed on.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import islice

from pydantic import BaseModel, ConfigDict, Field

from chatscene.errors import LanguageModelError, NothingFits, SettingsError
from chatscene.files.caches import cache_folder
from chatscene.interpret.asked import heard
from chatscene.interpret.decide import understand
from chatscene.interpret.retrieve import retrieve
from chatscene.library.bind import bound
from chatscene.library.load import Library, library_with
from chatscene.models.language.protocol import Example, LanguageModel, Limits, Prompt, load_language_model
from chatscene.models.language.structured import printable
from chatscene.sentences.describe import describe, described, joined
from chatscene.settings import OFFLINE, RetrievalSettings
from chatscene.terms.description import Description
from chatscene.terms.scenario import BaseScenario

LIMITS = Limits(reply_tokens=2048)
ROUNDS = 3  # times a model is asked, while sentences are missing
MOST = 25  # sentences asked for at a time: what a reply of 1,000 tokens holds
SHORTEST, LONGEST = 20, 400  # characters of a sentence
SHOTS = 4  # sentences in an example
SHOWN = 12  # refused sentences that a model is shown

SYSTEM = """You make up dangerous traffic situations for a driving simulator, as short sentences in English.
The ego (also: we, the vehicle under test) is the car that is tested; the adversary is the one road user who endangers
it: a car, truck, bus, motorcycle, bicycle, pedestrian or emergency vehicle. A sentence says what the ego does and
where, who the adversary is, where it comes from, and what it does. No weather, animals, second adversaries or doors.
Every sentence is a different situation."""

_TOLD: dict[BaseScenario, str] = {
    BaseScenario.STRAIGHT_OBSTACLE: "the ego drives along a road, no junction, and somebody gets in its way",
    BaseScenario.TURNING_OBSTACLE: "the ego turns at a junction; the adversary walks or is on two wheels",
    BaseScenario.LANE_CHANGING: "the ego changes lanes",
    BaseScenario.VEHICLE_PASSING: "the ego goes around something parked in its lane, through the oncoming lane",
    BaseScenario.RED_LIGHT_RUNNING: "the ego goes straight at a junction with a signal; the adversary runs the red",
    BaseScenario.UNPROTECTED_LEFT_TURN: "the ego turns left at a junction; the adversary is a motor vehicle",
    BaseScenario.RIGHT_TURN: "the ego turns right at a junction; the adversary is a motor vehicle",
    BaseScenario.CROSSING_NEGOTIATION: "the ego goes straight at a junction; nobody runs a light",
}


class Sentences(BaseModel):
    """What a model is asked for."""

    model_config = ConfigDict(extra="forbid")

    sentences: list[str] = Field(max_length=2 * MOST)


@dataclass(frozen=True, slots=True)
class Unserved:
    """A sentence of a model that was not kept.

    Attributes:
        reason: ``text``, ``duplicate``, ``adversary``, ``base``, ``refused`` or ``same triple``; ``reply`` if there was
            none.
    """

    text: str
    reason: str
    message: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Told:
    """What came of asking a model for sentences.

    Attributes:
        by_model: Sentences of the model's that the library serves, each by a triple of its own.
        topped_up: Sentences written offline, for those that were missing.
    """

    by_model: tuple[Description, ...]
    topped_up: tuple[Description, ...]
    unserved: tuple[Unserved, ...]

    @property
    def descriptions(self) -> tuple[Description, ...]:
        """All that are kept, the model's first."""
        return (*self.by_model, *self.topped_up)

    @property
    def reasons(self) -> dict[str, int]:
        """How many were not kept for each reason, most frequent first."""
        return dict(Counter(one.reason for one in self.unserved).most_common())


def describe_with(
    model: LanguageModel,
    base: BaseScenario | None,
    n: int,
    *,
    library: Library,
    settings: RetrievalSettings,
    seed: int,
    instruction: str = "",
) -> Told:
    """Have a model make up scenarios, and keep those that can be run.

    Raises:
        NothingFits: The library has nothing of the base scenario and the instruction.
        SettingsError: None is asked for.
    """
    if n < 1:
        raise SettingsError(f"the number of sentences must be at least 1, not {n}")
    settings = replace(settings, language_model=OFFLINE)
    offline = described(base, library=library, seed=seed, instruction=instruction)
    shown = tuple(islice(offline, SHOTS))
    examples = _examples(base, shown, instruction)
    sieve = _Sieve(base, library, settings, known=[d.text for d in shown])
    for _ in range(ROUNDS):
        missing = n - len(sieve.kept)
        if not missing:
            break
        text = _asked(base, min(missing, MOST), instruction) + _told_off(sieve)
        try:
            answer = model.reply(Prompt(system=SYSTEM, examples=examples, text=text), Sentences).answer
        except LanguageModelError as error:
            sieve.unserved.append(Unserved("", "reply", printable(str(error), 400)))
            break
        for sentence in answer.sentences[:missing]:
            sieve.take(sentence)
    triples, texts = {d.snippet_ids for d in sieve.kept}, {_normalised(d.text) for d in sieve.kept}
    others = (d for d in offline if d.snippet_ids not in triples and _normalised(d.text) not in texts)
    return Told(
        by_model=tuple(sieve.kept),
        topped_up=tuple(islice(others, n - len(sieve.kept))),
        unserved=tuple(sieve.unserved),
    )


def describe_for(
    settings: RetrievalSettings, base: BaseScenario | None, n: int, *, seed: int, instruction: str = ""
) -> Told:
    """Make up scenarios by the language model of the settings, or offline.

    Raises:
        NothingFits: The library has nothing of the base scenario and the instruction.
        SettingsError: There is no such library, embedder or language model.
    """
    library = library_with(settings.library)
    if settings.language_model == OFFLINE:
        offline = describe(base, n, library=library, seed=seed, instruction=instruction)
        return Told(by_model=(), topped_up=offline, unserved=())
    model = load_language_model(settings.language_model, limits=LIMITS, cache=cache_folder("replies"))
    return describe_with(model, base, n, library=library, settings=settings, seed=seed, instruction=instruction)


class _Sieve:
    """Lets through what the library serves and what was not there before."""

    def __init__(
        self,
        base: BaseScenario | None,
        library: Library,
        settings: RetrievalSettings,
        *,
        known: Sequence[str],
    ) -> None:
        self._base, self._library, self._settings = base, library, settings
        self._seen = {_normalised(text) for text in known}
        self.kept: list[Description] = []
        self.unserved: list[Unserved] = []

    def take(self, sentence: str) -> None:
        text = printable(sentence, LONGEST + 1)
        found = self._unfit(text) or self._served(text)
        if isinstance(found, Description):
            self.kept.append(found)
        else:
            self.unserved.append(found)
        self._seen.add(_normalised(text))

    def _unfit(self, text: str) -> Unserved | None:
        if not SHORTEST <= len(text) <= LONGEST:
            return Unserved(text[:80], "text", f"a sentence has {SHORTEST} to {LONGEST} characters, not {len(text)}")
        if _normalised(text) in self._seen:
            return Unserved(text, "duplicate", "it was said before")
        return None

    def _served(self, text: str) -> Description | Unserved:
        try:
            frame = heard(text, self._settings)
            if frame.outright.adversary is None:
                return Unserved(text, "adversary", "it is read as no situation")
            scenario = understand(frame, self._settings)
            if scenario.base is None or self._base not in (None, scenario.base):
                return Unserved(text, "base", f"it is read as {scenario.base or 'none of the eight'}")
            found = retrieve(scenario, self._library, self._settings)
            bound(found.snippets, scenario)
        except (NothingFits, SettingsError) as error:
            return Unserved(text, "refused", printable(str(error), 300))
        behavior, geometry, spawn = (snippet.id for snippet in found.snippets)
        if any(d.snippet_ids == (behavior, geometry, spawn) for d in self.kept):
            return Unserved(text, "same triple", f"{behavior}, {geometry} and {spawn} serve another one already")
        return Description(
            text=text,
            base=scenario.base,
            adversary=found.adversary,
            snippet_ids=(behavior, geometry, spawn),
            slots=joined(found.snippets, found.adversary),
        )


def _examples(base: BaseScenario | None, described: Sequence[Description], instruction: str) -> tuple[Example, ...]:
    if not described:
        return ()
    reply = Sentences(sentences=[d.text for d in described]).model_dump_json()
    return (Example(_asked(base, len(described), instruction), reply),)


def _asked(base: BaseScenario | None, count: int, instruction: str) -> str:
    about = f" In all of them {_TOLD[base]}." if base else ""
    wish = f" They are about: {' '.join(instruction.split())}." if instruction.strip() else ""
    return f"Write {count} sentences.{about}{wish}"


def _told_off(sieve: _Sieve) -> str:
    """What a model is told when it is asked again."""
    said = [f"- {d.text}" for d in sieve.kept[-2 * SHOWN :]]
    there = "\nThere are already:\n" + "\n".join(said) if said else ""
    wrong = [f"- {one.text} ({one.message[:120]})" for one in sieve.unserved[-SHOWN:]]
    return there + ("\nThese could not be used:\n" + "\n".join(wrong) if wrong else "")


def _normalised(text: str) -> str:
    return " ".join(re.findall(r"[^\W_]+", text.casefold()))
