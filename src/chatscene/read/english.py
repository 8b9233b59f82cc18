"""Whether a text is English, which alone the packaged reader has learned."""

from __future__ import annotations

import re

from chatscene.errors import NothingFits

_ENGLISH_WORDS = """
    the and of on at to from by with as while when where who which that this it its he she his her we us our is are was
    were be been being have has had then just after before into onto over out off up down through along across behind
    front
"""
_ENGLISH = frozenset(_ENGLISH_WORDS.split())
_OTHER_WORDS = """
    der das den dem des ein eine einen einem einer und ist wir uns von vor nach mit auf aus im bei zu rechts links
    el la los las un una uno y que del con por para desde hacia nos se en su derecha izquierda delante
    le les une et est nous du de des qui dans avec sur depuis devant vers notre gauche droite au
    il lo gli che di da dal dalla nel nella con noi davanti sinistra destra verso
    het een naar voor wij ons onze os um uma
"""
_OTHER = frozenset(_OTHER_WORDS.split())  # without those that English has as well, such as "die" and "van"
_LAST_LATIN = "\u024f"


def is_english(text: str) -> bool:
    """Whether a text looks English: by its letters, and by the small words that every language has its own of."""
    letters = [c for c in text if c.isalpha()]
    if sum(c > _LAST_LATIN for c in letters) * 2 > len(letters):
        return False
    words = re.findall(r"[^\W\d_]+", text.lower())
    other = sum(word in _OTHER for word in words)
    return other < 2 or other <= sum(word in _ENGLISH for word in words)


def check_english(text: str) -> None:
    """Hold a text to the language that was learned; another one would be read as anything.

    Raises:
        NothingFits: It looks like another language.
    """
    if not is_english(text):
        raise NothingFits(
            "this does not look like English, and the offline reader reads only English; write English, or name a "
            "language model with --language-model",
            reasons=("not in English",),
        )
