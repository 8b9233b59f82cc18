"""What words mean on the road: patterns for who, does what, where, and a net for typos.

Patterns are matched against lower-case text in which typos are mended. They are our own, collected from crash
reports, driving schools and the way people talk.
"""

from __future__ import annotations

import re
from functools import lru_cache

from chatscene.read.ego_state import SAID as EGO_STATES
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.scenario import Control, Occluder, Place, Site
from chatscene.terms.surroundings import Light, Surface, Weather, on_the_road


def _p(*patterns: str) -> re.Pattern[str]:
    return re.compile("|".join(rf"\b(?:{pattern})\b" for pattern in patterns))


# Who

EGO = _p(
    r"(?:the |our |my )?ego(?:'s)?(?: vehicle| car)?(?:'s)?",
    r"we|i",  # "us" and "me" are never the ones who do something
    r"(?:our|my) (?:own )?(?:car|vehicle|path|lane|way)",
    r"(?:the )?(?:av|adas vehicle|autonomous (?:car|vehicle)|self-driving (?:car|vehicle)|host(?: vehicle)?|vut|"
    r"(?:test|subject|tested) vehicle|(?:vehicle|car) under test|sut|egos?)",
)
EGO_AS_OBJECT = re.compile(
    r"\b(?:in front of|ahead of|behind|towards?|to|at|past|into|onto|across|beside|next to|alongside|near|before|of|for|"
    r"with|from|against|cuts? off|cutting off|hits?|blocks?|blocking|facing|overtakes?|passes|avoid|parallel to|by)"
    r" (?:the |our |my )?(?:ego(?:'s)?(?: vehicle| car)?(?:'s)?|us|me|car we|av|host(?: vehicle)?|vut|(?:test|subject|tested|autonomous|self-driving) (?:vehicle|car)|(?:vehicle|car) under test|"
    r"(?:own )?(?:car|vehicle|path|lane|way|course|trajectory|bonnet|bumper|nose))(?:'s)?(?: original)?"
    r"(?: (?:path|lane|way|course|trajectory|vehicle))?\b"
)

# The words of one kind may be part of another's name: a dirt bike is no bike. The general ones are looked for last.
KINDS: dict[AdversaryKind, re.Pattern[str]] = {
    kind: _p(kind.row.words)
    for kind in sorted(AdversaryKind, key=lambda kind: kind.row.general)
    if kind.row.words and not kind.lies  # of things only the reader of whole texts may speak
}
ANYBODY = re.compile("|".join(pattern.pattern for pattern in KINDS.values()))
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
        rf"{_STANDING} (?:delivery )?(?:trucks?|lorry|lorries|hgv)",
        rf"(?:truck|lorry)(?: that| which)?(?: is| stands)? {_PARKED}",
        r"(?<=behind )(?:a|the) (?:truck|lorry)",
    ),
    Occluder.PARKED_BUS: _p(
        rf"{_STANDING} (?:school )?(?:bus|coach|buses)",
        rf"(?:bus|coach)(?: that| which)?(?: is| stands)? (?:{_PARKED}|at (?:a|the) stop)",
        r"(?<=behind )(?:a|the) (?:school )?(?:bus|coach)(?! (?:stop|shelter))",
    ),
    Occluder.PARKED_CAR: _p(
        rf"{_STANDING} (?:cars?|vehicles?|vans?|suvs?|taxis?)",
        rf"(?:car|vehicle|van|suv|taxi)(?: that| which)?(?: is| stands)? {_PARKED}",
        r"row of (?:parked )?cars",
        r"(?<=behind )a (?:car|van)",
    ),
    Occluder.KIOSK: _p(r"kiosk|news ?stand|food stall|market stall|booth"),
    Occluder.CONTAINER: _p(r"containers?|dumpster|skip|bins?"),
    Occluder.HEDGE: _p(r"hedges?|bush(?:es)?|shrub\w*|fence|(?:garden |brick |stone )?wall|greenery|shrubbery"),
    Occluder.BILLBOARD: _p(
        r"billboards?|hoarding|poster(?: wall)?|advert\w* (?:column|board|pillar|panel|sign)|sign ?board|advertisement"
    ),
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

LEFT_TURN, RIGHT_TURN = _p(Action.TURN_LEFT.row.words), _p(Action.TURN_RIGHT.row.words)
LANE_CHANGE = _p(
    r"chang\w* (?:its |our |the )?lanes?",
    r"(?:chang|switch|shift)\w* (?:in)?to (?:the |another )?(?:\w+ )?(?:lane|left|right)",
    r"lane(?: |-)chang\w*|\blc\b",
    r"(?:chang|mov|get|gett|go|shift|switch|merg)\w* (?:over )?(?:on|in|to|into|onto) (?:the )?(?:left|right|next|other|adjacent) lane",
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
    Place.THREE_WAY: _p(
        r"(?:three|3)(?:-| )(?:way|arm(?:ed)?|legged|leg)(?: \w+)?(?: intersection| junction| crossing)?|t(?:-| )?(?:junction|intersection|crossing|int|jct|form|shape)|(?:at|off|of|on|signali[sz]ed|uncontrolled|controlled|the|a|an?) t(?= (?:with|without|where|and|at|junction)|[,.;]|$)|^t(?= with)|"
        r"(?:junction|intersection) (?:with|of|has) (?:three|3) (?:arms|legs|roads|streets)|stem of (?:the|a) t"
    ),
    Place.FOUR_WAY: _p(
        r"(?:four|4)(?:-| )(?:way|arm(?:ed)?|legged|leg)(?: intersection| junction| crossing)?|cross-? ?roads|"
        r"(?:junction|intersection|crossing) (?:with|of|has) (?:four|4) (?:arms|legs|roads|streets)|four-cornered"
    ),
    Place.JUNCTION: _p(
        r"intersections?|junctions?|crossing negotiation|(?:side|cross) (?:road|street)s?|traffic lights?|signals?|stop sign"
    ),
    Place.LEFT_CURVE: _p(
        r"left(?:-hand|-handed|ward)?(?:-| )(?:curve|bend|hander)|(?:curv|bend|swing|veer)\w* (?:round )?(?:to the |off to the )?left"
    ),
    Place.RIGHT_CURVE: _p(
        r"right(?:-hand|-handed|ward)?(?:-| )(?:curve|bend|hander)|(?:curv|bend|swing|veer)\w* (?:round )?(?:to the |off to the )?right"
    ),
    Place.CURVE: _p(r"curves?|bends?|curved|winding|corner of the road"),
    Place.ROAD: _p(r"roads?|streets?|highways?|motorways?|lanes?|carriageways?|avenue"),
}
# A road user on its way from a ramp, so that the ego goes by where that joins
FROM_RAMP = _p(
    r"(?:from|off|out of) (?:the|an?|its) (?:motorway |freeway |highway )?"
    r"(?:on-? ?ramp|entry ramp|entrance ramp|slip ?road|entry slip|on-slip|accel(?:eration)? lane)"
    r"|(?:merg|join)\w* (?:in |on |over )?from (?:the|a) ramp"
)
# The first that is named stands; a ramp is the ego's only where the ego is told to be on it
SITES: dict[Site, re.Pattern[str]] = {
    Site.ROUNDABOUT: _p(r"roundabouts?|rotary|traffic circle|rotunda|gyratory"),
    Site.BUS_BAY: _p(r"bus (?:bay|lay-?by)"),
    Site.CROSSWALK: _p(r"zebra(?: crossing)?|crosswalk|pedestrian crossing|school crossing"),
    Site.OFF_RAMP: _p(r"off-? ?ramp|exit ramp|exit slip|off-slip"),
    Site.ON_RAMP: _p(r"on-? ?ramp|entry ramp|entrance ramp|entry slip|on-slip|accel(?:eration)? lane"),
    Site.LANE_DROP: _p(r"lane (?:ends|ending|drops|drop|tapers|runs out|reduction|that ends)|lane-drop"),
    Site.PARKING: _p(r"parking (?:lot|area|aisle)|car ?park"),
    Site.MOTORWAY: _p(
        r"(?<!towards the )(?<!toward the )(?<!over the )(?<!under the )(?<!near the )"
        r"(?:motorways?|freeways?|expressways?|autobahn|autoroute|autostrada|autopista|interstate|turnpike)",
        r"highway(?! (?:patrol|code|police|agency|department|\d))|i-? ?\d{1,3}(?![\d:])|(?:the |on )m\d{1,2}|m\d\d|hard shoulder",
    ),
    Site.RURAL: _p(r"rural|(?:country|field|forest|village) (?:road|lane)"),
}
CONTROLS: dict[Control, re.Pattern[str]] = {
    Control.NONE: _p(
        r"un-?signali[sz]ed|uncontrolled|unregulated|unmarked|(?:no|without)(?: any)? (?:traffic )?(?:lights?|signals?|signs?|control)|neither (?:lights?|signals?)|"
        r"signal-free|priority to the right|crossing negotiation|lights? (?:are|is) (?:out|off)"
    ),
    Control.STOP_SIGN: _p(
        r"stop(?:-| )signs?|(?:all|two|three|four|4)(?:-| )way(?:-| )stop|stop(?:-| )(?:controlled|line|sign-controlled)|(?:stop|halt) board"
    ),
    Control.SIGNAL: _p(
        r"(?:traffic|red|green) (?:lights?|signals?)|(?<!un)signali[sz]ed|(?:signal|light|traffic-light|lights)-(?:controlled|regulated)|regulated by (?:signals|lights)|governed by (?:signals|lights)|"
        r"set of (?:traffic )?lights|with (?:traffic )?(?:signals?|lights)|lights? (?:is|are|turns?) (?:red|green)|"
        r"(?:the|a) red|on (?:red|green)|stop ?lights?|at (?:the|a) (?:lights|signals)"
    ),
}

# What the adversary does

# Turns are looked for later: the ego makes them as well, in the same words
ACTIONS: dict[Action, re.Pattern[str]] = {
    action: _p(action.row.words) for action in Action if action.row.words and not action.row.turn
}
_ON_FOOT = r"pedestrian|walker|person|man|woman|child|kid|boy|girl|jogger|runner"
_ACROSS_US = r"(?= across (?:(?:our (?:\w+ )?(?:path|way|bows?|front|lane|nose)|us|(?:in|the) front of (?:us|our))\b|the ego))(?![^.;]* from (?:the |our )?(?:left|right)\b)"
# Where traffic keeps right, who turns across oncoming traffic turns left, also in a report from where it keeps left
KEEPING_RIGHT: tuple[tuple[re.Pattern[str], str], ...] = (
    (
        re.compile(
            r"((?<![\w-])(?:turn(?:s|ed|ing)|(?:we|they|to|will) turn))"
            r"(?= (?:across|in front of) (?:(?:the|its) (?:path|way|bows?|front|lane) of )?(?:an? |the |another )?oncoming\b)"
        ),
        r"\1 left",
    ),
    (
        re.compile(
            r"((?:^|\b(?:an?|the|another) )(?:oncoming|approaching|opposing) "
            rf"(?:(?!(?:an?|the|{_ON_FOOT}) )[\w-]+ ){{1,2}}"
            r"turn(?:s|ed|ing))(?: right)?" + _ACROSS_US
        ),
        r"\1 left",
    ),
    (
        re.compile(
            r"(\b(?:car|vehicle|van|truck|lorry|bus|coach|tram|taxi|cab|suv|pickup|trailer|motorcycl\w+|motorbike|moped|"
            r"scooter|cyclist|bicycle|bike|driver|rider)\b[^.;]{0,30}?\b"
            r"(?:coming|came|comes|driving|travelling|approaching) (?:the other way|towards? (?:us|the ego)"
            r"|(?:from|in) the (?:opposite|other) direction)(?: (?:and|then|suddenly|was|is|just))* turn(?:s|ed|ing))"
            r"(?: right)?" + _ACROSS_US
        ),
        r"\1 left",
    ),
)
# Behind two letters that are no point of the compass: a plate, a line, a firm, or "note well"
_NO_NAME = r"(?![-':\u2019]| (?:plates?|registered|line|ramp|mason)\b)"
# Other ways to say what the patterns know
REWRITES: tuple[tuple[re.Pattern[str], str], ...] = (
    # What is asked for, before it is told
    (
        re.compile(
            r"^(?:please |can you |could you )?(?:generate|create|build|design|make|simulate|write)(?: (?:me|us))? (?:a |the )?(?:driving |test |traffic )?(?:scenario|scene|test case|situation)"
            r" (?:where|in which|such that|so that|of|with) "
        ),
        "",
    ),
    # Who the ego is called by in games, in learning and in lessons
    (
        re.compile(r"\b(?:the )?(?:player(?: car)?|(?:rl|driving) agent|learner(?: driver)?|candidate)(?!')\b"),
        "the ego",
    ),
    (re.compile(r"\b(?:the )?(?:player|learner|candidate|agent)'s\b"), "the ego's"),
    # Who reports, and under what title, is not part of the situation
    (
        re.compile(
            r"^(?:according to (?:the |a )?(?:report|police|witness\w*|driver|statement)\w*,? ?|(?:the )?(?:driver|witness\w*|report|police|caller)s? "
            r"(?:state|report|say|said|note|describe|claim|record)\w*(?: that)?:? |(?:test )?(?:case|scenario|situation|summary|description)(?: \d+)?: )"
        ),
        "",
    ),
    # A child's scooter has no motor; others on two wheels are called by their wheels
    (
        re.compile(
            r"\b((?:(?:an?|the|some|this) )?)(?:(?:young|little|small) )?(?:child|toddler|schoolboy|schoolgirl|(?<=little )(?:girl|boy|kid)|(?<=small )(?:girl|boy|kid)) "
            r"(?:on|riding) (?:an? |his |her |their )?(?:(?:little|small|toy|kick|push|balance) )*scooter\b"
        ),
        r"\1e-scooter",
    ),
    (
        re.compile(
            r"\b(?:(?:young|old|elderly|older|little|small) )?(?:man|woman|girl|boy|kid|child|teenager|guy|person|lady|somebody|someone|rider|courier|student|teen|bloke|lad) "
            r"(?:on|riding|astride) (?:an? |his |her |their )?(?=(?:\w+ )?(?:motor ?cycle|motor ?bike|scooter|moped|vespa|bicycle|bike|e-bike|cargo bike|push ?bike)\b)"
        ),
        "",
    ),
    # The inside is the side of the kerb, which is the right one
    (
        re.compile(
            r"\b(c[oa]m(?:e|es|ing)|rid(?:e|es|ing)|rode) up (?:on |along )?(?:the|our|my) inside(?: of (?:us|me))?\b"
        ),
        r"\1 from behind on the right",
    ),
    # Of two lanes one is for each way, whatever the road is called
    (
        re.compile(r"\b(?:two|2)[- ]lane,? (?:(?:undivided|state|county|us|federal) ){0,2}highway\b"),
        "road with one lane each way",
    ),
    # Who skids into our lane or slides over the middle swerves, as far as anybody sees
    (
        re.compile(
            r"\b(?:ha[sd] )?(?:(?:skid(?:s|ded)|slither(?:s|ed)|aquaplane[sd]|hydroplane[sd]|slew(?:s|ed))"
            r"(?= (?:out |over )?(?:over|across|into|onto) (?:the (?:cent(?:re|er)|middle|path of)|our|its? wrong))"
            r"|sli(?:d|des)(?= (?:out )?(?:over|across|into|onto) the (?:cent(?:re|er)|middle|path of)))"
        ),
        "swerved",
    ),
    # Who does not come to a stop does not stop, and who "has stop" has a sign that says so
    (
        re.compile(
            r"\b(?:fail(?:s|ed|ing)? to|(?:did|does|do|could|would) not|(?:did|does|do|could|would)n't) (?:come to|make) (?:an? )?(?:(?:\w+ and )?\w+ )?"
            r"(?:stop|halt|standstill)\b"
        ),
        "did not stop",
    ),
    (
        re.compile(r"\bwithout (?:coming to|making) (?:an? )?(?:(?:\w+ and )?\w+ )?(?:stop|halt|standstill)\b"),
        "without stopping",
    ),
    (
        re.compile(
            r"\b(has|had) (?:an? )?stop(?=,? (?:and |but )?(?:never|does not|doesn't|did not|didn't|fails|failed|ignores|ignored|runs|ran|rolls)\b)"
        ),
        r"\1 a stop sign",
    ),
    # Where the lane of a ramp ends, whoever is on it has to come over
    (
        re.compile(r"(?<!\bwe )\b(?:runs|ran) out of (?:acceleration|merg(?:e|ing)) lane\b"),
        "comes from the on-ramp",
    ),
    (re.compile(r"\bpeds?\b"), "pedestrian"),
    (re.compile(r"\bint\b\.?"), "intersection"),
    (re.compile(r"\b(?:jct|jn)\b\.?"), "junction"),
    (re.compile(r"\bn/b\b|\bnb\b" + _NO_NAME), "northbound"),
    (re.compile(r"\bs/b\b|\bsb\b" + _NO_NAME), "southbound"),
    (re.compile(r"\be/b\b|\beb\b" + _NO_NAME), "eastbound"),
    (re.compile(r"\bw/b\b|\bwb\b" + _NO_NAME), "westbound"),
    (re.compile(r"\bw/o\b"), "without"),
    (re.compile(r"\bw/"), "with "),
    (re.compile(r"\bveh\b\.?"), "vehicle"),
    (re.compile(r"\b(?:lhs|l/h side|nearside left)\b"), "left side"),
    # Traffic keeps right on our maps
    (re.compile(r"\b(?:nearside|near-side)\b(?! (?:lane|of))"), "right side"),
    (re.compile(r"\b(?:farside|far-side|offside)\b(?! (?:lane|of))"), "left side"),
    (re.compile(r"\b(?:rhs|r/h side)\b"), "right side"),
    (
        re.compile(
            r"\b(?:the |our |my )?(?:vehicle (?:1|one|a)|v1|u1|unit (?:1|one)|vut|sut|(?:vehicle|car) under test|(?:test|subject|tested|host|autonomous|automated|ego|self-driving) (?:vehicle|car)|host(?! of)|"
            r"(?:our|my) (?:robot(?:ic)?|robo-?|automat(?:ic|ed)|autonomous|self-driv(?:e|ing)|driverless|computer-driven)[- ]?(?:car|taxi|vehicle|sedan|saloon|unit|van|shuttle)|"
            r"(?<!the )sv|our (?:own )?(?:vehicle|car)|my (?:own )?(?:vehicle|car)|(?:own|main) (?:vehicle|car)|av)\b"
        ),
        "the ego",
    ),
    (re.compile(r"\b(?:the )?(?:vehicle (?:2|two|b)|v2|u2|unit (?:2|two))\b"), "the other vehicle"),
    (re.compile(r"\b(?:the )?(?:pov|principal other vehicle|target vehicle|gvt)\b"), "the other vehicle"),
    (re.compile(r"\b(?:ept[ac]?|pedestrian target|child target)\b"), "pedestrian"),
    (re.compile(r"\b(?:ebt[a]?|bicyclist target|cyclist target)\b"), "cyclist"),
    (re.compile(r"\b(?:emt|motorcyclist target)\b"), "motorcyclist"),
    # Somebody parked of whom more is told is no thing that stands about
    (
        re.compile(
            r"\b(car|vehicle|van|suv|taxi|truck|lorry|bus|coach|motorcycle|motorbike|scooter|ambulance|engine|limousine|wagon|sedan|saloon|cab|pickup|hgv)"
            r" (?:is|was|sits|sat|stands|stood) (?:parked|stationary|standing|waiting|stopped)? ?(?=(?:at|on|along|by) the )"
        ),
        r"\1 at the kerb ",
    ),
    (
        re.compile(
            r"\b(?:parked|stationary|standing) (car|vehicle|van|suv|taxi|truck|lorry|bus|coach|motorcycle|motorbike|ambulance)"
            r"((?: (?:at|on|by|to|in|along) the (?:\w+ )?(?:left|right|kerb|curb|roadside|side)(?: side)?)?)"
            r"(?=,? (?:that |which )?(?:suddenly |abruptly |then |just |slowly |quickly |all of a sudden |without \w+ |starts? to |begins? to )*"
            r"(?:pull|mov|driv|set|swing|start|leav|reverse|revers|back|edg|mak|lurch|shoot|nos|roll|creep|manoeuvr|join|cut)\w*)"
        ),
        r"\1 at the kerb\2",
    ),
)

# Whoever moves to a side and so comes to be where the ego is, comes from the lane on the other; but for the ego, for
# those who turn, and for who is ahead, at the kerb, on foot, or comes towards us
_TURNS_IN = re.compile(
    r"\b(?:oncoming|opposite|opposing|head-on|wrong[ -]way|towards?|junction|intersection|crossroads|arm|side (?:road|street)|corner|driveway)\b"
)
_NOT_BESIDE = re.compile(
    rf"\b(?:we|i|the ego|ahead|front|lead(?:ing)?|preceding|(?:our|my|the same|the ego's) lane|kerb|curb|stop|parked|sidewalk|pavement|shoulder|{_ON_FOOT})\b[^.;!?]*$"
)
_WHITHER = re.compile(
    r"\b((?:chang|mov|merg|shift|slid|swerv|veer|drift|wander)\w*"
    r"(?: (?:lanes?|over|across|suddenly|abruptly|sharply|slowly|quickly|back|out|in)){0,2}),? "
    r"(?:to )?(?:the |its |his |her )?(left|right)(?:-hand)?(?: lane)?"
    r"(,?(?: (?!(?:and|to|so|it|he|she|they|an?|left|right(?! in\w* ))\b)[\w-]+){0,3}? "
    r"(?:(?:in)?to (?:the )?(?:path|way|lane) of|into|onto|in front of|ahead of|before|across|cutting off|in (?=our|my|the ego's)) "
    r"?(?:us|me|the ego(?!')|(?:our|my|the ego's) (?:own )?(?:lane|path|way|car|vehicle|side|nose|bonnet|hood|bumper))\b)"
)
_OTHER_SIDE = {"left": "right", "right": "left"}

# What happens on roads and is in no library of ours; who speaks of it is refused rather than served something else
FOREIGN = _p(
    r"cats?|horses?|cows?|cattle|sheep|animals?|moose|boars?|birds?|pony|ponies|fox|foxes|ducks?|kangaroos?",
    r"trams?|tramways?|trains?|railway|level crossing|helicopters?|aeroplanes?|airplanes?|planes?|drones?|boats?|spaceships?|meteors?|robots?|dragons?",
    r"parking garage|multi-storey|tunnel collapse|landslide|pothole|hole in (?:the )?road",
    r"(?:car |passenger |driver's |front )?doors? (?:open|swing|fly|shall be opened)\w*|open\w* (?:the|its|his|her|a) (?:\w+ )?door",
    r"flood\w*|earthquake|wheelchair robot",
)
_U_TURN = r"(?:(?:a|an|our|the) )?(?:(?!not\b)\w+ )?u[ -](?:turns?|ey)\b"
_TURNS_ROUND = (
    rf"(?:(?:mak|tak|do(?!w)|perform|pull|complet|execut|attempt)\w*|made|did|took) {_U_TURN}"
    r"|(?:turn|swing)(?:ing|ed|s)? (?:a)?round in the (?:road|street)|u-turn(?:ing|ed)?\b"
)
# What no ego does, where it begins a clause
NO_MANEUVER = re.compile(
    rf"(?:^|[.,;:!?] |\b(?:and|but|when|while|as|where|because|that) )(?:we|the ego)"
    r"(?: (?:are|is|were|was|have|has|had|will|just|then|want(?:ed)? to|about to|going to|start\w*|beg[iau]n\w*"
    rf"|tr(?:y|ied|ying) to|fancied|to))* (?P<what>{_TURNS_ROUND})"
    rf"|(?:^|[.;!?] )(?:while |when |on )?(?P<first>(?:mak|tak|do|perform)ing {_U_TURN}),? (?:we|the ego)\b",
    re.IGNORECASE,
)
LIGHTS: dict[Light, re.Pattern[str]] = {light: _p(light.row.words) for light in Light}
WEATHERS: dict[Weather, re.Pattern[str]] = {weather: _p(weather.row.words) for weather in Weather}
SURFACES: dict[Surface, re.Pattern[str]] = {surface: _p(surface.row.words) for surface in Surface}
OF_A_ROAD = re.compile(
    r"\S+ (?P<road>(?:\w+ )?(?:roads?|streets?|roadway|asphalt|tarmac|carriageway|lanes?|bend|curve))"
)
# What no scene has
NO_LIGHT = _p(
    r"sun ?glare|low sun|(?:setting|rising|blinding) sun",
    r"(?:dazzl|blind)\w* (?:us|by)"
    r"(?: (?:the |its |his |her )?(?:low |setting |rising )?(?:sun|head ?lights?|high beams?|full beams?))?",
)
NO_WEATHER = _p(
    r"mist|misty|haz[ey]|smog|sleet|hail(?:stones?|storm|ing)?|thunderstorms?|storm(?:y|s)?",
    r"gusts?|crosswinds?|(?:strong|high|heavy) winds?|windy",
    rf"{on_the_road('flooded')}|aquaplan\w*|puddles?|patch(?:es)? of (?:black )?ice|ic(?:e|y) patch(?:es)?",
)
# What may come of several; no scene has it unless it is said of which
SLIPPERY = _p(on_the_road("slippery|slick|greasy"))
HARDLY_SEEN = _p(r"(?:poor|bad|low|reduced|zero|limited) visibility|(?:bad|poor|adverse|severe) weather")
# Before what is said not to be so
DENIED = re.compile(
    r"(?:\b(?:no(?: more| longer)?|without(?: any)?|neither|nor|not)|n't)(?: (?:in|at|on|yet|very|really|any|the|an?|heavy))*$"
)

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
    r"(?:walk|com|approach|rid|driv|head|runn?)\w* (?:\w+ ){0,2}towards? (?:us|me|the ego)|approach\w* (?:us|me|the ego) (?:on foot|head)|(?:com|approach)\w* (?:the )?other way|oncoming|opposite (?:direction|lane|arm)|opposing|head(?:-| )on|wrong(?:-| )way|against (?:traffic|us)|other way|"
    r"(?:com|approach|head|driv|rid|walk|runn?|speed|rac)\w* (?:straight |right )?(?:towards?|at) (?:us|me|the ego)"
)
FAR = _p(
    r"opposite (?:sidewalk|side|pavement|kerb|curb|corner|footpath)|far(?:ther|ther)? (?:side|corner|kerb|curb|sidewalk|pavement)|other side"
)
CROSSING = _p(
    r"crossing (?:car|vehicle|truck|bus|traffic|motorcycle)|cross traffic|side (?:road|street)|perpendicular|cross(?:es|ing)"
)
NEIGHBOUR = _p(r"(?:target|adjacent|next|neighbou?ring|other|left|right|passing) lane|lane (?:beside|next to|to the)")
KERB = _p(
    r"(?:at|from|on|by|along|against|off|leav\w*) (?:the )?(?:\w+ )?(?:kerb|curb|kerbside|roadside)|pulled over|lay-?by|bus (?:bay|stop)|"
    r"park(?:ing|ed)(?: (?:space|bay|spot|lane|row|position))?|hard shoulder|standing at the (?:side|edge)|unpark\w*"
)
NEAR = _p(
    r"just (?:ahead|behind|beyond|in front)|close (?:by|ahead|in front|behind|to us)|nearby|a few (?:\w+ )?(?:metres|meters|yards|steps) (?:ahead|away|off|in front|further)|"
    r"right up behind|hardly a (?:car )?length|only (?:metres|meters) (?:from|away|off|ahead)|a (?:car )?length (?:ahead|in front)|(?:very )?(?:near|close) behind|short before us|only a few (?:metres|meters|yards|paces|steps) away|a few (?:paces|steps) away|quite near|very close|close at hand|(?:just |only )?(?:five|ten|fifteen|5|10|15) (?:metres|meters) (?:off|away)|"
    r"a short (?:way|distance)|immediately (?:ahead|in front|behind)|right next to|at close (?:range|quarters)|very near"
)
FAR_AWAY = _p(
    r"from far|far out|(?:at |from )?long range|first far|still far|still (?:a good|some) way off|a long way back|way back|far back|a long way off|(?:further|far) off|(?:some )?(?:forty|fifty|sixty|seventy|40|50|60|70) (?:metres|meters) (?:off|away|ahead)|far (?:ahead|away|off|down|in front|behind|up)|in the distance|a long way|well (?:ahead|down|up) |farther (?:down|up)|further (?:down|up)|"
    r"at (?:a )?(?:long|great|large) (?:range|distance)|distant|way (?:ahead|down|up)"
)
_PEOPLE = (
    r"pedestrians|walkers|persons|people|children|kids|men|women|boys|girls|joggers|runners|students|schoolchildren|school ?kids|teenagers|friends|"
    r"cyclists|bicycles|bikes|riders|motorcycles|motorcyclists|motorbikes|bikers|scooters"
)
GROUP = _p(
    r"(?:group|crowd|bunch|gang|pack|family|couple|pair|class|party|handful) of",
    rf"(?:two|three|four|five|several|some|multiple|many|a few|both|2|3|4) (?:\w+ )?(?:{_PEOPLE})",
    r"(?:pedestrians|children|kids|people|schoolchildren|cyclists|bikers|teenagers|joggers)",
    r"(?:a|the) (?:family|crowd|mother with (?:a |her )?\w+|parent and child)",
)
MANY_LANES = _p(
    r"(?:two|2|several|more) lanes (?:there|ours|on (?:its|our|his|her|the ego's) side|for (?:us|our|my)|our way|my way)|2-lane|(?:left|right|inner|outer) (?:lane )?(?:of|from) (?:the )?two|(?:in|of|from) (?:the )?two lanes|"
    r"several lanes|more than one lane|(?:has|have|with) (?:two|three|2|3) lanes|(?:two|three) lanes (?:going|for|its|their|wide|that|to)|(?:two|three|four|2|3|4)-lane (?:approach|carriageway|one-way)|multi-?(?: )?lane|(?:two|three|four|several|2|3) lanes (?:in (?:each|our|the same|one|its|the ego's)|each|per|our)\w*|dual carriageway|"
    r"motorway|highway|freeway|lanes (?:in (?:the same|our) direction)|(?:left|right|middle|inner|outer|fast|slow|passing) lane"
)
ONE_LANE = _p(
    r"(?:rural|country),? (?:two|2)[- ]lane|(?:two|2)[- ]lane,? (?:rural|country)",
    r"1 ?\+ ?1|(?:1|one) lane (?:each|for each|in each|either|per)|(?:just|only) one lane|(?:single|one)(?:-| )(?:lane|track)(?! to (?:another|the))|(?:one|a single) lane (?:each way|per direction|in (?:each|its|our|either) direction|our way|going)|narrow (?:road|street|lane)",
)
TWO_WAY = _p(
    r"lanes? (?:each way|per direction|in (?:each|either) direction)|with oncoming traffic|two(?:-| )way|oncoming lane|opposite lane|opposing lane|one lane (?:each way|per direction|in each direction)|undivided"
)
EACH_WAY = _p(
    r"lanes? (?:each way|per direction|in (?:each|either) direction|for each direction|each)|1 ?\+ ?1|two directions"
)
# A vehicle of which a bystander tells where it was going
ON_ITS_WAY = re.compile(
    r"\b(?:the|a|my \w+'s) (?:\w+ )?(?P<vehicle>car|van|taxi|cab|suv|hatchback|estate|minivan|saloon|sedan|fiat|golf|ford)\b"
    r"(?: there)? (?:was |is |had been |just |wanted to |going to |trying to )*(?:just )?"
    r"(?:turn(?:ing|ed|s)?|going straight|driving straight|mov(?:ing|ed) over|chang(?:ing|ed)|went straight|goes straight|coming straight|get into|going along|came up|driving along)"
)
ONE_WAY = _p(r"one(?:-| )way")
SIDE_ROAD = _p(
    r"(?:side|cross(?:ing)?|minor|intersecting) (?:road|street|arm)|(?:com|approach|driv|rid|arriv|enter)\w* (?:in |out |over )?from (?:the |our )?(?:\w+ )?(?:left|right)|"
    r"(?:left|right)(?:-hand)? (?:arm|street|road|approach|leg|branch)"
)
SAME_LANE = _p(
    r"(?:same|our|my|the ego's|its) (?:own )?lane|directly (?:ahead|in front|behind|before)|(?:right|straight|immediately) (?:behind|in front|ahead)|edge of (?:the|our) lane"
)
BEHIND = _p(r"(?:from )?behind|rear|tailgat\w*|back")
AHEAD = _p(r"ahead|(?:in )?front|lead(?:ing)?|preceding")
BESIDE = _p(r"parallel|alongside|beside|next to|side by side|level with")
TURNING_WORDS = re.compile(
    r"\b(?:turn|swerv|veer|merg|chang|mov|steer|pull|swing|hook)\w*(?: (?!from\b|on\b|in\b)\w+){0,2}? (?:to (?:the|its) )?(?:left|right)\b"
    r"|\b(?:left|right)(?:-hand)?(?: |-)turn\w*|\bright (?:in front|in (?:our|my|the ego's?) (?:face|way|path)|away|before|behind|after|at|into|next|now|of way|past|through|on|up|across|beside|up to|there|where|when|as)\b"
)
SIDE = re.compile(r"\b(left|right)\b")

# Sentences say what the ego then has to do; that is no part of the situation
REACTION = re.compile(
    r"(?:,| and)? ?\b(?:forcing|causing|requiring|necessitating|making it|leaving(?! (?:(?:the|an?|its|our|his|her) )?(?:[\w-]+ )?(?:bay|lane|kerb|curb|lay-by|parking|driveway|motorway|highway|freeway|road|roundabout|junction|stop|space))|so that|such that|which forces|"
    r"requires the ego|prompting|compelling)\b[^;.]*"
    r"|(?:,? (?:and|which|that|so it))? (?:forced?|forces|caused?|causes|obliged?|obliges|ma(?:de|kes?)|ha[ds]|left|leaves?|g[eo]ts?|sen[dt]s?|prompt(?:s|ed)|compel(?:s|led)) "
    r"(?:us|me|(?:our|my) (?:car|vehicle|driver)|the (?:ego|av|vut|sut|subject vehicle|robotaxi|driver of the ego))\b(?!'s| off\b)[^;.,]*?(?= then | before | until |[;.,]|$)"
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


def rewritten(text: str) -> str:
    """A text in words that the patterns know."""
    for pattern, meant in REWRITES:
        text = pattern.sub(meant, text)
    moved = None if _TURNS_IN.search(text) else _WHITHER.search(text)
    if moved is None or _NOT_BESIDE.search(text[: moved.start()]):
        return text
    came = f"{moved[1]} from the {_OTHER_SIDE[moved[2]]} lane{moved[3]}"
    return f"{text[: moved.start()]}{came}{text[moved.end() :]}"


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


# Words that say nothing beyond what a rule has read, and those that say what is always so
_PLAIN_WORDS = """
    positioned situated located
    a an the and or of in on at to for from by with as while when where who which that this these those it its itself he
    she his her him they them their there here we us our ours be is are was were been being am has have had having do
    does did will would can could may might must shall should then just after before into onto over out off up down
    through along across again so but if than very too also both each other own some any all one no not only about
    around toward towards until because during within near nearby side sides front back rear way path lane lanes road
    roads street streets car's ego ego's vehicle vehicles driver traffic position direction point place

    sudden suddenly abrupt abruptly unexpected unexpectedly sharply hard heavily immediately instantly once warning
    right left straight ahead forward forwards close

    drive drives driving drove driven go goes going went gone come comes coming came move moves moving moved travel
    travels travelling traveling ride rides riding rode walk walks walking walked start starts
    begin begins keep keeps stay stays stand stands standing proceed
    proceeds proceeding continue continues continuing approach approaches approaching want wants
    try tries trying head heads heading arrive arrives collision collide collides
    without another soon first light lights stretch
    crash crashes dangerous danger test scenario situation scene dry daylight day daytime sunny clear
"""
_PLAIN = frozenset(_PLAIN_WORDS.split())

# Words that are part of what somebody does: alone they tell nothing, unless it was read wrongly
_DEED_WORDS = """
    run runs running ran turn turns turning leave leaves leaving hit hits hitting strike strikes struck follow follows
    following enter enters entering pull pulls pulling step steps stepping get gets getting take takes make makes making
    collide collides crashes
"""
_DEEDS = frozenset(_DEED_WORDS.split())


_ENGLISH_WORDS = """
    the and of on at to from by with as while when where who which that this it its he she his her we us our is are was
    were be been has have had then just after before into onto over out off up down through along across behind front
"""
_ENGLISH = frozenset(_ENGLISH_WORDS.split())
_OTHER_WORDS = """
    der die das den dem des ein eine einen einem einer und ist wir uns von vor nach mit auf aus im bei zu rechts links
    el la los las un una uno y que del con por para desde hacia nos se en su derecha izquierda delante
    le les une et est nous du de des qui dans avec sur depuis devant vers notre gauche droite au
    il lo gli i che di da dal dalla nel nella con per noi davanti sinistra destra verso
    het een van naar voor wij ons onze os um uma
"""
_OTHER = frozenset(_OTHER_WORDS.split()) - {"die", "per", "i", "van", "no"}  # English has these as well


def is_english(text: str) -> bool:
    """Whether a text looks English: by its letters, and by the small words that every language has its own of."""
    letters = [c for c in text if c.isalpha()]
    if sum(c > "\u024f" for c in letters) * 2 > len(letters):
        return False
    small = re.findall(r"[^\W\d_]+", text)
    other = sum(word in _OTHER for word in small)
    return other < 2 or other <= sum(word in _ENGLISH for word in small)


@lru_cache(maxsize=1)
def _rules() -> tuple[re.Pattern[str], ...]:
    """Every pattern that reads something."""
    groups = (KINDS, OCCLUDERS, PLACES, CONTROLS, ACTIONS, LIGHTS, WEATHERS, SURFACES, EGO_STATES)
    single = (
        EGO, SOMEBODY, ADVERSARIAL, LEADER, BLOCKING, BACKGROUND, LEFT_TURN, RIGHT_TURN, LANE_CHANGE, BYPASS, UNPROTECTED,
        RUNNING, CUTTING_IN, SLOWING, FEINT, MATCHING, ERRATIC, GOING_ON, ONCOMING, FAR, CROSSING, NEIGHBOUR, KERB, NEAR,
        FAR_AWAY, GROUP, MANY_LANES, ONE_LANE, TWO_WAY, EACH_WAY, ONE_WAY, SIDE_ROAD, SAME_LANE, BEHIND, AHEAD, BESIDE,
        SIDE, HIDING, ENCOUNTER, FOREIGN, NO_LIGHT, NO_WEATHER, SLIPPERY, HARDLY_SEEN, REACTION,
    )  # fmt: skip
    return (*(pattern for group in groups for pattern in group.values()), *single)


def known_to_no_rule(text: str) -> list[str]:
    """The runs of words that no rule reads and that mean something, as they stand in a text.

    Args:
        text: Lower case, mended; numbers are left to those who read numbers.
    """
    read = bytearray(len(text))
    for rule in _rules():
        for found in rule.finditer(text):
            read[found.start() : found.end()] = b"\1" * (found.end() - found.start())
    runs: list[tuple[int, int]] = []
    for word in re.finditer(r"[^\W\d_]+(?:['-][^\W\d_]+)*", text):
        if word[0] in _PLAIN or word[0] in _DEEDS or all(read[word.start() : word.end()]):
            continue
        if runs and text[runs[-1][1] : word.start()] == " ":
            runs[-1] = (runs[-1][0], word.end())
        else:
            runs.append(word.span())
    return list(dict.fromkeys(text[start:end] for start, end in runs))
