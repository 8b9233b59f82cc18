"""What words mean on the road: a text is cut into clauses by them for snippets, and sentences are made up with them.

Patterns are matched against lower-case text. They are our own, collected from crash reports, driving schools and the
way people talk.
"""

from __future__ import annotations

import re

from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.scenario import Occluder, Place


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
    if kind.row.words and not kind.lies  # things do nothing
}
ENCOUNTER = _p(
    r"encounter\w*|meets?|faces?|notices?|sees?|spots?",
    r"(?:surprised|cut off|cut up|overtaken|passed|hit|approached|blocked|struck|confronted|followed|tailgated) by",
)
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

# What the adversary does

# Turns stand apart: the ego makes them as well, in the same words
ACTIONS: dict[Action, re.Pattern[str]] = {
    action: _p(action.row.words) for action in Action if action.row.words and not action.row.turn
}
# Sentences say what the ego then has to do; that is no part of the situation
REACTION = re.compile(
    r"(?:,| and)? ?\b(?:forcing|causing|requiring|necessitating|making it|leaving(?! (?:(?:the|an?|its|our|his|her) )?(?:[\w-]+ )?(?:bay|lane|kerb|curb|lay-by|parking|driveway|motorway|highway|freeway|road|roundabout|junction|stop|space))|so that|such that|which forces|"
    r"requires the ego|prompting|compelling)\b[^;.]*"
    r"|(?:,? (?:and|which|that|so it))? (?:forced?|forces|caused?|causes|obliged?|obliges|ma(?:de|kes?)|ha[ds]|left|leaves?|g[eo]ts?|sen[dt]s?|prompt(?:s|ed)|compel(?:s|led)) "
    r"(?:us|me|(?:our|my) (?:car|vehicle|driver)|the (?:ego|av|vut|sut|subject vehicle|robotaxi|driver of the ego))\b(?!'s| off\b)[^;.,]*?(?= then | before | until |[;.,]|$)"
)
