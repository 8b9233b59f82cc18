"""Who reads a text, and what it says as a frame: the facts of the situation that was read in it.

Who chooses snippets (the paper's way, a library of one's own) takes a frame, whoever read it.
"""

from __future__ import annotations

from dataclasses import replace

from chatscene.errors import NothingFits
from chatscene.interpret.decide import understand
from chatscene.interpret.known import SURE, offered, taken
from chatscene.interpret.readers import reader_of
from chatscene.interpret.slots_of import facts_of, parties_of
from chatscene.interpret.stated import facts_stated, in_text, with_named
from chatscene.read.clauses import cut
from chatscene.read.quotes import unread, words_of
from chatscene.read.reader import in_one_line
from chatscene.settings import OFFLINE, RetrievalSettings
from chatscene.terms.conclusions import concluded
from chatscene.terms.frame import About, Clauses, Frame, Note
from chatscene.terms.scenario import QuantityKind, Scenario, Unused, Why
from chatscene.terms.situation import Situation


def heard(text: str, settings: RetrievalSettings) -> Frame:
    """Read a text for whoever chooses snippets.

    What tells no situation says nothing, and nothing of it is sure.

    Raises:
        SettingsError: The text is empty or too long, there is no such model or reading, or a fact that the user stated
            has no place in it.
        LanguageModelError: The model gave no usable reply.
        MissingExtra: The language model's package is missing.
        NothingFits: The text is not English.
    """
    plain = in_one_line(text)
    read = reader_of(settings).read(plain)
    frame = Frame(text=plain, clauses=Clauses(whole=plain))
    if read.reader != OFFLINE:
        frame = replace(frame, reader=read.reader, notes=(Note(about=About.READER, said=(read.reader,)),))
    named = facts_stated(settings.stated)
    try:
        one, ranked = taken(read, lambda situation: with_named(situation, named), settings)
    except NothingFits:
        return replace(frame, notes=(*frame.notes, Note(about=About.NOTHING, said=(read.reader, read.verdict.said))))
    notes = [Note(about=About.STATED, said=(in_text(named).replace(" ", ", "),))] if named else []
    if settings.reading:
        notes.append(Note(about=About.TAKEN, said=(str(settings.reading), f"{one.probability:.0%} likely")))
    refused = not settings.reading and one.probability < settings.refuse_below
    doubted = not settings.reading and one.probability < SURE
    return replace(
        said_by(frame, one.situation),
        sure=1.0 if settings.reading else one.probability,
        notes=(*frame.notes, *notes),
        readings=offered(ranked, settings, served=None if refused else one) if doubted else (),
    )


def scenario_of(text: str, settings: RetrievalSettings | None = None) -> Scenario:
    """What a text says, for whoever chooses snippets for it.

    Raises:
        SettingsError: As `heard`.
        LanguageModelError: The model gave no usable reply.
        NothingFits: The text is not English, or in the paper's way no triple has the kind of road user that was said.
    """
    settings = settings or RetrievalSettings()
    return understand(heard(text, settings), settings)


def said_by(frame: Frame, situation: Situation) -> Frame:
    """A frame with the facts of the situation that was read in its text; none where nobody meets the ego."""
    parties = parties_of(situation)
    if parties is None:
        return frame
    facts = facts_of(situation, parties)
    numbers = facts.quantities
    words = words_of(situation, frame.text)
    return replace(
        frame,
        clauses=cut(frame.text, words),
        outright=concluded(facts.slots),
        quantities=tuple(one for one in numbers if one.measure is not QuantityKind.EGO_SPEED),
        ego_speed=next((one for one in numbers if one.measure is QuantityKind.EGO_SPEED), None),
        surroundings=facts.surroundings,
        unused=tuple(Unused(said=words, why=Why.WORDS) for words in unread(situation, frame.text)),
        words=words,
    )
