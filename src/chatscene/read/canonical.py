"""One way of writing for whatever a sentence says: case, white space, the full stop and the ego's name carry nothing.

An encoder hears them all the same, so that the same situation would be read in two ways; whoever reads a sentence
reads its canonical form, and the user's own words are what is shown.
"""

from __future__ import annotations

import re

_END = re.compile(r"[\s.!?…]+$")
_APOSTROPHES = str.maketrans("\N{RIGHT SINGLE QUOTATION MARK}\N{LEFT SINGLE QUOTATION MARK}", "''")

# A lone speaker drives as well as several
_SPEAKER: tuple[tuple[re.Pattern[str], str], ...] = tuple(
    (re.compile(rf"\b(?:{said})\b"), meant)
    for said, meant in (
        ("i'm|i am|we're|im(?= \\w)", "we are"),
        ("am i", "are we"),
        ("i was", "we were"),
        ("was i", "were we"),
        ("i've|we've|ive", "we have"),
        ("i(?=[ ',;:]|$)", "we"),
        ("me", "us"),
        ("my", "our"),
        ("mine", "ours"),
        ("myself", "ourselves"),
        ("you're|u're|you are|ur(?= \\w+ing)", "we are"),
        ("you've", "we have"),
        ("your|ur", "our"),
        ("yours", "ours"),
    )
)
_TELEGRAM = re.compile(r" STOP(?= (?!SIGN|LINE|AT|IN|ON|AND)|$)")  # where a full stop would stand
_READER = re.compile(  # who is told the scene drives in it
    r"(?<!could )(?<!can )(?<!would )(?<!will )(?<!thank )\b(?:you|u)\b(?![- ]turn)"
)
_EGO = re.compile(r"\b(?:(?:the|our|an?) )?ego(?: vehicle| car)?(?P<owns>'s)?(?![\w-])")
# Before an ego to which something is done; elsewhere it does something, if a verb follows
_TO_IT = re.compile(
    r"\b(?:of|behind|towards?|to|at|past|into|onto|across|beside|alongside|near|for|with|from|against|off|up|around|"
    r"ahead|by|than|on|parallel|(?:hit|block|cut|pass|overtak|follow|forc|mak|fac|avoid|tailgat|approach|ram|push|clip|strik|surpris|"
    r"threaten|endanger|undertak|caus|leav|giv)(?:s|es|e|ing|ed|ting|ping)?) $"
)
_OPENS = re.compile(r"(?:^|[.,;:!?(]\s*|\b(?:as|when|while|whilst|and|but|if|where|because|until|then|that|once|so) )$")
_NO_VERBS = ("as", "across", "towards", "its", "his", "this", "us", "always", "sideways", "perhaps", "afterwards")
_ADVERB = r"(?:(?:\w+ly|just|still|then|now|already|also|always|soon|never) )"
_VERB = re.compile(
    rf"(?P<between> {_ADVERB}{{0,2}})(?P<verb>[a-z]+s|[a-z]+ed|will|shall|must|can|could|should|would|had|"
    r"went|drove|came|took|made|began|stood|rode|got|kept|ran)\b"
)
# What an ego goes on to do: "turns left and stops"
_GOES_ON = re.compile(
    rf"(?P<before>\b(?:and|then|or) {_ADVERB}?)(?P<verb>(?:turn|drive|go|change|overtake|pass|stop|brake|wait|start|"
    r"merge|move|pull|continue|follow|accelerate|slow|approach|enter|cross|keep|come|try|want|head|swing|steer|reverse|leave)e?s|tries|crosses|passes)\b"
)
_CLAUSE_ENDS = re.compile(r"([.,;:!?]|\b(?:that|who|which|whose|as|when|while|because)\b|$)")
_PLURAL = {"is": "are", "was": "were", "has": "have", "does": "do", "goes": "go"}


def canonical(text: str) -> str:
    """A text in lower case with single spaces and one full stop, in which the ego is "we", "us" and "our".

    Args:
        text: What a user wrote; only what can be printed counts.

    Returns:
        The canonical form; only a full stop if nothing is said.
    """
    shown = " ".join("".join(c if c.isprintable() else " " for c in text).split())
    if len(_TELEGRAM.findall(shown)) > 1:  # one alone is an act
        shown = _TELEGRAM.sub(".", shown)
    plain = shown.lower().translate(_APOSTROPHES)
    plain = _END.sub("", plain)
    for pattern, meant in _SPEAKER:
        plain = pattern.sub(meant, plain)
    plain = _READER.sub(lambda m: "us" if _TO_IT.search(m.string[: m.start()]) else "we", plain)
    told, rest = "", plain
    while (ego := _EGO.search(rest)) is not None:
        told += rest[: ego.start()]
        name, rest = _named(told, ego, rest[ego.end() :])
        told += name
    return f"{told}{rest}."


def _named(before: str, ego: re.Match[str], after: str) -> tuple[str, str]:
    """What an ego is called where it stands, and the rest of the text with the verb that goes with it."""
    if ego["owns"]:
        return "our", after
    verb = _VERB.match(after)
    does = verb is not None and verb["verb"] not in _NO_VERBS
    if _TO_IT.search(before) or not (does or _OPENS.search(before)):
        return "us", after
    if verb is None or not does:
        return "we", after
    clause, mark, others = _CLAUSE_ENDS.split(after[verb.end() :], maxsplit=1)
    clause = _GOES_ON.sub(lambda m: m["before"] + _plural(m["verb"]), clause)
    return "we", f"{verb['between']}{_plural(verb['verb'])}{clause}{mark}{others}"


def _plural(verb: str) -> str:
    """A verb of the third person as we use it of ourselves."""
    if verb in _PLURAL:
        return _PLURAL[verb]
    if verb.endswith("ies"):
        return verb[:-3] + "y"
    if re.search(r"(?:ss|sh|ch|x|zz|o)es$", verb):
        return verb[:-2]
    return verb.removesuffix("s") if not verb.endswith("ss") else verb
