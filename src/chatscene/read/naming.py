"""Names that reports use for what has a plain word: the ego under its maker's name, cars by theirs, streets, dates.

Reports of operators, the police and insurers call the ego "the Acme AV", "Vehicle 1" or "a test vehicle", others by make
and model, and every road by its name. Before anybody reads a text the ego becomes "the ego" and a make a car, and what
no scene can show is taken out and listed: when it was, on which street, by whom it was driven, what it broke.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

# The ego

_AUTOMATED = r"(?:[Aa]utonomous|[Aa]utomated|[Ss]elf-[Dd]riving|[Dd]riverless|ADS-equipped|[Rr]obotic)"
_CAR = r"(?:[Tt]est )?(?:[Vv]ehicle|[Cc]ar|[Ss]huttle|[Tt]axi|[Tt]ruck|[Vv]an|AV)"
_EGO = re.compile(
    rf"\b(?:(?:[Aa]n?|[Tt]he|[Oo]ur|[Tt]his|[Oo]ne) )?(?:(?!the\b|when\b|as\b)[\w.-]+ )??"
    rf"(?:{_AUTOMATED} {_CAR}|AV|[Tt]est[ -](?:vehicle|car)|[Rr]obotaxi|[Cc]ase [Vv]ehicle|[Ss]ubject [Vv]ehicle|ALKS vehicle|SV|[Ii]nsured(?:'s (?:vehicle|car))?|[Cc]lient's (?:vehicle|car)|PH|[Pp]olicyholder|[Ii]nsd|[Vv]eh(?:icle)? A|[Uu]nit A)(?![\w-])"
)
_MAKER = re.compile(
    rf"\b(?:An?|The|Our|[Ss]topped|a|the|our)(?: [a-z]+)? (?P<name>(?!Autonom|Automat|Driverless|Test)[A-Z][a-z]\w*(?: (?!Autonomous|Automat|AV)[A-Z]\w+)?)(?: {_AUTOMATED})?"
    r" (?:AV|[Vv]ehicle|test vehicle|car|shuttle|(?:truck|van|bus|taxi)(?= (?:\([^)]*\) )?(?:in|under|operating)))\b"
)
_BRACKETS = re.compile(r" ?\([^()]{1,60}\)")
_ALIAS = re.compile(r"[\"\u201c\u201d'\u2018\u2019]|(?:[Vv]ehicle|[Cc]ar|[Uu]nit) ?\d")
_REPORTS = re.compile(
    rf"\b(?:{_AUTOMATED}|AV|ADS|[Aa]utonomy|[Tt]est[ -](?:vehicle|car)|(?:manual|conventional|autonomous|automated)(?: driving)? mode)\b"
)
"""What the operators of automated vehicles speak of; others may own a make as well."""
_SPEAKER = re.compile(r"\b(?:[Ww]e|I)\b")

_OWN_LEADS = (
    "a", "an", "the", "our", "this", "one", "test", "robotaxi", "case", "autonomous", "automated", "self-driving",
    "driverless",
)  # fmt: skip
_HOW_IT_IS = ("stopped", "stationary", "parked", "waiting", "standing")
_SHUTTLE = re.compile(r"\b([Tt])he shuttle\b")
_OWN_DRIVER = re.compile(
    r"\b([Tt])he ego (?:operator|driver|safety driver|test driver|test operator|test specialist)s?\b"
)

# Others, by their place in a report

_PARTY = re.compile(
    r"\b(?:(?:[Vv]eh(?:icle|\.)?|[Uu]nit|[Cc]ar|VEHICLE|VEH|UNIT) ?(?:#|[Nn]o\.? ?)?1|[Vv]-?1|(?:[Vv]eh(?:icle)?|[Uu]nit) A|TP|[Cc]lmt|[Cc]laimant)\b"
)
_FIRST = re.compile(r"\b(?:[Tt]he )?(?:(?:[Vv]eh(?:icle|\.)?|[Uu]nit|[Cc]ar) ?(?:#|[Nn]o\.? ?)?1|[Vv]-?1)\b")
_THEIRS = re.compile(
    r"\b(?:TP|[Cc]laimant)(?:'s)? (?=(?:[\w-]+ )?(?:coach|bus|truck|van|lorry|trailer|semi-trailer|car|motorcycle)\b)"
)
_SECOND = re.compile(
    r"\b(?:[Tt]he )?(?:(?:[Vv]eh(?:icle|\.)?|[Uu]nit|[Cc]ar) ?(?:#|[Nn]o\.? ?|number )?2|[Vv]-?2|[Vv]eh(?:icle)? B|[Uu]nit B|TP(?: [Vv]ehicle)?(?!'s)|[Cc]laimant|[Cc]lmt)\b(?: ?\((?:an? )?(?P<kind>[\w -]+)\)|, an? (?P<kind2>[\w-]+))?"
)

# Streets

_WORD = r"(?:[A-Z][\w&'.-]+|\d+(?:st|nd|rd|th)|\[X+\]|[A-Z]\.)"
_STREET = (
    r"(?:[Ss]treets?|St|[Aa]venues?|Aves?|[Bb]oulevards?|Blvd|[Rr]oad|Rd|[Dd]rive|Dr|[Ll]ane|Ln|[Ww]ay|[Pp]lace|Pl|[Cc]ourt|Ct|"
    r"[Pp]arkway|Pkwy|[Tt]errace|Circle|Alley|Plaza|Square)\b\.?"
)
# Makes of cars as far as reports name them

_MAKES = (
    r"Acura|Alfa Romeo|Audi|BMW|Buick|Cadillac|Chevrolet|Chevy|Chrysler|Citroen|Dodge|Fiat|Ford|GMC|Honda|Hyundai"
    r"|Infiniti|Jaguar|Jeep|Kia|Land Rover|Lexus|Lincoln|Mazda|Mercedes(?:[- ]Benz)?|Mini Cooper|Mitsubishi|Nissan|Opel"
    r"|Peugeot|Pontiac|Porsche|Prius|Range Rover|Renault|Saab|Scion|Skoda|Subaru|Suzuki|Tesla|Toyota|Vauxhall"
    r"|Volkswagen|Volvo|VW"
)
_BODY = r"(?:[Ss]edan|[Cc]oupe|[Hh]atchback|SUV|suv|[Mm]inivan|[Pp]ickup(?: truck)?|van|car|vehicle|hybrid|convertible|truck|bus|motorcycle)"
_COLOURS = r"(?:black|white|red|blue|green|gr[ae]y|silver|yellow|orange|brown|gold|dark|light|older|newer|nearby)"
_MAKE = re.compile(
    rf"(?:\b(?P<article>[Aa]n?|[Tt]he|[Aa]nother) )?(?:(?:\d{{4}}|{_COLOURS}) )*(?:Model \w+ )?\b(?:{_MAKES})(?! {_STREET})"
    rf"(?: (?!AV\b|{_STREET})(?:[A-Z][\w-]*|\d[\w-]*)){{0,3}}(?: (?P<body>{_BODY}))?(?![\w-])"
)

# What no scene shows

_OPENS = r"(?:The|An?|Our|His|Her|Its?|He|She|We|They|Their|This|That|There|When|While|As|Then|Upon|Both|Another|Driver|Unit|Vehicle)\b"
# What begins a sentence behind "St." is no part of the street's name.
_NAMES = rf"{_WORD}(?: (?!(?<=\. ){_OPENS})(?:(?:and|&|de|of) )?{_WORD})*(?: {_STREET})?"
_NAMES_OF_STREET = rf"(?:{_WORD} )*(?:{_WORD} {_STREET}|\d+(?:st|nd|rd|th)(?: {_STREET})?|\[X+\])"
_COMPASS = r"(?:[Nn]orth|[Ss]outh|[Ee]ast|[Ww]est)(?:[ -]?(?:[Ee]ast|[Ww]est))?[ -]?[Bb]ound"
_MOTORWAY = re.compile(
    r"\b(?:the )?(?:Interstate|I-|Freeway|M) ?\d+(?: (?:[Ff]reeway|[Hh]ighway))?|\bUS[- ]\d+ [Ff]reeway"
)
_MODE = r"(?:fully |supervised |conventional |manual |driverless |automated |autonomous |human |test |AV |self-driving |Level \d |driving )*"
_MONTH = r"(?:January|February|March|April|May|June|July|August|September|October|November|December)"
_CLOCK = r"(?:\d{1,2}:\d\d|\d{1,2}(?= ?[ap]\.?m))(?: ?(?:[ap]\.?m\.?|[AP]\.?M\.?|hrs|hours))?(?: [PMCE][SD]?T)?"
_NOTHING: tuple[re.Pattern[str], ...] = (
    re.compile(
        rf"\b(?:[Oo]n|[Ii]n)? ?{_MONTH}(?: (?:\d{{1,2}}(?:st|nd|rd|th)?|\[X+\]))?(?:,? ?\d{{4}})?(?:,? at (?:approximately |about )?{_CLOCK})?,?"
    ),
    re.compile(rf"\b(?:[Aa]t|[Aa]round) (?:approximately |about )?{_CLOCK},?"),
    re.compile(
        rf",? ?\b(?:(?:while|was|being|and|which was) )*(?:(?:operating|driving|operated|driven|engaged) )?(?:in|under|with) (?:an? |the )?"
        rf"(?:{_MODE}(?:mode|control)|autonomy|(?:automated driving system|ADS) engaged)\b"
        r"(?: (?:with|by) (?:a|the) (?:safety|test|human) (?:operator|driver)(?: driving)?)?(?:,(?! (?:when|and|but)\b))?",
    ),
    re.compile(rf",? ?\boperating in {_NAMES}(?:, (?:California|CA|Arizona|AZ|Texas|TX))?,?"),
    re.compile(rf"\bbetween {_NAMES},?"),
    re.compile(rf"\b(?:with|of) {_NAMES}(?=[\s.,]|$)"),
    re.compile(
        rf"\b(?:on|onto|from|along|down|toward|towards|to|near|in|off|past|before|after|at|approaching|through)(?= (?:{_COMPASS} )?{_NAMES}(?:[\s.,]|$))"
        rf"(?: (?P<kept>{_COMPASS}))? {_NAMES}(?:, (?:California|CA|Arizona|AZ|Texas|TX)\b)?"
    ),
)
_CORNER = re.compile(
    rf" (?:on|at|along) (?:{_COMPASS} )?{_NAMES_OF_STREET} (?:at|and|&) (?:{_COMPASS} )?{_NAMES}"
)  # of two streets
_SUMMARY = re.compile(  # told again in full
    r"(?:,? (?:and|when it))? (?:was|were) (?:in|involved in) an? (?:collision|incident|accident|crash)(?: (?:involving|with) (?:an? |the )?(?:[\w-]+ ){0,3}?[\w-]+(?= at\b| on\b| in\b| near\b| while\b| when\b|[.,]|$))?"
)
_CAME_OF_IT = re.compile(
    r",?(?: which| that| and| thereby| both)?(?: the| both)?(?: [\w-]+){0,3}? "
    r"(?:caus(?:ed|ing)|result(?:ed|ing)|damag(?:ed|ing)|scratch(?:ed|ing)|scrap(?:ed|ing)|dent(?:ed|ing)|sustain(?:ed|ing)|incurr(?:ed|ing)|leaving)\b"
    r"(?! (?:the |us )?(?:to|a|lane|road)\b)[^;]*?(?=\.$|;|$)"
)
_ABOUT_NOTHING = re.compile(
    r"\b(?:injur\w+|damag\w+|dent\w*|scratch\w*|scrap(?:ed|ing)|police|law enforcement|911|towed|exchang\w+|Level \d|VIN|alleg\w+|EMS|Emergency Medical|footage|"
    r"first responders?|disengaged|(?:left|fled|leaving) the scene|claimed|Autonomy was not|NCI|soreness|narrative|page)\b",
    re.IGNORECASE,
)
_TELLS = re.compile(
    r"\b(?:contact(?:ed)? (?!at)|struck|collided|hit|rear-ended|side-?swiped|turn\w*|cross\w*|cut\w*|swerv\w*|chang\w+|merg\w+|stopped (?:at|for|behind)|"
    r"approach\w*|pull\w*|back(?:ed|ing)|revers\w+|proceed\w*|overt\w+|slow\w*|brak\w+|enter\w*|pass(?:ed|ing))\b"
)
_SENTENCE_END = re.compile(
    r"(?<!\b(?:St|Dr|Jr|Ln|Rd|Pl|Ct|vs|No))(?<!\b(?:Ave|Mrs|Hwy|Inc))(?<!\bBlvd)(?<![ .][A-Z])\.(?=\s|$)(?!\s+[a-z])"
    rf"|(?:(?<=\b(?:St|Dr|Ln|Rd|Pl|Ct))|(?<=\b(?:Ave|Hwy))|(?<=\bBlvd))\.(?=\s+{_OPENS})"
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Named:
    """A text in which everybody has a plain name.

    Attributes:
        text: As it is read on.
        dropped: What was taken out, in order: no scene shows it.
    """

    text: str
    dropped: tuple[str, ...] = ()


def plainly_named(text: str) -> Named:
    """A text with "the ego" for all names of the ego, "car" for makes, and no streets, dates, modes or damage.

    Args:
        text: Printable, as a user wrote it.

    Returns:
        The same text where it has nothing of the kind.
    """
    dropped: list[str] = []
    maker = _maker_in(text)
    if not (maker or _EGO.search(text) or _PARTY.search(text)):
        return Named(text=_MAKE.sub(_car, text))
    text = _SECOND.sub(_second, _THEIRS.sub("the other ", text))
    text = _BRACKETS.sub(lambda m: _without_brackets(m, dropped), text)
    text = _FIRST.sub(_first, _ego_named(text, maker))
    text = _MAKE.sub(_car, _MOTORWAY.sub("the motorway", text))
    sentences = [_told(sentence, dropped) for sentence in _SENTENCE_END.split(text)]
    told = ". ".join(sentence for sentence in sentences if sentence)
    return Named(text=told or text, dropped=tuple(dropped))


def _maker_in(text: str) -> str:
    """Whose the ego is, where an operator of automated vehicles reports; empty if nobody does."""
    maker = _MAKER.search(text)
    if maker is None or re.match(rf"(?:{_MAKES})\b", maker["name"]):
        return ""  # anybody's car
    return maker["name"] if _REPORTS.search(text) and not _SPEAKER.search(text) else ""


def _ego_named(text: str, maker: str) -> str:
    """A text with "the ego" for what its maker, the police or an insurer call it."""
    shuttle = False
    if maker:
        shuttle = re.search(rf"\b{re.escape(maker)} shuttle\b", text) is not None
        text = re.sub(_of_maker(maker), _by_maker, text)
    text = _EGO.sub(lambda m: _begun(m[0], _ego(m)), text)
    if shuttle:
        text = _SHUTTLE.sub(r"\1he ego", text)
    return _OWN_DRIVER.sub(r"\1he driver of the ego", text)


def _without_brackets(match: re.Match[str], dropped: list[str]) -> str:
    """Nothing in place of an aside; another name for somebody is no loss."""
    if not _ALIAS.search(match[0]):
        dropped.append(match[0].strip(" ()"))
    return ""


def _of_maker(name: str) -> str:
    return (
        rf"\b(?:(?:[Aa]n?|[Tt]he|[Oo]ur|[Oo]ne) )?(?P<how>(?:stopped|stationary|parked) )?{re.escape(name)}(?: {_AUTOMATED})?"
        r"(?: (?:AV|[Vv]ehicle|car|shuttle|truck|van|bus|taxi|test vehicle|test car))?"
        r"(?P<whose> (?:operator|driver|safety driver|test driver))?(?![\w-])"
    )


def _by_maker(match: re.Match[str]) -> str:
    return _begun(match[0], "the driver of the ego" if match["whose"] else f"the {match['how'] or ''}ego")


def _first(match: re.Match[str]) -> str:
    return "The ego" if _begins(match) else "the ego"


def _second(match: re.Match[str]) -> str:
    kind = match["kind"] or match["kind2"]
    return f"{'The' if _begins(match) else 'the'} {kind or 'other vehicle'}"


def _begins(match: re.Match[str]) -> bool:
    """Whether a sentence begins with it."""
    return match.string[: match.start()].rstrip()[-1:] in ("", ".")


def _begun(said: str, meant: str) -> str:
    """Other words for what was said, with a capital where that had one and may begin a sentence."""
    return meant[0].upper() + meant[1:] if re.match(r"(?:An?|The|Our|One) ", said) else meant


def _ego(match: re.Match[str]) -> str:
    """The ego, behind a word that only stands before its name: "stopped the AV"."""
    lead, *rest = match[0].split()
    how = next((word.lower() for word in (lead, *rest) if word.lower() in _HOW_IT_IS), "")
    if how and (lead.lower() == how or lead.lower() in _OWN_LEADS):
        return f"the {how} ego"
    return f"{lead} the ego" if lead.islower() and lead not in _OWN_LEADS else "the ego"


_AFTER_ARTICLE = re.compile(r"\b(?:[Tt]he|[Aa]n?|[Aa]nother) \w+ $")


def _car(match: re.Match[str]) -> str:
    """A car, or what of its body is said, for a make; with the article that goes before it."""
    if match["article"] is None and _AFTER_ARTICLE.search(match.string[: match.start()]):
        return (match["body"] or "car").lower()
    article = match["article"] or "a"
    return f"{article[0] if article.lower() == 'an' else article} {(match['body'] or 'car').lower()}"


def _told(sentence: str, dropped: list[str]) -> str:
    """A sentence without what no scene shows; empty if nothing is left of it."""
    sentence = _CORNER.sub(" at the intersection", sentence.strip())
    sentence = _SUMMARY.sub(lambda m: _dropped(m, dropped), sentence)
    if _ABOUT_NOTHING.search(sentence):
        sentence = _CAME_OF_IT.sub(lambda m: _dropped(m, dropped), sentence)
        if _ABOUT_NOTHING.search(sentence) and not _TELLS.search(sentence):
            dropped.append(sentence)
            return ""
    for pattern in _NOTHING:
        sentence = pattern.sub(lambda m: _dropped(m, dropped), sentence)
    sentence = re.sub(r"\s+([,.;])", r"\1", " ".join(sentence.split()))
    sentence = re.sub(r"(?:, ?)+(?=[,.;]|$)", "", sentence).strip(" ,")
    told = re.sub(rf"\b(?:[Tt]he ego|{_COMPASS}|at|on|in|near|the|intersection)\b", " ", sentence).split()
    if "intersection" in sentence and not told:
        return "At the intersection"
    return sentence if told and (len(sentence.split()) > 1 or not dropped) else ""


def _dropped(match: re.Match[str], dropped: list[str]) -> str:
    """What stands for words that are taken out: the heading among them, or a space."""
    kept = match.groupdict().get("kept")
    dropped.append(match[0].strip(" ,."))
    return f" {kept} " if kept else " "
