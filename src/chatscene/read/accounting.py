"""What became of each word of a text: the fact that it gave, or that it is without effect, or that it was not read.

The phrases of the readers are sought in the text as it is read on, and what is found is brought back to the words that
the user wrote. Which of several readers was believed is not asked; the facts that were decided on are.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from difflib import SequenceMatcher
from functools import lru_cache

from chatscene.read import lexicon
from chatscene.read.account_rules import NOT, PLAIN, Kind, rules
from chatscene.read.account_wordings import prepared
from chatscene.read.canonical import canonical, telegraphed
from chatscene.read.naming import plainly_named
from chatscene.read.phrases import Sort, phrases_at, road_user
from chatscene.read.quantities import quantity_or_speed_at
from chatscene.read.without_effect import ALWAYS, without_effect
from chatscene.terms.acts import Action
from chatscene.terms.edit import EDITED
from chatscene.terms.frame import Word
from chatscene.terms.scenario import Scenario, Unused, Why

EGO = "the ego"
CONTACT, PART = "contact", "a part that is touched"
JOINS = "says nothing alone"
_OF_EDIT = "an edit, read by itself"
_UNSAID = (Action.FOLLOW, Action.STAND, Action.ONCOMING, Action.BLOCK, Action.STOP, Action.SLOW)
"""Acts that other facts may hold as well, so that they need not stand among those that were decided on."""
_OF_SORT = {
    Sort.EGO: EGO, Sort.ACTOR: "adversary", Sort.SAME: "adversary", Sort.ACT: "actions", Sort.MANEUVER: "maneuver",
    Sort.STATE: "ego", Sort.WHERE: "position", Sort.ROW: "group", Sort.SIDE: "side", Sort.TARGET: "actions",
    Sort.PLACE: "place", Sort.SITE: "site", Sort.LANES: "lanes", Sort.TWO_WAY: "two_way", Sort.OCCLUDER: "occluder",
    Sort.LEADER: "leader", Sort.BYPASS: "maneuver",
}  # fmt: skip
_OF_KIND = {
    **dict.fromkeys((Kind.STRUCK, Kind.HIT, Kind.EGO_HITS, Kind.CONTACT, Kind.BY), CONTACT),
    **dict.fromkeys((Kind.OUR_PART, Kind.PART_OF), PART),
    **dict.fromkeys((Kind.ACT, Kind.RESUMES, Kind.WAYWARD, Kind.ENTERS, Kind.NOUN, Kind.BARE, Kind.TARGET), "actions"),
    **dict.fromkeys((Kind.HEADING, Kind.COMPASS_SIDE, Kind.WHERE, Kind.AHEAD, Kind.OWN_SIDE), "position"),
    **dict.fromkeys((Kind.BYPASSES, Kind.EGO_TURNS, Kind.EGO_CHANGES_LANE, Kind.TURNING, Kind.PAST), "maneuver"),
    **dict.fromkeys((Kind.STATE, Kind.SETS_OFF), "ego"),
    Kind.DRIVER: "adversary", Kind.OWN_DRIVER: EGO, Kind.FROM_SIDE: "side", Kind.AROUND_IT: "maneuver",
    Kind.SLIP_LANE: "place", Kind.SITE: "site", Kind.MEETS: "position",
}  # fmt: skip
_OF_PATTERNS = (
    ("occluder", (*lexicon.OCCLUDERS.values(), lexicon.HIDING)),
    ("adversary", (*lexicon.KINDS.values(), lexicon.SOMEBODY)),
    ("maneuver", (lexicon.LEFT_TURN, lexicon.RIGHT_TURN, lexicon.LANE_CHANGE, lexicon.BYPASS)),
    ("leader", (lexicon.LEADER,)),
    ("control", tuple(lexicon.CONTROLS.values())),
    ("place", tuple(lexicon.PLACES.values())),
    *((f"actions={action}", (pattern,)) for action, pattern in lexicon.ACTIONS.items()),
    ("ego", tuple(lexicon.EGO_STATES.values())),
    ("distance", (lexicon.NEAR, lexicon.FAR_AWAY)),
    ("group", (lexicon.GROUP,)),
    ("side", (lexicon.SIDE,)),
    ("position", (lexicon.BEHIND, lexicon.AHEAD, lexicon.BESIDE, lexicon.ONCOMING, lexicon.KERB, lexicon.SAME_LANE)),
    ("lanes", (lexicon.MANY_LANES, lexicon.ONE_LANE)),
    ("two_way", (lexicon.TWO_WAY, lexicon.EACH_WAY, lexicon.ONE_WAY)),
)
"""The patterns of each fact; whoever comes first has the words."""
_TOGETHER = {
    "position": ("side", "place", "others"),
    "side": ("position", "occluder", "others"),
    "place": ("position", "control", "site", "maneuver"),
    "control": ("place",),
    "occluder": ("position", "blocker"),
    "leader": ("others",),
    "maneuver": ("place", "site", "blocker"),
    **dict.fromkeys((f"actions={act}" for act in Action), ("ego",)),
    "adversary": ("others",),
    "ego": ("maneuver",),
    "site": ("place", "position"),
    "group": ("adversary",),
}
"""Facts that the same words may have given, where the first was not decided on."""
_LISTED = {
    Why.BESIDES: "no scene shows it",
    Why.REACTION: "the ego under test decides how it reacts",
    Why.DEGREE: "there is only one of it",
}
_WORD = re.compile(r"[^\W_]+(?:['\u2019.,:/-][^\W_]+)*")


@dataclass(frozen=True, slots=True)
class _Found:
    """What a word of the text as it is read tells: a fact, nothing alone, or neither."""

    word: str
    fact: str = ""
    plain: bool = False


def words_of(scenario: Scenario, unused: Iterable[Unused] = ()) -> tuple[Word, ...]:
    """What became of each word of a scenario's text; none for one that nobody read from a text.

    Args:
        scenario: What was understood, with what of it is not used.
        unused: What else is not used, of what was retrieved for it.
    """
    frame = scenario.frame
    if frame is None:
        return ()
    text, lower = frame.text, frame.text.lower()
    read = _aligned(text, _as_read(text))
    around = list(_surroundings(lower))
    listed = [(one.why, span) for one in (*scenario.unused, *unused) for span in _spans(lower, one.said)]
    facts = _decided(scenario)
    edits = [match.span() for match in EDITED.finditer(text)]
    stops = telegraphed(text)
    told: list[Word] = []
    for match in _WORD.finditer(text):
        span = match.span()
        if any(_within(span, other) for other in edits):
            told.append(Word(text=match[0], start=span[0], end=span[1], fact="", besides=_OF_EDIT))
            continue
        if span in stops:
            told.append(Word(text=match[0], start=span[0], end=span[1], fact="", besides=JOINS))
            continue
        name = next((name for name, other in around if _within(span, other)), "")
        fact, besides = read.get(span[0], ("", ""))
        fact = next((one for one in (fact, *_TOGETHER.get(fact, ())) if one in facts), "").partition("=")[0]
        why = next((why for why, other in listed if _within(span, other)), None)
        if why is not None and not (fact and why is Why.BESIDES):  # a red van runs a red light
            fact, besides = "", _LISTED.get(why, "")
        if not name and not besides:
            nothing = without_effect(text, span)
            if nothing in ALWAYS or not fact:
                fact, besides = "", nothing or (JOINS if PLAIN.fullmatch(match[0].lower()) else "")
        fact = name or fact
        told.append(Word(text=match[0], start=span[0], end=span[1], fact=fact, besides="" if fact else besides))
    return tuple(map(_joined, told, [*told[1:], None]))


def _joined(word: Word, after: Word | None) -> Word:
    """A word, of which nothing is left if it is an article before a word that is without effect."""
    alone = word.text.lower() in ("a", "an", "the") and after is not None and after.besides in ALWAYS
    return replace(word, fact="", besides=JOINS) if alone else word


def _decided(scenario: Scenario) -> set[str]:
    """The facts that were decided on, and each act by name; what goes without saying may have been said."""
    frame, slots = scenario.frame, scenario.slots
    does = {act for one in (slots, *slots.others) for act in one.actions}
    does |= {Action(brought) for act in does for brought in act.row.brings} | set(_UNSAID)
    numbers = frame.quantities if frame else ()
    return {
        *slots.said(),
        *(f"actions={act}" for act in does),
        *(one.measure.value for one in numbers),
        EGO,
        CONTACT,
        PART,
    }


# The text as it is read


@lru_cache(maxsize=16)
def _as_read(text: str) -> tuple[_Found, ...]:
    """Each word of a text as the readers have it, with what it tells; a run asks several times for that of its own."""
    found: list[_Found] = []
    told = prepared(lexicon.rewritten(canonical(" ".join(plainly_named(text).text.split()))))
    at, of_ego = 0, True
    while at < len(told):
        end, fact, plain = _most_telling(told, at, of_ego)
        if fact in (EGO, "adversary"):
            of_ego = fact == EGO
        found += [_Found(one[0], fact, plain or bool(PLAIN.fullmatch(one[0]))) for one in _WORD.finditer(told, at, end)]
        at = end
        while at < len(told) and told[at] == " ":
            at += 1
    return tuple(found)


def _most_telling(text: str, at: int, of_ego: bool) -> tuple[int, str, bool]:
    """Where the longest phrase at a place ends, the fact that it tells, and whether it is known to tell none."""
    best, fact, plain = at, "", False
    for end, found, known in _matches(text, at, of_ego):
        if end > best:
            best, fact, plain = end, found, known
    if best > at:
        return best, fact, plain
    word = _WORD.match(text, at)
    return (word.end(), "", bool(PLAIN.fullmatch(word[0]))) if word else (at + 1, "", True)


def _matches(text: str, at: int, of_ego: bool) -> Iterator[tuple[int, str, bool]]:
    """Whatever matches at a place: where it ends, its fact, and whether it is known to tell none."""
    for rule in reversed(rules()):
        if (rule.ego in (None, of_ego) or rule.opens) and (match := rule.pattern.match(text, at)):
            fact = f"actions={rule.action}" if rule.action else _OF_KIND.get(rule.kind, "")
            yield match.end(), fact, False
    for phrase in phrases_at(text[at]):
        if phrase.ego in (None, of_ego) and (match := phrase.pattern.match(text, at)):
            fact = f"actions={phrase.value}" if phrase.sort is Sort.ACT else _OF_SORT.get(phrase.sort, "")
            yield match.end(), fact, phrase.sort not in _OF_SORT
    if named := road_user().match(text, at):
        yield named.end(), "adversary", False
    if (number := quantity_or_speed_at(text, at)) is not None:
        yield number[1], number[0].measure.value, False
    if no := NOT.match(text, at):
        yield no.end(), "", True
    for fact, patterns in _OF_PATTERNS:
        ends = (match.end() for pattern in patterns if (match := pattern.match(text, at)))
        yield max(ends, default=at), fact, False


# Back to the words that were written


def _aligned(text: str, read: Sequence[_Found]) -> dict[int, tuple[str, str]]:
    """What was found for each word of a text, by where it begins: the fact, and why it has none if that is known."""
    written = list(_WORD.finditer(text))
    matcher = SequenceMatcher(
        None, [_plainly(word[0]) for word in written], [_plainly(one.word) for one in read], autojunk=False
    )
    found: dict[int, tuple[str, str]] = {}
    for tag, first, last, start, end in matcher.get_opcodes():
        block = read[start:end]
        for place, word in enumerate(written[first:last]):
            if tag == "equal" or last - first == end - start:
                found[word.start()] = _told([block[place]])
            else:
                found[word.start()] = _told(block)
    return found


def _told(block: Iterable[_Found]) -> tuple[str, str]:
    """What the words tell that stand for a written one."""
    block = list(block)
    fact = next((one.fact for one in block if one.fact), "")
    return fact, JOINS if not fact and block and all(one.plain for one in block) else ""


def _plainly(word: str) -> str:
    return word.lower().replace("\u2019", "'")


def _surroundings(text: str) -> Iterator[tuple[str, tuple[int, int]]]:
    """Where light, weather and the state of the road are said."""
    for name, table in (("surface", lexicon.SURFACES), ("weather", lexicon.WEATHERS), ("light", lexicon.LIGHTS)):
        for pattern in table.values():
            for match in pattern.finditer(text):
                yield name, match.span()


def _spans(text: str, said: str) -> Iterator[tuple[int, int]]:
    """Where words stand in a text, as whole words."""
    for match in re.finditer(rf"(?<!\w){re.escape(said.lower())}(?!\w)", text):
        yield match.span()


def _within(span: tuple[int, int], other: tuple[int, int]) -> bool:
    return other[0] <= span[0] and span[1] <= other[1]
