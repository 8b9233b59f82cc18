"""What a text may say once a user stated some of it, and which of its readings a user is asked to choose between."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from chatscene.errors import NothingFits, OfferedReading, SettingsError, SituationError
from chatscene.settings import MOST_READINGS, OFFLINE, RetrievalSettings
from chatscene.situations.facts import said_in, with_fact
from chatscene.situations.main_facts import same_in_the_main
from chatscene.situations.words import told
from chatscene.terms.reading import Ranked, SituationReading, Verdict
from chatscene.terms.situation import Situation

SURE = 0.75  # of a text as likely to be read rightly as this, no other readings are told
SURE_IN_PART = 0.7  # from here on a part of a text is served where the whole is not sure enough
FAINTEST = 0.005  # a reading less likely than this is not offered
_BESIDE_SERVED = 2  # readings that are told where something is served
_FAINT = 0.1  # a further reading is offered from this share of the probability of the likeliest on

WithFacts = Callable[[Situation], Situation]
"""Sets what a user stated in a situation."""


def once_known(ranked: Sequence[Ranked], with_facts: WithFacts) -> tuple[Ranked, ...]:
    """Readings once a user stated some facts: those that agree in all others are one, as likely as all of them.

    It is told as the likeliest of them in which the reader itself has what was stated, else as the likeliest.

    Raises:
        SettingsError: A fact has no place in the likeliest reading.
        SituationError: The same of a fact that is stated by its path.
    """
    found: list[Ranked] = []
    ours: set[int] = set()  # of which the reader itself has it so
    for one in ranked:
        try:
            made = with_facts(one.situation)
        except (SettingsError, SituationError):
            if one is ranked[0]:
                raise
            continue  # so it is not what the user means
        at = next((i for i, other in enumerate(found) if same_in_the_main(made, other.situation)), None)
        if at is None:
            at = len(found)
            found.append(replace(one, situation=made))
        else:
            kept = made if made == one.situation and at not in ours else found[at].situation
            likely = min(found[at].probability + one.probability, 1.0)
            found[at] = replace(found[at], situation=kept, probability=likely)
        if made == one.situation:
            ours.add(at)
    return tuple(sorted(found, key=lambda one: -one.probability))


def taken(
    read: SituationReading, with_facts: WithFacts, settings: RetrievalSettings
) -> tuple[Ranked, tuple[Ranked, ...]]:
    """The reading of a text that is taken, and all that there are with what the user stated, the likeliest first.

    Raises:
        NothingFits: The text tells no situation.
        SettingsError: There is no such reading, or a fact has no place in it.
        SituationError: A fact has no place in it.
    """
    if read.verdict is not Verdict.SITUATION:
        reader = "the offline reader" if read.reader == OFFLINE else read.reader
        because = f": “{read.reason}”" if read.reason else ""
        reason = read.reason or read.verdict.said
        raise NothingFits(f"{reader} says that {read.verdict.said}{because}", reasons=(reason,))
    ranked = once_known(read.ranked, with_facts)
    if settings.reading > len(ranked):
        raise SettingsError(f"there is no reading {settings.reading} of this text; {read.reader} gives {len(ranked)}")
    return ranked[max(settings.reading, 1) - 1], ranked


def taken_in_part(
    read: SituationReading,
    with_facts: WithFacts,
    settings: RetrievalSettings,
    cannot_build: Callable[[Situation], str] = lambda _: "",
) -> Ranked | None:
    """The most of what a text says that is sure enough to be served without the rest; None if nothing is."""
    least = max(settings.refuse_below, SURE_IN_PART)
    for one in read.parts:
        try:
            is_so = with_facts(one.situation) == one.situation
        except (SettingsError, SituationError):
            continue
        if is_so and one.probability >= least and not cannot_build(one.situation):
            return one
    return None


def offered(
    ranked: Sequence[Ranked],
    settings: RetrievalSettings,
    cannot_build: Callable[[Situation], str] = lambda _: "",
    served: Ranked | None = None,
) -> tuple[OfferedReading, ...]:
    """What a user may choose between, by its number, the likeliest first; only what can be built.

    Beside what is served these are of the two likeliest; else of the three, the third if it is not much fainter.
    """
    most = MOST_READINGS if served is None else _BESIDE_SERVED
    faintest = max(FAINTEST, _FAINT * ranked[0].probability) if ranked else FAINTEST
    is_told = told(served.situation) if served is not None else ""
    numbered = [(number, one) for number, one in enumerate(ranked[:most], 1) if told(one.situation) != is_told]
    return tuple(
        OfferedReading(
            number=number,
            told=told(one.situation),
            probability=one.probability,
            settled_by=_settling(one, ranked, settings),
        )
        for number, one in numbered
        if one.probability >= (FAINTEST if number <= _BESIDE_SERVED else faintest) and not cannot_build(one.situation)
    )


def _settling(one: Ranked, ranked: Sequence[Ranked], settings: RetrievalSettings) -> str:
    """The fact, as ``path=value``, by which a reading is sure enough once it is stated; empty if no single one is."""
    rival = next((other for other in ranked if other is not one), None)
    if rival is None:
        return ""
    for path, value in _apart(one.situation, rival.situation):

        def stating(situation: Situation, path: str = path, value: object = value) -> Situation:
            return with_fact(situation, path, value)

        try:
            first = once_known(ranked, stating)[0]
        except SituationError:
            continue
        if same_in_the_main(first.situation, one.situation) and first.probability >= settings.refuse_below:
            return f"{path}={value}"
    return ""


def _apart(one: Situation, other: Situation) -> Iterator[tuple[str, object]]:
    """The facts of one situation that another has otherwise or not at all."""
    theirs = dict(said_in(other))
    return ((path, value) for path, value in said_in(one) if theirs.get(path) != value)
