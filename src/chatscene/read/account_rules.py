"""The words of accounts: the one table by which `chatscene.read.account` reads them, and the patterns beside it.

Reports, protocols and notes say what somebody does in other words than sentences of the grammar do, and in the passive
as often as not. A rule is a regular expression over canonical text, in which the ego is "we", "us" and "our". Where two
rules match as much, the later one holds. All are our own.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import StrEnum
from functools import lru_cache

from chatscene.read.inflection import any_form
from chatscene.read.phrases import Where
from chatscene.terms.acts import Action
from chatscene.terms.scenario import EgoState, Maneuver, Side, Site


class Kind(StrEnum):
    """What a rule tells, by which `chatscene.read.account_meaning` knows what to make of it."""

    STRUCK = "struck"  # the ego was, by whoever is named next
    HIT = "hit"  # somebody touches the ego
    EGO_HITS = "ego-hits"  # the ego touches whoever is named next
    CONTACT = "contact"  # of the ego and somebody, whoever's doing it was
    BY = "by"  # whoever is named next touches the ego
    OUR_PART = "our-part"  # a part of the ego, as the subject
    PART_OF = "part-of"  # of whoever is named next
    DRIVER = "driver"  # of somebody who was named, or of the ego
    OWN_DRIVER = "own-driver"
    HEADING = "heading"
    COMPASS_SIDE = "compass-side"  # a side of the road, by the compass
    BYPASSES = "bypasses"  # the ego, whoever is named next
    MEETS = "meets"  # the ego waits for, or follows, whoever is named next
    ACT = "act"
    RESUMES = "resumes"  # somebody goes on who stopped
    WAYWARD = "wayward"  # somebody goes on where it ought to wait
    ENTERS = "enters"  # a junction, a road, a crosswalk
    FOREIGN = "foreign"  # nothing that an act says: an attack, somebody on the car
    DOOR = "door"  # one opens
    NOUN = "noun"  # an act of whoever is named next: "the cut-in of"
    BARE = "bare"  # an act of nobody in particular
    TARGET = "target"  # where an act leads, which says no more than the act
    WHERE = "where"
    FROM_SIDE = "from-side"
    AHEAD = "ahead"
    OWN_SIDE = "own-side"  # the ego's lane, of several
    EGO_TURNS = "ego-turns"
    EGO_CHANGES_LANE = "ego-changes-lane"
    EGO_REVERSES = "ego-reverses"
    TURNING = "turning"  # the ego is, to a side that is not said
    SLIP_LANE = "slip-lane"
    PAST = "past"  # a turn that the ego has done with
    STATE = "state"  # of the ego, at the pedals
    SETS_OFF = "sets-off"  # the ego, from a standstill
    AROUND_IT = "around-it"  # the ego drives around whoever stands there
    SITE = "site"


@dataclass(frozen=True, slots=True, kw_only=True)
class Rule:
    """Words of accounts that mean one thing.

    Attributes:
        kind: What they tell.
        pattern: How they are written.
        ego: Whether they are said of the ego alone (True), of others alone (False), or of either (None).
        opens: Whether they may come before whoever they are said of: "from the left comes a van".
        action: The act that they tell.
        where: Where they say that somebody is.
        maneuver: What they say that the ego does.
        state: What they say that the ego does at the pedals.
        site: Where they say that it is.
    """

    kind: Kind
    pattern: re.Pattern[str]
    ego: bool | None = None
    opens: bool = False
    action: Action | None = None
    where: Where | None = None
    maneuver: Maneuver | None = None
    state: EgoState | None = None
    site: Site | None = None


def _rule(
    kind: Kind,
    pattern: str,
    *,
    ego: bool | None = None,
    opens: bool = False,
    action: Action | None = None,
    where: Where | None = None,
    maneuver: Maneuver | None = None,
    state: EgoState | None = None,
    site: Site | None = None,
) -> Rule:
    return Rule(
        kind=kind,
        pattern=re.compile(rf"(?:{pattern})(?!\w)"),
        ego=ego,
        opens=opens,
        action=action,
        where=where,
        maneuver=maneuver,
        state=state,
        site=site,
    )


def _act(action: Action, pattern: str, where: Where | None = None) -> Rule:
    return _rule(Kind.ACT, pattern, ego=False, action=action, where=where)


PART_NOUN = (
    r"(?:bumpers?|corner|sides?|fender|doors?|mirrors?|panel|quarter panel|wheels?|wheel well|wheel arch|arch|end|tire|tyre|window|hatch|trunk|boot|"
    r"sensors?|lidar|radar|fascia|hood|bonnet|front|rear|back|tail(?:[ -]?lights?|gate)?|headlight|bodywork|flank|quarter|axle|roof|windscreen|windshield|wing|trailer|housing|plate|grille)"
)
_PART = rf"(?:(?!of\b|and\b|we\b|us\b)[\w'/-]+ ){{0,5}}?{PART_NOUN}(?: {PART_NOUN}| assembly| area| and (?:[\w'-]+ ){{0,4}}?{PART_NOUN})*"
_OWN_PART = rf"(?:(?:front|rear|left|right|lower|upper|cent(?:er|re)|back|driver|passenger|side|outer|inner|own|wing|near|off)(?:'s)?[-/ ])*{PART_NOUN}(?: {PART_NOUN})*"
_HIT = (
    rf"(?:{any_form('make')} (?:\w+ ){{0,2}}contact(?: again)?|(?:came|comes|come|coming) in(?:to)? (?:\w+ )?contact"
    rf"|{any_form('strike', 'hit', 'collide', 'rear-end', 'rear end', 'sideswipe', 'side-swipe', 'contact', 'clip', 'bump', 'ram', 'crash', 'scrape', 'graze', 'impact', 'tap', 'touch', 'brush', 'nudge', 'shunt', 'broadside', 'catch')}|struck|caught"
    r"|(?:runs?|ran|running|rode|rides?|drives?|drove|driving|slams?|slammed|slamming|smash(?:es|ed)|ploughs?|ploughed|plows?|plowed|bangs?|backs?|backed|revers(?:es|ed|ing)|backing|rolls?|rolled) (?:straight |right )?into)"
)
_INTO = r"(?: (?:with|into|against|on|up against|to|at))*"
_TARGET = rf"(?:(?:the |a )?(?P<part>{_PART}|back|rear) of us(?:\b|$)|(?:our|its) (?P<part2>{_PART})|us|(?P<it>it)(?= from|[.,;]|$| and\b| on\b)|(?:the )?(?P<part3>{_PART})(?! of))"
_HELP = r"(?:were|was|are|is|been|being|get|gets|got|get)"
_LY = r"(?:\w+ly )?"
_OUR_SIDE = r"our (?:lane|side|half)(?: of the (?:road|carriageway))?"
_BEGINS = r"(?:(?:attempt\w*|tr(?:y|ies|ied|ying)|beg[aiu]n\w*|start\w*|proceed\w*|continu\w*|go(?:es|ing)|wants?|decid\w+) (?:to )?)?"
_SIDES = r"left|right"
_LANE = rf"(?:(?:{_SIDES})[ -]?(?:hand )?|adjacent |neighbou?ring |next |parallel |target |passing |overtaking |number \w+ |no\. \d |cent(?:er|re) |inside |outside |inner |outer |middle |bike |turn(?:ing)? |travel |through |fast |slow )*lane"
_FROM = r"(?:(?:coming |approaching |travell?ing )?(?:out )?(?:from|on|at|to|in|off))"
KERB = r"(?:kerb|curb|sidewalk|pavement|roadside|verge|footpath|(?:hard |soft )?shoulder|side(?: of the (?:road|street))?|edge(?: of the (?:road|street)|(?! of (?:(?!road)\w+ ){0,2}lane\b)))"


def _turn(side: str) -> str:
    return rf"{_BEGINS}(?:(?:mak(?:e|es|ing)|made|complet\w+|perform\w*|execut\w*|initiat\w*|tak(?:e|es|ing)|took|in the process of making|do(?:es|ing)?|want\w* (?:to )?|signal\w+ for|prepar\w+ (?:to make|for)|prior to making|waiting to make|attempt\w*|begin\w*|began) (?:a |an |its |their |our |the )?(?:\w+ )?{side}(?:[ -]?hand)?(?: turn|(?! (?:lane|side|hand|arm|kerb|curb|of|rear|front|turn)\b))|{any_form('turn')} (?:off )?(?:to (?:the |our )?)?{side}|{side}[ -]turn(?:ing|s)?|proceed {side}|{any_form('go')} {side}|hook\w* {side})"


@lru_cache(maxsize=1)
def rules() -> tuple[Rule, ...]:
    """All rules, in an order in which a later one is the more telling."""
    enter = any_form(
        "change",
        "merge",
        "move",
        "enter",
        "swerve",
        "veer",
        "drift",
        "cut",
        "encroach",
        "pull",
        "steer",
        "come",
        "squeeze",
        "drop",
        "swing",
        "shift",
        "get",
        "pop",
        "slide",
        "barge",
        "push",
        "dive",
        "slip",
        "tuck",
        "nip",
        "cross",
        "change lanes",
    )
    return (
        # Contact
        _rule(Kind.STRUCK, rf"(?:{_HELP} |^|(?<=[,.;:] )|(?<=\bwe )|(?<=\band ))(?:also |then |{_LY})(?:struck|hit|rear[ -]ended|contacted|side-?swiped|clipped|bumped|tapped|impacted|rammed)(?P<part>(?: (?!by\b|when\b|and\b)[\w'-]+){{0,14}}?) by", ego=True),
        _rule(Kind.STRUCK, rf"(?:{_HELP} |^|(?<=[,.;:] ))rear[ -]ended(?! by)", ego=True),
        _rule(Kind.HIT, rf"{_BEGINS}{_LY}{_HIT}{_INTO} {_TARGET}(?: (?P<from>from (?:the )?(?:rear|behind|back)))?(?: on (?:its|our|the) (?P<part4>{_PART}))?", ego=False),
        _rule(Kind.HIT, rf"{_BEGINS}{_HIT}(?: (?P<from>from (?:the )?(?:rear|behind)|head-on))", ego=False),
        _rule(Kind.HIT, rf"{_BEGINS}{_HIT}(?=[.,;]|$)", ego=False),
        _rule(Kind.EGO_HITS, rf"{_HIT}{_INTO} (?:the |its |a )?{_PART} of", ego=True),
        _rule(Kind.EGO_HITS, rf"{_HIT}{_INTO}(?= (?:the |a |an |another |its |that ))", ego=True),
        _rule(Kind.BY, rf"we and(?= (?:the |an? |another )?(?:other )?(?:[\w-]+ ){{0,3}}?[\w-]+ {_HIT})"),
        _rule(Kind.CONTACT, rf"contact (?:was|is) made (?:with|to|between|at)(?: (?:the )?(?P<part>{_PART}) of us| our (?P<part2>{_PART})| us)?(?P<by> by)?"),
        _rule(Kind.BY, r"(?:a |the )?(?:contact|collision|impact)(?: was made)? by|(?:a |the )?(?:rear[- ]end )?(?:collision|crash|impact) of(?= (?:an?|the) )"),
        _rule(Kind.CONTACT, rf"(?:was|is) made (?:with|to|at) (?:(?:the )?(?P<part>{_PART}) of us|our (?P<part2>{_PART})|us)"),
        _rule(Kind.OUR_PART, rf"our {_OWN_PART}|the {_OWN_PART} of us"),
        _rule(Kind.PART_OF, rf"(?:the|its) {_OWN_PART} of(?= (?:the|a|an|another)\b)"),
        # Whose way it is
        _rule(Kind.DRIVER, r"(?:the |our |a )?(?:safety |test )?(?:driver|operator|occupant|rider)s? of (?P<of>us|the other (?:vehicle|car)|the (?:vehicle|car|truck|bus))(?: (?:proceeding|continuing))?"),
        _rule(Kind.OWN_DRIVER, r"(?:our|the|a) (?:safety |test |vehicle |av )?(?:operator|safety driver|test driver|driver)s?(?: of us)?|(?:the )?avtos?"),
        _rule(Kind.HEADING, r"(?:heading |headed |travell?ing |proceeding |driving |going |facing )?(?P<compass>(?:north|south)(?:[ -]?(?:east|west))?|east|west)(?:[ -]?bound|erly)?(?: lanes?)?(?! (?:kerb|curb|sidewalk|side|pavement|verge|edge|corner|crosswalk|leg|arm))"),
        _rule(Kind.HEADING, r"(?:coming |approaching |arriving |came |comes )?(?:out )?(?:from|of) the (?P<origin>(?:north|south)(?:[ -]?(?:east|west))?|east|west)(?: (?:arm|leg|approach))?(?! (?:kerb|curb|sidewalk|side|pavement|verge|edge|corner|crosswalk))"),
        _rule(Kind.COMPASS_SIDE, rf"(?:from|on|at|off) the (?P<compass>north|south|east|west) (?:{KERB}|leg|arm|crosswalk)"),
        # What else is met
        _rule(Kind.BYPASSES, rf"{any_form('manoeuvre', 'maneuver', 'go', 'drive', 'move', 'steer', 'pull', 'swing', 'pass')} (?:around|past|by|round)(?: and to the (?:left|right) of)?(?= (?:a|an|the|another|some)\b)|{any_form('pass', 'overtake')}(?= (?:a|an|the|another|some)\b)|{any_form('avoid')}(?= (?:(?:an?|the) )?(?:parked|standing|stationary|broken))", ego=True),
        _rule(Kind.MEETS, rf"(?:{any_form('yield', 'wait', 'stop', 'slow', 'brake', 'queue')}(?: (?:down|briefly|again|immediately|completely|up|gently))*(?: (?:to|for|behind|due to|because of|in response to|as))+|in response to|{any_form('come')} to an? (?:\w+ )?(?:stop|halt|standstill)(?: (?:to|for|behind|due to|in response to|at))+|due to|because of|to avoid|to evade|to pass|to overtake|avoiding|in order to avoid|for clearance to|{any_form('give')} way to|to let|waiting for|behind|following|{any_form('follow', 'trail')}|{any_form('sit')} behind)(?= (?:a|an|the|another|some|two|other|slow|traffic|oncoming|cross|left|approaching)\b)", ego=True),
        # Acts in the words of reports
        _act(Action.FOLLOW, rf"{any_form('approach')} (?:us |towards us )?(?:quickly |rapidly |fast )?from (?:the rear|behind)|(?:coming|comes|came|drives|driving|closes|closing) (?:up )?(?:from )?behind(?: us)?|(?:coming|comes|came) from behind", Where.BEHIND),
        _act(Action.FOLLOW, rf"(?:{any_form('travel', 'drive', 'proceed', 'follow', 'ride', 'go')}|directly|immediately|close|stopped|waiting|who was|that was|the one|right|just)(?: (?:directly|immediately|close|right|just))? behind(?: us)?|behind us|{any_form('follow')} us|(?:is |was )?following", Where.BEHIND),
        _act(Action.CUT_IN, rf"{_BEGINS}{_LY}(?:{enter})(?: (?:over|in|across|partially|back|out|closely|directly|abruptly|suddenly|straight|right|close|tightly|sharply|its lane|lanes?|wide|the (?:cent(?:er|re) ?line|line)))*(?: (?:from (?:the |our )?(?P<side>{_SIDES})(?:[ -]?hand)?(?: lane| side)?))?(?: (?:in|into|to|onto|on|across|over))* (?:our (?:travel )?(?:lane|path|side)(?: of (?:travel|the (?:line|road)))?|the (?:same )?lane (?:as|of) (?:us|we)|the (?:\w+ )?lane (?:in which we were travel?ling|that we were in)|the path of us|(?:closely |directly |right |just |close )?(?:in front|ahead) of us|before us|(?:the |a |that )?(?:(?:short|small|tight|narrow|tiny) )?(?:[\d.]+ m )?gap(?: of [\d.]+ m)?(?: between us and [\w ]+)?|front of us|(?:right |just |immediately )?(?:in front of|before|ahead of) our (?:nose|bonnet|hood|car|bumper))"),
        _act(Action.CUT_IN, r"(?:swing|swung|came|comes|com|drift|veer)\w* (?:out )?(?:of|from) the (?:next|adjacent|other) lane|shears? in|squeez\w+ (?:itself |himself |herself )?in\b|incorporat\w+ (?:itself )?(?:just |directly )*(?:in front|ahead)(?: of us)?|pulls? back in(?:to (?:our )?lane(?: \w+)?)?|invad\w+ (?:our (?:lane|side)(?: of the road)?|(?:the )?ours)"),
        _act(Action.CUT_IN, r"(?:pull|mov|squeez|com|cam|swing|swung)\w* (?:back )?in (?:sharply|tightly|too early|closely|again|front)"),
        _act(Action.CUT_IN, r"cut(?:s|ting)?(?:[ -]in| us off| in front| up)|cut-in"),
        _act(Action.CUT_IN, rf"(?:{enter}|cut|slid|swung|shot)(?: (?:itself|himself|herself|(?:his|its|her) way|back|early|over|in|right|straight|across|out|directly|just))* (?:before|in front of|ahead of|across) (?:us|our (?:nose|bonnet|hood|bumper|front(?: corner)?))|{any_form('place', 'put', 'insert', 'force', 'squeeze', 'push')} (?:itself |himself |herself |(?:his|its|her) way )?(?:in )?(?:directly |right |just )*(?:before|in front of|ahead of) us|{any_form('force', 'push', 'squeeze')} (?:his|its|her) way in|cut(?:s|ting)? back in"),
        _act(Action.CHANGE_LANE, rf"{any_form('slide', 'swoop', 'go', 'steer', 'hop', 'move', 'pull', 'swing')}(?: (?:out|over|across))* (?:in)?to the (?:next|middle|adjacent|other|neighbou?ring|cent(?:re|er)|{_SIDES})(?:[- ]hand)? lane"),
        _act(Action.CHANGE_LANE, rf"{_BEGINS}(?:{any_form('change', 'switch')} (?:\w+ )?lanes?|{any_form('merge')}(?: into (?:the|a|an) (?:[\w-]+ ){{0,3}}lane)?|(?:{any_form('change', 'move', 'swerve', 'merge', 'swing', 'pull')}|swung) (?:over |out |across )?(?:into|to) (?:the|a) (?:[\w-]+ ){{0,3}}?(?:lane|right|left)|(?:made|makes|making|attempt\w*|initiat\w*|began|begins) (?:to (?:make|initiate) )?an? (?:\w+ )?(?:left |right )?lane change)(?: to the (?:left|right))?(?: directly)?(?: in front of us)?"),
        _act(Action.CHANGE_LANE, r"mov(?:es|ed|ing) (?:over|aside|out of the way)(?= and\b|[,.;]|$)"),
        _act(Action.CHANGE_LANE, rf"cuts? out|cut-out|cutting out|(?:leaves|left|leaving|exits|vacates|moves out of|pulls out of) (?:our|the same|its|the) lane|{any_form('change')} into (?:the |an? )?(?:[\w-]+ )?lane(?=,? (?:reveal|expos))", Where.AHEAD),
        _act(Action.OVERTAKE, rf"lane[ -]splitting|{any_form('split')} lanes|{any_form('filter')}(?: (?:past|between|through)[\w ]*)?", Where.BEHIND),
        _act(Action.OVERTAKE, rf"{_BEGINS}(?:{any_form('overtake')}(?: us)?|(?:{any_form('pass')}|pass(?:es|ed|ing)? (?:through|between) (?:the )?(?:traffic|lanes|vehicles|cars)|(?:came?|comes|coming|went|goes|shoots?|shot|fl(?:ies|ew|ying)|rac\w+|blast\w+)(?: \w+ing)? past|get around|go around|goes? past|went past|drive around|maneuver around|manoeuvre around|squeezes? (?:past|by)|squeezed (?:past|by)) us|{any_form('pass')}(?= (?:on|to) (?:the|our|its)|[,.;]| and| exactly| as| while| behind|$))(?: (?:to|on|by) (?:the |our |its )?(?P<side>{_SIDES})(?: side)?)?"),
        _act(Action.OVERTAKE, rf"{_LY}(?:{any_form('squeeze', 'filter', 'fly', 'blow', 'sneak', 'shoot', 'slip', 'race', 'zoom', 'blast', 'flick', 'roar', 'tear', 'double', 'get')}|flew|blew)(?: \w+ly)? (?:past|by)(?: us)?(?! (?:the|an?|its|his)\b)(?: (?:on|to|by) (?:the |our )?(?P<side>{_SIDES})(?: side)?)?|{any_form('double')} us"),
        _act(Action.OVERTAKE, rf"{any_form('undertake')}(?: us)?|(?:{any_form('go', 'come', 'drive', 'ride', 'swing', 'pull')}) (?:a?round|by)(?: us|(?= (?:on|to) (?:the|our)\b))(?: (?:on|to) (?:the |our )?(?P<side>{_SIDES})(?: side)?)?|(?:{any_form('go', 'come', 'drive', 'ride')}) round the (?P<side2>{_SIDES}) of us|{any_form('pass')} us(?: by)?"),
        _rule(Kind.WAYWARD, r"(?:straight )?(?:past|through) (?:the|its|his|her|a) stop sign", ego=False),
        _rule(Kind.WAYWARD, rf"(?:fail(?:s|ed|ing)? to (?:yield|give way|stop|slow|brake)|without (?:stopping|yielding|giving way|looking)|not (?:waiting|stopping|yielding|braking)|(?:(?:is|was|are|were) unable to|could(?: not|n't)) (?:stop|brake)(?: in time)?|(?:does|did|do) not (?:yield|give way|stop|slow|brake)|(?:doesn't|didn't|don't) (?:yield|give way|stop|slow|brake)|no yield|{any_form('run', 'disregard', 'ignore')} (?:the |its |a )?stop sign|(?:passe[sd]|went|goes|drove|drives|proceed\w*|roll\w*|rode|rides|came|blew|blows) (?:through|past) (?:the |its |a )?stop sign)(?: (?:at|for|to) (?:the |its |a )?(?:stop sign|right[ -]of[ -]way|us|stop|traffic))?", ego=False),
        _act(Action.RUN_LIGHT, rf"(?:{any_form('run', 'disregard', 'ignore', 'jump', 'violate')}|(?:passe[sd]|went|goes|drove|drives|proceed\w*|rode|rides?|came|going|proceeding|shoots?|shot|blew|blows|blasts?) (?:straight )?(?:through|on|against|over)(?: (?:on|at))?|{any_form('enter')} (?:the (?:intersection|junction) )?(?:on|against)|against|failed to stop (?:for|at)|did not stop (?:for|at)) (?:the |its |a |their |his )?(?:steady |solid )?(?:red(?: (?:traffic )?(?:light|signal))|red)"),
        _act(Action.RUN_LIGHT, r"(?:(?:still |straight |right )*(?:com\w+|cam\w+|go\w*|went|driv\w+|drove|enter\w*|cross\w*|rid\w+|rode|walk\w*|cycl\w+|roll\w*|shoot\w*|shot|continu\w+|proceed\w*) (?:straight |right |over the \w+ |across the \w+ |the \w+ |in |out )?)?(?:through )?(?:on|against|through|over) (?:(?:its|the|a|his|her|their|own|solid|steady|full) )*red(?: (?:light|signal|hand))?(?=[,.;:]|$| (?:and|from|while|when|as|into|but|to|at|which|in)\b)|blew (?:the|a|its) red"),
        _rule(Kind.ENTERS, rf"(?:{any_form('enter', 'cross')}|{any_form('proceed', 'drive', 'travel', 'ride', 'go', 'continue', 'come', 'run', 'walk')} (?:straight )?(?:into|through|across|over)) (?:the|an?) (?:intersection|junction|roadway|crosswalk|zebra(?: crossing)?|carriageway|roundabout)|enters?|entered(?= from)", ego=False),
        _act(Action.CROSS, rf"(?:{any_form('step', 'walk', 'run', 'ride', 'dart', 'dash', 'emerge', 'come', 'roll', 'jump', 'appear', 'pop', 'rush', 'go', 'cycle')}|rode|leaves?|left) (?:straight |right |quickly |suddenly )?(?:(?:out|off|in|on|onto|into|over|across|from)(?: of the \w+)? )*(?:(?:the|a) )?(?:(?P<side>{_SIDES}) |(?:north|south|east|west) )?(?:(?:road(?:way)?|street|carriageway)(?! debris)|lane|crosswalk|zebra(?: crossing)?|front(?: of us)?|path of us|{KERB})(?: into the (?:road(?:way)?|street|lane))?"),
        _act(Action.CROSS, r"cross(?:es|ed|ing)? (?:the )?(?:(?:street|road|exit|arm)(?: that| which)? we (?:turn|are turning|go|drive) into|exit road|exit)", Where.FAR_CORNER),
        _act(Action.CROSS, r"(?:dash|dart|sprint|shoot|rush|bolt|burst|tear|fly|step|walk|run|com|rid|emerg)(?:e?s|ing|ed)? (?:straight )?(?:out|across)(?= (?:from|in front|behind|of)\b|[,.;]| and\b)|(?:ran|shot|came|rode|tore|flew|stepped) (?:straight )?(?:out|across)(?= (?:from|in front|behind|of)\b|[,.;]| and\b)"),
        _act(Action.CROSS, rf"{any_form('cross')}(?: (?:the|our|over|in|this) ?(?:road(?:way)?|street|carriageway|lane|path|junction|intersection|front of us|way)?)*|across the front|(?:starts?|started|sets? (?:out|off)) (?:across|over)(?: (?:the|our) (?:road|street|lane|crosswalk|zebra))?|(?:\w+ly )?(?:roll|glid|yeet|zip|trundl|shuffl|hobbl|blast|rac|shoot|leap|trot|wander|ambl|saunter|stroll|jog)\w* (?:straight |\w+ly )?(?:across|over)(?! (?:us|our))|steps? off(?: the (?:kerb|curb|pavement|sidewalk))?(?=[,.;]| and| in| into|$)|(?:walk|run|rid|wander|com)(?:s|es|ing)? over(?= from)|walks? over|cut(?:s|ting)? across(?: (?:us|the road|the street|our (?:path|way|lane)))?|crosses"),
        _act(Action.REVERSE, rf"{_BEGINS}(?<!the )(?<!our )(?<!its )(?<!further )(?<!way )(?<!bit )(?:{any_form('back', 'reverse')}(?! (?:in|into|to|onto|at|there|before)\b)|(?:backed|backs|backing|reversed|reverses|reversing) (?=into us)|(?:put|puts|has put|engaged?) (?:the |its )?(?:back|reverse) gear|(?:rolls?|rolled|moves?|moved) back(?:wards?)?)(?: (?:up|out|backwards?|into|toward|towards|in reverse|of|from)\b)*|beg[ai]n(?:s|ning)? (?:to )?revers\w+|beg[ai]n(?:s|ning)? (?:to )?back(?:ing)?(?: up)?"),
        _act(Action.PULL_OUT, rf"(?:{any_form('pull', 'come', 'drive', 'exit', 'move', 'nose')} (?:out |away |off )*(?:of|from)|{any_form('leave', 'exit')}) (?:a|an|the|its) (?:[\w-]+ )?(?:parking (?:space|spot|place|lot|bay)|driveway|garage|curb|kerb|alley|loading zone|lot|parked position|bay|bus (?:bay|stop)|stop)|{any_form('pull')} (?:away|out) from (?:the|a) (?:curb|kerb)|nos(?:es|ed|ing) out|{any_form('pull')} (?:out|away|off)(?: anyway| suddenly)?|{any_form('set', 'move')} off|{any_form('depart')}(?: from)?|(?:leav(?:es|ing)|left) (?:the |its |a )?(?:bay|kerb|curb|lay-by|parking (?:spot|space|bay))"),
        _act(Action.U_TURN, r"(?:mak|mad|do|did|perform)\w* (?:a |the )?(?:half[- ]turn|turn of 180(?: degrees)?)"),
        _act(Action.U_TURN, rf"{_BEGINS}(?:(?:mak(?:e|es|ing)|made|do(?:es|ing)?|perform\w*|complet\w+|attempt\w*|execut\w*) (?:a|its|an)? ?(?:\w+ )?)?u[ -]turns?(?: across[\w ]*lanes?)?"),
        _act(Action.TURN_LEFT, _turn("left")),
        _act(Action.TURN_RIGHT, _turn("right")),
        _act(Action.ACCELERATE, rf"{any_form('accelerate')}|{any_form('speed')} up|sped up|increas\w+ (?:its |their )?speed|gives? (?:full )?gas|picks? up speed|floors it|guns it|puts (?:his|her|its) foot down"),
        _act(Action.WEAVE, r"(?:veer|swerv|weav|wander|swing|lurch|mov)\w* (?:\w+ly )?(?:to and fro|from side to side|from one side to the other|back and forth|about)|zigzag\w*|wobbl\w*(?: (?:left and right|all over(?: the (?:lane|road))?))?|oscillat\w*(?: laterally)?|all over the (?:lane|road)"),
        _act(Action.BRAKE, r"(?:hits?|hit|stamps? on|steps? on|applies|applied) (?:the |its |his |her )?brakes|(?:slams? (?:on )?(?:the |its )?brakes|slammed on (?:the |its )?brakes|brak(?:e|es|ed|ing)(?: (?:hard|sharply|abruptly|suddenly))*|decelerat(?:e|es|ed|ing)(?: hard)?|emergency brak\w+)"),
        _act(Action.BRAKE, rf"brake[ -]check\w*(?: us)?|{any_form('anchor')} (?:on|up)|follow\w* by (?:\w+ )?(?:braking|deceleration)"),
        _act(Action.STOP, r"brak\w+ (?:down )?(?:to|until|till) (?:zero|0(?: (?:km/h|mph))?|(?:a )?(?:standstill|stop|halt))|(?:comes?|came) to (?:a )?full stop|stop(?:s|ped) (?:dry|dead|short|suddenly|abruptly|sharply|without warning|out of nowhere|all (?:at once|of a sudden))|(?:suddenly|abruptly) stopped"),
        _act(Action.STOP, r"(?:to|until|into) (?:a )?(?:standstill|halt|complete stop|stop)|comes? to (?:a )?(?:rest|halt|stop|standstill)|came to (?:a )?(?:complete )?(?:rest|halt|stop|standstill)|stays? (?:standing|there)|remains? (?:standing|there)|freezes?|froze|(?:until|till|to) (?:it is |a )?(?:stationary|standstill|stopped)|halts?|halted"),
        _act(Action.HESITATE, r"(?:paus|hesitat)(?:e|es|ed|ing)(?: (?:halfway|briefly|for a (?:moment|second)))?(?:,? (?:and )?(?:then )?(?:carries|carried|goes|went|continues|continued|walks|walked|shot|shoots) (?:on|out)(?: anyway)?)?"),
        _rule(Kind.RESUMES, rf"(?:{any_form('move', 'set', 'go', 'start', 'drive', 'roll', 'inch', 'proceed', 'walk', 'carry', 'continue', 'ride', 'come', 'pull')}(?: off| on| out| away| up)?(?: moving| walking| going)? again|{any_form('resume')}(?: (?:moving|walking|driving))?|{any_form('get')} going(?: again)?|{any_form('carry')} on(?: again)?|then {any_form('go', 'continue', 'proceed')}(?: on)?(?=[,.;]| and\b|$))", ego=False),
        _act(Action.DIAGONAL, r"(?:cut|cuts|cutting|crosses|crossed|crossing) diagonally(?: across)?|diagonal(?:ly)?(?: style)?|at an angle across|in (?:a )?diagonal(?: direction)?|at a (?:slant|diagonal)|slantwise|oblique(?:ly)?|at \d+ ?° to the road(?: axis)?"),
        _act(Action.TURN_BACK, r"(?:turns?|turned|(?:mak\w+|made) (?:a |the )?turn) (?:around|round|back)(?: and (?:runs?|goes|ran|went|walks?|walked)? ?back)?|(?:runs?|ran|goes|went) back"),
        _act(Action.SLOW, r"(?:creep|dawdl|crept|inch(?:es|ing)|trundl)\w*(?: along)?|(?:moves |goes |drives |walks |is )?(?:slow )?(?:like|as) an? snail|at (?:a )?snail's pace|(?:barely|hardly|scarcely) moving|(?:barely|only|a mere|hardly) (?:five|six|seven|eight|nine|ten|twelve|fifteen|walking pace)"),
        _act(Action.SLOW, r"(?:super |very |too |extremely )?slow(?:ly)?|at (?:a )?(?:walking|low|crawling) (?:pace|speed)|crawl\w*|slow-moving|(?:do(?:es|ing)|going|travell?ing|driving|at) (?:just |only |barely |hardly )+(?:about )?\d+(?: ?(?:km/h|mph|kph))?|(?:does|doing) \d+ in an? \d+(?: zone)?"),
        _act(Action.BLOCK, rf"(?:{any_form('block', 'obstruct', 'fill', 'occupy')}|(?:(?:is|was) )?closing)(?: up| off)?(?: (?:the|our|its|all|both|a|an))*(?: (?:entire|whole|full|complete|two|three))* (?:width|lanes?|road(?:way)?|carriageway|street|way|path)(?: of (?:the|our) (?:road|lane|carriageway|street))?|(?:across|over) (?:the|our) (?:whole|entire|full|complete) (?:road|street|carriageway|width|lane)|(?:stands?|stood|standing|parked|stopped|lies|lay|stuck)(?: there)? (?:crosswise|crossways|sideways|broadside|transverse(?:ly)?|horizontal(?:ly)?)|blocks (?:it|full width|everything)"),
        _act(Action.NARROW, rf"(?:(?:{any_form('stand', 'be', 'park', 'stop', 'sit', 'leave')}|parked|stopped)(?: \w+ly)? )?(?:half(?:way)?|partly|partially|in part)[ -](?:of it )?(?:in|on|over|across|into|onto) (?:the|our|its|a) (?:\w+ )?(?:lane|road|carriageway|street)|half[ -]parked|(?:(?:parked|stopped|standing) )?(?:(?:stick|pok|hang|jut|protrud|extend|intrud|project|reach)\w*|stuck|hung)(?: half(?:way| way)?| partly| partially)?(?: out)?(?: (?:about |some )?(?:[\d.]+|\w+) (?:m|metres?|meters?|feet|foot|cm))? ?(?:in|on|over)?(?:to)? (?:the|our|its|traffic|travel)(?: \w+)? (?:lane|road|carriageway|street)|intrud(?:es|ing)|(?:clos|tak|block|occup|narrow|cover)\w* (?:up )?(?:half|(?:a )?part|some|a third|more than its half)(?: of)? (?:the|our|its) (?:\w+ )?(?:lane|road)"),
        _act(Action.STAND, r"(?:is |was |were |are |remain\w* |sat |stood |sits |stands )?(?:double[- ]?parked|parked(?: (?:parallel|legally|illegally))?|stationary|stopped|disabled|standing|stalled|broken[- ]down|waiting|stranded|not moving|motionless)(?: (?:in|on) (?:the|our|its) (?:same )?(?:\w+ )?lane)?|stands|stand(?: still)?|(?:just )?(?:sits?|sitting|stuck) (?:there\b|(?:in|on|at) (?=the |our ))"),
        _act(Action.WRONG_WAY, r"ghost driver|in the wrong direction|(?:from|on|in) (?:the )?wrong (?:side|direction)(?: of the (?:road|street))?|retrograde"),
        _act(Action.WRONG_WAY, r"(?:the )?wrong[ -]way|against (?:the )?(?:traffic|direction of (?:travel|traffic))|on (?:our|the wrong) side(?: of the (?:road|line))?|contraflow"),
        _act(Action.SWERVE, rf"{any_form('jerk', 'swoop', 'lurch')}(?: (?:over|across|out))?|(?:(?:com|hang|go|be|drift|mov)\w*|came|hung|went|is|was) (?:\w+ )?(?:over|across) the (?:(?:cent(?:re|er)|middle) )?line|{any_form('cut')} the (?:corner|bend|curve)|{any_form('swing', 'steer', 'jink')} (?:once )?towards us|(?:swing|swerv|jink|steer)\w* (?:out )?(?:a)?round an? \w+"),
        _act(Action.SWERVE, rf"{_LY}(?:runs|ran|drifts?|drifted|veer\w*|swerv\w*|cross\w*|com(?:e|es|ing)|wander\w*|strays?|swings?) (?:wide|(?:over|across) (?:the |into )?(?:(?:cent(?:er|re)|middle) ?line|line|{_OUR_SIDE})|(?:into|onto|over (?:in)?to) (?:{_OUR_SIDE}|the wrong side))(?: (?:in)?to our lane| there| and ends up on our side of the line)*|(?:swerv(?:e|es|ed|ing)|veer(?:s|ed|ing)?)(?: towards? us)?|drift(?:s|ed|ing)? (?:over|across|sideways)|(?:enter|mov|slip|get|got|encroach|invad|swing|swung|pull|cut)\w* (?:(?:over|out|across|in|on|to|into|onto) )*our half(?: of the (?:\w+ )?(?:road|carriageway))?"),
        _rule(Kind.ACT, rf"(?:{any_form('swerve', 'veer', 'drift')} |(?:{enter}) )(?:over )?(?:to the |to its |to )?(?P<whither>{_SIDES})(?:,? (?:and|right|straight|very|immediately|directly|just|suddenly|close\w*))* (?:in(?:to)? our lane|onto our lane|before (?:us|our \w+)|in front of us|(?:close )?ahead of us|towards? us)", action=Action.CUT_IN, ego=False),
        _act(Action.PACE, r"(?:keep\w*|kept|stay\w*|remain\w*|exactly|driv\w+)(?: exactly)? (?:level|abreast|alongside|parallel)(?: (?:with|to) us)?(?: the whole time)?|match\w* (?:our|the|its) (?:speed|pace)|at (?:an )?identical speed|(?:at )?(?:the )?same speed(?: as us)?(?: the)?(?: whole time)?", Where.BESIDE),
        _act(Action.PACE, rf"(?:(?:keep|stay|remain|rid|driv|stick|hold|sit|hang|travel)\w*|kept|rode|drove|stuck|held|sat|hung)(?: (?:right|exactly|just|still|always|directly|precisely|there))* (?:level|abreast|alongside|parallel|beside|next to|even|side by side)(?: (?:with|to|of))?(?: us)?|(?:(?:keep|hold|match|maintain)\w*|kept|held)(?: exactly)? (?:our|the same|same|(?:his|its|her) exact) (?:exact )?(?:speed|pace|velocity)|{any_form('go', 'drive', 'ride')} (?:exactly )?(?:as fast as (?:us|we)(?: (?:do|go))?|(?:to|at|with) the same (?:velocity|speed|pace)(?: (?:as|than) us)?)|{any_form('pace')} us|exactly (?:next to|beside|abreast|alongside|in parallel|parallel)(?: (?:of|with|to))?(?: us)?|{any_form('keep')} up with us", Where.BESIDE),
        _act(Action.TAILGATE, r"(?:(?:rid|sit|hang|stick|follow|driv|clos|glu)\w*|right|close|tight|sat|hung|stuck|rode|drove|stayed)(?: (?:right|up|very|too|so|much|close|tight|tightly|closely))* (?:on|onto|to|behind|against|at) (?:our |the )?(?:(?:rear|back) )?(?:bumper|tail|back end|exhaust|boot)(?: of us)?|(?:riding|hugging|biting) our (?:tail|bumper)|too close(?:ly)?(?: behind)?|at (?:an? )?(?:headway|gap|distance) of (?:(?:less than|only|just|under) )*(?:an?|one|two|half an?|0?\.\d+|1) ?(?:s|seconds?|yards?|metres?|meters?|m|car lengths?|inch)|(?:(?:an|one) inch|inches|(?:a|one|two|half a) (?:metres?|meters?|feet)|centimetres) behind us|(?:very|extremely|dangerously) close behind(?: us)?", Where.BEHIND),
        _act(Action.TAILGATE, r"tailgat\w+(?: us)?|following (?:too |very )?closely(?: behind)?(?: us)?|(?:much |far )?too close(?:ly)? behind(?: us)?|bumper to bumper|(?:sit|sat|rid|driv|hang|stick|stuck|glued|right|close)\w* (?:right |up )?(?:on|onto|to) our (?:rear )?bumper|(?:riding|hugging) our (?:rear )?bumper|up our (?:tail|exhaust)|(?:sits?|sat) (?:\w+ )?(?:inches|centimetres|feet) (?:off|from) our (?:rear )?bumper", Where.BEHIND),
        _act(Action.FOLLOW, rf"(?:{any_form('go', 'continue', 'proceed', 'drive', 'ride', 'travel', 'move', 'walk', 'roll')}) ?(?:straight(?: (?:on|ahead|through))?|on(?! (?:the|our|a|its|to)\b)|along|forward|ahead|at (?:a )?constant speed|in (?:its|the same) lane)|straight(?: on| ahead)?|constant(?: speed)?|(?:hold|keep|maintain)(?:s|ing)? (?:its|the|an?|his|her|their) (?:(?:constant|steady|same) )?(?:speed|pace|line|course)|kept its speed|remains? in (?:its )?lane|(?:walk|go|driv|mov|rid)e?s again|carries on|carried on"),
        _rule(Kind.FOREIGN, r"(?:climb|jump|leap|kick|punch|spat|spit|slash|hit and broke|threw|throw|vandal|graffiti|block\w* us in)\w*(?: (?:on(?:to)?|off|at|out))*(?: (?:the|our|us)(?: (?:hood|roof|bonnet|windscreen|windshield|trunk|sensors?))?)?|on foot", ego=False),
        _act(Action.FAST, r"like an? (?:rocket|bullet|train|shot|missile|arrow)|(?:so|very|really|extremely|much|way) fast(?! (?:lane|food))|at (?:about |an estimated )?\d+ (?:km/h |mph |kph )?in an? \d+(?: zone| limit)?|(?:much |far |way )?faster than (?:is |was )?(?:allowed|permitted|the (?:speed )?limit)|at twice the (?:speed )?limit"),
        _act(Action.FAST, r"(?:at |with )?(?:a )?(?:\w+ly )?(?:very )?(?:excessive|high|great|breakneck|full)(?: rate of)? speed|(?:way|well|far) (?:over|above) (?:the )?(?:speed )?limit|(?:way|far|much) too fast|speeding"),
        # Acts as nouns: "the cut-in of a van"
        *(
            _rule(Kind.NOUN, rf"(?:(?:sudden|abrupt|emergency|unexpected|hard|the|a|an|illegal) )*(?:{noun})(?: of us)?(?:(?: of (?:the |our |a )?(?:[\w'-]+ ){{0,2}}(?:road|path|lane|intersection|junction|street))? by| of)(?! us)", action=action)
            for action, noun in (
                (Action.BRAKE, "deceleration|braking(?: manoeuvre| maneuver)?|brake"),
                (Action.CUT_IN, "cut[ -]in|cutting[ -]in|merging|merge"),
                (Action.CHANGE_LANE, "cut[ -]out|lane change"),
                (Action.TURN_LEFT, "left[ -]turn"),
                (Action.TURN_RIGHT, "right[ -]turn"),
                (Action.U_TURN, "u[ -]turn"),
                (Action.REVERSE, "reversing|backing(?: up)?"),
                (Action.CROSS, "crossing|traversal|entry|(?:running|stepping|walking|dashing|darting|coming) out"),
                (Action.DIAGONAL, "diagonal (?:crossing|traversal)"),
                (Action.PULL_OUT, "departure|pulling out|pull-out"),
                (Action.OVERTAKE, "overtaking(?: manoeuvre| maneuver)?|passing"),
                (Action.TAILGATE, "tailgating"),
                (Action.SWERVE, "incursion|drifting|veering|swerving"),
                (Action.ACCELERATE, "acceleration"),
                (Action.RUN_LIGHT, "red[ -]light (?:violation|running)"),
                (Action.WEAVE, "weaving"),
                (Action.STOP, "stopping"),
            )
        ),
        _rule(Kind.NOUN, r"(?:are|were|is|was|being|been|get|got)?(?: then| being)? ?(?:overtaken|passed|undertaken)(?: from behind)?(?: (?:on|to) (?:the |our )?(?:left|right))? by(?! us)", action=Action.OVERTAKE, ego=True),
        _rule(Kind.NOUN, r"(?:are|were|is|was|being|been)?(?: then| being)? ?tailgated by", action=Action.TAILGATE, ego=True),
        _rule(Kind.NOUN, r"(?:are|were|is|was|being|been|get|got)?(?: then| being)? ?cut (?:off|up) by", action=Action.CUT_IN, ego=True),
        _rule(Kind.NOUN, r"(?:is |are |being )?crossed by", action=Action.CROSS),
        _rule(Kind.BARE, r"cut[ -]in", action=Action.CUT_IN, ego=True),
        _rule(Kind.DOOR, r"(?:open(?:s|ed|ing)?) (?:\w+ ){0,5}?doors?|doors? (?:\w+ )?(?:open\w*|swings? open)|open door"),
        # Where
        _rule(Kind.TARGET, r"(?:in|on)?to the (?:oncoming|opposite|opposing|other) lane(?: of traffic)?", ego=False),
        _rule(Kind.WHERE, r"(?:coming |comes |came )?(?:from|of) (?:the )?(?:opposite (?:sense|direction|side)|opposite|front)(?=[,.;]|$| (?:comes?|came|coming|and|is|was|has|straight|at|in|turns?|before)\b)|face to face|(?:is|are|was|were) coming(?=[.;]|$)", where=Where.OPPOSITE, ego=False, opens=True),
        _rule(Kind.WHERE, r"(?:coming |approaching )?(?:from|in|on|at) the (?:opposite|opposing)(?: (?:direction|side|lane|approach|arm))?(?: of (?:travel|the (?:intersection|road|street)))?|oncoming|opposing|coming the other way|(?:coming|comes|came|heading|headed|heads|driving|drives|drove|riding|rides|rode) (?:straight |right |directly )?at us|(?:coming|heading|headed) towards? (?:us|it)(?: in (?:that|the) (?:opposing|opposite|oncoming) lane)?|facing us|opposite(?= (?:turns?|is|makes|comes|goes|who|that|drives|[a-z]+s)\b)|head-on|the other way|(?:came|comes|coming) against us", where=Where.OPPOSITE, ego=False, opens=True),
        _rule(Kind.WHERE, rf"(?:in|from|on|of|occupying) (?:the|an|a|our)?(?: )?(?P<side>{_SIDES})?(?:[ -]?hand)? ?{_LANE}(?: (?:to|on) (?:the |our |its )(?P<side2>{_SIDES})(?: of us)?| (?:adjacent to|next to|beside|alongside) us)?|in the lane (?:to|on) (?:its|our|the) (?P<side3>{_SIDES})|alongside(?: us)?|level(?= (?:on|to)\b)|(?:level|abreast) with (?:us|the cab)|(?:next to|beside)(?: us| it)?(?: on (?:that|its|the|our) (?P<side4>{_SIDES})(?: side)?)?", where=Where.NEXT_LANE, ego=False),
        _rule(Kind.OWN_SIDE, r"(?:in|of|on) the (?P<side>left|right)(?:most|hand)?(?:[ -]hand)?(?: through| travel)? lane", ego=True),
        _rule(Kind.FROM_SIDE, rf"(?:coming |approaching |travell?ing )?(?:from|on|at|to|in|off|along)? ?(?:the |our |its |that )?(?P<side>{_SIDES})(?:[ -]?hand)?(?: {KERB}| side| arm| side street| verge)?(?: (?:of (?:us|the (?:road|street|intersection|junction))|street|lane))?(?! (?:signal|turn|indicator|blinker|front|rear|bumper|side|of way|wheel|door|mirror))", ego=False, opens=True),
        _rule(Kind.WHERE, rf"{_FROM} (?:the |a )?{KERB}(?: (?:on|to) (?:the |our )?(?P<side>{_SIDES}))?", where=Where.EDGE, ego=False, opens=True),
        _rule(Kind.WHERE, rf"{_FROM} (?:the |a )?(?:side|cross|minor|intersecting) (?:street|road)(?: (?:on|to) (?:the |our )?(?P<side>{_SIDES}))?", where=Where.ARM, ego=False, opens=True),
        _rule(Kind.WHERE, r"(?:further|some way|a bit|a little|way) (?:back|behind)(?: us)?", where=Where.BEHIND, ego=False),
        _rule(Kind.WHERE, r"(?:already )?in (?:that|the target|the new) lane|already there", where=Where.NEXT_LANE, ego=False, opens=True),
        _rule(Kind.AHEAD, r"(?:further|a bit|a little|some way) (?:on|up|along)\b(?! (?:the|our|from))|(?:further |slightly (?:further )?|directly |immediately |just )?(?:ahead|in front)(?: of (?:us|it))?(?: in (?:the same|our) lane)?|lead(?:ing)?", ego=False),
        _rule(Kind.AHEAD, r"of front|preced(?:es?|ed|ing) us|before us(?=[,.;]|$| (?:is|was|drives|brakes|stops))", ego=False),
        _rule(Kind.WHERE, r"in (?:our|the same|that same|our own) (?:\w+ )?lane", where=Where.OWN_LANE, ego=False),
        # The ego
        _rule(Kind.EGO_TURNS, _turn("left"), maneuver=Maneuver.LEFT_TURN, ego=True),
        _rule(Kind.EGO_TURNS, _turn("right"), maneuver=Maneuver.RIGHT_TURN, ego=True),
        _rule(Kind.EGO_CHANGES_LANE, rf"(?:in the process of )?{_BEGINS}(?:(?:{any_form('change', 'merge', 'move', 'shift', 'pull')})(?: lanes?| over| out)*(?: (?:in)?to(?: the| an?)?| from| for(?: the)?)*(?: adjacent)? ?(?P<side>{_SIDES})(?:most)?(?:[ -]hand)?(?: {_LANE})?|(?:changing|changed|moving|moved|merging|merged) from the (?:left|right|center|middle) lane (?:in)?to the (?P<side5>{_SIDES})(?:[ -]hand)? lane|an? (?:\w+ )?lane[ -]change(?: maneuver)? to (?:the |our )?(?P<side2>{_SIDES})|(?:initiat|perform|commenc|begin|start|execut|mak)\w* (?:an? |its |our )?(?P<side7>{_SIDES}) lane[ -]change|lane[ -]change (?:of us )?(?:to (?:the )?)?(?P<side3>{_SIDES})|has to change to the (?P<side4>{_SIDES})|{any_form('go', 'get', 'steer', 'head')} (?:over )?(?:in)?to the (?P<side6>{_SIDES})(?:most|[ -]hand)? lane)", ego=True),
        _rule(Kind.EGO_CHANGES_LANE, rf"(?:lc|lane[ -]changes?) (?:to (?:the )?)?(?P<side>{_SIDES})|(?:{any_form('want', 'need', 'try', 'go', 'intend')}|would) (?:to )?(?:(?:get|pass|move|go|be|shift|cross|come)(?: over)? )?(?:(?:in)?to |on |in )?(?:the )?(?P<side2>{_SIDES})(?:[- ]hand)? lane|{any_form('shift', 'cross', 'get', 'pass')} (?:over )?(?:in)?to the (?P<side3>{_SIDES})(?:[- ]hand)? lane", ego=True),
        _rule(Kind.EGO_REVERSES, rf"{_HELP} (?:reversing|backing|in reverse)|in reverse(?: gear)?|{any_form('reverse')}|{any_form('back')} (?:up|out|into)|parallel parking(?! (?:vehicle|car|spot|space))|(?:exiting|leaving|pulling out of) (?:a|the|its) (?:\w+ )?parking (?:space|spot|place)", ego=True),
        _rule(Kind.TURNING, r"(?:was |were |are |is |while |started |starting )?turning(?! (?:to |off )?(?:the |our |its )?(?:left|right))|(?:started|starting|began) to turn(?! (?:left|right))|(?:make|making) (?:a|its) turn", ego=True),
        _rule(Kind.SLIP_LANE, r"(?:the |a )?slip ?lane", ego=True),
        _rule(Kind.PAST, r"(?:outside|away from|nowhere near) (?:of )?(?:any|a|the|all) (?:\w+ )?(?:crosswalk|zebra|pedestrian crossing)s?"),
        _rule(Kind.PAST, r"(?:after|having|just) (?:completing|completed|making|made|having made) (?:an? |its |the |our )?(?:\w+ )?(?:left|right) turn"),
        # What it does at the pedals
        _rule(Kind.STATE, r"(?:were|was|are|is|be|been|being|just)? ?(?:(?:just|already|still|then|fully|completely|legally|first) )*(?:stopped|stationary|parked|at rest|waiting|standing(?: still)?(?! \w+er\b)|queue?d|queue?ing|halted|sitting|sat|(?<=were )held|(?<=are )held|(?<=was )held|(?<=is )held|idle|stuck|at a (?:complete |full )?(?:stop|standstill|halt))|(?:wait(?:s|ed)?|stands?|stood|(?:sits?|sat)(?! behind)|remain\w* (?:stopped|stationary))|continu\w+ to wait|broken down", state=EgoState.STANDS, ego=True),
        _rule(Kind.STATE, r"(?:came?|comes|coming|slowed|slows|slow|brought) to (?:a |an )?(?:\w+ )?(?:stop|halt|standstill|rest)|(?<!-way )(?<!a )(?<!the )(?<!bus )stop(?:s|ped)?(?![ -](?:sign|line|light))", state=EgoState.STOPS, ego=True),
        _rule(Kind.STATE, rf"{_BEGINS}(?:slow(?:s|ed|ing)?(?: down)?|decelerat\w+|reduc\w+ (?:its |our )?speed|eas(?:es|ed|ing) off)", state=EgoState.SLOWS_DOWN, ego=True),
        _rule(Kind.STATE, rf"{_BEGINS}(?:brak(?:e|es|ed|ing)(?: hard| sharply)?|appl\w+ (?:the )?brakes)", state=EgoState.BRAKES, ego=True),
        _rule(Kind.STATE, r"(?:creep|crawl|inch|roll)\w*(?: along| forward| through)?|at (?:a )?walking pace|very slowly", state=EgoState.SLOW, ego=True),
        _rule(Kind.STATE, r"(?:then )?(?:beg[aiu]n|start(?:s|ed|ing)?|attempt(?:s|ed)?|proceed(?:s|ed)?|continu(?:es|ed))(?: to| its| our)* (?:move|moving|proceed|proceeding|go|going|accelerate|accelerating|drive|driving|turn|turning|roll|rolling|make|making|forward|into|through|left turn|right turn|enter|across)(?: (?:off|forward|straight))*|(?:set|sets|setting|moves?|moved|moving|pulls?|pulled|pulling|starts?|started|drives?|drove) (?:off|away)|(?:then |and )?proceeded|making the|entered the (?:intersection|junction|roundabout)", state=EgoState.SETS_OFF, ego=True),
        _rule(Kind.STATE, r"at (?:a )?standstill|(?<!forward )(?<!along )(?:first )?in (?:a |the )?(?:traffic )?(?:queue|jam)", state=EgoState.STANDS, ego=True),
        _rule(Kind.SETS_OFF, rf"(?:{any_form('start', 'go', 'move', 'pull', 'set', 'drive')})(?: off| away| up| moving)?(?: (?:on|at|with|when|as))+ (?:(?:the|our|a|its) )*(?:(?:light|signal|arrow)s? (?:turn|go|went|chang)\w* (?:to )?)?green(?: (?:light|signal|arrow))?", ego=True),
        _rule(Kind.STATE, r"(?:and )?then (?:go|goes|went|start(?:s|ed)?|drive|drove)(?=[,.;]| and\b| when\b|$)", state=EgoState.SETS_OFF, ego=True),
        _rule(Kind.SETS_OFF, r"(?:(?:just|then) )?(?:set(?:s|ting)?|mov(?:e|es|ed|ing)|pull(?:s|ed|ing)?|start(?:s|ed|ing)?|driv(?:e|es|ing)|drove) (?:off|away)(?: from (?:a )?(?:standstill|rest|stop))?", ego=True),
        _rule(Kind.AROUND_IT, r"us(?:e|es|ed|ing) the (?:opposite|oncoming|opposing|other) lane(?: to (?:bypass|pass|overtake|get around|go around)(?: (?:the|a|it)(?: [\w-]+)?)?)?|(?:pass(?:es|ed)?|overt(?:ake|akes|ook)) (?:it|them)(?! on)|(?:pass(?:es|ed)?|overt(?:ake|akes|ook)) it on the (?:opposite|other|oncoming)[\w ]*|(?:go|went|goes|driv\w+|drove|steer\w*|pull\w*|swing\w*|swung|mov\w+) (?:out )?(?:a?round|past) it|to get (?:past|around|round)(?: it)?|{any_form('go', 'drive', 'steer')} (?:a?round|past)(?=[,.;])", ego=True),
        # The place
        _rule(Kind.SITE, r"(?:the |a |an )?(?:\w+-lane )?(?:[\w-]+ )?(?:motorway|freeway|expressway|autobahn|autoroute|autopista|interstate|turnpike)|highway", site=Site.MOTORWAY),
        _rule(Kind.SITE, r"(?:the |a )?(?:motorway |freeway |highway )?(?:on-ramp|entry ramp|entrance ramp|slip road|entry slip|on-slip|acceleration lane)(?: (?:to|of|onto) the (?:motorway|freeway|highway))?", site=Site.ON_RAMP),
        _rule(Kind.SITE, r"(?:from|off|out of) (?:the|an?|its) (?:motorway |freeway |highway )?(?:on-ramp|entry ramp|entrance ramp|slip road|entry slip|on-slip|acceleration lane)(?: (?:to|of|onto) the (?:motorway|freeway|highway))?", site=Site.PAST_ON_RAMP, ego=False),
        _rule(Kind.SITE, r"(?:the |a )?(?:single-lane |motorway |freeway |highway )*(?:off-ramp|exit ramp|exit slip|off-slip)", site=Site.OFF_RAMP),
        _rule(Kind.SITE, r"(?:inside (?:of )?)?(?:the |a )?(?:roundabout|rotary|traffic circle)", site=Site.ROUNDABOUT),
        _rule(Kind.SITE, r"(?:the |a )?(?:mid-block |marked )*(?:crosswalk|zebra(?: crossing)?)|(?:the|a) (?:marked )?pedestrian crossing", site=Site.CROSSWALK),
        _rule(Kind.SITE, r"(?:the |a )?(?:rural|country) (?:road|lane)", site=Site.RURAL),
        _rule(Kind.SITE, r"(?:in |from )?(?:a |the )?bus bay|(?<=bus in )the bay", site=Site.BUS_BAY),
    )  # fmt: skip


# Beside the rules

NOT = re.compile(
    r"(?:(?:does|do|did|will|would|could|can|has|have|had|is|are|was|were)(?: not|n't| never)|don't|doesn't|didn't|won't|isn't|wasn't|never|not|without|no|nor|neither|nobody|he not|(?:is |was |were |are )?unable to)(?: (?:actually|even|yet|ever|really|any|then|the|a))*(?![\w'])"
)
"""What comes next is said not to be."""
DENIED_VERB = re.compile(r"(?:not|n't|never)(?: (?:be|been))? $")
"""Behind these, an unknown verb is what is denied."""
SOMEBODY = re.compile(
    r"\b(?:(?:some|an?|the|this|that|one|another) )?(?:(?:drunk|young|old|angry|impatient|stupid|other) )?(?:someone|somebody|guy|bloke|fell(?:a|ow)|idiot|jerk|clown|chap|dude|lunatic|maniac|driver|motorist|he|she)\b"
)
"""Whoever is spoken of where no road user is named: a driver."""
NUMBER = re.compile(
    r"(?:at |with |about |some |around |like |doing |doing about )*\d+(?:[.,/]\d+)? ?(?:km/h|kph|kmh|kmph|mph|m/s(?:²|\^?2)?|metres?|meters?|mtrs?|m|%|seconds?|s|ft|feet|g|lux)?(?![\w/])"
)
"""A number of nobody in particular, which no slot has."""
PLAIN = re.compile(
    r"(?:a|an|the|and|or|but|of|on|in|at|to|from|with|as|by|for|into|onto|over|out|off|up|down|through|along|is|are|was|were|be|"
    r"been|being|has|have|had|will|would|can|could|it|its|he|his|she|her|him|we|they|their|them|there|this|that|these|those|"
    r"which|who|whom|whose|us|our|ours|when|while|where|then|than|after|before|during|until|just|also|still|again|yet|so|such|"
    r"same|time|moments|seconds|shortly|thereafter|approximately|about|later|subsequently|currently|immediately|suddenly|"
    r"abruptly|quickly|slowly|briefly|lightly|slight|slightly|minor|low|speed|mph|very|another|other|second|third|party|one|two|"
    r"traveling|travelling|driving|proceeding|continuing|moving|going|traffic|travel|lane|lanes|street|road|avenue|direction|way|"
    r"towards|toward|near|within|between|mid-block|adjacent|involved|collision|incident|accident|crash|event|contact|impact|"
    r"began|begin|beginning|start|started|attempt|attempted|attempting|tried|continued|proceed|proceeded|approached|approaching|"
    r"vehicle|vehicles|car|cars|straight|ahead|forward|position|center|middle|green|clear|path|line|space|spot|target|dummy|"
    r"sign|light|red|signal|intersection|junction|child|adult|test|case|variant|want|wants|ped|corner|sidewalk|roadway)"
)
"""Words that say nothing alone: one of them without a place is no sign that something was missed."""
RETURNS = re.compile(r"(?:prior to|before|while|when|as|and)\b")
"""Behind one of these, whoever was only met is done with."""
APPOSED = re.compile(r" (?:who|that|which)\b")
"""Behind a name, what comes next is said of whoever was named just before: "somebody, a pedestrian who"."""
STOP_SIGN = re.compile(r"stop[ -](?:sign|line)")
"""In these, nobody stops."""
PARTICIPLE = re.compile(
    r" (?:\w+ly )?(?:attempting|making|causing|cutting|forcing|hitting|striking|entering|coming|trying|apparently)\b"
)
"""Behind a comma, what comes next is still said of the same."""
WORD = re.compile(r"[^\s.,;:!?]+|[.,;:!?]+")
"""A word, or marks between words."""
REVEALS = re.compile(r"\b(?:reveal|expos|uncover)\w*|there (?:it|he|she) (?:was|is)")
"""Somebody leaves, and somebody else is there."""
STATED = re.compile(
    r"\b(?:intersection|junction|crossroads|(?:three|four)-leg|un-?signali[sz]ed|uncontrolled|four-way|all-way stop|three-way|stop sign|(?:traffic|red|green) (?:light|signal)s?|at (?:the|a) (?:red|lights)|t-(?:junction|intersection)|side (?:street|road)|cross (?:street|road)|arm|signali[sz]ed|roundabout|at (?:the|a) (?:lights|signal))\b"
)
"""A junction is spoken of, whatever patterns conclude."""
SIGNALISED = re.compile(r"signali[sz]ed|traffic light|lights")
"""Traffic lights are spoken of."""
UNCONTROLLED = re.compile(
    r"\bun-?signal|\buncontrolled|\b(?:no|without|neither)(?: any)? (?:traffic )?(?:lights|signals|signs|controls?|lights? or signs?)\b|\bunregulated|\bnon-signal"
)
"""A junction is said to have neither lights nor signs."""
LIGHTS = re.compile(
    r"\b(?:red|green|yellow|amber) (?:traffic )?(?:light|signal|arrow|ball|hand)s?\b|\b(?:on|under|against) (?:(?:the|its|our|a|an|permissive|flashing|steady|full) )*(?:green|amber|red)(?=[,.;:]|$| (?:and|from|while|when|as|into|but|to|at|which|in)\b)|\b(?:walk|don't-walk) signal\b|\b(?:light|signal|arrow)s? (?:is|are|was|were|had|turn|go|went|chang)\w*(?: to)? (?:green|red|amber)\b|\blights (?:are |were |was )?(?:green|red|both)\b|\bwith (?:traffic )?lights\b|\b(?:had|have|on|got|still|at|with) (?:a |the )?(?:steady |solid )?(?:green|red)\b(?! (?:car|vehicle|sedan|truck|van|suv))|\bat the lights\b|\b(?:red|green) (?:traffic )?light\b"
)
"""Somebody has a green light or a red one."""
REAR = re.compile(r"\b(?:rear|back|behind|tail|trunk|hatch|boot)\b")
"""Parts of the ego that somebody touches from behind."""
FLANK = re.compile(r"\b(?:doors?|side|quarter panel|wheels?|mirror|flank)\b")
"""Parts of the ego that somebody touches from beside."""


def side_named(part: str) -> Side | None:
    """The side of a part of the ego, as far as its words name one."""
    if re.search(r"\bleft\b", part):
        return Side.LEFT
    return Side.RIGHT if re.search(r"\bright\b", part) else None
