"""A reader that asks a language model: it fills a whole situation from a text, in one question.

What it writes is data, and it is held to everything that a situation is held to: its form, its contradictions, the
text that it quotes, and what the caller can build. What is wrong goes back to it in words.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, fields, replace
from typing import Any, cast, get_args, get_type_hints

from pydantic import BaseModel, ConfigDict

from chatscene.errors import NoUsableReply
from chatscene.models.language.protocol import LanguageModel, Limits, Prompt
from chatscene.models.language.structured import printable
from chatscene.read.quotes import faults_of_quotes, unread, without_words
from chatscene.read.reader import check_text
from chatscene.read.situation_prompt import EXAMPLES, form, system
from chatscene.situations.facts import NO_FACTS, is_said
from chatscene.situations.faults import Fault, Malformed, Path, by_name
from chatscene.situations.form import parsed
from chatscene.terms.amount import Amount
from chatscene.terms.reading import Ranked, SituationReading, Verdict
from chatscene.terms.situation import Deed, Ego, Road, Situation, Start, When
from chatscene.terms.vocabulary import UserKind

LIMITS = Limits(reply_tokens=2048)  # a situation of four road users with three deeds each has some 1,500
LONGEST_REASON = 300  # characters of a model's own words that a message repeats
_NOT_THE_MODELS = NO_FACTS - {"evidence"}  # a map, for one, is a file: nobody but the user names one
_PARTS = frozenset(("ego", "road", "contact", "around"))
_AMOUNTS = frozenset(
    one.name
    for noun in (Ego, Road, Start, Deed, When)
    for one in fields(noun)
    if any(isinstance(kind, type) and issubclass(kind, Amount) for kind in get_args(get_type_hints(noun)[one.name]))
)


class Answer(BaseModel):
    """What a model is asked for; what is wrong with the situation is told with its paths, beside what it is."""

    model_config = ConfigDict(extra="ignore")

    verdict: Verdict
    reason: str | None = ""
    situation: dict[str, Any] | None = None


@dataclass(frozen=True, slots=True)
class ModelReader:
    """Reads by a language model; see `chatscene.read.reader.Reader` for the contract."""

    model: LanguageModel
    cannot_build: Callable[[Situation], str] = lambda _: ""

    @property
    def name(self) -> str:
        """That of the model."""
        return self.model.name

    def read(self, text: str) -> SituationReading:
        """What a text tells.

        A situation that still cannot be built when the model was told so twice, or gives it again, is given as it is:
        whoever builds it leaves out, or refuses, the fact.

        Raises:
            SettingsError: The text is empty or too long.
            LanguageModelError: The model gave no situation that is one; the message names the last faults.
        """
        check_text(text)
        sound: list[Situation] = []  # but for what cannot be built, the last one last

        def check(answer: Answer) -> str:
            if answer.verdict is not Verdict.SITUATION:
                return "" if (answer.reason or "").strip() else "reason: say in one sentence why it is no situation"
            try:
                situation = situation_in(answer.situation)
            except Malformed as error:
                return faults_in(answer.situation, error)
            situation = without_empty_quotes(situation)
            if faults := list(faults_of_quotes(situation, text)):
                return "; ".join(faults)
            if sound and situation == sound[-1]:
                return ""
            sound.append(situation)
            if why := self.cannot_build(situation):
                return (
                    f"it cannot be built: {why}. If the text can be told in other words of the form, use those; never "
                    "leave out or change what the text says: if it needs this fact, give the same situation again, "
                    "which is built without it where that can be, and tells so"
                )
            return ""

        asked = Prompt(system=system(), examples=EXAMPLES, text=text, form=form())
        try:
            answer = self.model.reply(asked, Answer, check=check).answer
        except NoUsableReply:
            if not sound:
                raise
            return self._reading(text, sound[-1])
        if answer.verdict is not Verdict.SITUATION:
            reason = printable(answer.reason or "", LONGEST_REASON)
            return SituationReading(text=text, reader=self.name, verdict=answer.verdict, reason=reason, tells=0.0)
        return self._reading(text, sound[-1])

    def _reading(self, text: str, situation: Situation) -> SituationReading:
        evidence = replace(situation.evidence, assumed=without_words(situation))
        made = replace(situation, about=text, evidence=evidence)
        return SituationReading(
            text=text,
            reader=self.name,
            verdict=Verdict.SITUATION,
            ranked=(Ranked(situation=made, probability=1.0),),
            unread=unread(made, text),
        )


def without_empty_quotes(situation: Situation) -> Situation:
    """The same without words that were quoted for a part of which nothing was said: they are told as not read."""
    quoted = situation.evidence.quoted
    kept = {path: words for path, words in quoted.items() if path not in _PARTS or is_said(situation, path)}
    return (
        situation if len(kept) == len(quoted) else replace(situation, evidence=replace(situation.evidence, quoted=kept))
    )


def faults_in(written: object, error: Malformed) -> str:
    """What is wrong with a situation that a model wrote, with the path of each fault, as it is told so."""
    return "; ".join(f"{at}: {said}" if at else said for at, said in by_name(written, error.faults))


def situation_in(written: dict[str, Any] | None) -> Situation:
    """The situation that a model wrote; null says as little as nothing.

    Raises:
        Malformed: It is none, or nobody is in it.
    """
    if not written:
        raise Malformed([Fault(("situation",), "is missing")])
    said = _as_default({name: value for name, value in _said(written).items() if name not in _NOT_THE_MODELS})
    if bare := list(_without_unit(said, ())):
        raise Malformed(
            Fault(path, f"{value!r} has no unit; write it as in '50 km/h', '20 m', '2 s'") for path, value in bare
        )
    situation = parsed(said)
    if not situation.others:
        raise Malformed([Fault(("others",), "nobody is there whom the ego meets; without one there is no situation")])
    return situation


def _as_default(said: dict[str, Any]) -> dict[str, Any]:
    """The same without a kind of the ego that says no more than nothing: it is a vehicle by itself."""
    ego = said.get("ego")
    if not isinstance(ego, dict) or cast("dict[str, Any]", ego).get("kind") != UserKind.VEHICLE:
        return said
    return {**said, "ego": {name: one for name, one in cast("dict[str, Any]", ego).items() if name != "kind"}}


def _said(value: Any) -> Any:
    """A value without what is null."""
    if isinstance(value, dict):
        named = cast("dict[str, Any]", value)
        return {name: _said(one) for name, one in named.items() if one is not None}
    return [_said(one) for one in cast("list[Any]", value)] if isinstance(value, list) else value


def _without_unit(value: Any, path: Path) -> Iterator[tuple[Path, Any]]:
    """The amounts that are numbers alone, of which a model thinks in whatever unit the text has."""
    if isinstance(value, dict):
        for name, one in cast("dict[str, Any]", value).items():
            yield from _without_unit(one, (*path, name))
    elif isinstance(value, list):
        for i, one in enumerate(cast("list[Any]", value)):
            yield from _without_unit(one, (*path, i))
    elif path and path[-1] in _AMOUNTS and "evidence" not in path and not Amount.has_unit(value):
        yield path, value
