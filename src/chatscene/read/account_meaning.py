"""What the rules and phrases of an account mean: what each adds to what was made out so far.

A rule is of the telling, such as who touched whom, or of the party that is spoken of, such as what it does; each kind
has a small function in one of two tables. The phrases are those that sentences are read by, too.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from chatscene.read.account_rules import KERB, PARTICIPLE, Kind, Rule, rules
from chatscene.read.phrases import Phrase, Sort, Where, side_in
from chatscene.read.telling import NAMED_NEXT, AtPedals, Contact, Party, Telling
from chatscene.terms.actors import Manner
from chatscene.terms.acts import Action
from chatscene.terms.conclusions import JUNCTIONS
from chatscene.terms.scenario import EgoState, Maneuver, Place, Side, Site

_HEADINGS = {
    name: 45 * eighth
    for eighth, name in enumerate(
        ("north", "northeast", "east", "southeast", "south", "southwest", "west", "northwest")
    )
}
_OF_COMPASS = {90: Side.RIGHT, 270: Side.LEFT}  # of one who drives north
_LEAD_ASIDE = frozenset(
    (Action.TURN_LEFT, Action.TURN_RIGHT, Action.CHANGE_LANE, Action.SWERVE)
)  # behind these, a side is whither
_LEAVE_OPEN = frozenset((Kind.PART_OF, Kind.OUR_PART, Kind.NOUN, Kind.BARE, Kind.SITE))
"""After these, the reader is still where it was in the clause."""
_PHRASES_LEAVE_OPEN = frozenset((Sort.JOINT, Sort.THEN, Sort.END, Sort.SEES, Sort.FILLER, Sort.PLACE, Sort.SITE))


def apply_rule(telling: Telling, rule: Rule, match: re.Match[str]) -> None:
    """Take what a rule matches for said, of the ego or of whoever is spoken of."""
    if effect := _OF_TELLING.get(rule.kind):
        effect(telling, rule, match)
    elif telling.party is not None:
        of_party(telling, telling.party, rule, match)
    else:
        telling.pending.append((rule, match))
        return
    if rule.kind not in _LEAVE_OPEN:
        telling.opens = False


def of_party(telling: Telling, party: Party, rule: Rule, match: re.Match[str]) -> None:
    """Take what a rule matches for said of a party."""
    if effect := _OF_PARTY.get(rule.kind):
        effect(telling, party, rule, match)
    if rule.where is not None:
        party.where.add(rule.where)
    if whither := match.groupdict().get("whither"):
        party.side = party.side or (Side.RIGHT if whither == Side.LEFT else Side.LEFT)
        return
    whither = rule.kind is Kind.FROM_SIDE and bool(_LEAD_ASIDE & set(party.acts[-1:])) and "from" not in match[0]
    if party.side is None and not whither:
        party.side = _side_of(match)


def ends(telling: Telling) -> None:
    """A sentence ends: nobody is awaited any more."""
    telling.opens, telling.meets, telling.awaited, telling.hits, telling.denied = True, False, None, False, False
    if telling.parties:
        telling.pending.clear()
    telling.sentence += 1


def joins(telling: Telling) -> None:
    """Another clause begins, of the same subject if none is named."""
    telling.opens, telling.meets, telling.denied = True, False, False
    telling.subject = telling.main


def _side_of(match: re.Match[str]) -> Side | None:
    """The first side that a rule names."""
    side = side_in(match)
    return Side(side) if side else None


def _part_of(match: re.Match[str]) -> str:
    """The words for where on the ego somebody touches it."""
    found = match.groupdict()
    told = [value for name, value in found.items() if value and (name.startswith("part") or name == "from")]
    return " ".join(told) or ("rear" if re.search(r"\brear[ -]end", match[0]) else "")


# Contact


def _struck(telling: Telling, _rule: Rule, match: re.Match[str]) -> None:
    telling.struck_behind = telling.struck_behind or "rear" in match[0]
    telling.awaited = _part_of(match) or ("rear" if "rear" in match[0] else "")


def _hit(telling: Telling, _rule: Rule, match: re.Match[str]) -> None:
    party, number = telling.party, telling.subject
    if party is None or number is None or (match.groupdict().get("it") and len(telling.parties) > 1):
        return  # of two, "it" may be the other
    telling.contacts.append(Contact(number, _part_of(match), sentence=telling.sentence))
    if re.match(r"dr[io]v|back|roll|ram|rear", match[0]):
        party.drives = True
    does = match[0].split(" us")[0].split(" our")[0]
    if re.search(r"\b(?:back(?:s|ed|ing)?|revers\w+)\b(?! of)", does):
        party.does(Action.REVERSE)


def _ego_hits(telling: Telling, _rule: Rule, _match: re.Match[str]) -> None:
    telling.hits = True


def _contact(telling: Telling, _rule: Rule, match: re.Match[str]) -> None:
    if match.groupdict().get("by"):
        telling.awaited = _part_of(match)
        return
    number = telling.subject if telling.subject is not None else len(telling.parties) - 1
    if number >= 0:
        telling.contacts.append(Contact(number, _part_of(match), sentence=telling.sentence))


def _by(telling: Telling, _rule: Rule, _match: re.Match[str]) -> None:
    telling.awaited = ""


def _foreign(telling: Telling, _rule: Rule, _match: re.Match[str]) -> None:
    telling.foreign = True


# Who is spoken of


def _our_part(telling: Telling, _rule: Rule, _match: re.Match[str]) -> None:
    telling.of_ego()


def _driver(telling: Telling, _rule: Rule, match: re.Match[str]) -> None:
    if match["of"] == "us":
        telling.of_ego()
    elif telling.parties:
        telling.main = telling.subject = len(telling.parties) - 1


def _own_driver(telling: Telling, _rule: Rule, match: re.Match[str]) -> None:
    if telling.opens or re.search(r"our|safety|test|operator|av", match[0]):
        telling.of_ego()


def _noun(telling: Telling, rule: Rule, _match: re.Match[str]) -> None:
    assert rule.action is not None
    telling.deeds.append(rule.action)
    telling.bare = telling.bare or rule.kind is Kind.BARE


def _nothing(_telling: Telling, _rule: Rule, _match: re.Match[str]) -> None:
    """The words are known, and say nothing that a slot has: they are no words that somebody missed."""


# By the compass


def _heading(telling: Telling, _rule: Rule, match: re.Match[str]) -> None:
    origin = match.groupdict().get("origin")
    heading = _HEADINGS[re.sub(r"[ -]", "", origin or match["compass"])]
    heading = (heading + 180) % 360 if origin else heading
    party = telling.party
    if party is not None:
        party.heading = heading if party.heading is None else party.heading
        return
    if telling.heading is not None and telling.turning and heading != telling.heading:
        right = (heading - telling.heading) % 360 < 180
        telling.facts.setdefault("maneuver", Maneuver.RIGHT_TURN if right else Maneuver.LEFT_TURN)
    telling.heading = heading if telling.heading is None else telling.heading


def _compass_side(telling: Telling, _rule: Rule, match: re.Match[str]) -> None:
    party = telling.party
    if party is not None and telling.heading is not None:
        angle = (_HEADINGS[match["compass"]] - telling.heading) % 360
        party.side = party.side or _OF_COMPASS.get(angle)
        party.where.add(Where.EDGE)


# The ego


def _meets(telling: Telling, rule: Rule, match: re.Match[str]) -> None:
    telling.meets, telling.passes = True, rule.kind is Kind.BYPASSES
    telling.follows = re.match(r"(?:follow|trail|behind|s[ia]t\w* behind)", match[0]) is not None
    stands = re.search(r"\b(?:were|was|are|is|been|just|still) $", match.string[: match.start()]) is not None
    for said, state in _WHILE_MEETING:
        if re.match(rf"(?:com\w+ to an? (?:\w+ )?)?(?:{said})|came to an? (?:\w+ )?(?:{said})", match[0]):
            does = EgoState.STANDS if stands and state is EgoState.STOPS else state
            telling.pedals.append(AtPedals(does, telling.somebody_is_there, because_of=NAMED_NEXT))


_WHILE_MEETING = (
    ("stop|halt|standstill", EgoState.STOPS),
    ("wait|queue", EgoState.STANDS),
    ("slow", EgoState.SLOWS_DOWN),
    ("brak", EgoState.BRAKES),
)


def _ego_turns(telling: Telling, rule: Rule, match: re.Match[str]) -> None:
    telling.facts.setdefault("maneuver", rule.maneuver)
    to_come = re.match(r"wait|signal|prepar|prior|want", match[0]) or match.string[: match.start()].endswith(" to ")
    if telling.pedals and not to_come:
        telling.pedals.append(AtPedals(EgoState.SETS_OFF, after=False))


def _ego_changes_lane(telling: Telling, _rule: Rule, match: re.Match[str]) -> None:
    left = _side_of(match) is Side.LEFT
    telling.facts.setdefault("maneuver", Maneuver.LANE_CHANGE_LEFT if left else Maneuver.LANE_CHANGE_RIGHT)


def _ego_reverses(telling: Telling, _rule: Rule, _match: re.Match[str]) -> None:
    telling.reverses = True


def _turning(telling: Telling, _rule: Rule, _match: re.Match[str]) -> None:
    telling.turning = True


def _slip_lane(telling: Telling, _rule: Rule, _match: re.Match[str]) -> None:
    telling.facts.setdefault("maneuver", Maneuver.RIGHT_TURN)


def _own_side(telling: Telling, _rule: Rule, match: re.Match[str]) -> None:
    telling.own_lane = telling.own_lane or _side_of(match)


def _state(telling: Telling, rule: Rule, _match: re.Match[str]) -> None:
    assert rule.state is not None
    telling.pedals.append(AtPedals(rule.state, telling.somebody_is_there))


def _sets_off(telling: Telling, _rule: Rule, _match: re.Match[str]) -> None:
    telling.pedals += [AtPedals(EgoState.STANDS, after=False), AtPedals(EgoState.SETS_OFF, after=False)]


def _around_it(telling: Telling, _rule: Rule, _match: re.Match[str]) -> None:
    for one in telling.parties:
        stands = Action.STAND in one.acts or Action.BLOCK in one.acts
        if stands and not one.aside:
            one.aside = True
            telling.facts.setdefault("maneuver", Maneuver.BYPASS)


def _site(telling: Telling, rule: Rule, _match: re.Match[str]) -> None:
    _at_site(telling, rule.site)


def _at_site(telling: Telling, site: object) -> None:
    """A site stands, unless it is the motorway of which another is a part."""
    if telling.facts.get("site") in (None, Site.MOTORWAY):
        telling.facts["site"] = site


_OF_TELLING: dict[Kind, Callable[[Telling, Rule, re.Match[str]], None]] = {
    Kind.STRUCK: _struck,
    Kind.HIT: _hit,
    Kind.EGO_HITS: _ego_hits,
    Kind.CONTACT: _contact,
    Kind.BY: _by,
    Kind.FOREIGN: _foreign,
    Kind.DOOR: _foreign,
    Kind.OUR_PART: _our_part,
    Kind.PART_OF: _nothing,
    Kind.DRIVER: _driver,
    Kind.OWN_DRIVER: _own_driver,
    Kind.NOUN: _noun,
    Kind.BARE: _noun,
    Kind.TARGET: _nothing,
    Kind.PAST: _nothing,
    Kind.HEADING: _heading,
    Kind.COMPASS_SIDE: _compass_side,
    Kind.MEETS: _meets,
    Kind.BYPASSES: _meets,
    Kind.EGO_TURNS: _ego_turns,
    Kind.EGO_CHANGES_LANE: _ego_changes_lane,
    Kind.EGO_REVERSES: _ego_reverses,
    Kind.TURNING: _turning,
    Kind.SLIP_LANE: _slip_lane,
    Kind.OWN_SIDE: _own_side,
    Kind.STATE: _state,
    Kind.SETS_OFF: _sets_off,
    Kind.AROUND_IT: _around_it,
    Kind.SITE: _site,
}


# Others


def _act(telling: Telling, party: Party, rule: Rule, match: re.Match[str]) -> None:
    action = _meant(rule, party, match)
    if not telling.touched_before(party):
        party.does(action)
    if action is Action.STAND and telling.passed is not None and telling.parties[telling.passed] is party:
        telling.facts.setdefault("maneuver", Maneuver.BYPASS)
    if action is Action.CROSS:
        _cross_by_compass(telling, party, match)
    if action is Action.REVERSE and re.search(r"\bout\b|\bof\b", match[0]):
        party.where.add(Where.EDGE)
    _crossed_site(telling, match)


@dataclass(frozen=True, slots=True)
class _Instead:
    """Words of one act that mean another, by where it leads and who does it.

    Attributes:
        of: The act that the rule tells.
        words: Its words.
        means: The act that is meant.
        fits: By whom.
        where: Where whoever does it is by that; None if the words leave it open.
        unless: Words behind them by which they mean what the rule tells after all.
    """

    of: Action
    words: re.Pattern[str]
    means: Action
    fits: Callable[[Party], bool] = lambda _: True
    where: Where | None = None
    unless: re.Pattern[str] | None = None


def _drives(party: Party) -> bool:
    return party.kind.row.manner is Manner.DRIVES


def _turns_in_its_lane(party: Party) -> bool:
    """Not into it, out of it or across it."""
    return _drives(party) and not {Action.CROSS, Action.PULL_OUT, Action.CUT_IN}.intersection(party.acts)


def _stands(party: Party) -> bool:
    return Action.STAND in party.acts


def _is_ahead_in_traffic(party: Party) -> bool:
    return Where.AHEAD in party.where and Where.EDGE not in party.where


def _is_parked(party: Party) -> bool:
    return Where.EDGE in party.where or _stands(party)


_INSTEADS = (
    _Instead(Action.CUT_IN, re.compile(r"^(?:\w+ly )?(?:swerv|veer|drift)\w* .*(?:left|right)"), Action.SWERVE),
    _Instead(Action.CUT_IN, re.compile(r"^(?:pull|mov|com|driv|set|swing)"), Action.PULL_OUT, _is_parked),
    _Instead(Action.CHANGE_LANE, re.compile(r"front of us"), Action.CUT_IN),
    _Instead(Action.CROSS, re.compile(r"^(?:run|ran|go|rid|roll)\w* in front"), Action.FOLLOW, _drives, Where.AHEAD),
    _Instead(Action.CROSS, re.compile(r"^leaves? (?:the|our|its) lane"), Action.CHANGE_LANE, _drives, Where.AHEAD),
    _Instead(Action.CROSS, re.compile(r"^appear"), Action.STAND, _stands),
    _Instead(Action.CROSS, re.compile(r"kerb|curb"), Action.PULL_OUT, _drives),
    _Instead(Action.PULL_OUT, re.compile(r"^(?:set|mov|pull)\w* (?:off|away)"), Action.FOLLOW, _is_ahead_in_traffic),
    _Instead(
        Action.TURN_BACK,
        re.compile(r"^(?:turn|ma[dk])"),
        Action.U_TURN,
        _turns_in_its_lane,
        unless=re.compile(r" (?:in|on)?to\b"),
    ),
    _Instead(Action.RUN_LIGHT, re.compile(r"^on "), Action.STAND, _stands),
)


def _meant(rule: Rule, party: Party, match: re.Match[str]) -> Action:
    """The act that a rule tells, by where it leads and who does it."""
    assert rule.action is not None
    for one in _INSTEADS:
        led = one.unless is not None and one.unless.match(match.string[match.end() :])
        if one.of is rule.action and one.words.search(match[0]) and one.fits(party) and not led:
            if one.where is not None:
                party.where.add(one.where)
            return one.means
    return rule.action


def _cross_by_compass(telling: Telling, party: Party, match: re.Match[str]) -> None:
    compass = re.search(r"\b(north|south|east|west) ", match[0])
    if compass and telling.heading is not None:
        party.side = party.side or _OF_COMPASS.get((_HEADINGS[compass[1]] - telling.heading) % 360)


def _crossed_site(telling: Telling, match: re.Match[str]) -> None:
    for site, said in ((Site.CROSSWALK, r"crosswalk|zebra"), (Site.ROUNDABOUT, "roundabout")):
        if re.search(said, match[0]):
            telling.facts.setdefault("site", site)


def _resumes(telling: Telling, party: Party, _rule: Rule, _match: re.Match[str]) -> None:
    """Who stopped and goes on hesitated; of anybody else it says no more than that he is there."""
    if telling.touched_before(party):
        return
    stopped = next((act for act in (Action.STOP, Action.STAND) if act in party.acts), None)
    if stopped is not None:
        party.acts[party.acts.index(stopped)] = Action.HESITATE
    elif Action.HESITATE not in party.acts:
        party.does(Action.FOLLOW)


def _wayward(_telling: Telling, party: Party, _rule: Rule, match: re.Match[str]) -> None:
    party.wayward = True
    if "stop sign" in match[0]:
        party.where.add(Where.ARM)


def _enters(telling: Telling, party: Party, _rule: Rule, match: re.Match[str]) -> None:
    onward = re.match(r"(?:continu|proceed|go|went|travel|driv|drove)", match[0]) is not None
    beside = bool(party.where & {Where.NEXT_LANE, Where.BESIDE})
    party.wayward = party.wayward or not beside
    if beside or (onward and Where.OPPOSITE in party.where):
        party.does(Action.FOLLOW)
    elif party.kind.is_vulnerable:
        party.does(Action.CROSS)
    _crossed_site(telling, match)


def _ahead(_telling: Telling, party: Party, _rule: Rule, _match: re.Match[str]) -> None:
    if Action.CHANGE_LANE in party.acts:
        party.acts[party.acts.index(Action.CHANGE_LANE)] = Action.CUT_IN  # that is where it leads
    else:
        party.where.add(Where.AHEAD)


def _from_side(_telling: Telling, party: Party, _rule: Rule, match: re.Match[str]) -> None:
    if "from" in match[0]:
        party.where.add(Where.FROM_SIDE)
    if re.search(KERB, match[0]):
        party.where.add(Where.EDGE)
    elif "arm" in match[0]:
        party.where.add(Where.ARM)


_OF_PARTY: dict[Kind, Callable[[Telling, Party, Rule, re.Match[str]], None]] = {
    Kind.ACT: _act,
    Kind.RESUMES: _resumes,
    Kind.WAYWARD: _wayward,
    Kind.ENTERS: _enters,
    Kind.AHEAD: _ahead,
    Kind.FROM_SIDE: _from_side,
}


# Phrases


def apply_phrase(telling: Telling, phrase: Phrase, match: re.Match[str]) -> None:
    """Take a phrase of the common table for said."""
    if effect := _OF_PHRASES.get(phrase.sort):
        effect(telling, phrase.value, match)
    elif name := _SLOTS.get(phrase.sort):
        telling.facts.setdefault(name, phrase.value)
    elif telling.party is not None:
        _said_of(telling, telling.party, phrase, match)
    if phrase.sort not in _PHRASES_LEAVE_OPEN:
        telling.opens = False


def _joint(telling: Telling, _value: Any, match: re.Match[str]) -> None:
    same = match[0].strip() == "," and PARTICIPLE.match(match.string, match.end())
    if telling.subject is None or not same:
        joins(telling)


def _end(telling: Telling, _value: Any, _match: re.Match[str]) -> None:
    ends(telling)


def _sees(telling: Telling, value: Any, _match: re.Match[str]) -> None:
    telling.subject, telling.opens = None, True
    telling.follows = value is Where.AHEAD


def _ego(telling: Telling, _value: Any, match: re.Match[str]) -> None:
    if telling.opens or match[0].startswith("we"):
        telling.of_ego()


def _same(telling: Telling, _value: Any, match: re.Match[str]) -> None:
    """Whoever is followed does something itself: "we followed a van and it stopped". Who "was hit" is the ego."""
    if telling.subject is not None or not telling.parties or match[0] not in ("it", "he", "she"):
        return
    rest = match.string[match.end() :].split(".")[0]
    hit = any(rule.pattern.search(rest) for rule in rules() if rule.kind is Kind.STRUCK)
    if telling.parties[-1].aside and Where.AHEAD in telling.parties[-1].where and not hit:
        telling.subject = len(telling.parties) - 1


def _place(telling: Telling, value: Any, _match: re.Match[str]) -> None:
    place, control = value
    known = telling.facts.get("place")
    if known is None or (known in (Place.ROAD, Place.JUNCTION) and place in JUNCTIONS):
        telling.facts["place"] = place
    if control is not None:
        telling.facts.setdefault("control", control)


def _said_site(telling: Telling, value: Any, _match: re.Match[str]) -> None:
    site, maneuver = value
    _at_site(telling, site)
    if maneuver is not None:
        telling.facts.setdefault("maneuver", maneuver)


def _maneuver(telling: Telling, value: Any, _match: re.Match[str]) -> None:
    if value is not Maneuver.STRAIGHT:  # which goes without saying, and may be said before a turn
        telling.facts.setdefault("maneuver", value)


_OF_PHRASES: dict[Sort, Callable[[Telling, Any, re.Match[str]], None]] = {
    Sort.END: _end,
    Sort.JOINT: _joint,
    Sort.THEN: _joint,
    Sort.SEES: _sees,
    Sort.EGO: _ego,
    Sort.SAME: _same,
    Sort.PLACE: _place,
    Sort.SITE: _said_site,
    Sort.MANEUVER: _maneuver,
    Sort.BYPASS: _maneuver,
}
_SLOTS = {Sort.LANES: "lanes", Sort.TWO_WAY: "two_way", Sort.LEADER: "leader"}


def _said_of(telling: Telling, party: Party, phrase: Phrase, match: re.Match[str]) -> None:
    value: Any = phrase.value
    if phrase.sort is Sort.ACT:
        if not telling.touched_before(party):
            party.does(value)
    elif phrase.sort is Sort.OCCLUDER:
        party.occluder = value
    elif phrase.sort is Sort.WHERE:
        if match[0] != "from behind" or Where.AHEAD not in party.where:  # whom we approach from behind is ahead
            party.where.add(value)
    elif phrase.sort is Sort.SIDE:
        whence = value is Where.ARM or (value is None and "from" in match[0])  # else, behind a turn, it is whither
        if party.side is None and (whence or not _LEAD_ASIDE & set(party.acts[-1:])):
            party.side = Side(side_in(match) or "")
        if value is not None:
            party.where.add(value)
        elif "from" in match[0]:
            party.where.add(Where.FROM_SIDE)
