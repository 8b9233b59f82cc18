"""What words mean on the road: patterns for who, does what, where, and a net for typos.

Patterns are matched against lower-case text in which typos are mended. They are our own, collected from crash
reports, driving schools and the way people talk.
"""

from __future__ import annotations

import re
from functools import lru_cache

from chatscene.terms.scenario import Action, AdversaryKind, Control, Occluder, Place


def _p(*patterns: str) -> re.Pattern[str]:
    return re.compile("|".join(rf"\b(?:{pattern})\b" for pattern in patterns))


# Who

EGO = _p(
    r"(?:the |our |my )?ego(?:'s)?(?: vehicle| car)?(?:'s)?",
    r"we|i",  # "us" and "me" are never the ones who do something
    r"(?:our|my) (?:own )?(?:car|vehicle|path|lane|way)",
    r"(?:the )?(?:av|adas vehicle|autonomous (?:car|vehicle)|self-driving (?:car|vehicle)|host(?: vehicle)?|vut|test vehicle)",
)
EGO_AS_OBJECT = re.compile(
    r"\b(?:in front of|ahead of|behind|towards?|to|at|past|into|onto|across|beside|next to|alongside|near|before|of|for|"
    r"with|from|against|cuts? off|cutting off|hits?|blocks?|blocking|facing|overtakes?|passes|avoid|parallel to|by)"
    r" (?:the |our |my )?(?:ego(?:'s)?(?: vehicle| car)?(?:'s)?|us|me|car we|av|host(?: vehicle)?|vut|"
    r"(?:own )?(?:car|vehicle|path|lane|way|course|trajectory|bonnet|bumper|nose))(?:'s)?(?: original)?"
    r"(?: (?:path|lane|way|course|trajectory|vehicle))?\b"
)

KINDS: dict[AdversaryKind, re.Pattern[str]] = {
    AdversaryKind.PEDESTRIAN: _p(
        r"pedestrians?|walkers?|persons?|people|child|children|kids?|man|woman|men|women|boys?|girls?|joggers?|runners?|"
        r"jaywalk\w*|toddler|student|old lady|on foot|passer-?by"
    ),
    AdversaryKind.MOTORCYCLE: _p(r"motor ?(?:cycl\w+|bikes?|bikers?)|bikers?|mopeds?|scooters?|motorist on two wheels"),
    AdversaryKind.BICYCLE: _p(r"(?:bi)?cycl(?:es?|ists?)|bikes?|bike riders?|e-?bikes?"),
    AdversaryKind.TRUCK: _p(r"trucks?|lorry|lorries|semis?|tractor-trailers?|hgv|pickups?"),
    AdversaryKind.BUS: _p(r"bus|buses|coach|coaches"),
    AdversaryKind.CAR: _p(
        r"cars?|vehicles?|sedans?|suvs?|taxis?|cabs?|vans?|hatchbacks?|drivers?|automobiles?|jeeps?|limousines?|traffic"
    ),
}
ENCOUNTER = _p(
    r"encounter\w*|meets?|faces?|notices?|sees?|spots?",
    r"(?:surprised|cut off|cut up|overtaken|passed|hit|approached|blocked|struck|confronted|followed|tailgated) by",
)
SOMEBODY = _p("somebody|someone|anyone|guy|fellow|idiot|fool|maniac")  # on foot, if nothing else is said
ADVERSARIAL = _p("adversarial|adversary|attacking|hostile")

# Parts of the scene that are no adversary; taken out before anyone is looked for

_PARKED = r"(?:double[- ]|illegally |badly )?(?:parked|stationary|abandoned|disabled|broken[- ]down)"
_STANDING = rf"(?:{_PARKED}|stopped|stalled|standing)"

OCCLUDERS: dict[Occluder, re.Pattern[str]] = {
    Occluder.BUS_STOP: _p(r"bus (?:stop|shelter)|bus-stop|tram stop"),
    Occluder.VENDING_MACHINE: _p(r"vending machine|drinks machine|ticket machine"),
    Occluder.PARKED_TRUCK: _p(
        rf"{_STANDING} (?:trucks?|lorry|lorries|bus|coach)",
        rf"(?:truck|lorry|bus|coach)(?: that| which)?(?: is| stands)? {_PARKED}",
        r"(?<=behind )(?:a|the) (?:truck|lorry)",
    ),
    Occluder.PARKED_CAR: _p(
        rf"{_STANDING} (?:cars?|vehicles?|vans?|suvs?|taxis?)",
        rf"(?:car|vehicle|van|suv|taxi)(?: that| which)?(?: is| stands)? {_PARKED}",
        r"row of (?:parked )?cars",
        r"(?<=behind )a (?:car|van)",
    ),
    Occluder.KIOSK: _p(r"kiosk|news ?stand|food stall|market stall|booth"),
    Occluder.CONTAINER: _p(r"container|dumpster|skip|bins?"),
}
HIDING = _p(r"behind|hidden|hides|hiding|obscured|concealed|occluded|between|masked|screened|out of sight")
LEADER = _p(
    r"slow(?:er)?(?:(?:-| )?moving)? (?:lead(?:ing)? )?(?:vehicle|car|van|truck|lorry|bus|taxi|tractor|leader|one|driver)"
    r"(?: ahead| in front)?",
    r"lead(?:ing)? (?:slow(?:er)? )?(?:vehicle|car|van|truck|lorry|bus|taxi)",
    r"leader",
)
BLOCKING = _p(
    r"block\w* (?:its|our|the|my|the ego's) (?:own )?lane",
    r"obstruct\w* (?:its|our|the|my|the ego's) (?:own )?lane",
    r"(?:in|on) (?:its|our|my|the ego's) (?:own )?lane",
)
BACKGROUND = _p(r"oncoming traffic|crossing traffic|other traffic|traffic lights?|traffic signals?|traffic")

# What the ego does

LEFT_TURN = _p(
    r"turn\w* (?:to the )?left",
    r"(?:mak|tak|hang)\w* an? (?:sharp )?left",
    r"(?:unprotected )?left(?:-hand)?(?: |-)turn\w*",
    r"unprotected left",
)
RIGHT_TURN = _p(
    r"turn\w* (?:to the )?right", r"(?:mak|tak|hang)\w* an? (?:sharp )?right", r"right(?:-hand)?(?: |-)turn\w*"
)
LANE_CHANGE = _p(
    r"chang\w* (?:its |our |the )?lanes?",
    r"(?:chang|switch|shift)\w* (?:in)?to (?:the |another )?(?:\w+ )?(?:lane|left|right)",
    r"lane(?: |-)chang\w*",
    r"(?:merg\w*|mov\w*|pull\w*|switch\w*) (?:over )?(?:in)?to the (?:left|right|next|adjacent|other|fast|slow|passing) lane",
    r"switch\w* lanes?",
    r"overtak\w*",
)
BYPASS = _p(
    r"bypass\w*",
    r"go(?:es|ing)? around",
    r"(?:use|uses|using|through|via) the (?:opposite|oncoming|other|opposing) lane",
    r"(?:swing|pull|swerv|steer|driv|manoeuvr|maneuver)\w* (?:out )?(?:a)?round",
    r"(?:pass|overtak)\w* (?:it|a parked|the parked)",
    r"get(?:s|ting)? around",
)
UNPROTECTED = _p(r"unprotected(?: left)?(?: turn)?")

# Where

PLACES: dict[Place, re.Pattern[str]] = {
    Place.THREE_WAY: _p(r"(?:three|3)(?:-| )way(?: intersection| junction)?|t(?:-| )(?:junction|intersection)"),
    Place.FOUR_WAY: _p(r"(?:four|4)(?:-| )way(?: intersection| junction)?|cross ?roads"),
    Place.JUNCTION: _p(
        r"intersections?|junctions?|crossing negotiation|(?:side|cross) (?:road|street)s?|traffic lights?|signals?|stop sign"
    ),
    Place.CURVE: _p(r"curves?|bends?|curved|winding"),
    Place.ROAD: _p(r"roads?|streets?|highways?|motorways?|lanes?|carriageways?|avenue"),
}
CONTROLS: dict[Control, re.Pattern[str]] = {
    Control.NONE: _p(
        r"un-?signali[sz]ed|uncontrolled|unregulated|(?:no|without) (?:traffic )?(?:lights?|signals?)|crossing negotiation"
    ),
    Control.STOP_SIGN: _p(r"stop(?:-| )signs?|(?:all|two|three|four|4)(?:-| )way stop"),
    Control.SIGNAL: _p(
        r"(?:traffic|red|green) (?:lights?|signals?)|signali[sz]ed|signal-controlled|lights? (?:is|are|turns?) (?:red|green)|"
        r"(?:the|a) red|on (?:red|green)|stop ?lights?|at (?:the|a) (?:lights|signals)"
    ),
}

# What the adversary does

ACTIONS: dict[Action, re.Pattern[str]] = {
    Action.RUN_LIGHT: _p(
        r"r[ua]n(?:s|ning)? (?:through )?(?:a|the) (?:red|stop ?light|light|signal)\w*",
        r"red(?:-| )light (?:runner|running)",
        r"(?:jump|ignor|blow|shoot|skip|disregard|violat|disobey|barrel|sail)\w* (?:past |through )?(?:a|the|its|their) (?:red|light|traffic light|signal)s?",
        r"through (?:a|the) red",
        r"on red",
    ),
    Action.TURN_BACK: _p(
        r"(?:turn|go|run|walk|jump|step|dart)(?:s|es|ing)? back|turns? around|chang\w* (?:his|her|its|their) mind|retreats?"
    ),
    Action.DIAGONAL: _p(r"diagonal(?:ly)?|at an angle|slant\w*|obliquely"),
    Action.HESITATE: _p(
        r"hesitat\w*|dither\w*|pauses?|stop(?:-| )and(?:-| )go|fits and starts|again and again|wavers?"
    ),
    Action.REVERSE: _p(r"revers\w*|back(?:s|ing)? (?:up|out)|backwards?|rolls? back"),
    Action.WEAVE: _p(r"weav\w*|zig-?zag\w*|erratic(?:ally)?|snak\w*|side to side|stagger\w*|slalom\w*|between lanes"),
    Action.SWERVE: _p(r"swerv\w*|veer\w*|drifts?|lurch\w*|jink\w*"),
    Action.PACE: _p(
        r"parallel|alongside|keep\w* pace|side by side|matches our speed|level with|stays beside|keeps? level"
    ),
    Action.CHANGE_LANE: _p(r"original lane|chang\w* lanes?|lane change"),
    Action.CUT_IN: _p(
        r"cut(?:s|ting)?(?: us| the ego(?: vehicle)?| me)? (?:in|off|up|across)|merg\w*|squeez\w*(?: in)?|"
        r"(?:pull|swing|dart|drift|mov)(?:s|es|ing)? (?:in |out )?(?:right |directly |suddenly )?(?:in front|before|ahead)|barg\w* in|(?:in|on)to (?:our|the ego's?|my) (?:original )?lane|"
        r"turns? into (?:our|the ego's?|my|the ego vehicle's) (?:path|lane|way)"
    ),
    Action.ACCELERATE: _p(
        r"accelerat\w*|speed(?:s|ing)? up|speeds|throttle|guns (?:it|the engine)|floors it|surg\w*|sprint\w*|dash\w*|dart\w*|rush\w*|"
        r"bolt\w*|hurr\w*|picks up speed|steps on the gas"
    ),
    Action.BRAKE: _p(
        r"brak(?:es?|ing|ed)|slam\w* (?:on )?(?:the |its |his |her )?brakes?|brake(?:-| )check\w*|decelerat\w*|emergency stop|"
        r"stops? (?:short|hard)|brakes? hard|pretends? to"
    ),
    Action.STOP: _p(
        r"stop(?:s|ped|ping)?|halt\w*|fr(?:eez|oze)\w*|stands? still|standstill|dismount\w*|stall\w*|stays? put|blocks? (?:the|our|its) path|"
        r"blocking (?:the|our|its) path|motionless"
    ),
    Action.SLOW: _p(
        r"slow(?:s|ing|ly)?(?: down)?|crawl\w*|creep\w*|inch(?:es|ing)|dawdl\w*|snail\w*|limp\w*|shuffl\w*|ambl\w*|at walking pace"
    ),
    Action.CROSS: _p(
        r"cross(?:es|ed|ing)?|jaywalk\w*|"
        r"(?:step|walk|run|ran|dash|dart|sprint|rush|bolt|jump|leap|hop|wander|stroll|shuffl|stumbl|rid|pedal|roll|cycl|charg|burst|shoot)\w* "
        r"(?:out|across|into|onto|in|off|over|from)|cut(?:s|ting)? across|"
        r"emerg\w*|appear\w*|pop\w* (?:out|up)|com(?:es|ing) out|enters? the (?:road|street|lane)|across (?:the|our) (?:road|street|path|way|lane)"
    ),
    Action.FOLLOW: _p(
        r"(?:driv|rid|keep|go|carr|travel)\w* (?:on|along|going|straight on)|continu\w*|tailgat\w*|follow(?:s|ing) (?:us|the ego|its lane)"
    ),
    Action.ONCOMING: _p(r"oncoming|opposite direction|head(?:-| )on|wrong(?:-| )way|against traffic|opposing"),
}
RUNNING = _p(r"r[ua]n(?:s|ning)? (?:out|across|into|onto|over|off)")
CUTTING_IN = _p(r"cut(?:s|ting)?(?: us| the ego(?: vehicle)?| me)? (?:in|off|up)|merg\w*|squeez\w*")
PASSING = _p(
    r"(?:does|do|did)(?: not|n't)|never|without|through|crossing|cross(?:es)?|oncoming|enters?|arriv\w*|com(?:es|ing)|approach\w*"
)
NO_ACTION = re.compile(r"\bstop(?:-| )signs?\b|\bslow(?:-| )?moving\b|\bcrossing (?=car|vehicle|truck|bus|traffic)")
SLOWING = _p(r"slow(?:s|ing)? down")
ANYTHING = re.compile("")
FEINT = _p(r"pretend\w*|feint\w*|fakes?|as if to cross|about to cross|seems? to")
MATCHING = _p(r"match\w* (?:the |its )?(?:speed|pace)|speed of the (?:slow|lead)\w*|blocks? (?:the )?(?:ego|us) from")
ERRATIC = _p(r"erratic\w*")
GOING_ON = _p(r"(?:and|then) (?:then )?(?:walk|go|driv|mov|continu|rid|run)\w* (?:on|off|again|away|diagonally)")

# Where the adversary starts

ONCOMING = _p(
    r"oncoming|opposite (?:direction|lane|arm)|opposing|head(?:-| )on|wrong(?:-| )way|against (?:traffic|us)|other way|"
    r"(?:com|approach|head|driv|rid|walk|runn?|speed|rac)\w* (?:straight |right )?(?:towards?|at) (?:us|me|the ego)"
)
FAR = _p(
    r"opposite (?:sidewalk|side|pavement|kerb|curb|corner|footpath)|far(?:ther|ther)? (?:side|corner|kerb|curb|sidewalk|pavement)|other side"
)
CROSSING = _p(
    r"crossing (?:car|vehicle|truck|bus|traffic|motorcycle)|cross traffic|side (?:road|street)|perpendicular|cross(?:es|ing)"
)
NEIGHBOUR = _p(r"(?:target|adjacent|next|neighbou?ring|other|left|right|passing) lane|lane (?:beside|next to|to the)")
BEHIND = _p(r"(?:from )?behind|rear|tailgat\w*|back")
AHEAD = _p(r"ahead|(?:in )?front|lead(?:ing)?|preceding")
BESIDE = _p(r"parallel|alongside|beside|next to|side by side|level with")
TURNING_WORDS = re.compile(
    r"\b(?:turn|swerv|veer|merg|chang|mov|steer|pull|swing|hook)\w*(?: (?!from\b|on\b|in\b)\w+){0,2}? (?:to (?:the|its) )?(?:left|right)\b"
    r"|\b(?:left|right)(?:-hand)?(?: |-)turn\w*|\bright (?:in front|away|before|behind|after|at|into|next|now|of way|past|through)\b"
)
SIDE = re.compile(r"\b(left|right)\b")

# Sentences say what the ego then has to do; that is no part of the situation
REACTION = re.compile(
    r"(?:,| and)? ?\b(?:forcing|causing|requiring|necessitating|making it|leaving|so that|such that|which forces|"
    r"requires the ego|prompting|compelling)\b[^;.]*"
)
NEGATED = re.compile(
    r"(?:\b(?:not|never|neither|nor|cannot|without|instead of|rather than|fails? to|failing to|no longer|refus\w+ to)|n't)\b"
    r"(?: \w+){0,2}$"
)

_WORDS = """
    pedestrian bicycle cyclist motorcycle motorcyclist vehicle truck intersection junction crossing crosses
    oncoming suddenly brakes braking accelerates reverses swerves weaves merges overtake overtaking parked
    behind stops turning turns vending machine kiosk container straight signal traffic light opposite lane
    right left front ahead freezes halts street sprints dashes unprotected changing changes driving walks
    steps running parallel alongside slowly direction hesitates diagonally adversarial sidewalk roadside
    pavement before across motorbike scooter abruptly signalised signalized unsignalised curve approach
    approaching slams hidden appears emerges cutting
"""
_KNOWN = tuple(_WORDS.split())  # what typos are mended to


_REAL = frozenset(("baking", "barking", "brining"))  # words a letter away from ours that are no typos


@lru_cache(maxsize=4096)
def mended(word: str) -> str:
    """A word, or the word of the road it is a typo of (words of five letters and more).

    A typo starts with the right letter and has one slip: two letters swapped, one missing, one too many; in longer
    words one wrong or two slips. A wrong letter in a short word usually makes another real word (track, truck).
    """
    if len(word) < 5 or word in _KNOWN or word in _REAL or _is_word(word):
        return word
    near = [known for known in _KNOWN if known[0] == word[0] and _is_slip(word, known)]
    return near[0] if near and _stem(near[0]) != _stem(word) else word  # another form of a word is no typo


def _is_slip(word: str, known: str) -> bool:
    if len(known) < 8:
        return (len(word) != len(known) and edits(word, known) == 1) or _swapped(word, known)
    return edits(word, known) <= (2 if len(known) >= 9 else 1)


def _swapped(word: str, known: str) -> bool:
    return sorted(word) == sorted(known) and edits(word, known) == 1


def edits(one: str, other: str) -> int:
    """Edit distance: letters added, dropped, changed, or swapped with their neighbour (F. Damerau, 1964)."""
    before: list[int] = []
    row = list(range(len(other) + 1))
    for i, a in enumerate(one, start=1):
        older, before, row = before, row, [i]
        for j, b in enumerate(other, start=1):
            cost = min(before[j] + 1, row[j - 1] + 1, before[j - 1] + (a != b))
            if i > 1 and j > 1 and a == other[j - 2] and one[i - 2] == b:
                cost = min(cost, older[j - 2] + 1)
            row.append(cost)
    return row[-1]


def _stem(word: str) -> str:
    return re.sub(r"(?:e?s|e?d|ing|ly|e)$", "", word)


def _is_word(word: str) -> bool:
    """Whether some pattern knows the word as it stands."""
    groups = (KINDS, OCCLUDERS, PLACES, CONTROLS, ACTIONS)
    return any(pattern.fullmatch(word) for group in groups for pattern in group.values())


def strangers(text: str) -> list[str]:
    """What is spoken of as "a …" and is nothing the reader knows."""
    named = re.findall(r"\b(?:an?|another|some|two|three|several) ([a-z]+)", text)
    return [word for word in dict.fromkeys(named) if not _is_word(word) and word not in _KNOWN]
