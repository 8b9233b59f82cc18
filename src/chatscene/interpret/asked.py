"""What a text says as a frame, where a language model reads it: the facts of the situation that the model fills.

Who chooses snippets (the paper's way, a library of one's own) takes a frame, whoever read it.
"""

from __future__ import annotations

from dataclasses import replace

from chatscene.errors import LanguageModelError, SettingsError
from chatscene.files.caches import cache_folder
from chatscene.interpret.slots_of import facts_of, parties_of
from chatscene.models.language.protocol import load_language_model
from chatscene.read.by_model import LIMITS, ModelReader
from chatscene.read.reading import read
from chatscene.settings import LEARNED, OFFLINE, RetrievalSettings
from chatscene.terms.conclusions import concluded
from chatscene.terms.frame import About, Frame, Note, certain
from chatscene.terms.scenario import Slots, Why


def heard(text: str, settings: RetrievalSettings) -> Frame:
    """Read a text, offline or by the language model that the settings name.

    The model's facts are sure; what it gives no situation for says nothing. Notes say who read it, and where the two
    readers differ.

    Raises:
        SettingsError: The text is empty or too long, there is no such model, or the reader chooses no snippets.
        MissingExtra: The language model's package is missing.
    """
    if settings.reader == LEARNED:
        raise SettingsError(f"the reader {LEARNED!r} writes situations, for run and explain; it chooses no snippets")
    frame = read(text, settings)
    if settings.language_model == OFFLINE:
        return frame
    model = load_language_model(settings.language_model, limits=LIMITS, cache=cache_folder("replies"))
    try:
        read_so = ModelReader(model).read(text)
    except LanguageModelError as error:
        return replace(frame, notes=(*frame.notes, Note(about=About.OFFLINE, said=(str(error),))))
    situation = read_so.ranked[0].situation if read_so.ranked else None
    parties = parties_of(situation) if situation is not None else None
    facts = facts_of(situation, parties) if situation is not None and parties is not None else None
    slots = concluded(facts.slots) if facts is not None else Slots()
    differ = [
        Note(about=About.DIFFERENT, said=(name, model.name, str(new), "the offline reader", str(old)))
        for name, new in slots.said().items()
        if (old := frame.beliefs.likeliest(name)) not in (None, new)
    ]
    return replace(
        frame,
        outright=slots,
        beliefs=certain(slots, frame.beliefs),
        quantities=facts.quantities if facts is not None else (),
        surroundings=facts.surroundings if facts is not None else frame.surroundings,
        unused=tuple(one for one in frame.unused if one.why not in (Why.WORDS, Why.LANGUAGE)),  # it knows more
        notes=(Note(about=About.READER, said=(model.name,)), *differ),
        reader=model.name,
        whole=False,
    )
