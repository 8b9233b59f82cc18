"""The words of edits: what they say beyond the phrases in which situations are told.

An edit is made of the phrases of `chatscene.read.phrases`, of the wider words of `chatscene.read.lexicon`, and of the
marks below, which say what is to be done with a fact: set it, drop it, put it beside others, in place of another.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import lru_cache
from typing import Any

from chatscene.read import lexicon
from chatscene.read.asides import COURTESY, WORSE_THAN
from chatscene.read.inflection import any_form
from chatscene.read.parse import SEVERAL
from chatscene.read.phrases import Phrase, Sort, Where, kind_in, phrases_at, road_user, side_in, traits_in
from chatscene.read.quantities import WALKING_PACE, number_at, quantity_at
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.scenario import (
    Control,
    Distance,
    EgoState,
    Maneuver,
    Measure,
    Place,
    Quantity,
    Shift,
    Site,
    Slots,
)
from chatscene.terms.surroundings import Light, Surface, Weather


class Mark(StrEnum):
    """What words of an edit do, or which fact they name."""

    SET = "set"  # make it, use
    OLD = "old"  # instead of, rather than: what follows is what was
    CHANGE = "change"  # replace, turn: what follows is what was, up to NEW
    NEW = "new"  # with, by, into
    INSTEAD = "instead"
    DROP = "drop"
    ADD = "add"
    ALSO = "also"
    THEN = "then"
    FIRST = "first"
    BEFORE = "before"
    AFTER = "after"
    ON_THE_WAY = "on-the-way"  # halfway
    ONLY = "only"
    JOINT = "joint"
    EGO = "ego"
    IT = "it"  # the adversary
    REPAIR = "repair"  # no, I mean: what follows takes the place of what was said
    OTHER = "other"  # the second road user
    SIDE = "side"  # a bare one
    OTHER_SIDE = "other-side"
    MIRROR = "mirror"
    USER = "user"  # a road user: kind, article, traits
    ACT = "act"
    WHERE = "where"
    SIDED = "sided"  # a side, with a `Where` or None
    PLACE = "place"
    CONTROL = "control"
    SITE = "site"
    MANEUVER = "maneuver"
    STATE = "state"
    MOVES = "moves"  # the ego is under no orders
    OCCLUDER = "occluder"
    HIDDEN = "hidden"  # nothing tells by what
    SEEN = "seen"  # nothing hides it
    LEADER = "leader"
    LANES = "lanes"
    TWO_WAY = "two-way"
    GROUP = "group"
    DEGREE = "degree"  # of rain and the like, which has none here
    FAR = "far"  # near or far
    LIGHT = "light"
    WEATHER = "weather"
    SURFACE = "surface"
    NUMBER = "number"
    SHIFT = "shift"
    ANY = "any"  # number of a measure
    FILLER = "filler"


@dataclass(frozen=True, slots=True, kw_only=True)
class Word:
    """Words of an edit that mean one thing.

    Attributes:
        mark: What they do or name.
        value: The fact that they name, if any.
        said: The words.
        at: Where they begin in the text.
    """

    mark: Mark
    value: Any = None
    said: str
    at: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Named:
    """A road user as words name it.

    Attributes:
        kind: What it is.
        article: The word before it; empty if there is none.
        traits: What is said before the noun.
        several: Whether there are several of it.
    """

    kind: AdversaryKind
    article: str
    traits: tuple[tuple[Sort, object], ...]
    several: bool


A_TURN = "a turn"  # to either side: the one that somebody makes already
_PRONOUN = r"(?:it|him|her|them|that|this|he|she|they)"
_CAUSE = r"(?:make|let|have|get|want|put|send|keep)"
_VALUE = r"(?:speed|distance|gap|deceleration|braking)"
_STAGING = "|".join(
    (
        # Phrases that set a scene and say nothing of it
        rf"(?:(?:in|de)crease|raise|reduce|lower|bring)(?: (?:the|its|his|her))?(?: \w+)? {_VALUE}(?= (?:up |down )?to )|gap(?: of)?",
        r"slippery(?= (?:with|from|because of|ice|snow)\b)|(?:in)?to (?:the|a|an) (?:next|neighbou?ring|adjacent|other) lane",
        r"(?:let us|us) (?:see|try|have|do|take|use|say)(?: (?:it|that|this))?(?: with(?= an?))?|(?:would|might|could|will) be",
        r"time of (?:the )?day|vehicle (?:type|class|category|kind)|type of|way(?= (?:so|that))|then(?= please)|back(?= to)|there(?= (?:is|are|should|shall|will)\b)",
        r"(?:keep|leave) the rest|(?:the )?rest (?:as it is|unchanged|stays)|everything else (?:stays|unchanged|the same)|otherwise (?:the same|unchanged)",
        r"of day|bit where|at all|any ?more|any longer|out there|over there|all of a sudden|in general|as usual|right now|as before",
        # Verbs without a meaning of their own
        r"(?:should|shall|must|will|would|could|can|may|might|ought to|needs? to|has to|have to)(?: have been| be)?",
        r"[be]|been|am|do(?:es)?|did|done|[have]|[get]|got|[give]|[show]|[see]|seen|[try]|[use]|[happen]|[occur]|takes? place|taking place|plays? out|[set]|[move]|[place]|located?|positioned|"
        r"[come]|[go]|[approach]|[drive]|driven|[start](?: off)?|[begin]|[appear]|[stand]|[walk]|[ride]|[travel]|[run](?: it)?(?= \w)|[keep]|[put]|[turn] out|[become]|suppose|assume|imagine|[mean]|[call]|[be] called|[name]",
        # Closed classes
        r"the|an?|its|his|her|their|our|this|that|these|those|such|some|any|all|both|whole|same|else|few|one|ones|anything|something|everything|everyone",
        r"here|there|everywhere|somewhere|outside|outdoors|to|in|on|at|of|by|from|with|for|up|away|over|out|across|along|through|into|onto|toward|towards|during|under|about|around|if|whether|than|able|(?:as|than|like) before|itself|himself|herself|themselves",
        r"already|yet|again|now|just|so|but|very|quite|simply|merely|really|super|duper|extremely|totally|entirely|completely|altogether|suddenly|abruptly|hard|sharply|rather|instead|even|once|better|bit|little|lot|long",
        # Names of what is named
        r"scene|scenario|situation|case|variant|version|event|setting|geometry|environment|adversarial|man(?:oeuvre|oeuver|euver|euvre)s?|lighting|behaviou?r|position|value|act|actions?|part|number|kind|type|class|state|parameter|actor|initial|"
        r"road|street|segment|section|stretch|weather|conditions?|surface|friction|low-friction|light|side|hand|lane|adjacent|neighbou?ring|day|time|speed|closing|distance|deceleration|direction|trigger|conflict|vrus?|us|ego|complete|full|sudden|fallen|ordinary|normal|regular|usual|plain|standard|poor|real|actual|other(?= (?:car|driver))",
    )
)

_MARKS: tuple[tuple[Mark, Any, str], ...] = (
    (Mark.SET, None, rf"(?:place|position|locate|start|spawn)(?= the )|(?:{_CAUSE}|place|position|locate|move|start|spawn|shift) {_PRONOUN}|(?:make|let|have|use|take|try|put|set|give|want|change {_PRONOUN} (?:to|into)|turn {_PRONOUN} into|it(?:'s| is| should be| must be| will be)|make the (?:scene|scenario|situation|whole thing))(?: {_PRONOUN})?|we want|how about|what if"),
    (Mark.REPAIR, None, r"(?<=, )(?:(?:no|nope|oops|sorry|correction|rather|or rather),?(?= (?:an?|the|it|make|from|on|at|in|we|let)\b)|(?:no, )?(?:we|i) mean(?:t)?)"),
    (Mark.OLD, None, rf"{WORSE_THAN}|instead of|rather than|in place of|not|as opposed to|in lieu of"),
    (Mark.CHANGE, None, r"replace|swap(?: out)?|exchange|change|switch|convert|turn(?= the )|substitute"),
    (Mark.NEW, None, r"(?:with|by|for|to|into|become|becomes)(?= |$)"),
    (Mark.INSTEAD, None, r"instead|rather|in its place|in stead|this time|for a change|after all"),
    (Mark.DROP, None, r"no|without(?: any)?|minus|ditch|scratch|kill|drop|remove|take away|take out|delete|lose|get rid of|leave out|leave away|forget(?: about)?|skip|scrap|omit|do away with|cut out(?= the )|(?:does|do|did|should|must|shall|will|can|could|would|need|is|are|was) ?not(?: (?:be|have|want))?|never|nobody|no one|no-one|(?:there (?:is|are|should be|shall be) )(?:no|not)(?: any)?|no longer|not any|nor|neither|stops?(?= the (?:rain|snow|fog))"),
    (Mark.ADD, None, r"add(?: in)?|include|introduce|bring in|there (?:is|are|should be|shall be|has to be)(?: also)?|plus|throw in|put in"),
    (Mark.ALSO, None, r"also|too|as well|additionally|in addition|on top(?: of that)?|besides"),
    (Mark.THEN, None, r"(?:and )?(?:then|followed by|after (?:that|this|it)|afterwards?|later on(?= it)|after which|next(?= (?:it|he|she|they)\b)|finally|in the end|at the end|subsequently|thereafter)(?: also)?|before (?:it )?finally"),
    (Mark.FIRST, None, r"first(?: of all)?|at first|initially|to begin with|beforehand"),
    (Mark.BEFORE, None, rf"before(?: {_PRONOUN})?(?= \w)"),
    (Mark.AFTER, None, rf"(?:after|once|when|having)(?: {_PRONOUN})?(?: has)?(?= \w+(?:ing|s|ed)\b)"),
    (Mark.ON_THE_WAY, None, r"halfway(?: across| over| through)?|half-way|midway|mid-way|half way|in the middle(?: of (?:the|our|his|her|its) (?:road|street|lane|crossing|junction|way))?|on (?:its|his|her|the) way|in between|(?:for )?a (?:moment|second|sec|while|short while|bit(?= in))|briefly|part-?way"),
    (Mark.ONLY, None, r"only|just(?: the)? one|alone|a single|single|by (?:it|him|her)self|on (?:its|his|her) own"),
    (Mark.JOINT, None, r",|;|\.|:|and|but|or|so that|while|as|that|who|which|where|when|as soon as"),
    (Mark.EGO, None, rf"{_CAUSE} us|(?:{_CAUSE} )?(?:we|our (?:own )?(?:car|vehicle)|the (?:av|vut|sut|host(?: vehicle)?|tested (?:car|vehicle)|test vehicle|subject vehicle))(?! (?:want|would like)\b)"),
    (Mark.OTHER, None, r"the (?:second|third|other) (?:one|(?!side|direction|lane|way|hand)(?P<of>\w+))|(?:the |any )?(?:second|additional|extra|further) (?:road user|vehicle|party|actor|adversary|one)|everybody else|anybody else|anyone else|somebody else|other (?:road users?|traffic)|the others?"),
    (Mark.IT, None, rf"{_PRONOUN}|(?:(?:the|our) )?(?:adversary|opponent|actor|agent)(?: vehicle)?(?:'s)?|(?:the|that|this|our) (?:other (?:party|road user|driver|rider|one|person)|driver|rider|road user|person|human|guy|one|vehicle|attacker|actor)"),
    (Mark.OTHER_SIDE, None, r"(?:(?:from|on|to|at) )?(?:the )?(?:(?:other|opposite|opposing) (?:side|hand)|other direction)(?: of the (?:road|street))?|(?:swap|switch|change|flip)(?: the)? sides?|(?:the )?other way(?: a?round)?|from the other|(?:the )?other lane"),
    (Mark.MIRROR, None, r"(?:reverse(?= (?:everything|left|the (?:whole|scene|scenario|situation|sides)))|mirror|flip)(?: (?:it|everything|(?:the )?(?:(?:whole|entire) )?(?:scene|scenario|situation|thing)|that|this|left and right))?(?: left to right)?|swap left and right|mirrored|mirror image|the same (?:thing )?mirrored|left and right swapped"),
    (Mark.SIDE, None, r"(?:the |our )?(?P<side>left|right)(?:-hand)?(?: (?:side|kerb|curb|roadside|pavement|sidewalk))?"),
    (Mark.SIDED, ("left", None), r"(?:from )?(?:the )?left to (?:the )?right"),
    (Mark.SIDED, ("right", None), r"(?:from )?(?:the )?right to (?:the )?left"),
    (Mark.ACT, Action.WEAVE, r"wobbl\w*(?: from side to side)?|sway\w*"),
    (Mark.ACT, Action.BRAKE, r"(?:an? )?emergency (?:braking|brake|stop)|[hit] the brakes(?: hard)?|[step] on the brakes?"),
    (Mark.ACT, A_TURN, r"[turn](?! (?:to|left|right|back|around|round|off|into|it|them|the)\b)"),
    (Mark.ACT, Action.FOLLOW, r"(?:[stay]|[remain]|[keep])(?= (?:behind|ahead|beside|alongside) )|(?:[stay]|[keep]|[remain]) (?:in|to) (?:its|his|her|their|the) (?:own )?lane"),
    (Mark.ACT, Action.STAND, r"(?:[stay]|[remain]|[keep]) (?:parked|standing|still|put|where it is|stationary)|broken[- ]down|not moving|motionless|parked(?= (?:in|on|ahead))"),
    (Mark.STATE, EgoState.SLOW, r"(?:[go]|[drive]|[move])? ?(?:very |quite |more )?slowly|slow|slower"),
    (Mark.ACT, Action.TAILGATE, r"[follow] (?:us )?(?:(?:too|very|right|so|dangerously) )?close(?:ly)?(?: behind(?: us)?)?"),
    (Mark.WHERE, Where.BEHIND, r"[follow] us"),
    (Mark.ACT, Action.NARROW, r"(?:only )?(?:partly|partially|half|halfway) (?:in|on|into|onto|across) (?:our|the) lane|[block] (?:only |just )?(?:a |one )?(?:half|part)(?: of)? (?:our|the) lane"),
    (Mark.ACT, Action.ONCOMING, r"oncoming|[come] (?:towards|at) us|from the front|[come] the other way"),
    (Mark.STATE, EgoState.SLOWS_DOWN, r"[decelerate]"),
    (Mark.STATE, EgoState.SETS_OFF, r"(?:then )?[start](?: to (?:move|drive))?"),
    (Mark.ACT, Action.TURN_BACK, r"[turn] a?round"),
    (Mark.ACT, Action.CHANGE_LANE, r"[change] (?:in|on)?to (?:the |our )?(?:next|adjacent|neighbou?ring|other|left|right)(?:-hand)? lane"),
    (Mark.ACT, Action.TAILGATE, r"[drive] (?:much |far |way |very )?too close(?: (?:behind|to) us)?"),
    (Mark.WHERE, Where.BEHIND, r"(?:from )?behind us"),
    (Mark.MOVES, None, r"(?:are |be )?(?:moving|rolling|under way)|are (?:driving|going)(?=$|,)|[keep] (?:moving|driving|going)|(?:do not|don't) (?:wait|stand|stop|brake|slow down)|not (?:standing|waiting|stopped|stationary|braking)|[drive] (?:normally|as usual)|at normal speed"),
    (Mark.STATE, EgoState.STANDS, r"[be] (?:standing|parked|halted)(?: still)?|(?:have|had)(?: just)? stopped|[be] not moving|not moving|at a standstill|stationary|standing(?: still)?|[stand](?: still)?"),
    (Mark.MANEUVER, Maneuver.STRAIGHT, r"[go] straight(?: (?:on|ahead|through|over))?|straight (?:on|ahead|through)|[drive] straight(?: (?:on|ahead|through))?|[keep] straight(?: on)?|[stay] in (?:our|the|its) lane"),
    (Mark.MANEUVER, Maneuver.LANE_CHANGE_LEFT, r"[change] (?:into |to |in )?(?:the )?(?:lanes? )?(?:to the )?left(?: lane)?|[do] a lane change (?:to the )?left"),
    (Mark.MANEUVER, Maneuver.LANE_CHANGE_RIGHT, r"[change] (?:into |to |in )?(?:the )?(?:lanes? )?(?:to the )?right(?: lane)?|[do] a lane change (?:to the )?right"),
    (Mark.HIDDEN, None, r"(?:is |be |stays? |being )?(?:hidden|concealed|obscured|occluded|masked|covered)(?: (?:behind|between|by|from view))?|(?:hides?|hiding|conceals?|obscures?|obscuring|occludes?|occluding|covers?|covering|masks?|masking)(?: (?:him|her|it|them|behind))?|(?:steps?|comes?|walks?|runs?|rides?|appears?|emerges?|pops?)?(?: out)?(?: from)? ?behind(?= (?:an?|the|some) (?!\w* ?(?:curve|bend|corner|junction|turn)))|(?:in|to) (?:our|the) (?:view|sight)|(?:blocks?|blocking|obstructs?|obstructing) (?:the|our) (?:view|sight)(?: with)?|in front of (?:it|him|her|them|the (?!ego|av)\w+)|from (?:view|sight)|out of sight|to hide(?: (?:him|her|it|them))?|(?:so (?:that )?)?(?:we|you|ego|nobody) (?:can ?not|could ?not|do not|will not)(?: yet)? see(?: (?:him|her|it|them))?(?: (?:at first|coming|until late))?|in the way of (?:our |the )?(?:sight|view)|at first"),
    (Mark.SEEN, None, r"(?:(?:is|be|are|fully|clearly|plainly|stays?|well) )*visible(?: (?:from the (?:start|beginning|outset)|all the time|at all times|all along))?|in plain (?:view|sight)|in full view|(?:out )?in the open|unhidden|not (?:be )?(?:hidden|concealed|obscured|occluded)|(?:with )?nothing (?:hides|hiding|hidden|in between|blocking)(?: (?:him|her|it|them|the view|our view))?|no (?:occlusion|occluder|cover|obstruction|hiding)|without (?:an? |the |any )?(?:occlusion|occluder|cover|obstruction|hiding)|(?:can|could) be seen(?: from the start)?|seen from the start"),
    (Mark.OCCLUDER, None, r"(?:the |an? |any )?(?:occluder|occlusion|cover|view blocker|obstruction)"),
    (Mark.LEADER, True, r"(?:with|behind|following|add|we follow) (?:an?|the|another) slow(?:er)?(?:[- ]moving)? (?:car|vehicle|truck|lorry|van|bus)(?: (?:ahead|in front)(?: of us)?)?(?: that we follow)?|(?:the |an? |any )?(?:slow )?(?:lead(?:ing)? (?:car|vehicle)|leader)(?: (?:ahead|in front)(?: of us)?)?"),
    (Mark.LANES, 1, r"(?:only |just )?(?:one|a single|1) lane(?: (?:each|per|in each|in our|in either) (?:way|direction))?|(?:on an? )?(?:single|one)[- ]lane(?: (?:road|street))?"),
    (Mark.LANES, 2, r"(?:two|2) lanes(?: (?:each|per|in each|in our|in either|for our|our) (?:way|direction))?|(?:on an? )?(?:two|2)[- ]lane(?: (?:road|street|carriageway))?"),
    (Mark.LANES, 3, r"(?:three|3) lanes(?: (?:each|per|in each|in our|in either|for our|our) (?:way|direction))?|(?:on an? )?(?:three|3)[- ]lane(?: (?:road|street|carriageway))?"),
    (Mark.TWO_WAY, True, r"(?:on a )?two[- ]way(?: (?:road|street))?|with (?:an )?oncoming (?:traffic|lane)"),
    (Mark.TWO_WAY, False, r"(?:on a )?one[- ]way(?: (?:road|street))?"),
    (Mark.GROUP, True, r"(?:in )?(?:a |the )?(?:whole )?(?:group|crowd|bunch|pack)(?: of(?: them)?)?|several(?: of them)?|two of them|three of them|more than one|with (?:others|friends|company)|together with others|multiple"),
    (Mark.DEGREE, None, r"(?:heavy|light|torrential|pouring|driving|thick|dense|patchy|slight|steady|strong|severe)(?= (?:rain|snow|fog|shower))"),
    (Mark.FAR, Distance.FAR, r"(?:(?:very|quite|from|start|starts|starting) )?far (?:away|off|ahead|behind)(?: (?:from|of) us)?|in the distance|a long way (?:off|away|ahead|behind)|at (?:a )?(?:long|great|large) (?:distance|range)"),
    (Mark.FAR, Distance.NEAR, r"(?:(?:very|quite|start|starts|starting|right) )?(?:close by|nearby|close to us|near us|close up|close at hand)|a short (?:way|distance) (?:off|away|ahead)|at (?:a )?(?:short|close) (?:distance|range)"),
    (Mark.CONTROL, Control.SIGNAL, r"(?:with |that has )?(?:a set of |the |a |any )?(?:red |green )?(?:traffic |stop ?)?(?:lights?|signals?)|signali(?:s|z)ed|(?:light|signal)[- ]controlled"),
    (Mark.CONTROL, Control.STOP_SIGN, r"(?:with )?(?:a |the |any )?stop[- ]signs?(?: controlled)?|(?:all|two)[- ]way stop"),
    (Mark.CONTROL, Control.NONE, r"un-?signali(?:s|z)ed|uncontrolled|unregulated|without (?:any )?(?:traffic )?(?:lights?|signals?)(?: or signs?)?|no (?:red |green )?(?:traffic )?(?:lights?|signals?)(?: or signs?)?|without any control|no control"),
    (Mark.PLACE, Place.THREE_WAY, r"t[- ]?(?:junction|intersection|crossing)|(?:three|3)[- ](?:way|arm(?:ed)?|leg(?:ged)?)(?: (?:junction|intersection|crossing))?"),
    (Mark.PLACE, (Place.FOUR_WAY, Control.STOP_SIGN), r"(?:at )?(?:a |the )?four[- ]way stop"),
    (Mark.PLACE, Place.FOUR_WAY, r"cross-?roads|(?:four|4)[- ](?:way|arm(?:ed)?|leg(?:ged)?)(?: (?:junction|intersection|crossing))?"),
    (Mark.PLACE, Place.JUNCTION, r"(?:a |the |an |any )?(?:street )?(?:intersection|junction)|(?:at|on|in) (?:the|a) crossing"),
    (Mark.PLACE, Place.LEFT_CURVE, r"(?:in |on |around |round |through |behind |after )?(?:a |the )?left(?:-hand)? (?:bend|curve)|(?:a )?(?:bend|curve) to the left"),
    (Mark.PLACE, Place.RIGHT_CURVE, r"(?:in |on |around |round |through |behind |after )?(?:a |the )?right(?:-hand)? (?:bend|curve)|(?:a )?(?:bend|curve) to the right"),
    (Mark.PLACE, Place.CURVE, r"(?:in |on |around |round |through |into |behind |after )?(?:a |the )?(?:sweeping )?(?:bend|curve)|curv(?:ed|ing|y)(?: road)?|winding(?: road)?"),
    (Mark.PLACE, Place.ROAD, r"(?:on |along )?(?:a |an |the )?(?:(?:straight|open|normal|plain|ordinary|regular) )+(?:piece of |stretch of |stretch|section of )?(?:road|street)?|between (?:the )?(?:junctions|intersections)|mid-?block|away from (?:any|the) (?:junction|intersection)"),
    (Mark.SITE, Site.ROUNDABOUT, r"(?:an?|the|any)? ?(?:roundabout|traffic circle|rotary)"),
    (Mark.SITE, Site.MOTORWAY, r"(?:an?|the|any)? ?(?:motorway|highway|freeway|expressway|autobahn)"),
    (Mark.SITE, Site.RURAL, r"(?:out )?(?:in|into|to) the country(?:side)?|rural(?: (?:road|area))?|(?:an?|the|any)? ?country (?:road|lane)"),
    (Mark.SITE, Site.CROSSWALK, r"(?:an?|the|any)? ?(?:crosswalk|zebra(?: crossing)?|pedestrian crossing)"),
    (Mark.LIGHT, Light.DAY, r"(?:(?:by|in|during|at) )?(?:the )?(?:(?:broad|full|bright) )?(?:day(?:time|light)|noon|midday|sun(?:light|shine|ny)?)|(?:by|in the|during the|a bright|on a bright|a sunny|on a sunny) day|(?:in the )?(?:morning|afternoon)|(?:make it )?day(?:time)?|in the sun(?:shine)?"),
    (Mark.LIGHT, Light.NIGHT, r"(?:when it is |it is |in the )?dark(?:ness)?|(?:in|at|by|during) the night(?:time)?|nocturnal"),
    (Mark.LIGHT, Light.DUSK, r"in the twilight|at (?:dusk|dawn|twilight|sunset|sunrise)|in the (?:late )?evening"),
    (Mark.WEATHER, Weather.CLEAR, r"(?:it )?(?:has )?(?:just )?stop(?:s|ped)? (?:raining|snowing)|(?:the )?(?:rain|snow|fog) (?:has |is )?(?:stops?|stopped|gone|over|clears?|cleared|lifts?|lifted)|(?:the )?sun (?:is |comes? )?(?:shining|shines|out)|(?:in )?(?:clear|fine|good|nice) (?:weather|conditions)|clear"),
    (Mark.WEATHER, Weather.RAIN, r"(?:the )?rain (?:is )?falling|(?:in |during |under )?(?:the )?rain(?:y|ing|s)?(?: weather)?|(?:it )?rains?|it is raining|pouring(?: down)?(?: with rain)?"),
    (Mark.WEATHER, Weather.SNOW, r"(?:the )?snow (?:is )?falling|(?:in |during )?(?:the )?snow(?:fall|y|ing|s)?(?: weather)?|it is snowing"),
    (Mark.WEATHER, Weather.FOG, r"(?:in |during )?(?:the )?fog(?:gy)?(?: weather)?"),
    (Mark.SURFACE, Surface.DRY, r"(?:on )?(?:a |the )?dry(?: (?:road|street|surface|asphalt|conditions?))?|in the dry"),
    (Mark.SURFACE, Surface.WET, r"(?:on )?(?:a |the )?wet(?: (?:road|street|surface|asphalt|conditions?))?|in the wet"),
    (Mark.SURFACE, Surface.ICE, r"(?:on )?(?:a |an |the )?(?:icy|frozen)(?: (?:road|street|surface))?|(?:on |with )?(?:black )?ice(?: on the (?:road|street))?"),
    (Mark.SURFACE, Surface.SNOW, r"(?:on )?(?:a |the )?(?:snowy|snow-?covered) (?:road|street|surface)|(?:with )?snow on the (?:road|street|ground)"),
    (Mark.ANY, Measure.SPEED, r"(?:at )?(?:any|whatever) speed|no matter how fast"),
    (Mark.ANY, Measure.DISTANCE, r"(?:at )?any distance|anywhere"),
    (Mark.FILLER, None, COURTESY),
    (Mark.FILLER, None, _STAGING),
)  # fmt: skip

_DEGREE = r"(?:(?:a (?:little )?bit|a little|slightly|somewhat|a touch|much|far|way|a lot|considerably|even|significantly|noticeably|any|still|quite a bit|rather|more|a good deal) )*"
_ADVERB = r"(?: (?:than (?:that|before|now|it is|it was)|to us|from us|behind us|ahead of us|in front of us|ahead|behind|at us))?"
_TOO = rf"(?:(?:{_PRONOUN} )?(?:is|was|are|looks|seems|feels) |^)(?:(?:a bit|a little|much|far|way|just) )?too"  # who complains wants the opposite
_SHIFTS: tuple[tuple[Measure, bool, str], ...] = (
    (Measure.SPEED, True, rf"{_TOO} slow(?:ly)?|(?:really|super|that|so|pretty|extremely)? ?fast|faster|quicker|more quickly|(?:at )?(?:an? )?(?:higher|greater|increased) speed|more speed|speedier|speed (?:it|him|her|them|things) up|(?:increase|raise|up) (?:the|its|his|her|the \w+'s|the \w+ \w+'s) (?:walking |driving |riding )?speed|(?:in (?:more of )?a (?:hurry|rush)|(?:at a )?run(?:ning)?|jogging|sprinting)"),
    (Measure.SPEED, False, rf"{_TOO} (?:fast|quick|speedy)|slower|more slowly|(?:at )?(?:an? )?(?:lower|reduced|smaller) speed|less speed|slow (?:it|him|her|them|things) down|(?:not (?:so|as|quite so|that)|less) (?:fast|quick|quickly)|(?:decrease|reduce|lower) (?:the|its|his|her|the \w+'s|the \w+ \w+'s) (?:walking |driving |riding )?speed"),
    (Measure.DISTANCE, False, rf"{_TOO} (?:far|distant)(?: away)?|(?:(?:at a )?(?:smaller|shorter) distance|less (?:room|space|distance)|(?:reduce|decrease|shorten|lower) (?:the|its|his|her) (?:initial |starting |start )?(?:distance|gap)|smaller(?: gap)?|tighter|closer|nearer|less far)"),
    (Measure.DISTANCE, True, rf"{_TOO} (?:close|near)|(?:(?:at a )?(?:greater|larger|longer|bigger) distance|more (?:room|space|distance)|(?:increase|extend|lengthen|enlarge) (?:the|its|his|her) (?:initial |starting |start )?(?:distance|gap)|(?:bigger|larger)(?: gap)?|(?:farther|further)(?: (?:away|off|out|back|up|down))?|more distant|not (?:so|as) (?:close|near))"),
    (Measure.TRIGGER, False, rf"{_TOO} (?:early|soon)|later(?: on)?|(?:at )?a later (?:moment|point)|not (?:so|as) early"),
    (Measure.TRIGGER, True, rf"{_TOO} late|earlier|sooner|(?:at )?an earlier (?:moment|point)|not (?:so|as) late"),
    (Measure.DECELERATION, True, rf"{_TOO} (?:gentle|soft|weak)|harder|more (?:sharply|abruptly|strongly|violently|heavily|forcefully|suddenly)|stronger|sharper"),
    (Measure.DECELERATION, False, rf"{_TOO} (?:hard|strong|sharp)|softer|gentler|more (?:gently|softly|smoothly)|less (?:hard|sharply|abruptly|strongly|violently|heavily)|not (?:so|as) hard|weaker|smoother"),
    (Measure.TIME, True, r"(?:for )?longer|for a longer time|not (?:so|as) short"),
    (Measure.TIME, False, r"(?:for )?shorter|for a shorter time|less long|more briefly|not (?:so|as) long"),
)  # fmt: skip
_TIMES: tuple[tuple[float, str], ...] = (
    (2.0, r"(?:twice|double|two times|2 ?x|2 times)(?: (?:as|the))?"),
    (3.0, r"(?:three times|triple|3 ?x|3 times)(?: (?:as|the))?"),
    (0.5, r"half(?: (?:as|the))?|halve (?:the|its|his|her)"),
    (1.5, r"one and a half times(?: (?:as|the))?|half again as"),
)
_OF: tuple[tuple[Measure, str], ...] = (
    (Measure.SPEED, r"fast(?: as (?:before|now|that))?|speed|quick"),
    (Measure.DISTANCE, r"far(?: (?:away|off))?(?: as (?:before|now|that))?|distance"),
    (Measure.DECELERATION, r"hard(?: as (?:before|now|that))?"),
    (Measure.TIME, r"long(?: as (?:before|now|that))?"),
)


_MARKED = re.compile(r"\[([a-z]+)\]")


def _compiled(text: str) -> re.Pattern[str]:
    marked = _MARKED.sub(lambda verb: any_form(verb[1]), text)
    return re.compile(rf"(?:{marked})(?![\w'])")


@lru_cache(maxsize=1)
def _marks() -> tuple[tuple[Mark, Any, re.Pattern[str]], ...]:
    return tuple((mark, value, _compiled(said)) for mark, value, said in _MARKS)


@lru_cache(maxsize=1)
def _shifts() -> tuple[tuple[Measure, bool, re.Pattern[str]], ...]:
    return tuple((measure, more, _compiled(rf"{_DEGREE}(?:{said}){_ADVERB}")) for measure, more, said in _SHIFTS)


@lru_cache(maxsize=1)
def _times() -> tuple[tuple[Measure, float, re.Pattern[str]], ...]:
    return tuple(
        (measure, times, _compiled(rf"(?:at )?(?:{many}) (?:its |his |her )?(?:{said})"))
        for times, many in _TIMES
        for measure, said in _OF
    )


_SORTS = {
    Sort.ACT: Mark.ACT,
    Sort.WHERE: Mark.WHERE,
    Sort.SIDE: Mark.SIDED,
    Sort.SITE: Mark.SITE,
    Sort.MANEUVER: Mark.MANEUVER,
    Sort.BYPASS: Mark.MANEUVER,
    Sort.STATE: Mark.STATE,
    Sort.LEADER: Mark.LEADER,
    Sort.OCCLUDER: Mark.OCCLUDER,
    Sort.LANES: Mark.LANES,
    Sort.TWO_WAY: Mark.TWO_WAY,
    Sort.PLACE: Mark.PLACE,
    Sort.TARGET: Mark.FILLER,
    Sort.FILLER: Mark.FILLER,
}
"""What phrases of whole texts are in an edit; the others mark clauses, which edits have their own way of."""


def words_at(text: str, at: int) -> Iterator[tuple[int, Word]]:
    """Everything that the words at a place may be, with where it ends; what is meant rather comes first.

    Args:
        text: Lower case.
        at: Where they begin.
    """
    for readers in (_numbers_at, _marks_at, _phrases_at):
        for end, mark, value in readers(text, at):
            yield end, Word(mark=mark, value=value, said=text[at:end].strip(), at=at)


def _numbers_at(text: str, at: int) -> Iterator[tuple[int, Mark, Any]]:
    if (number := _number(text, at)) is not None:
        yield number[1], Mark.SHIFT if isinstance(number[0], Shift) else Mark.NUMBER, number[0]
    for measure, more, pattern in _shifts():
        if match := pattern.match(text, at):
            yield match.end(), Mark.SHIFT, Shift(measure=measure, more=more, said=match[0])
    for measure, times, pattern in _times():
        if match := pattern.match(text, at):
            yield match.end(), Mark.SHIFT, Shift(measure=measure, more=times > 1.0, times=times, said=match[0])


def _marks_at(text: str, at: int) -> Iterator[tuple[int, Mark, Any]]:
    for mark, value, pattern in _marks():
        if (match := pattern.match(text, at)) and match.end() > at:
            yield match.end(), mark, match["side"] if mark is Mark.SIDE else value


def _phrases_at(text: str, at: int) -> Iterator[tuple[int, Mark, Any]]:
    for phrase in phrases_at(text[at]):
        if phrase.sort in _SORTS and (match := phrase.pattern.match(text, at)):
            yield match.end(), _SORTS[phrase.sort], _value(phrase, match)
    if match := road_user().match(text, at):
        article = match["article"] or ""
        traits = tuple(traits_in(match))
        named = Named(kind=kind_in(match), article=article, traits=traits, several=article in SEVERAL)
        yield match.end(), Mark.USER, named
    for mark, value, pattern in _LEXICON:
        if (match := pattern.match(text, at)) and match.end() > at:
            yield match.end(), mark, value


_SOME = r"(?:(?:an?|the|some) )?(?:(?:tall|high|large|big) )?"
_LEXICON: tuple[tuple[Mark, Any, re.Pattern[str]], ...] = (
    *((Mark.OCCLUDER, one, re.compile(f"{_SOME}(?:{said.pattern})")) for one, said in lexicon.OCCLUDERS.items()),
    *((Mark.LIGHT, one, said) for one, said in lexicon.LIGHTS.items()),
    *((Mark.WEATHER, one, said) for one, said in lexicon.WEATHERS.items()),
    *((Mark.SURFACE, one, said) for one, said in lexicon.SURFACES.items()),
    *((Mark.ACT, one, said) for one, said in lexicon.ACTIONS.items()),
    (Mark.ACT, Action.TURN_LEFT, lexicon.LEFT_TURN),
    (Mark.ACT, Action.TURN_RIGHT, lexicon.RIGHT_TURN),
)
"""Wider words than those of phrases, as many people write."""


def _value(phrase: Phrase, match: re.Match[str]) -> Any:
    return (side_in(match), phrase.value) if phrase.sort is Sort.SIDE else phrase.value


_BY = re.compile(
    r" (?P<how>faster|quicker|slower|harder|softer|closer|nearer|further(?: away)?|farther(?: away)?|longer|shorter|later|earlier|sooner)(?![\w'])"
)


_IN_UNITS_OF = {Measure.TRIGGER: Measure.DISTANCE}  # how far off the ego is when somebody acts


_SHARE = r"(?:by )?(?P<share>\d+(?:[.,]\d+)?) ?(?:%|percent|per cent)"
_PERCENT = re.compile(_SHARE + _BY.pattern)
_BY_PERCENT = re.compile(
    r"(?P<verb>increase|raise|reduce|decrease|lower|cut) (?:(?:the|its|his|her) )?(?:\w+ )?(?P<of>speed|distance|gap|deceleration) "
    + rf"(?:{_SHARE})?"
)
_CHANGED = {
    "speed": Measure.SPEED,
    "distance": Measure.DISTANCE,
    "gap": Measure.DISTANCE,
    "deceleration": Measure.DECELERATION,
}


_PACE = re.compile(r"(?:at |with )?(?:a )?walking (?:pace|speed)(?! (?:to|of|by)\b)(?![\w'])")


def _percent(text: str, at: int) -> tuple[Shift, int] | None:
    """By what share of what it was, or by how much, something is to be another, and where that ends."""
    if match := _PERCENT.match(text, at):
        kinds = [(measure, more) for measure, more, pattern in _shifts() if pattern.fullmatch(match["how"])]
    elif match := _BY_PERCENT.match(text, at):
        kinds = [(_CHANGED[match["of"]], match["verb"] in ("increase", "raise"))]
    else:
        return None
    measure, more = kinds[0]
    if match["share"] is None:
        by = number_at(text, match.end()) if text.startswith("by ", match.end()) else None
        if by is None or by[0].measure is not measure:
            return None
        return Shift(measure=measure, more=more, by=by[0].value, said=text[at : by[1]]), by[1]
    share = float(match["share"].replace(",", ".")) / 100
    times = 1.0 + share if more else max(1.0 - share, 0.0)
    return Shift(measure=measure, more=more, times=times, said=match[0]), match.end()


def _number(text: str, at: int) -> tuple[Quantity | Shift, int] | None:
    """A number with its unit, and where it ends; by how much something is another, if that is said."""
    if (shift := _percent(text, at)) is not None:
        return shift
    if pace := _PACE.match(text, at):
        return Quantity(measure=Measure.SPEED, value=WALKING_PACE, said=pace[0]), pace.end()
    told, bare = quantity_at(text, at), number_at(text, at)
    if bare is None or (told is not None and told[1] >= bare[1]):
        return told
    quantity, end = bare
    if by := _BY.match(text, end):
        for measure, more, pattern in _shifts():
            if pattern.fullmatch(by["how"]) and quantity.measure in (measure, _IN_UNITS_OF.get(measure)):
                said = text[at : by.end()]
                return Shift(measure=measure, more=more, by=quantity.value, said=said), by.end()
    return quantity, end


# A whole edit

OF_EGO = (Mark.MANEUVER, Mark.STATE, Mark.MOVES)
"""What is said of the ego alone."""

_WORD = re.compile(r"\S+")
_IT = re.compile(rf"\b{_PRONOUN}\b")
_OF_IT = (Mark.SET, Mark.BEFORE, Mark.AFTER)  # with a pronoun
_REWRITES: tuple[tuple[re.Pattern[str], str], ...] = tuple(
    (re.compile(said, re.IGNORECASE), meant)
    for said, meant in (
        (r"[\N{RIGHT SINGLE QUOTATION MARK}\N{LEFT SINGLE QUOTATION MARK}`]", "'"),
        (r"^(left|right)\s*(?:->|=>|\N{RIGHTWARDS ARROW})\s*(left|right)$", r"\2"),
        (r"^(.+?)\s*(?:->|=>|\N{RIGHTWARDS ARROW})\s*(.+)$", r"change \1 to \2"),
        (r"(?<=\w) ?(?::|=+) ?(?!\d\d\b)", " is "),  # "speed: 5 m/s", "adversary=car"
        (r"\bcut-in", "cut in"),
        (r"\bgimme\b", "give me"),
        (r"\blemme\b", "let me"),
        (r"\b(?:wan|gon|got)(?:na|ta)\b", "want to"),
        (r"^(?:(?:oh|no|actually|hang on|hold on),? )*wait,? |^(?:no,? )+(?=(?:an?|the|it|he|she|we|not|i)\b)", ""),
        (
            r"^((?:wh\w+|and|so)? ?)\b(could|should|would|can|is|are|was|does|do|did|might)n't (?=(?:it|we|i|you|he|she|they|there|the|this|that)\b)",
            r"\1\2 ",
        ),
        (r"\blet's\b", "let us"),
        (r"\b(I|we|you|he|she|it|they|that|there)'d\b", r"\1 would"),
        (r"\b(?:an )?(?:additional|extra|one more) (?=\w)", "another "),
        (r"\bwon't\b", "will not"),
        (r"\bcan't\b", "can not"),
        (r"n't\b", " not"),
        (r"\bmore (near|fast|quick|slow|hard|soft|long|short|small|strong)\b", r"\1er"),
        (r"\bmore (late|close)\b", r"\1r"),
        (r"\bmore (?:far|distant)\b", "farther"),
        (r"\bmore early\b", "earlier"),
        (r"\bmore (?:big|large)\b", "bigger"),
        (r"\b(about|mind|try|consider|suggest|prefer) (mak|us|hav|tak|giv|chang|replac|remov|plac)ing\b", r"\1 \2e"),
        (r"\b(about|mind|try|consider|suggest|prefer) (add|turn|start|let|put|set|swap|drop)(?:[tp])?ing\b", r"\1 \2"),
        (r"\b(it|he|she|that|there|who|what|this)'s\b", r"\1 is"),
        (r"'s(?= (?:\w+ing|behind|in|on|at|from|ahead|beside|not|now|a|an|the)\b)", " is"),
        (r"\b(it|he|she|they|that)'ll\b", r"\1 will"),
        (r"\bthe (?:front|first|lead|leading) (?!one)(\w+)", r"the \1 ahead"),
        (r"\bthe (?:rear|back|following) (?!one|side|of)(\w+)", r"the \1 behind"),
        (r"\.{2,}|\s[\N{EN DASH}\N{EM DASH}-]\s|[!?]", ", "),
        (r"[\"()\N{LEFT DOUBLE QUOTATION MARK}\N{RIGHT DOUBLE QUOTATION MARK}]", " "),
    )
)


def plainer(text: str) -> str:
    """An edit without short forms, arrows and marks that say nothing."""
    for said, meant in _REWRITES:
        text = said.sub(meant, text)
    return text.strip(" ,")


def scanned(text: str, slots: Slots) -> tuple[list[Word], list[str]]:
    """The words of an edit that mean something, and those that mean nothing, in order.

    Args:
        text: Lower case.
        slots: The facts at hand: of words with two meanings, the one that is so already is meant.
    """
    found: list[Word] = []
    unread: list[str] = []
    ego, at, gap = False, 0, True
    while at < len(text):
        if text[at] == " ":
            at += 1
            continue
        end, best = _longest(text, at, slots, ego=ego)
        if best is None:
            match = _WORD.match(text, at)
            assert match is not None  # a space was skipped
            if gap or not unread:
                unread.append(match[0])
            else:
                unread[-1] += f" {match[0]}"
            at, gap = match.end(), False
            continue
        found.append(best)
        at, gap = end, True
        if best.mark is Mark.EGO:
            ego = True
        elif best.mark in (Mark.IT, Mark.USER, Mark.OTHER) or (best.mark in _OF_IT and _IT.search(best.said)):
            ego = False
    return found, unread


def _longest(text: str, at: int, slots: Slots, *, ego: bool) -> tuple[int, Word | None]:
    """The longest words at a place that mean something of whoever is spoken of, and where they end."""
    end, best = at, None
    turns = [action for action in slots.actions if "turn" in action]
    for until, word in words_at(text, at):
        if (word.mark is Mark.ACT and ego) or (word.mark in OF_EGO and not ego) or (word.value == A_TURN and not turns):
            continue
        meant = replace(word, value=turns[0]) if word.value == A_TURN else word
        if until > end or (until == end and _is_done(meant, slots) and best and best.mark is Mark.ACT):
            end, best = until, meant
    return end, best


def _is_done(word: Word, slots: Slots) -> bool:
    """Whether words name what the adversary does already."""
    return word.mark is Mark.ACT and word.value in slots.actions
