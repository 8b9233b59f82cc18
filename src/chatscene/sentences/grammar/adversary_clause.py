"""The clause about the adversary: who it is, where, and what it does."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from chatscene.sentences.grammar import deed_pairs, deeds, where, who
from chatscene.sentences.grammar.quoting import predicate
from chatscene.sentences.grammar.voice import Voice
from chatscene.situations.inflection import Form, conjugated
from chatscene.terms.actors import Manner
from chatscene.terms.acts import Action
from chatscene.terms.description import Style
from chatscene.terms.nouns import plural, with_article
from chatscene.terms.scenario import Distance, Position

OWN_WORDS = 0.35  # share of sentences that say what the adversary does in the words of its snippet, where they fit

_BEHIND = (Position.BEHIND, Position.BEHIND_BESIDE)
_WITH_SPEED = {Action.CROSS, Action.ACCELERATE, Action.FOLLOW}  # have phrases of their own for doing so fast
_QUALIFIED = re.compile(r" (?:on|with) ")
_AT_JUNCTION = re.compile("intersection|junction|crossroads|corner")
_COMING_OUT = re.compile(r"\[(?:emerge|come)\](?: out)? \{from\} and ")
_BEFORE_EGO = re.compile(r"^\[(?:stop|halt|come|freeze)\].*(?:front|path|lane)|towards")
_ABRUPT = re.compile(r"abrupt|sudden|without|sharp|hard|dead|slow|moment|short")
_JOINED = re.compile(r" (?:and|then|but|before) ")
_GOING = re.compile(r"^\[(?:keep|carry|continue|go|drive|ride)\]| before ")
_LISTED = re.compile(r" (?:and|then) ")
_CONTENT = re.compile(
    r"\b(?:towards|behind|head-on|heading|head|coming|come|front|stop|stand|walk|level|pace|alongside|beside|opposite|driv)\w*"
)


@dataclass(frozen=True, slots=True)
class Adversary:
    """How a sentence speaks of the adversary.

    Attributes:
        noun: With its article.
        where: What follows the noun: place and distance.
        stands: Its place as a predicate after *is*; empty where what it does says it.
        pronoun: it, he, she or they.
        many: Whether it is a group.
        does: Marked phrases, in order.
        quoted: Whether the phrases are finite already (third person, present).
    """

    noun: str
    where: str
    stands: str
    pronoun: str
    many: bool
    does: tuple[str, ...]
    quoted: bool = False

    @property
    def subject(self) -> str:
        """The noun and where it is."""
        return f"{self.noun} {self.where}".strip()


def adversary(voice: Voice, texts: Sequence[str], at_junction: bool) -> Adversary:
    """Decide how a telling speaks of the adversary.

    Args:
        voice: Who tells it.
        texts: Wordings of its behavior that may be quoted.
        at_junction: Whether it happens at a junction.
    """
    slots = voice.slots
    manner = slots.adversary.row.manner if slots.adversary else Manner.DRIVES
    noun, pronoun, many = _noun(voice)
    finite = many or voice.past or voice.style is Style.TELEGRAM
    quoted = None if finite else _quoted(voice, texts, manner, at_junction)
    does = (quoted,) if quoted else _deeds(voice, manner, at_junction)
    origin = _origin(voice) if not quoted and "{from}" in does[0] and voice.chance(0.65) else ""
    oncoming = slots.position is Position.ONCOMING and manner is not Manner.WALKS
    before = oncoming and slots.side is None and not many and voice.chance(0.5)
    stands = "" if origin or before else _post(voice, does, manner)
    if not origin:  # nobody emerges from nowhere
        does = tuple(_COMING_OUT.sub("", phrase) for phrase in does)
    return Adversary(
        noun=noun if many else _article(voice, f"oncoming {noun}" if before else noun),
        where=f"{stands}, {_distance(voice)}," if slots.distance is not None else stands,
        stands=stands,
        pronoun=pronoun,
        many=many,
        does=tuple(voice.fill(phrase, pronoun, voice.fill(origin, pronoun)) for phrase in does),
        quoted=quoted is not None,
    )


def acts(voice: Voice, one: Adversary, many: bool) -> str:
    """What the adversary does, as a finite predicate; `many` counts the subject that stands before it."""
    if one.quoted:
        return one.does[0]
    verbs = [voice.finite(phrase, many) for phrase in one.does]
    if voice.style is Style.TELEGRAM or len(verbs) == 1:
        return ", ".join(verbs)
    first, last = ", ".join(verbs[:-1]), verbs[-1]
    if _JOINED.search(first):
        return f"{first}, then {last}"
    if _LISTED.search(last):
        return f"{first}, {last}"
    between = voice.pick((" and ", " and ", " and then ", ", then ", " before "))
    if between == " before ":
        ends = len(verbs) == 2 and one.does[-1].startswith("[") and not _GOING.search(one.does[-1])
        between, last = (between, conjugated(one.does[-1], Form.ING)) if ends else (" and ", last)
    return f"{first}{between}{last}"


# Who


def _noun(voice: Voice) -> tuple[str, str, bool]:
    """A noun without article, its pronoun, and whether it is in the plural."""
    kind = voice.slots.adversary
    options = who.NOUNS[kind] if kind else who.UNNAMED
    if voice.slots.group:  # "three men on a bicycle" would be another situation
        options = tuple(option for option in options if not _QUALIFIED.search(option))
    noun, _, pronoun = voice.pick(options).partition(":")
    if voice.slots.group:
        return voice.pick(who.GROUPS).format(many=plural(noun)), "they", True
    if kind and kind.row.painted and voice.chance(0.15):
        noun = f"{voice.pick(who.COLOURS)} {noun}"
    return noun, pronoun or ("they" if kind and kind.is_vulnerable else "it"), False


def _article(voice: Voice, noun: str) -> str:
    if voice.slots.adversary is not None and voice.style is Style.COLLOQUIAL and voice.chance(0.25):
        return f"some {noun}" if voice.chance(0.5) else f"this {noun}"
    return with_article(noun)


# Where


def _origin(voice: Voice) -> str:
    """Where it comes from, as what follows a verb; empty where that is no way to say it."""
    slots = voice.slots
    if slots.occluder is not None:
        thing = voice.pick(where.OCCLUDERS[slots.occluder])
        return _at_side(voice, voice.pick(where.HIDDEN_FROM).replace("{occluder}", thing))
    if slots.position is not None and slots.position in where.FROM:
        sided, plain = where.FROM[slots.position]
        return voice.pick(sided if slots.side and sided else plain)
    return voice.pick(where.SIDE_FROM) if slots.position is None and slots.side else ""


def _post(voice: Voice, does: tuple[str, ...], manner: Manner) -> str:
    """Where it is, as what follows its noun or *is*; rather in other words than those of what it does."""
    used = {word[:4] for phrase in does for word in _CONTENT.findall(phrase)}
    post = ""
    for _ in range(4):
        post = _any_post(voice, manner)
        if not any(word[:4] in used for word in _CONTENT.findall(post)):
            break
    return voice.fill(post)


def _any_post(voice: Voice, manner: Manner) -> str:
    slots = voice.slots
    if slots.occluder is not None:
        thing = voice.pick(where.OCCLUDERS[slots.occluder])
        return _at_side(voice, voice.pick(where.HIDDEN_POST).replace("{occluder}", thing))
    if slots.position is None:
        return voice.pick(where.SIDE_POST) if slots.side else ""
    sided, plain = where.POST[slots.position]
    if slots.position is Position.ONCOMING and manner is Manner.WALKS:
        sided, plain = (), where.ON_FOOT_ONCOMING
    if slots.side and sided:
        return voice.pick(sided)
    post = voice.pick(plain)
    return f"{post} {voice.pick(where.SIDE_POST)}" if slots.side else post


def _at_side(voice: Voice, behind: str) -> str:
    slots = voice.slots
    if slots.position is not None and slots.position in where.HIDDEN_IN:
        behind = f"{behind} {voice.pick(where.HIDDEN_IN[slots.position])}"
    return f"{behind} {voice.pick(where.HIDDEN_SIDE)}" if slots.side else behind


def _distance(voice: Voice) -> str:
    distance = voice.slots.distance or Distance.NEAR
    if distance is Distance.FAR and voice.slots.position in _BEHIND:
        return voice.pick(where.FAR_BUT_NOT_AHEAD)
    return voice.pick(where.DISTANCES[distance])


# What it does


def _quoted(voice: Voice, texts: Sequence[str], manner: Manner, at_junction: bool) -> str | None:
    """What it does in words of its snippet, if any fit."""
    if not texts or not voice.chance(OWN_WORDS):
        return None
    said = predicate(voice.pick(texts), manner)
    return said if said and (at_junction or not _AT_JUNCTION.search(said)) else None


def _deeds(voice: Voice, manner: Manner, at_junction: bool) -> tuple[str, ...]:
    """A marked phrase per thing it does, pairs that belong together in one."""
    left = sorted(voice.slots.actions, key=lambda action: action is not Action.PULL_OUT)  # whoever does, does so first
    if voice.slots.position is Position.ONCOMING and len(left) > 1 and Action.ONCOMING in left:
        left.remove(Action.ONCOMING)  # where it is says so
    at_speed = Action.FAST in left and len(left) > 1 and not _WITH_SPEED & set(left)
    if at_speed:
        left.remove(Action.FAST)
    said: list[str] = []
    done: list[Action] = []
    sudden = voice.chance(0.35)
    while left:
        table, taken = _next(voice, left, done, manner, at_junction)
        phrase = voice.pick(_possible(voice, deeds.phrases(table, manner)))
        if sudden and taken[0].row.sudden and phrase.startswith("[") and not _ABRUPT.search(phrase):
            phrase, sudden = f"{voice.pick(deeds.SUDDENLY)} {phrase}", False
        said.append(phrase)
        done += taken
        left = [action for action in left if action not in taken]
    if at_speed:
        said[0] = f"{said[0]} {voice.pick(deeds.phrases(deeds.AT_SPEED, manner))}"
    return tuple(said) or ("[get] in {egos} way",)


def _next(
    voice: Voice, left: list[Action], done: list[Action], manner: Manner, at_junction: bool
) -> tuple[deeds.Table, list[Action]]:
    """The table that says the next thing it does, and the actions that are said with it."""
    action, position = left[0], voice.slots.position
    if not done and (first := _first(left, position, manner)) is not None:
        return first
    for other in left[1:] if action is Action.CROSS else left[1:2]:
        together = deed_pairs.TOGETHER.get(frozenset((action, other)))
        if together is not None and (other is not Action.ACCELERATE or voice.chance(0.6)):
            return together, [action, other]
    for before in reversed(done):
        if (table := deed_pairs.AFTER.get((before, action))) is not None:
            return table, [action]
    through = at_junction and position in (Position.CROSSING, Position.ONCOMING, None)
    if through and action in deed_pairs.THROUGH and manner is not Manner.WALKS:
        return deed_pairs.THROUGH[action], [action]
    return deeds.DEEDS[action], [action]


def _first(left: list[Action], position: Position | None, manner: Manner) -> tuple[deeds.Table, list[Action]] | None:
    """Beginnings that hang on where it starts, or on what comes later."""
    beside = position in (Position.ROADSIDE, Position.FAR_CORNER, None)
    if set(left) == {Action.BRAKE, Action.STOP} and beside and manner is not Manner.DRIVES:
        return deed_pairs.FEINT, left
    if left[0] is Action.TURN_BACK and Action.CROSS in left:
        return deed_pairs.ATTEMPT, left[:1]
    half_out = left[0] is Action.STOP and position is Position.KERB
    return (deed_pairs.HALF_OUT, left[:1]) if half_out else None


def _possible(voice: Voice, options: tuple[str, ...]) -> tuple[str, ...]:
    """The phrases that fit where it is: nobody behind the ego stops in front of it."""
    if voice.slots.position not in (*_BEHIND, Position.BESIDE):
        return options
    return tuple(phrase for phrase in options if not _BEFORE_EGO.search(phrase)) or options
