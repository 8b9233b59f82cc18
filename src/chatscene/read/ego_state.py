"""What the ego does at the pedals: that it stands, sets off, drives slowly, slows down, brakes or stops on its way.

A text says that in two ways, of which only one is meant here: what the ego does anyhow ("we wait at a red light", "as
we brake for a crossing") and how it reacts to the adversary ("a car cuts in, we brake"), which is its own affair. Who
stands or crawls does not do so in answer to anybody; who brakes or stops does, unless words give another reason, come
before anybody else is spoken of, or make it the circumstance of what happens then.
"""

from __future__ import annotations

import re

from chatscene.terms.scenario import EgoState

_WE = r"\b(?:we|(?:(?:the|our|an?) )?ego(?: vehicle| car)?|our (?:car|vehicle|taxi|van))(?: ?\([^)]*\))?(?:'d|'ve)?"
_MODE = r"(?:(?: \w+ing)?,? (?:in|under) (?:\w+ ){1,2}(?:mode|control)\b,?)?(?: \([^)]*\))?"  # of a report
_ADVERBS = (
    r"(?: (?:just|already|still|now|then|also|all|only|first|fully|completely|safely|gently|slowly|have|has|had|there|"
    r"here))*"
)
_ARE = rf"{_ADVERBS} (?:are|were|was|is|am|been){_ADVERBS}(?: been)?{_ADVERBS}"
_DO = rf"{_ADVERBS}(?: (?:are|were|was|is|beg[ia]n to|start(?:ed)? to|ha(?:ve|d) to|will))?{_ADVERBS}"
_WHILE = r"(?:^|(?<=[.;] )|(?<=: ))(?:while |whilst |when )?"  # at the beginning, of whoever is not named: the ego
_WHAT = (  # what a driver waits for
    r"(?:(?:a|the|our|some) )?(?:red|(?:\w+ )?(?:lights?|signals?|queue|jam|traffic|crosswalk|crossing|junction|"
    r"intersection|toll\w*)|(?:stop(?: |-))?sign|line|gap|green|oncoming)"
)
_AT = r"(?:at|in|on|behind|before|for)"

_GREEN = r"(?: (?:at|on|when the (?:traffic )?lights? (?:turns?|goes|go|turned|went)) green\b)?"

_STANDS = (
    rf"{_WE}{_MODE}{_ARE} (?:stopped|stationary|standing|queue?ing|queued|halted|parked|at rest|motionless|stalled)\b"
    rf"(?: {_AT} {_WHAT}\b)?",
    rf"{_WE}{_MODE}{_ARE} (?:disabled|broken down|yielding|waitin|at red|waiting (?:to|until|with|there))\b",
    rf"{_WE}{_MODE}{_ARE} at a (?:complete |full )?(?:standstill|stop(?![ -]sign)|halt)\b",
    rf"{_WE}{_MODE}{_ARE} stuck in (?:traffic|an? (?:traffic )?jam|an? queue|the queue)\b",
    rf"{_WE}{_ARE} waiting (?:at|in|on|behind|before|patiently)\b",
    rf"{_WE}{_ARE} (?:waiting|sitting|sat|queue?ing) (?:first |there |here )?{_AT} {_WHAT}\b",
    rf"{_WE} (?:waits?|waited|stands?|stood|queues?|queued|sits?|sat)(?: still| patiently| first)? {_AT} {_WHAT}\b",
    rf"{_WE} (?:waits?|waited) to (?:turn|go|let|cross|enter|merge)\b",
    rf"{_WE} (?:stands?|stood|sits?|sat) still\b",
    rf"{_WE}(?: (?:have|has|had))? br(?:oken?|eaks?) down\b",
    rf"{_WE}(?:{_ARE})? (?:first |sat |just )*(?:at|on) (?:a |the )?red\b",
    rf"{_WHILE}(?:stopped|stationary|waiting|standing|queued|queue?ing|sitting|halted) {_AT} {_WHAT}\b"
    r"(?! (?:to|on|of|from) (?:the |our )?(?:left|right))",
    rf"(?:{_WE}|\bus|\bego),? (?:stationary|at rest|standing|halted)\b",
    r"\bthe (?:stationary|stopped|standing|waiting|disabled|broken-down) ego\b",
    r"\bour (?:stationary|stopped|standing|waiting|disabled|broken-down) (?:car|vehicle|taxi|van)\b",
)
_SETS_OFF = (
    rf"{_WE}{_DO} set(?:s|ting)? off\b{_GREEN}",
    rf"{_WE}{_DO} (?:pull|mov|driv|drov)(?:e|s|es|ed|ing)? (?:away|off)\b{_GREEN}",
    rf"{_WE}{_DO} start(?:s|ed|ing)? (?:off|up|moving|rolling|to (?:move|roll|drive|go)|(?:at|on) green)\b",
    rf"\b(?:lights?|signals?|it) (?:turn(?:s|ed)?|goes|went|go|changed to|became|becomes) green,?(?: and| n| so)?"
    rf" {_WE}(?: then)? (?:go|goes|went|start\w*|dr[io]ve|pull\w*|launch\w*)\b",
    rf"{_WE}{_DO} start(?:s|ed|ing)? from (?:a |the )?(?:stand\w*|rest|stop|line|lights?)\b",
    rf"{_WE} (?:gets?|got) (?:going|moving)\b",
)
_SLOW = (
    rf"{_WE}{_DO} (?:crawl|creep|crept|inch|dawdl|trundl)(?:e|s|es|ed|ing)?\b",
    rf"{_WE}{_DO} (?:driv|drov|go|mov|travel|roll)(?:e|s|es|ed|ing)?(?: along| forward| on)?(?: very| quite)?"
    r" (?:slowly\b|at (?:a )?(?:walking|snail's|crawling|very low|low) (?:pace|speed)\b|at a crawl\b)",
    rf"{_WE}(?: (?:are|were|was|is))? slowly \w+ing\b",
)
_SLOWS_DOWN = (
    rf"{_WE}{_MODE}{_DO} slow(?:s|ed|ing)?\b(?! (?:car|vehicle|ourselves))(?: down)?",
    rf"{_WE}{_MODE}{_DO} (?:decelerat\w+|eas\w+ off|lift\w* off|reduc\w+ (?:its |our )?speed)\b",
    rf"{_WHILE}(?:slowing|decelerating)(?: down)?\b",
)
_BRAKES = (
    rf"{_WE}{_MODE}{_DO} (?:hard-)?brak(?:e|es|ed|ing)\b(?! check)",
    rf"{_WE}{_MODE}{_DO} (?:appl\w+|hit|slam\w*(?: on)?|step\w* on) (?:the |our |its )?brakes\b",
    rf"{_WE}{_DO} (?:do(?:es)?|did|ma[kd]e|perform\w*) an emergency (?:stop|braking)\b",
    rf"{_WHILE}braking\b",
)
_STOPS = (
    rf"{_WE}{_MODE}{_DO} stop(?:s|ped|ping)?\b(?!(?: |-)sign)",
    rf"{_WE}{_MODE}{_DO} (?:com(?:es?|ing)|came|slow\w*|brak\w+) to an? (?:\w+ )?(?:stop|standstill|halt)\b",
    rf"{_WE}{_DO} pull(?:s|ed|ing)? up (?:at|behind|before|for)\b",
    rf"{_WHILE}stopping\b",
)


def _any(patterns: tuple[str, ...]) -> re.Pattern[str]:
    return re.compile("|".join(f"(?:{pattern})" for pattern in patterns))


# The most telling first: who sets off stood, who stops has braked, who brakes has slowed down.
SAID: dict[EgoState, re.Pattern[str]] = {
    EgoState.SETS_OFF: _any(_SETS_OFF),
    EgoState.STANDS: _any(_STANDS),
    EgoState.STOPS: _any(_STOPS),
    EgoState.BRAKES: _any(_BRAKES),
    EgoState.SLOWS_DOWN: _any(_SLOWS_DOWN),
    EgoState.SLOW: _any(_SLOW),
}
"""How words say each state, with what the ego is called."""

_GOES_ON = _any(  # of who stood until then
    (
        r"\b(?:turn|turns|turned|goes|went|changes?|changed|comes? up|came up) (?:to )?green\b|\bgreen comes up\b",
        rf"{_WE} (?:then )?(?:proceed\w*|beg[ia]n to (?:proceed|move|accelerate|drive)|dr[io]ve|turned|entered|"
        r"go|goes|went)\b",
        r"(?:and|,) beg[ia]n to (?:proceed|enter|move|accelerate)\b",
    )
)
_GOES_ON_AT_ONCE = re.compile(
    r"(?: (?:at|for|before|behind) (?:(?:the|an?|its|our|my|your) )?(?:[\w-]+ ){0,3}?"
    r"(?:signs?|line|lights?|signal|red|stop))?"
    r"(?:(?:,|;| and)(?: then)?| then) (?:turn(?:s|ed)? (?:left|right|into)|(?:goes|go|went|proceed\w*|drives?|drove|"
    r"pull(?:s|ed)?) (?:straight|on|off|out|away|through|across|left|right|into))\b(?! (?:my|our|his|her|its|an?)\b)"
)  # told in the same breath
_REASON = re.compile(
    r"(?: (?:hard|sharply|gently|down|slightly|suddenly|abruptly|immediately|completely|briefly))*"
    r" (?:(?:as required )?at|for|behind|before|near|(?:be)?cause(?: of)?|in front of|"
    r"in response to|on (?:the )?approach|"
    r"to (?:turn|let|yield|give|enter|merge|make|park|check)|in (?:traffic|an? queue|the queue))\b"
)  # where the ego has one of its own
_ANSWERS = (EgoState.STOPS, EgoState.BRAKES, EgoState.SLOWS_DOWN)  # what may be how it reacts
_STOOD = (EgoState.STANDS, EgoState.STOPS)
_NOT_DONE = re.compile(  # as if we did, or somebody else beside us does
    r"\b(?:as if|as though|if|like|until|before|that|which|one|bay|space|"
    r"of|behind|beside|to|towards?|at|past|near|by|with) $"
)
_WHEN = re.compile(r"\b(?:as|while|whilst|when|after|since|once|where) $")
_INTO_US = re.compile(r"\bbehind (?:us|-)|\bfrom behind\b|\brear|\binto (?:us|our|-)|\bthe back of\b")
_THEY = re.compile(r"(?: (?:an?|the|another|some|two))?(?: (?!and\b)[\w-]+)? ")  # before somebody who is the reason


def ego_state_of(text: str, others: re.Pattern[str]) -> EgoState | None:
    """What a text says that the ego does at the pedals, apart from how it reacts.

    Args:
        text: Lower case, mended and rewritten, without what the ego then has to do.
        others: What names another road user.
    """
    named = re.sub(_WE, lambda own: "-" * len(own[0]), text)  # "our car" is nobody else
    for state, said in SAID.items():
        for found in said.finditer(text):
            before, after = named[: found.start()], named[found.end() :]
            onward = None
            if state in _STOOD:
                onward = _GOES_ON_AT_ONCE.match(text, found.end()) or _GOES_ON.search(text, found.end())
            if onward and not (others.search(before) or others.search(named, found.end(), onward.start())):
                return EgoState.SETS_OFF
            if _NOT_DONE.search(before) or (state in _ANSWERS and _reacts(before, after, others)):
                continue
            return EgoState.SETS_OFF if onward else state
    return None


def _reacts(before: str, after: str, others: re.Pattern[str]) -> bool:
    """Whether the ego slows down, brakes or stops because of the adversary, by what is said before and after that."""
    named = [other.start() for other in others.finditer(after)]
    reason = _REASON.match(after)
    if reason is not None and named and _THEY.fullmatch(after, reason.end(), named[0]):
        named = named[1:]  # who it stops for is not who runs into it
    if others.search(before):
        return not (_WHEN.search(before) or (reason is not None and _INTO_US.search(after)))
    return not named or not (_WHEN.search(before) or reason is not None or _INTO_US.search(after))
