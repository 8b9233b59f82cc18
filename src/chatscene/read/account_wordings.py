"""Other words for the same, put in their place before `chatscene.read.account` reads anything.

Each is a regular expression over canonical text, with what it is replaced by; they are taken in their order.
"""

from __future__ import annotations

import re

from chatscene.read.account_rules import PART_NOUN

_NOUN = r"(?:car|vehicle|truck|lorry|bus|van|taxi|suv|sedan|cyclist|bicyclist|bicycle|bike|motorcyclist|motorcycle|motorbike|pedestrian|e-scooter|scooter|minivan|trailer|pickup|wheelchair|dog|deer|ambulance)"
_OVERTAKEN = r"(?:(?:an?|the|another|some|its|his) (?!us\b)(?:[\w-]+ ){0,2}?(?!us\b)[\w-]+)"
_OVERTAKING = rf"(?:which |who |that )?(?:(?:is|was|starts?|begins?|tries|decides|has) (?:to )?)?(?:(?:pull|swing|move|come|veer|pop)(?:s|ed|ing)? (?:out )?(?:to |and ))?(?:overt(?:ak|ook)\w*|pass(?:es|ed|ing)?) {_OVERTAKEN}"
# Whoever is not named by a kind; the last three only where no word before says which wheels
_WHOEVER = r"(?:guy|idiot|bloke|somebody|someone|clown|numpty|muppet|moron|fool|lunatic|maniac|nutter|twit|prat|joker|cowboy|boy racer|(?<![\w-] )(?:chap|dude|fella)|(?<=\bthe )(?:chap|dude|fella)|(?<=\ba )(?:chap|dude|fella)|(?<=\bsome )(?:chap|dude|fella))"
_PREPARED: tuple[tuple[re.Pattern[str], str], ...] = tuple(
    (re.compile(pattern), meant)
    for pattern, meant in (
        (r"\b(left|right)-turner\b", r"car that turns \1"),
        (r"\bovertaker\b", "car that overtakes us and"),
        (r"\btailgater\b", "car that tailgates us"),
        (r"\bfollower\b(?! (?:" + _NOUN + r"))", "car behind us"),
        (r"\bfollower (?=" + _NOUN + r")", "following "),
        (r"\b(?:ghost|wrong[ -]way) (driver|biker|rider|cyclist|motorcyclist)\b", r"\1 driving the wrong way"),
        (r"\b(?:the |an? )?(?:npc|opponent|adversary|evt|tgt(?:_\w+)?)\b(?! (?:agent|is an?|: |(?:\w+ )?" + _NOUN + r"))", "the car"),
        (r"\badult\b(?=,| (?:walk|cross|step|run|stand|enter|emerg|from|on\b|target))", "pedestrian"),
        (r"\b(?:ptws?|powered two-wheelers?)\b", "motorcycle"),
        (r"\bkick ?board\b", "e-scooter"),
        (r"\b((?:drift|merg|mov|edg|eas|com)\w*) (?:slow|gradual|gent|stead|lateral)ly (?=(?:over |back |out )?(?:in|into|across|over)\b)", r"\1 "),
        (r"\bpassenger(?:'s)?[ -]side\b", "right side"),
        (r"\bdriver(?:'s)?[ -]side\b", "left side"),
        (r"\((left|right)\)", r"\1"),
        (r"(left|right) side (?:left|right)\b", r"\1 side"),
        (r" ?\((?:[^()]*)\)", ""),
        (r"\b((?:(?:a|an|the|another) )?)(lane-splitting|passing|overtaking|double-parked|reversing|merging|tailgating|wrong[ -]way|turning) ((?:box |delivery |semi-?)?(?:car|vehicle|truck|bus|van|taxi|suv|sedan|motorcyclist|motorcycle|cyclist|bicyclist|minivan|trailer|lorry|scooter)(?: truck)?)\b", r"\1\3 \2"),
        (r"\bsemi(?:[ -]?truck|[ -]?trailer(?: truck)?)?\b|\btractor[ -]?trailer\b|\bbig rig(?: truck)?\b", "truck"),
        (r"\ban auto\b", "a car"),
        (r"\b(?:standing|waiting|parked|stopped) at (?:the|a|its) (?:bus )?stop\b(?![ -](?:sign|line))", "parked"),
        (rf"\b(?:\w+ )?(?:{_WHOEVER}|person|man|woman|juvenile|child|girl|boy|rider|one) (?:on|riding|operating|driving) (?:an? |one of those |his |her )?(?=(?:electric |kick |rental |hire |hired |shared )*(?:e-?)?scooters?\b|(?:e-)?bike|bicycle|motorcycle|motorbike|moped)", ""),
        (r"\b(?:without|with) (?:using |giving |any )?(?:an? |its |the )?(?:left |right |turn |direction )?(?:signal(?:ling|ing)?|indicat\w+)(?: on)?\b|\bturn(?:ing)? (?:signals?|indicators?)(?: on)?\b|\b(?:headlights?|brake lights?|no lights? on|without lights?)\b", ""),
        (rf"\b(?:some |a |an |the )?(?:{_WHOEVER}|man|woman|lady|person) (?:in|driving) (?:an? |her |his )(?=(?:\w+ )?(?:car|van|truck|lorry|suv|pickup|taxi|bus)\b)", "a "),
        (rf"\b(?:some |a |an |the )?(?:{_WHOEVER}|driver)(?= (?:coming the other|coming towards|overt|cut|pull|doing|in front|ahead|beside|next to|alongside|facing|opposite|behind|coming|accelerat|speed|sped|brak|turn|chang|merg|tailgat|swerv|drift|revers|back))", "a car"),
        (r"\b(?:the|a|our) (stopped|stationary|parked|standing|waiting) us\b", r"us, we were \1,"),
        (r"\b(?:the|a|our) (stopped|stationary|parked|standing|waiting) we\b", r"we were \1 and we"),
        (r"\bus (lane|path|way)\b", r"our \1"),
        (r"\bwheelchair users?\b", "wheelchair"),
        (r"\b(?:that|this|said|these|those) (?=(?:same |other )?(?:car|vehicle|truck|bus|van|cyclist|bicyclist|pedestrian|motorcycl|suv|scooter))", "the "),
        (r"\b(?:somebody|someone)(?= (?:\w+ )?(?:walk|step|run|ran|cross|wander|jog|stroll))", "a person"),
        (r"\b(?:our|we) (?:own )?(?:taxi|shuttle|cab|van|bus|minibus|truck|lorry)\b(?! (?:lane|stop|bay))", "we"),
        (r" (?:to|for) (?:which|whom) we (?:have to |must )?(?:give way|yield|wait)\b", ""),
        (r" that (?:is|are) (?:blocking|parked in|standing in) (?:its|our|the) lane\b", " parked in our lane"),
        (r"\b(?:must|cautiously) ", ""),
        (r"\b(and|and suddenly|suddenly) encounters\b", r"\1 we encounter"),
        (r"\b(?:jaywalking) (pedestrians?|persons?)\b", r"\1 who crosses the road"),
        (r"\b(?:monitoring|watching|checking for|looking out for) (?:the )?(?:oncoming |other |cross )*traffic\b", ""),
        (r"\bmotor scooterist", "motorcyclist"),
        (r"\b(?:stand-up |electric |e-)scooterist", "e-scooter"),
        (r"\bscooterist", "motorcyclist"),
        (r"\belectric scooter", "e-scooter"),
        (r"\b(?:passenger|motor) (?=vehicle)", ""),
        (r"\b(?:and|then) (?:was|were) (?=stopped|struck)", "and we were "),
        (r"\b(the|a|an) ((?:[\w-]+ )?)(?:the )(other vehicle|ego)\b", r"\1 \2\3"),
        (r"\b((?:stationary|slow-moving|oncoming|stopped|slow|leading|lead|following|overtaking|crossing|parked)) the other vehicle\b", r"\1 car"),
        (r"\b(?:the |a )?(?:pov|tv|gvt|ov|lv)\d?\b", "the car"),
        (r"\b(?:the |a |our )?(?:third[ -]party|other (?:driver|motorist|party|person)|(?:guy|someone|somebody|idiot|driver|person|one)(?= behind)|idiot in|some idiot in)(?! (?:vehicle|car))\b", "the car"),
        (r"\bthird[ -]party (?=vehicle|car)", "other "),
        (r"\b(the|a|another|an) ((?:(?!us\b)[\w-]+ )?(?!us\b)[\w-]+)'s ((?:\w+ ){0,4}(?:" + PART_NOUN + r"))\b", r"the \3 of \1 \2"),
        (r"\b(?:posted|marked) (?=stop sign)", ""),
        (r"\b(4|four|3|three)-way stop\b(?! sign)", r"\1-way intersection"),
        (r"\b(do|does|did|is|was|wo|ca|has|would|could)(?:nt|n t)\b", r"\1 not"),
        (r"\b(it|he|she|they) not (?=\w)", r"\1 does not "),
        (r"\binfront\b", "in front"),
        (r"(?<!\bthe )(?<!\ba )(?<!\ban )(?<!\bour )\b(left|right) (kerb|curb|sidewalk|pavement)\b", r"at the \1 \2"),
        (r"\bthere(?:'s| is| was| are| were) (?=(?:an?|the|some) )", ""),
        (r"(?<![\w-])op(?=(?:'s)? (?!-))\b", "the other car"),
        (r"\b(?:id|insured) states:? ", ""),
        (r"\b(?:shall|should|must) be\b", "is"),
        (r"\b(?:shall|should|must) (?!not\b)", ""),
        (r"\b(?:mannequin|jaywalker)\b", "pedestrian"),
        (r"\b(?:(?:rural|country),? (?:two|2)[- ]lane|(?:two|2)[- ]lane,? (?:rural|country)) (?:road|highway|lane)\b", "rural road"),
        (rf"\b((?:an?|the|another|some|one) (?:oncoming|opposing|opposite) (?:\w+ )?{_NOUN}),? (?:{_OVERTAKING})", r"\1 drives the wrong way in our lane"),
        (rf"\b((?:an?|the|another|some|one) (?:\w+ )?{_NOUN}) ((?:coming|driving|travelling) (?:the other way|from the opposite direction|towards? us|in the (?:opposite|oncoming) lane)),? (?:{_OVERTAKING})", r"\1 \2 drives the wrong way in our lane"),
        (r"\bpowered two-wheelers?\b", "motorcycle"),
        (r"\btransporter\b", "van"),
        (r"\bred-light runner\b", "car that runs the red light"),
        (r"\bwrong-way driver\b", "car driving the wrong way"),
        (r"\bthe lane of us\b", "our lane"),
        (r"\b(left|right)-turning (" + _NOUN + r")\b", r"\2 that turns \1"),
        (r"\bstraight-going (" + _NOUN + r")\b", r"\1 going straight"),
        (r"\b(?:masked|covered|blocked from view|obstructed|screened|obscured|hidden until \w+)(?: from view)? by\b", "hidden by"),
        (r"\bhidden by (?:two |some )?parked (?:\w+ )?vehicles\b", "hidden by parked cars"),
        (r"(?<!the )(?<!a )\blead (?=(?:slams?|brakes?|stops?|slows?|decel))", "the lead vehicle "),
        (r" \+ ", " and "),
        (r"\bmoto\b", "motorcycle"),
        (r"\b(?:lane change|lc)[ -]?l\b", "lane change left"),
        (r"\b(?:lane change|lc)[ -]?r\b", "lane change right"),
        (r"\b[up]?lt\b(?! lane)", "left turn"),
        (r"\b[up]?rt\b(?! lane)", "right turn"),
        (r", signal(?=[,.])", ", with traffic lights"),
        (r"\b(?:challenging|object|conflicting|offending|unknown|involved) (?=" + _NOUN + r"\b)", ""),
        (r"(?<!a )(?<!the )(?<!an )\b(?:4|four)-way\b(?! (?:intersection|junction|stop|crossing))", "at a four-way intersection"),
        (r"(?<!a )(?<!the )(?<!an )\b(?:3|three)-way\b(?! (?:intersection|junction|stop|crossing))", "at a three-way intersection"),
        (r"\b(?:at|with) (?:an? |the )?(?:unchang\w+|steady|constant|uniform|even) (?:speed|pace|velocity)\b", "at a constant speed"),
        (r"\blane,? (?:where|in which|and there)\b", "lane, in that lane"),
        (r",? and behind (?:it|him|her|that)\b", ", and"),
        (r"\b(the (?:\w+ )?" + _NOUN + r") (?:that |which |whom )?we (?:are |were )?follow(?:ing)?\b(?! (?:the|an?) )", r"\1 ahead of us"),
        (r"\b(?:the |our |a )?leader\b", "the vehicle ahead of us"),
        (r"\b(which|who|that) then\b", r"\1"),
        (r"\bus,? (?:which|who|that) (stood|waited|had stopped|had come to a (?:stop|halt))\b", r"us, we \1,"),
        (r"(?<!parked )(?<!standing )(?<!waiting )(?<!stopped )\b(?:by|at|near|towards?|to|for|before|past|opposite|outside) (?:the|an?|its|his|her) (?:bus|tram|coach) (?:stop|station|shelter)\b", ""),
        (r"(?<!ahead of )(?<!behind )(?<!beside )(?<!left of )(?<!right of )\bus, (?:which|who) (?:is|are|was|were) (?=(?:proceed|driv|head|go|travell?)ing (?:straight |on )*(?:north|south|east|west)|turning (?:left|right))", "us, we were "),
        (r"\be scooter", "e-scooter"),
        (r"\bbetwen\b", "between"),
        (r"\bcomming\b", "coming"),
        (r"\bbreaks (?=hard|suddenly|abruptly|sharply)", "brakes "),
        (r"^((?:(?!adversar).)*?)\b(?:the|an?) adversar(?:y|ial) (?=(?:\w+ )?" + _NOUN + r"\b)", r"\1another "),
        (r"\b(?:adversar(?:y|ial)|npc|background|opponent|hostile)(?::| agent:?)? (?=(?:\w+ )?" + _NOUN + r"\b)", ""),
        (r"\bopposite (?=" + _NOUN + r"\b)", "oncoming "),
        (r"\b(left|right)[- ]lane (" + _NOUN + r")\b", r"\2 in the \1 lane"),
        (r"\b(an?|the|another) ((?:(?:north|south)(?:east|west)?|east|west)[- ]?bound) ((?:\w+ )?" + _NOUN + r")\b", r"\1 \3 heading \2"),
        (r"\b(?:with|walking|pushing|and) (?:an?|his|her|their|the) (?:dog|pram|pushchair|stroller|buggy|trolley|suitcase|umbrella)\b(?! (?:runs?|ran|darts?|dashe[sd]|jumps?|leaps?|bolts?|trots?|crosses)\b)", ""),
        (r"\b(?:in|of) ours\b(?! )", "in our lane"),
        (r"\binto ours\b", "into our lane"),
        (r"\bus,? (?:which|who|that) (?:is|are|was|were) (stationary|stopped|standing|waiting|not moving|parked)\b", r"us, we were \1,"),
        (r"\b(?:is|are|was|were|had been) not moving\b", "were stationary"),
        (r",? not moving\b", ", stationary"),
        (r", (?:from )?behind (?=(?:parked )?(?:car|van|truck|bus|hedge))", ", hidden behind a "),
        (r"\b(out|comes?|runs?|steps?|darts?|walks?|dashes)( out)? behind (?=(?:an?|the|some|two|parked) )", r"\1\2 from behind "),
        (r"\boccluded (?=by|behind)", "hidden "),
        (r"\bbetween (?:the |two |some )?(?:parked )?(cars|vehicles)\b", "from between parked cars"),
        (r"\b(from|out from) from between\b", "from between"),
        (r"\bout of (?=(?:an?|the) (?:hedge|bush|bushes)\b)", "from behind "),
        (r"\bit's\b", "it is"),
        (r"'s\b(?= (?:in|on|at|going|coming|turning|standing|driving|not|just|still|behind|changing)\b)", " is"),
    )
)  # fmt: skip


def prepared(text: str) -> str:
    """An account in the words that the rules and phrases know."""
    for pattern, meant in _PREPARED:
        text = pattern.sub(meant, text)
    return text
