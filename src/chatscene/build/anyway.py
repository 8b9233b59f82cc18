"""What was said and is so without a word: which way somebody faces who drives along, to which side one crosses."""

from __future__ import annotations

from collections.abc import Iterator

from chatscene.build.asked import Meets
from chatscene.situations.check import COMES_OVER
from chatscene.terms.situation import Other
from chatscene.terms.vocabulary import Facing

FACES = {Meets.ALONG: Facing.ALONG, Meets.KERB: Facing.ALONG, Meets.TOWARD: Facing.AGAINST}
"""Which way somebody faces who comes to meet the ego so."""


def said_anyway(one: Other, meets: Meets) -> Iterator[str]:
    """The paths of facts of somebody that hold as it is built, whether they are said or not.

    Args:
        one: Somebody, with its side.
        meets: How it comes to meet the ego.
    """
    at = f"others.{one.id}"
    if one.starts.facing is not None and FACES.get(meets) is one.starts.facing:
        yield f"{at}.starts.facing"
    for k, deed in enumerate(one.does):
        if deed.act in COMES_OVER and deed.to is not None and deed.to is not one.starts.side:
            yield f"{at}.does.{k}.to"
