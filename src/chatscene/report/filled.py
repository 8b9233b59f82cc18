"""A text on the way to its situation: who reads it, what was stated beside it, and why it is refused."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence, Set
from dataclasses import fields, replace

from chatscene.build.build import Built, build
from chatscene.errors import NotBuilt, NothingFits, OfferedReading, SettingsError, SituationError, no_such
from chatscene.files.caches import cache_folder
from chatscene.interpret.offline import OfflineReader
from chatscene.interpret.stated import FACTS, in_text
from chatscene.models.language.protocol import load_language_model
from chatscene.read.by_model import LIMITS, ModelReader
from chatscene.read.edit_by_model import edited_by
from chatscene.read.quotes import words_of
from chatscene.read.reader import Reader
from chatscene.report.stated import Editor, Stated, built_of, stated, with_edits
from chatscene.report.understood import Understood, understand
from chatscene.settings import LEARNED, OFFLINE, READERS, RetrievalSettings, Settings
from chatscene.situations.edited import Edited
from chatscene.situations.facts import NO_FACTS
from chatscene.situations.words import told
from chatscene.terms.reading import Ranked, SituationReading, Verdict
from chatscene.terms.situation import Situation


def filled(
    text: str,
    settings: RetrievalSettings,
    facts: Mapping[str, object] | None = None,
    map_name: str | None = None,
    speed: float | None = None,
) -> Stated:
    """The situation that a text tells, with some facts set, and its program.

    Args:
        text: The text.
        settings: Who reads, and which reading is taken.
        facts: Facts that the user states: by their paths, or, where no language model reads, by their names.
        map_name: The map that it is to be built on; None for any.
        speed: What the ego drives at [km/h], if the text does not say.

    Raises:
        SettingsError: The text is empty or too long, there is no such model, reading or fact, or a fact has no place.
        NothingFits: The reader says that it tells no situation, none that can be told here, or it is not sure enough.
        NotBuilt: A fact of the situation cannot be built.
        SituationError: A fact has no place in it.
        LanguageModelError: The model gave no usable reply.
    """
    _, by_path = _facts(facts or {}, settings)
    read, one = read_in(text, settings, facts, _unbuilt(by_path, map_name, speed))
    made = stated(one.situation, by_path, map_name, speed)
    try:
        built = built_of(made)
    except NotBuilt as error:
        raise _with_what_was_read(error, read, one) from None
    return Stated(
        situation=made,
        built=built,
        reader=read.reader,
        not_said=one.left_out,
        editor=editor_of(settings.language_model),
        readings=_offered(read, one),
    )


def read_in(
    text: str,
    settings: RetrievalSettings,
    facts: Mapping[str, object] | None = None,
    cannot_build: Callable[[Situation], str] = lambda _: "",
) -> tuple[SituationReading, Ranked]:
    """What a text is read as, and which of the readings is taken.

    Args:
        text: The text.
        settings: Who reads, and which reading is taken.
        facts: Facts that the user states, of which those count that a reader takes by their names.
        cannot_build: Why nothing can be built of a situation; empty where that is no matter.

    Raises:
        SettingsError: The text is empty or too long, or there is no such model, reading or fact.
        NothingFits: The reader says that it tells no situation, none that can be told here, or it is not sure enough.
        LanguageModelError: The model gave no usable reply.
    """
    named, _ = _facts(facts or {}, settings)
    reader = _reader(settings, named, cannot_build)
    read = reader.read(text)
    if read.verdict is not Verdict.SITUATION:
        raise NothingFits(f"{read.reader} says that {read.verdict.said}: “{read.reason}”", reasons=(read.reason,))
    taken = settings.reading if reader.name != OFFLINE else 0  # which the offline reader takes itself
    if taken > len(read.ranked):
        raise SettingsError(f"there is no reading {taken}; {read.reader} gives {len(read.ranked)}")
    one = read.ranked[max(taken, 1) - 1]
    if not taken and one.probability < settings.refuse_below:
        raise _unsure(read, one)
    return read, one


def is_filled(text: str, settings: RetrievalSettings) -> bool:
    """Whether a situation is read in a text; a library of one's own and the paper's way choose snippets for it."""
    return bool(text) and settings.reader in (READERS[0], LEARNED) and not settings.library


def explain_text(
    text: str,
    settings: Settings | None = None,
    *,
    facts: Mapping[str, object] | None = None,
    edits: Sequence[str] = (),
    map_name: str | None = None,
    speed: float | None = None,
) -> Understood | Stated:
    """What becomes of a text, and of edits of it, before anything is run.

    Args:
        text: The text.
        settings: Who reads it, among others.
        facts: Facts that the user states.
        edits: What is to be another than it says, in words, one after the other.
        map_name: The map that it is to be built on; None for any.
        speed: What the ego drives at [km/h], if the text does not say.

    Raises:
        SettingsError: The text is empty or too long, or a speed is given where snippets are chosen for it.
        EditRefused: An edit was not understood.
        NothingFits: Nothing serves it.
    """
    settings = settings or Settings()
    if not is_filled(text, settings.retrieval):
        if speed is not None:
            raise SettingsError(
                "the ego's speed is for a text of which a situation is made, and here snippets are chosen"
            )
        reading = replace(settings.retrieval, stated=in_text(facts)) if facts else settings.retrieval
        return understand(text, replace(settings, retrieval=reading), edits=edits)
    return with_edits(filled(text, settings.retrieval, facts, map_name, speed), edits)


def editor_of(language_model: str) -> Editor | None:
    """Who applies edits in words; None where no language model does."""
    if language_model == OFFLINE:
        return None
    model = load_language_model(language_model, limits=LIMITS, cache=cache_folder("replies"))

    def edited(situation: Situation, text: str) -> tuple[Edited, Built]:
        tried: list[tuple[Situation, Built]] = []

        def cannot_build(one: Situation) -> str:
            try:
                tried.append((one, built_of(one)))
            except NotBuilt as error:
                return str(error)
            return ""

        made = edited_by(model, cannot_build)(situation, text)
        return made, next((built for one, built in tried if one is made.after), None) or built_of(made.after)

    return edited


def read_already(settings: RetrievalSettings) -> RetrievalSettings:
    """The settings of a run of what was read: no model is asked again, and nothing is chosen or stated any more."""
    unasked = RetrievalSettings()
    return replace(settings, language_model=OFFLINE, reading=unasked.reading, stated=unasked.stated)


def _reader(settings: RetrievalSettings, named: str, cannot_build: Callable[[Situation], str]) -> Reader:
    if settings.reader == LEARNED:
        from chatscene.read.learned.reader import LearnedReader

        return LearnedReader()
    if settings.language_model == OFFLINE:
        facts = " ".join(filter(None, (settings.stated, named)))
        return OfflineReader(replace(settings, stated=facts), cannot_build)
    model = load_language_model(settings.language_model, limits=LIMITS, cache=cache_folder("replies"))
    return ModelReader(model, cannot_build)


def _facts(facts: Mapping[str, object], settings: RetrievalSettings) -> tuple[str, dict[str, object]]:
    """Facts that the offline reader takes by their names, as it takes them, and those that stand at a path."""
    offline = settings.language_model == OFFLINE and settings.reader != LEARNED
    wholes = {one.name for one in fields(Situation)}
    for name in facts:
        if "." not in name and name not in wholes and not (offline and _name(name) in FACTS):
            raise SettingsError(_nowhere(name, (*FACTS,) if offline else (), wholes))
    named = {name: value for name, value in facts.items() if offline and "." not in name and _name(name) in FACTS}
    return in_text(named), {name: value for name, value in facts.items() if name not in named}


def _nowhere(name: str, named: Sequence[str], wholes: Set[str]) -> str:
    """Why a fact cannot be set that has no such name: what can be, by name and by path."""
    known = no_such("fact", name, {*named, *wholes - NO_FACTS})
    return f"{known}; or say the path of a fact, as in others.A.starts.side or road.lanes"


def _name(fact: str) -> str:
    return fact.replace("-", "_")


def _unsure(read: SituationReading, one: Ranked) -> NothingFits:
    """Why a text is refused of which it is not sure enough what it says."""
    said = f"it is not sure enough what this says (confidence {one.probability:.0%})"
    reasons = tuple(filter(None, read.reason.split("; ")))
    told_so = f"{said}: {read.reason}" if read.reason else said
    return _with_what_was_read(NothingFits(told_so, reasons=reasons, confidence=one.probability), read, one)


def _with_what_was_read(refusal: NothingFits, read: SituationReading, one: Ranked) -> NothingFits:
    """A refusal that says what was read, word by word, and what else the text may say."""
    refusal.understood = told(one.situation)
    refusal.text = read.text
    refusal.words = tuple(word.as_dict() for word in words_of(one.situation, read.text))
    refusal.readings = _offered(read)
    return refusal


def _offered(read: SituationReading, taken: Ranked | None = None) -> tuple[OfferedReading, ...]:
    """What a text may say, but for what was taken."""
    others = zip(read.ranked[1:], read.settled_by[1:], strict=False)
    return tuple(
        OfferedReading(number=number, told=told(other.situation), probability=other.probability, settled_by=settled)
        for number, (other, settled) in enumerate(others, 1)
        if taken is None or other.situation != taken.situation
    )


def _unbuilt(
    facts: Mapping[str, object] | None, map_name: str | None, speed: float | None
) -> Callable[[Situation], str]:
    """Why a situation, with what the user states, cannot be built; empty if it can."""

    def why(situation: Situation) -> str:
        try:
            build(stated(situation, facts, map_name, speed))
        except NotBuilt as error:
            return str(error)
        except SituationError:  # which whoever states the facts is told
            return ""
        return ""

    return why
