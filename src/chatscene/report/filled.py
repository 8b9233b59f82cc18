"""A text on the way to its situation: who reads it, what was stated beside it, and why it is refused."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields, replace
from typing import Any

from chatscene.build.build import Built, build
from chatscene.errors import EditRefused, NotBuilt, NothingFits, OfferedReading, SettingsError, SituationError, no_such
from chatscene.files.caches import cache_folder
from chatscene.interpret.known import SURE, WithFacts, offered, taken, taken_in_part
from chatscene.interpret.readers import is_model, reader_of
from chatscene.interpret.stated import FACTS, facts_stated, in_text, with_named
from chatscene.read.quotes import otherwise_named, words_of
from chatscene.read.users_unread import users_unread
from chatscene.report.stated import Editor, Stated, built_in_part, built_of, stated, with_edits
from chatscene.report.understood import NO_EDITS, Understood, understand
from chatscene.settings import OFFLINE, PAPER_READER, RetrievalSettings, Settings
from chatscene.situations.edited import Edited
from chatscene.situations.facts import NO_FACTS
from chatscene.situations.words import told
from chatscene.terms.reading import Ranked, SituationReading
from chatscene.terms.situation import Situation


def filled(
    text: str,
    settings: RetrievalSettings,
    facts: Mapping[str, object] | None = None,
    map_name: str | None = None,
    speed: float | None = None,
) -> Stated:
    """The situation that a text tells, with some facts set, and its program.

    Raises:
        SettingsError: The text is empty or too long, there is no such model, reading or fact, or a fact has no
            place.
        NothingFits: The reader says that it tells no situation, none that can be told here, or it is not sure enough.
        NotBuilt: A fact of the situation cannot be built.
        SituationError: A fact has no place in it.
        LanguageModelError: The model gave no usable reply.
    """
    with_facts = _stating(facts or {}, settings)
    cannot_build = _unbuilt(map_name, speed)
    read, one, ranked = _read(text, settings, with_facts, cannot_build)
    made = stated(one.situation, None, map_name, speed)
    doubted = not settings.reading and (one.probability < SURE or bool(one.situation.evidence.open))
    try:
        made, built = built_in_part(made)
    except NotBuilt as error:
        raise _with_what_was_read(error, read, one, offered(ranked, settings, cannot_build, one)) from None
    return Stated(
        situation=made,
        built=built,
        reader=read.reader,
        editor=editor_of(settings.language_model),
        readings=offered(ranked, settings, cannot_build, one) if doubted else (),
    )


def read_in(text: str, settings: RetrievalSettings, facts: Mapping[str, object] | None = None) -> Ranked:
    """What a text is read as, with some facts set, whether or not it can be built.

    Raises:
        SettingsError: The text is empty or too long, there is no such model, reading or fact, or a fact has no
            place.
        NothingFits: The reader says that it tells no situation, none that can be told here, or it is not sure enough.
        SituationError: A fact has no place in it.
        LanguageModelError: The model gave no usable reply.
    """
    return _read(text, settings, _stating(facts or {}, settings))[1]


def is_filled(text: str, settings: RetrievalSettings) -> bool:
    """Whether a situation is read in a text; the paper's way, and perhaps a library of one's own, choose snippets."""
    return bool(text) and settings.reader != PAPER_READER and not settings.library


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

    Raises:
        SettingsError: The text is empty or too long, or a speed or a map is given where snippets are chosen for it.
        EditRefused: An edit was not understood.
        NothingFits: Nothing serves it.
    """
    settings = settings or Settings()
    if (understood := _by_snippets(text, settings, facts)) is not None:
        _check_for_snippets(speed, map_name, edits)
        return understood
    return with_edits(filled(text, settings.retrieval, facts, map_name, speed), edits)


def unless_by_snippets(
    text: str,
    settings: Settings,
    *,
    facts: Mapping[str, object] | None = None,
    edits: Sequence[str] = (),
    map_name: str | None = None,
    speed: float | None = None,
) -> Stated | None:
    """What becomes of a text, as `explain_text`; None where snippets serve it, which a run chooses in its folder."""
    if settings.retrieval.reader == PAPER_READER or _by_snippets(text, settings, facts) is not None:
        _check_for_snippets(speed)
        return None
    return with_edits(filled(text, settings.retrieval, facts, map_name, speed), edits)


def _by_snippets(text: str, settings: Settings, facts: Mapping[str, object] | None = None) -> Understood | None:
    """The snippets that serve a text: in the paper's way any, else only if the user's own are among them."""
    if is_filled(text, settings.retrieval):
        return None
    reading = replace(settings.retrieval, stated=in_text(facts)) if facts else settings.retrieval
    try:
        understood = understand(text, replace(settings, retrieval=reading))
    except NothingFits:
        if reading.reader == PAPER_READER:
            raise
        return None
    from chatscene.library.load import library_with  # the library is read with pydantic, which takes a while to load

    packaged, chosen = {snippet.id for snippet in library_with("")}, understood.retrieval
    own = chosen is None or not packaged.issuperset(snippet.id for snippet in chosen.snippets)
    return understood if own or reading.reader == PAPER_READER else None


def _check_for_snippets(speed: float | None, map_name: str | None = None, edits: Sequence[str] = ()) -> None:
    """Refuse what is for situations alone, where snippets serve a text."""
    if speed is not None:
        raise SettingsError("the speed is for a situation, and here snippets are used")
    if map_name is not None:
        raise SettingsError("the map is for a situation, and here snippets are used")
    if edits:
        raise EditRefused(NO_EDITS)


def editor_of(language_model: str) -> Editor | None:
    """Who applies edits in words; None where no language model does. The model is loaded when it is asked."""
    if not is_model(language_model):
        return None

    def edited(situation: Situation, text: str) -> tuple[Edited, Built]:
        from chatscene.models.language.protocol import load_language_model
        from chatscene.read.by_model import LIMITS
        from chatscene.read.edit_by_model import edited_by

        model = load_language_model(language_model, limits=LIMITS, cache=cache_folder("replies"))
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
    return replace(
        settings,
        library=unasked.library,
        language_model=OFFLINE,
        reading=unasked.reading,
        stated=unasked.stated,
    )


def _read(
    text: str,
    settings: RetrievalSettings,
    with_facts: WithFacts,
    cannot_build: Callable[[Situation], str] = lambda _: "",
) -> tuple[SituationReading, Ranked, tuple[Ranked, ...]]:
    """What a reader gave, the reading that is taken, and all readings with what the user states."""

    def cannot_build_so(situation: Situation) -> str:
        try:
            return cannot_build(with_facts(situation))
        except (SituationError, SettingsError):  # which whoever states the facts is told
            return ""

    read = reader_of(settings, cannot_build_so).read(text)
    one, ranked = taken(read, with_facts, settings)
    if not settings.reading and (one.probability < settings.refuse_below or lacked(read, one)):
        part = taken_in_part(read, with_facts, settings, cannot_build)
        if part is None:
            raise _unsure(read, ranked, settings, cannot_build)
        return read, part, ranked
    return read, one, ranked


def lacked(read: SituationReading, one: Ranked) -> tuple[str, ...]:
    """The words of a text that name a road user whom a reading of the offline reader has not: it is not the whole.

    What a language model reads is not held against its text so.
    """
    return users_unread(one.situation, read.text) if read.reader == OFFLINE else ()


def _stating(facts: Mapping[str, object], settings: RetrievalSettings) -> WithFacts:
    """Sets the facts that a user states, by their names and by their paths."""
    named, by_path = _facts(facts, settings)

    def with_facts(situation: Situation) -> Situation:
        return stated(with_named(situation, named), by_path)

    return with_facts


def _facts(facts: Mapping[str, object], settings: RetrievalSettings) -> tuple[dict[str, Any], dict[str, object]]:
    """Facts that are stated by their names, and those that stand at a path."""
    wholes = {one.name for one in fields(Situation)}
    named = {name: value for name, value in facts.items() if "." not in name and name.replace("-", "_") in FACTS}
    for name in facts:
        if "." not in name and name not in wholes and name not in named:
            known = no_such("fact", name, {*FACTS, *wholes - NO_FACTS})
            raise SettingsError(f"{known}; or say the path of a fact, as in others.A.starts.side or road.lanes")
    said = " ".join(filter(None, (settings.stated, in_text(named))))
    return facts_stated(said), {name: value for name, value in facts.items() if name not in named}


def _unsure(
    read: SituationReading,
    ranked: Sequence[Ranked],
    settings: RetrievalSettings,
    cannot_build: Callable[[Situation], str],
) -> NothingFits:
    """Why a text is refused of which it is not sure enough what it says."""
    sure = ranked[0].probability
    said = f"the reading is too uncertain (confidence {sure:.0%}; {settings.refuse_below:.0%} is needed)"
    if sure >= settings.refuse_below:
        said = f"the reading (confidence {sure:.0%}) has nobody for {', '.join(map(repr, lacked(read, ranked[0])))}"
    unread = (f"no fact was read in {', '.join(map(repr, read.unread))}",) if read.unread else ()
    readings, likeliest = offered(ranked, settings, cannot_build), ranked[0].situation
    why = "" if readings else cannot_build(likeliest)  # else nothing says why there is no reading to choose
    unbuilt = (f"as it is read it cannot be built: {why}",) if why else ()
    reasons = (*unread, *otherwise_named(likeliest), *unbuilt)
    told_so = NothingFits("; ".join((said, *reasons)), reasons=reasons or (said,), confidence=sure)
    return _with_what_was_read(told_so, read, ranked[0], readings)


def _with_what_was_read(
    refusal: NothingFits, read: SituationReading, one: Ranked, readings: tuple[OfferedReading, ...]
) -> NothingFits:
    """A refusal that says what was read, word by word, and what else the text may say."""
    refusal.understood = told(one.situation)
    refusal.text = read.text
    refusal.words = tuple(word.as_dict() for word in words_of(one.situation, read.text))
    refusal.readings = readings
    return refusal


def _unbuilt(map_name: str | None, speed: float | None) -> Callable[[Situation], str]:
    """Why a situation cannot be built; empty if it can."""

    def why(situation: Situation) -> str:
        try:
            build(stated(situation, None, map_name, speed))
        except NotBuilt as error:
            return str(error)
        return ""

    return why
