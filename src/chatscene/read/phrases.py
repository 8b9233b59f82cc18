"""What phrases mean: the one table by which a text is read from its first word to its last.

A phrase is a regular expression over canonical text, in which the ego is "we", "us" and "our". Those of acts are made
of the same marked phrases that sentences are written with (`chatscene.terms.acts`), so that what can be said can be
read; those of road users of the words in their table. All are our own.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum
from functools import cache, cached_property, lru_cache

from chatscene.read import lexicon
from chatscene.read.inflection import any_form, every_form, listed
from chatscene.terms.actors import AdversaryKind, Manner
from chatscene.terms.acts import Action
from chatscene.terms.scenario import Control, EgoState, Maneuver, Occluder, Place, Site


class Sort(StrEnum):
    """What a phrase tells of."""

    EGO = "ego"  # the ego, as the subject
    SEES = "sees"  # the ego meets whoever is named next
    ACTOR = "actor"  # a road user: the value is its kind
    SAME = "same"  # the road user that was spoken of last
    ACT = "act"
    MANEUVER = "maneuver"  # of the ego
    STATE = "state"  # of the ego
    WHERE = "where"  # of whoever is spoken of: the value is a `Where`
    ROW = "row"  # of several: how they stand or come
    SIDE = "side"
    TARGET = "target"  # where an act leads, which says no more than the act
    PLACE = "place"
    SITE = "site"  # the value is the site, with what the ego does there
    LANES = "lanes"
    TWO_WAY = "two-way"
    OCCLUDER = "occluder"
    LEADER = "leader"
    BYPASS = "bypass"
    JOINT = "joint"  # between clauses: somebody may be named next
    THEN = "then"  # the same, and what follows comes later
    FILLER = "filler"  # says nothing that a scene could show
    END = "end"


class Where(StrEnum):
    """A word on where a road user is."""

    AHEAD = "ahead"
    BEHIND = "behind"
    BESIDE = "beside"
    OWN_LANE = "own-lane"
    NEXT_LANE = "next-lane"
    EDGE = "edge"  # of the road: the kerb, the pavement
    OPPOSITE = "opposite"
    ARM = "arm"  # of a junction, to a side
    FAR_CORNER = "far-corner"
    FROM_SIDE = "from-side"  # it comes from there
    BEYOND = "beyond"  # the junction, in the lane that the ego comes into
    RAMP = "ramp"  # it comes from one, beside the ego's lane


@dataclass(frozen=True, kw_only=True)
class Phrase:
    """Words that mean one thing.

    Attributes:
        sort: What they tell of.
        value: What they tell.
        written: How they are written, a regular expression.
        begins: The letters that they begin with; empty if it may be any.
        manner: Of whom alone they are said; None for anybody.
        ego: Whether they are said of the ego alone (True), of others alone (False), or of either (None).
        exit: Whether they are of the exit of a motorway.
    """

    sort: Sort
    value: object
    written: str
    begins: str = ""
    manner: Manner | None = None
    ego: bool | None = None
    exit: bool = False

    @cached_property
    def pattern(self) -> re.Pattern[str]:
        """The regular expression, compiled when it is first asked for."""
        return re.compile(self.written)


_US = r"(?:us|the ego)"
_OUR = r"(?:our|the ego's)"
_ITS = r"(?:its|his|her|their|the)"
_THE = r"(?:a|an|the|our|this|some)"
_SIDE = r"(?P<side>left|right)"
_HAND = r"(?:-hand)?(?: side)?"
_BRACES = {"{ego}": _US, "{egos}": _OUR, "{its}": _ITS, " {from}": "", "{it}": r"(?:it|he|she|they)"}

_TRAITS: tuple[tuple[Sort, object, str], ...] = (
    # Said before a noun: facts about the road user
    (Sort.WHERE, Where.OPPOSITE, r"oncoming|opposing|opposite|approaching"),
    (Sort.WHERE, Where.AHEAD, r"leading|lead|preceding|front"),
    (Sort.WHERE, Where.BEHIND, r"following|trailing"),
    (Sort.WHERE, Where.EDGE, r"parked"),
    (Sort.WHERE, Where.ARM, r"crossing"),
    (Sort.ACT, Action.STAND, r"broken[- ]down|stationary|standing|stopped|stranded|disabled|stalled|waiting|crashed|abandoned"),
    (Sort.ACT, Action.SLOW, r"slow(?:er)?(?:[- ]moving)?|crawling"),
    (Sort.ACT, Action.FAST, r"speeding|fast"),
    (Sort.FILLER, None, r"red|blue|white|black|green|grey|gray|yellow|silver|small|big|large|young|old|elderly|empty|heavy|little|long|delivery|other|adult|male|female"),
)  # fmt: skip

_MARKED = re.compile(r"\[([a-z]+)\]")
_WORD = re.compile(r"[a-z]+(?![^ ])")


def _whole(text: str) -> str:
    """A pattern after which the word is at its end."""
    return rf"(?:{text})(?![\w'])"


@cache
def _written_and_begun(phrase: str) -> tuple[str, str]:
    """A marked phrase as it may be written, in any person and tense, and the letters that it may begin with."""
    text = _MARKED.sub(lambda m: f"\0{m[1]}\0", phrase.lower())
    for brace, meant in _BRACES.items():
        text = text.replace(brace, meant)
    text = re.sub(r"\0([a-z]+)\0", lambda m: any_form(m[1]), text)
    verb, word = _MARKED.match(phrase.lower()), _WORD.match(phrase.lower())
    begins = {form[0] for form in every_form(verb[1])} if verb else {word[0][0]} if word else set[str]()
    own_place = text.endswith(" along")  # what follows has a place of its own
    return _whole(text + r"(?! (?:the|our|a)\b)" if own_place else text), "".join(sorted(begins))


def _acts() -> Iterator[Phrase]:
    for action in Action:
        row = action.row
        told = [(Manner.DRIVES, row.drives), (Manner.RIDES, row.rides), (Manner.WALKS, row.walks)]
        if row.stands:
            told.append((Manner.LIES, row.drives))
        for manner, own in told:
            for phrase in (*listed(own or row.drives), *listed(row.also)):
                written, begins = _written_and_begun(phrase)
                yield Phrase(sort=Sort.ACT, value=action, written=written, begins=begins, manner=manner, ego=False)


_JUNCTIONS = {
    Place.THREE_WAY: r"t(?:-| )?(?:junction|intersection|crossing)|(?:three|3)-(?:way|arm|armed|legged) (?:intersection|junction|crossing)",
    Place.FOUR_WAY: r"cross-?roads|(?:four|4)-(?:way|arm|armed|legged) (?:intersection|junction|crossing|crossroads)",
    Place.JUNCTION: r"(?:(?:road|street|urban|city) )?(?:intersection|junction)",
}
_CONTROL_BEFORE = {
    Control.SIGNAL: r"signali[sz]ed|(?:signal|light|traffic-light)-controlled",
    Control.STOP_SIGN: r"all-way-stop|stop-(?:sign-)?controlled|stop-regulated",
    Control.NONE: r"un-?signali[sz]ed|uncontrolled|unregulated|signal-free|non-signali[sz]ed",
}
_CONTROL_AFTER = {
    Control.SIGNAL: r"with (?:a set of )?traffic (?:lights|signals)|controlled by traffic lights|that has traffic lights|regulated by signals",
    Control.STOP_SIGN: r"with (?:a )?stop signs?|(?:controlled|governed|regulated) by (?:a )?stop signs?|where stop signs are posted",
    Control.NONE: r"with(?:out| no)(?: any)? (?:traffic )?(?:lights|signals)(?: or signs)?|that has no traffic lights|with neither lights nor signs",
}
_AT = r"(?:at|on|in|into|through|across|towards|near|before|over|along|down)"


def _places() -> Iterator[Phrase]:
    for place, noun in _JUNCTIONS.items():
        plain = rf"(?:{_AT} |(?<=crosses )|(?<=cross )|(?<=crossing )|(?<=crossed )){_THE} (?:{noun})"
        yield Phrase(sort=Sort.PLACE, value=(place, None), written=_whole(plain))
        for control in Control:
            before = rf"{_AT} {_THE} (?:{_CONTROL_BEFORE[control]}) (?:{noun})"
            after = rf"{plain} (?:{_CONTROL_AFTER[control]})"
            yield Phrase(sort=Sort.PLACE, value=(place, control), written=_whole(f"{before}|{after}"))
    light = r"(?:at|before|on|behind) (?:(?:a|the) )?(?:red |green )?(?:traffic |stop )?(?:lights?|signals?)|(?:at|on) (?:red|green)"
    yield Phrase(sort=Sort.PLACE, value=(Place.JUNCTION, Control.SIGNAL), written=_whole(light))
    sign = r"(?:at|before|runs|ran|ignores|disregards) (?:a|the) stop sign"
    yield Phrase(sort=Sort.PLACE, value=(Place.JUNCTION, Control.STOP_SIGN), written=_whole(sign))
    bend = r"(?:round|around|through|in|into|on|along) {the} (?:{bend})(?: (?:in|of) the road| on a road)?"
    for place, noun in (
        (Place.LEFT_CURVE, r"left(?:-hand)? (?:bend|curve)|(?:bend|curve) to the left"),
        (Place.RIGHT_CURVE, r"right(?:-hand)? (?:bend|curve)|(?:bend|curve) to the right"),
        (Place.CURVE, r"(?:sweeping )?(?:bend|curve)"),
    ):
        yield Phrase(
            sort=Sort.PLACE, value=(place, None), written=_whole(bend.replace("{the}", _THE).replace("{bend}", noun))
        )
    road = r"(?:city |main |through )?(?:road|street|carriageway)"
    on = rf"(?:on|along|down) {_THE} "
    yield Phrase(sort=Sort.PLACE, value=(Place.ROAD, None), written=_whole(rf"{on}(?:straight )?{road}"))
    for many, said in ((2, "two|2"), (3, "three|3")):
        ours = rf"(?:{said}) lanes (?:(?:in|for|going) {_OUR} (?:direction|way)|each way|(?:in each|in either|per) direction)"
        yield Phrase(sort=Sort.LANES, value=many, written=_whole(rf"{on}{road} (?:with|that has) {ours}"))
    one = rf"{on}(?:single|one)-lane {road}|{on}{road} with (?:one|a single|just one) lane (?:each way|per direction|in (?:each|{_OUR}) direction)"
    yield Phrase(sort=Sort.LANES, value=1, written=_whole(one))
    yield Phrase(sort=Sort.TWO_WAY, value=True, written=_whole(rf"{on}two-way {road}"))
    yield Phrase(sort=Sort.TWO_WAY, value=False, written=_whole(rf"{on}one-way {road}"))


_MOTORWAY = r"(?:motorway|highway(?! patrol)|freeway|expressway)"
_ON_RAMP = rf"(?:{_MOTORWAY} )?(?:on-ramp|entry ramp|entrance ramp|slip road|acceleration lane)"
_OFF_RAMP = rf"(?:{_MOTORWAY} )?(?:off-ramp|exit ramp|exit(?: lane)?)"
_BY = r"(?:by|via|from|at|on|over|along|down)"


def _sites() -> Iterator[Phrase]:
    of = rf"(?: (?:of|to|onto) {_THE} {_MOTORWAY})?"
    where = {
        Site.MOTORWAY: rf"(?:(?:on|along|down|across) )?{_THE} {_MOTORWAY}",
        Site.PAST_ON_RAMP: rf"where {_THE} {_ON_RAMP} (?:joins|meets|merges (?:in|on)to) {_THE} {_MOTORWAY}|(?:at|past|near) {_THE} {_ON_RAMP}{of}",
        Site.PAST_OFF_RAMP: rf"where {_THE} {_OFF_RAMP} leaves {_THE} {_MOTORWAY}|(?:at|past|near) {_THE} {_OFF_RAMP}{of}",
        Site.RURAL: rf"(?:on|along|down) {_THE} (?:country|rural) (?:road|lane)",
        Site.CROSSWALK: rf"(?:(?:at|on|over|across|before|near|towards) )?{_THE} (?:crosswalk|zebra(?: crossing)?|pedestrian crossing)",
        Site.ROUNDABOUT: rf"(?:(?:at|in|on|into|through|around|round) )?{_THE} roundabout",
    }
    for site, said in where.items():
        yield Phrase(sort=Sort.SITE, value=(site, None), written=_whole(said))
    joins = rf"[merge] (?:on|in)to {_THE} {_MOTORWAY}(?: {_BY} {_THE} {_ON_RAMP})?|[join] {_THE} {_MOTORWAY}(?: {_BY} {_THE} {_ON_RAMP})?|[merge] from {_THE} {_ON_RAMP}"
    leaves = rf"[leave] {_THE} {_MOTORWAY}(?: {_BY} {_THE} {_OFF_RAMP})?|[exit] {_THE} {_MOTORWAY}|[take] {_THE} {_OFF_RAMP}{of}|(?:towards?|to|onto|into) {_THE} {_OFF_RAMP}{of}"
    back = rf"[move] back (?:on|in)?to {_THE} {_MOTORWAY}"
    yield Phrase(sort=Sort.ACT, value=Action.CHANGE_LANE, written=_marked(rf"{leaves}|{back}"), ego=False, exit=True)
    for site, maneuver, said in (
        (Site.ON_RAMP, Maneuver.LANE_CHANGE_LEFT, joins),
        (Site.OFF_RAMP, Maneuver.LANE_CHANGE_RIGHT, leaves),
    ):
        yield Phrase(sort=Sort.SITE, value=(site, maneuver), written=_marked(said), ego=True)


_OCCLUDERS: dict[Occluder, str] = {
    Occluder.BUS_STOP: r"bus (?:stop|shelter)",
    Occluder.VENDING_MACHINE: r"(?:drinks |snack )?(?:vending|ticket|drinks) machine",
    Occluder.PARKED_CAR: r"(?:(?:parked|stationary|standing|double-parked) )?(?:car|van|suv|taxi)s?|row of parked cars",
    Occluder.PARKED_TRUCK: r"(?:(?:parked|stationary|standing|double-parked) )?(?:delivery )?(?:truck|lorry)",
    Occluder.PARKED_BUS: r"(?:(?:parked|stationary|standing) )?(?:school )?(?:bus|coach)",
    Occluder.KIOSK: r"(?:newspaper |snack )?kiosk|news ?stand|(?:food|market) stall",
    Occluder.CONTAINER: r"(?:rubbish |construction |large )?container|dumpster|skip",
    Occluder.HEDGE: r"(?:tall |high )?hedge|fence|(?:garden )?wall",
    Occluder.BILLBOARD: r"(?:large )?billboard|advertising (?:column|board)|poster column",
}


def _occluders() -> Iterator[Phrase]:
    hidden = r"(?:hidden|concealed|obscured|masked|standing hidden)(?: from view)? (?:behind|by)|(?:out )?from (?:behind|between)|from the cover of"
    for occluder, noun in _OCCLUDERS.items():
        said = rf"(?:{hidden}) (?:(?:{_THE}|two) )?(?:{noun})"
        yield Phrase(sort=Sort.OCCLUDER, value=occluder, written=_whole(said), ego=False)


_WHERE: tuple[tuple[object, str], ...] = (
    (Where.AHEAD, rf"(?:(?:just|directly|right|straight|slightly|further|some way|close|immediately) )?(?:ahead|in front)(?: of {_US})?|before {_US}"),
    (Where.BEHIND, rf"(?:(?:just|directly|right|close|coming up|coming) )?behind(?: {_US})?|(?:coming |approaching |coming up )?from behind|from the rear"),
    (Where.BESIDE, rf"(?:beside|alongside|next to|level with) {_US}|alongside"),
    (Where.OWN_LANE, rf"(?:in|along) (?:{_OUR}|the same|the ego) lane|along the lane"),
    (Where.NEXT_LANE, r"(?:in|from) (?:the|an|a) (?:next|adjacent|neighbou?ring|other) lane|in that lane"),
    (Where.OPPOSITE, rf"(?:coming |approaching )?from the opposite direction|in the (?:opposite|oncoming) (?:lane|direction)|coming towards {_US}|(?:coming )?from the front|coming the other way"),
    (Where.EDGE, r"(?:at|by|on|from|beside|along) the (?:kerb|curb|roadside|pavement|sidewalk|(?:side|edge) of the (?:road|street|lane))|beside the road|parked|(?:in|from|out of) a parking (?:space|place|bay)"),
    (Where.ARM, r"(?:coming |approaching |out )?(?:from|out of|on) (?:a|the) (?:side|cross) (?:street|road)"),
    (Where.BEYOND, r"(?:just |right |directly |immediately )?(?:behind|around|round|after|beyond|past) the (?:corner|turn|junction|intersection|crossroads)|(?:on|in) the (?:street|road|lane) (?:that )?we (?:turn|come|drive) into"),
    (Where.RAMP, rf"(?:coming |merging |joining )?from {_THE} (?:on-)?ramp"),
    (Where.FAR_CORNER, r"(?:at|from) the far (?:corner|kerb|side)|(?:on|from) the (?:opposite|far) (?:sidewalk|pavement|side)"),
)  # fmt: skip
_SIDED: tuple[tuple[object, str], ...] = (
    (Where.NEXT_LANE, rf"(?:in|from) (?:the|our) {_SIDE}(?:-hand)? lane|(?:in|from) the (?:next |adjacent )?lane (?:to|on) (?:our|the) {_SIDE}|(?:in|from) the lane to {_OUR} {_SIDE}"),
    (Where.EDGE, rf"(?:at|by|on|from|beside|along) the {_SIDE}(?:-hand)? (?:kerb|curb|roadside|pavement|sidewalk|(?:side|edge) of (?:the|our) (?:road|street|lane))|(?:at|by|on|from) the (?:kerb|curb|roadside|pavement|sidewalk) (?:on|to) (?:the|our) {_SIDE}|(?:in|from|out of) a parking (?:space|place|bay) (?:on the {_SIDE}|at the {_SIDE}-hand kerb)"),
    (Where.FAR_CORNER, rf"(?:at|from) the far corner on the {_SIDE}|(?:on|from) the opposite (?:sidewalk|pavement|side) (?:on|to) the {_SIDE}"),
    (Where.ARM, rf"(?:coming |out )?(?:from|out of|on) (?:a|the) (?:side|cross) (?:street|road) (?:on|to) (?:the|our) {_SIDE}|(?:coming |approaching )?from the {_SIDE}(?:-hand)? (?:arm|side street|side road)(?: of the (?:junction|intersection))?"),
    (None, rf"(?:coming |approaching )?(?:on|from|at|to) (?:the|our) {_SIDE}{_HAND}|to the {_SIDE} of {_US}"),
)  # fmt: skip

_TARGETS = (
    rf"(?:right |directly |straight |close |just )?(?:in front of|ahead of|before) {_US}|(?:in|on)to {_OUR} (?:lane|path|way)|across {_OUR} (?:lane|path|way)|towards {_US}"
    rf"|(?:across|into|onto|over) the (?:road|street|lane)|in {_OUR} (?:path|way)|against {_US}|into {_US}|with {_US}"
)
_EGO_TURN = r"(?:[turn] {s}|(?:[make]|[begin]) a {s}(?:-hand)? turn|[take] (?:a|the) {s} turn|[turn] (?:off )?to the {s}|[go] {s}|[make] a {s})"
_EGO_CHANGE = (
    r"(?:[change] lanes? to the {s}|[change] (?:over )?(?:in)?to the {s}(?:-hand)? lane|[move] (?:over )?(?:in)?to the {s}(?:-hand)? lane"
    r"|[change] to the {s}|[switch] to the {s} lane|[merge] (?:in)?to the {s} lane|[move] over to the {s})"
)


def _marked(pattern: str) -> str:
    return _whole(_MARKED.sub(lambda m: any_form(m[1]), pattern))


def _of_ego() -> Iterator[Phrase]:
    ways = (
        (Maneuver.LEFT_TURN, _EGO_TURN, "left"),
        (Maneuver.RIGHT_TURN, _EGO_TURN, "right"),
        (Maneuver.LANE_CHANGE_LEFT, _EGO_CHANGE, "left"),
        (Maneuver.LANE_CHANGE_RIGHT, _EGO_CHANGE, "right"),
    )
    for maneuver, form, side in ways:
        yield Phrase(sort=Sort.MANEUVER, value=maneuver, written=_marked(form.replace("{s}", side)), ego=True)
    unprotected = r"an? unprotected(?= left)"
    yield Phrase(sort=Sort.PLACE, value=(Place.JUNCTION, Control.SIGNAL), written=_whole(unprotected), ego=True)
    yield Phrase(sort=Sort.MANEUVER, value=Maneuver.LEFT_TURN, written=_whole(r"left(?:-hand)? turn"), ego=True)
    turns = r"(?:[make]|[begin]|[start])(?= an? unprotected left)"
    yield Phrase(sort=Sort.FILLER, value=None, written=_marked(turns), ego=True)
    straight = r"[drive] straight (?:on|ahead)|[go] straight(?: on| ahead)?|[continue] straight (?:on|ahead)|[keep] (?:our|the ego's|its) lane|[keep] straight on"
    yield Phrase(sort=Sort.MANEUVER, value=Maneuver.STRAIGHT, written=_marked(straight), ego=True)
    drives = r"[drive](?: on| along)?|[travel]|[approach] (?=(?:a|an|the) )|[cross] (?:a|the) (?:junction|intersection)|[go](?: on| along)?|[proceed]|[continue]|[move]"
    yield Phrase(sort=Sort.FILLER, value=None, written=_marked(drives), ego=True)
    parked = r"(?:a|the) (?:parked|broken[- ]down|stationary|double-parked) (?:car|van|truck|vehicle)"
    bypass = rf"(?:[go]|[drive]|[swing]|[pass]) (?:around|round|past) {parked}(?: in {_OUR} lane)?|[overtake] {parked}|[pass] {parked}(?: (?:through|in|on) the (?:opposite|oncoming) lane)?"
    yield Phrase(sort=Sort.BYPASS, value=Maneuver.BYPASS, written=_marked(bypass), ego=True)
    leader = r"[follow] (?:a|the) slow(?:er)? (?:car|vehicle|truck)|(?:behind|after) (?:a|the) slow(?:er)? (?:car|vehicle|truck)"
    yield Phrase(sort=Sort.LEADER, value=True, written=_marked(leader), ego=True)
    states = {
        EgoState.STANDS: r"[wait]|[stand](?: still)?|(?:are|were|is|was) (?:stopped|stationary|held|standing still|at a standstill|waiting|standing|queue?ing|broken down)|(?:(?:has|have|had) )?(?:broken|breaks?|broke) down",
        EgoState.SETS_OFF: r"[set] off|[start](?: moving| driving)?|[pull] away|[drive] off|[move] off",
        EgoState.SLOW: r"[drive] (?:very )?slowly|[crawl](?: along)?|[creep] along",
        EgoState.SLOWS_DOWN: r"[slow] down|[slow]",
        EgoState.BRAKES: r"[brake] (?:hard|sharply|heavily)|[brake]",
        EgoState.STOPS: r"[stop]|[come] to a (?:stop|halt)",
    }
    for state, said in states.items():
        yield Phrase(sort=Sort.STATE, value=state, written=_marked(said), ego=True)


_JOINTS = r"around(?= (?:an?|the) )|while|whilst|when|as|and|but|where|,|;|because"
_THEN = r"(?:, |and |, and |but )?(?:then|after that|afterwards|next)(?:,)?|(?:; |, )?(?:and |which )?then"
_FILLERS = (
    r"suddenly|abruptly|unexpectedly|all of a sudden|without (?:any )?(?:warning|looking|signalling|indicating)|immediately|at once|just"
    r"|slightly|simply|only|also|still|again|now|there|here|both|too|hard|sharply|at the last moment|in the process|on its way|all the time"
    r"|(?:(?:starts?|begins?|started|began|continues?) to|starts?(?= \w+ing)|begins?(?= \w+ing)|keeps?(?= \w+ing))|is|are|was|were|has|have|had|will|be|being|to|comes and"
    r"|at (?:a )?constant speed|at a (?:steady|constant) speed|at the same speed|(?:the )?whole time|from a standstill|closer|as usual|of the road"
    r"|in (?:our|the same|its own|its|their) direction|in (?:its|his|her|their) (?:own )?lane|along with traffic|in the same direction"
)
_ROW = r"one (?:behind|after) (?:the other|another)|(?:behind|after) (?:each other|one another)|in a (?:row|queue|line)"
_SEES = r"we (?:meet|see|encounter|face|drive towards)(?= (?:a|an|the|another|some|two) )"
_COMES_UP = (
    r"we (?:come up (?:to|on|behind)|come upon|approach|follow|drive behind)(?= (?:a|an|the|another|some|two) )"
    r"|to (?:pass|overtake|get past|go past)(?= (?:a|an|the) )"
)
_LEAVES_IT = r"[leave] (?:it|that lane)"


@lru_cache(maxsize=64)
def phrases_at(letter: str) -> tuple[Phrase, ...]:
    """Of all phrases, in their order, those that may begin with a letter."""
    return tuple(phrase for phrase in phrases() if not phrase.begins or letter in phrase.begins)


@lru_cache(maxsize=1)
def phrases() -> tuple[Phrase, ...]:
    """Every phrase but those of road users, which the kinds' own words make."""
    found: list[Phrase] = [
        Phrase(sort=Sort.EGO, value=None, written=_whole(r"we|the ego(?: vehicle)?|our (?:own )?(?:car|vehicle)")),
        Phrase(sort=Sort.SEES, value=None, written=_whole(_SEES)),
        Phrase(sort=Sort.SEES, value=Where.AHEAD, written=_whole(_COMES_UP)),
        Phrase(sort=Sort.ACT, value=Action.CUT_IN, written=_marked(r"[cut] into that lane"), ego=False),
        Phrase(sort=Sort.ACT, value=Action.CHANGE_LANE, written=_marked(_LEAVES_IT), ego=False),
        Phrase(sort=Sort.SAME, value=None, written=_whole(r"it|he|she|they|who|which|that")),
        Phrase(sort=Sort.JOINT, value=None, written=rf"(?:{_JOINTS})(?!\w)"),
        Phrase(sort=Sort.THEN, value=None, written=rf"(?:{_THEN})(?!\w)"),
        Phrase(sort=Sort.FILLER, value=None, written=_whole(_FILLERS)),
        Phrase(sort=Sort.END, value=None, written=r"[.!]+"),
        Phrase(
            sort=Sort.ACT, value=Action.FOLLOW, ego=False,
            written=_whole(
                r"(?:does|do|did) not (?:stop|brake|yield|slow down|give way)|doesn't (?:stop|brake|yield|slow down)"
                r"|without (?:stopping|braking|slowing(?: down)?|yielding)|fails? to (?:stop|brake|yield)"
            ),
        ),
        *_acts(),
        *_of_ego(),
        *_places(),
        *_sites(),
        *_occluders(),
        *(Phrase(sort=Sort.WHERE, value=value, written=_whole(said), ego=False) for value, said in _WHERE),
        *(Phrase(sort=Sort.SIDE, value=value, written=_sided(said), ego=False) for value, said in _SIDED),
        Phrase(sort=Sort.ROW, value=None, written=_whole(_ROW), ego=False),
        Phrase(sort=Sort.TARGET, value=None, written=_whole(_TARGETS), ego=False),
    ]  # fmt: skip
    return tuple(found)


def _sided(said: str) -> str:
    """A pattern in which each alternative has the side under the one name."""
    parts = said.split(_SIDE)
    numbered = "".join(
        part + (rf"(?P<side{i}>left|right)" if i < len(parts) - 1 else "") for i, part in enumerate(parts)
    )
    return _whole(numbered)


def side_in(match: re.Match[str]) -> str | None:
    """The side that a match of a sided phrase names."""
    return next((value for name, value in match.groupdict().items() if name.startswith("side") and value), None)


_NAMED = (*(kind for kind in AdversaryKind if kind.lies), *lexicon.KINDS)  # a traffic cone is no traffic


@lru_cache(maxsize=1)
def road_user() -> re.Pattern[str]:
    """A road user with its article and what is said before the noun."""
    traits = "|".join(said for _, _, said in _TRAITS)
    nouns = "|".join(f"(?P<k{i}>{kind.row.words})" for i, kind in enumerate(_NAMED))
    article = r"(?P<article>an?|the|another|a second|a third|some|one|two|three|several|a group of|a pack of)"
    return re.compile(rf"(?:{article} )?(?P<traits>(?:(?:{traits}) )*)(?:{nouns})(?![\w'-])")


def kind_in(match: re.Match[str]) -> AdversaryKind:
    """The kind of road user that a match of `road_user` names."""
    return next(_NAMED[int(name[1:])] for name, value in match.groupdict().items() if name[0] == "k" and value)


def is_plural(match: re.Match[str], kind: AdversaryKind) -> bool:
    """Whether a match of `road_user` names several by the form of its noun: what is left of it is a noun of the kind."""
    noun = match[0].removeprefix(f"{match['article']} ").removeprefix(match["traits"])
    return any(re.fullmatch(kind.row.words, noun.removesuffix(end)) for end in ("s", "es") if noun.endswith(end))


def traits_in(match: re.Match[str]) -> Iterator[tuple[Sort, object]]:
    """The facts that stand before the noun."""
    left = match["traits"]
    while left:
        for sort, value, said in _TRAITS:
            if found := re.match(rf"(?:{said}) ", left):
                yield sort, value or found[0].strip()
                left = left[found.end() :]
                break
        else:  # pragma: no cover - the pattern is made of the same traits
            return
