"""Words that are known to be without effect: colours, makes, names of streets, dates, feelings, and what came of it.

No scene shows them, whatever is read of the rest.
"""

from __future__ import annotations

import re
from functools import lru_cache

_NAME = r"[A-Z][\w'-]+"
_STREET = (
    r"Streets?|St|Avenues?|Ave|Boulevard|Blvd|Road|Rd|Drive|Dr|Lane|Ln|Way|Place|Court|Ct|Parkway|Pkwy|Terrace|Square|"
    r"Highway|Hwy|Close|Crescent"
)
_COLOURS = (
    "red|blue|white|black|gr[ae]y|silver|green|yellow|orange|brown|beige|gold|purple|pink|maroon|navy|dark|colou?red"
)
STREET, DATE, COLOUR = "a name of a street or a place", "a date or a time of day", "a colour"
_SAID: tuple[tuple[str, re.Pattern[str]], ...] = (
    (
        STREET,
        re.compile(rf"(?:{_NAME} )+(?:{_STREET})\b\.?|\b\d+(?:st|nd|rd|th) (?:{_STREET})\b"),
    ),
    (
        DATE,
        re.compile(
            r"\b(?:(?:on|at|around|about|by) )*(?:\d{1,2}[:.]\d\d(?: ?[ap]\.?m\.?)?|\d{1,2} ?[ap]\.?m\b\.?|\d{1,2} o'clock|noon"
            r"|(?:Mon|Tues|Wednes|Thurs|Fri|Satur|Sun)day|(?:\d{1,2}(?:st|nd|rd|th)? )?(?:January|February|March|April|June|July"
            r"|August|September|October|November|December)(?: \d{1,2}(?:st|nd|rd|th)?)?(?:,? \d{4})?"
            r"|(?:this|that|one|yesterday|last|the other|in the|early|late|saturday|sunday) (?:morning|afternoon|evening|day|week)"
            r"|yesterday|today|tonight|recently|once)\b",
            re.IGNORECASE,
        ),
    ),
    (
        "a make or a model",
        re.compile(
            r"\b(?:Audi|BMW|Chevrolet|Chevy|Citro[eë]n|Dodge|Fiat|Ford|Honda|Hyundai|Jaguar|Jeep|Kia|Lexus|Mazda|Mercedes(?:[- ]Benz)?"
            r"|Mini|Mitsubishi|Nissan|Opel|Peugeot|Porsche|Renault|Seat|Skoda|Subaru|Suzuki|Tesla|Toyota|Vauxhall|Volkswagen|Volvo"
            r"|VW|Yamaha|Vespa|Ducati|Kawasaki)(?: [A-Z0-9][\w-]*)?\b"
        ),
    ),
    (
        COLOUR,
        re.compile(
            rf"\b(?:{_COLOURS})(?:[- ](?:{_COLOURS}))*\b(?! (?:traffic )?(?:lights?|signals?|phase))", re.IGNORECASE
        ),
    ),
    (
        "what somebody felt or thought of it",
        re.compile(
            r"\b(?:idiots?|morons?|maniacs?|lunatics?|stupid\w*|silly|crazy|bloody|damn\w*|flipping|thank god|thankfully|luckily"
            r"|fortunately|unfortunately|sadly|honestly|basically|literally|actually|obviously|apparently|probably|maybe|guess"
            r"|scar(?:ed|y)|frighten\w*|terrif\w+|shock\w*|shak(?:en|ing|y)|angry|furious|annoy\w*|upset|relieved|nervous|afraid"
            r"|sorry|apologi[sz]\w+|swear|swore|scream\w*|shout\w*|yell\w*|panic\w*|nightmare|lucky|horribl[ey]|terribl[ey]|awful\w*"
            r"|nearly died|heart|omg|wow|lol|ugh|oh|ok|okay|well|yeah|man|mate|please|thanks|dear|regards)\b",
            re.IGNORECASE,
        ),
    ),
    (
        "what came of it, or who was told",
        re.compile(
            r"\b(?:(?:no|minor|slight|major|any) )*(?:injur\w+|hurt|unhurt|bruis\w+|whiplash|wounded|hospital|ambulance came|damag\w+|dent(?:s|ed)?"
            r"|scratch\w*|scrap(?:e[sd]?|ing)|bent|broken|shattered|write-off|repair\w*|towed|insur\w+|polic(?:e|y|ies)|officers?|witness\w*"
            r"|report(?:s|ed|ing)?|statement|claim\w*|liabilit\w+|citation\w*|cited|ticket(?:ed)?|exchang\w+|details|claims?)\b",
            re.IGNORECASE,
        ),
    ),
    (
        "who was on board, or where they were going",
        re.compile(
            r"\b(?:my|our|the|his|her) (?:wife|husband|kids|children|son|daughter|mum|mom|dad|mother|father|girlfriend|boyfriend|friends?"
            r"|passengers?|colleague)\b|\b(?:on (?:my|our|the) way )?(?:home|to work|from work|to school|shopping|commut\w+)\b",
            re.IGNORECASE,
        ),
    ),
    (
        "said by the speed after it",
        re.compile(
            r"\b(?:driv(?:es?|ing|en)|drove|go(?:es|ing)?|went|travel(?:l?ed|l?ing|s)?|mov(?:es?|ed|ing)|do(?:es|ing)?|proceed(?:s|ed|ing)?"
            r"|cruis(?:es?|ed|ing)|run(?:s|ning)?|rid(?:es?|ing|den)|rode)(?= (?:(?:forwards?|straight|along|at|with|about|around"
            r"|some|roughly|approximately|constant|a|speed|of) )*\d[\d.,]*(?: ?(?:to|-) ?\d[\d.]*)? ?(?:km/?h|kph|kmh|mph|m/s)\b)",
            re.IGNORECASE,
        ),
    ),
    (
        "how it is told",
        re.compile(
            r"\b(?:stated|states|said|says|told|reported|reportedly|alleged\w*|according to|remember\w*|noticed|saw|seen|see|realis?zed?"
            r"|know|knew|think|thought|suppose\w*|imagine|scenario|situation|test|case|example|typical|usual|usually|want|wants|wanted"
            r"|consider|assume|given|let's|happen(?:s|ed|ing)?|sort of|kind of|some|any|every|each|by then|so|very|really|quite|rather|right then|all of a sudden)\b",
            re.IGNORECASE,
        ),
    ),
)


def without_effect(text: str, span: tuple[int, int]) -> str:
    """Why a word of a text is known to be without effect; empty if it is not."""
    start, end = span
    return next((why for low, high, why in _found(text) if low <= start and end <= high), "")


@lru_cache(maxsize=32)
def _found(text: str) -> tuple[tuple[int, int, str], ...]:
    """Where words without effect stand in a text, and why they are; the kinds in their order."""
    return tuple((*found.span(), why) for why, pattern in _SAID for found in pattern.finditer(text))
