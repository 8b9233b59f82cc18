"""Which way somebody faces at first, as was said, across the road or at a slant; and what of that is so anyway."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from chatscene.build.asked import Asked, Meets, Stand
from chatscene.situations.check import TO_A_SIDE
from chatscene.terms.situation import Other
from chatscene.terms.vocabulary import Act, Facing, Heads, Manner, Side, Where, acts_of

OVER = acts_of(Heads.ACROSS, Heads.IN, Heads.THROUGH)
"""What is done at a slant, if it is."""
LONGER = 1.25  # times as far as straight over is a way at the middle slant
_TURNS = {Facing.ALONG: 0.0, Facing.AGAINST: math.pi, Facing.ACROSS: math.pi / 2}
FACES = {Meets.ALONG: Facing.ALONG, Meets.KERB: Facing.ALONG, Meets.TOWARD: Facing.AGAINST}
"""Which way somebody faces who comes to meet the ego so."""


def turned(asked: Asked, stand: Stand) -> Stand:
    """The same, facing as was said: who stands any way, who goes somewhere the way it goes."""
    facing = asked.one.starts.facing
    if facing is None or stand.faces or stand.point:
        return stand
    turn = _TURNS[facing]
    if stand.meets is Meets.TOWARD:
        turn = math.pi - turn
    elif facing is Facing.ACROSS and asked.side == Side.LEFT:
        turn = -turn
    stays = asked.stands and all(deed.act is Act.STAND for deed in asked.one.does)
    goes_so = turn == 0.0 and stand.meets is not Meets.THROUGH
    return replace(stand, turn=turn, faces=True) if stays or goes_so else stand


def faces(asked: Asked, there: str, usual: Facing, side: str) -> str:
    """Which way somebody faces, level with a place on the ego's route; from a side, where it faces across."""
    match asked.one.starts.facing or usual:
        case Facing.ALONG:
            return f"directionOn(egoRoute, {there})"
        case Facing.AGAINST:
            return f"directionOn(egoRoute, {there}, 3.14159)"
        case Facing.ACROSS:
            return f'crossingDirection(egoRoute, {there}, "{side}")'


def slanting(asked: Asked, stand: Stand, side: str) -> Stand:
    """The same, facing forward as well as across if it is to cross at a slant."""
    slants = any(deed.manner is Manner.SLANTING and deed.act in OVER for deed in asked.one.does)
    facing = asked.one.starts.facing
    if facing in (Facing.ALONG, Facing.AGAINST):  # it turns when it crosses
        over = "(1.5708 - $SLANT)" if slants else "1.5708"
        return replace(
            stand, over=over if (side == Side.RIGHT) == (facing is Facing.ALONG) else f"-{over}", slants=slants
        )
    if not slants:
        return stand
    facing_so = f"{stand.facing} {'-' if side == Side.RIGHT else '+'} $SLANT"
    return replace(stand, facing=facing_so, left=f"{LONGER:g} * {stand.left}", slants=True)


def said_anyway(one: Other, meets: Meets) -> Iterator[str]:
    """The paths of facts of somebody that hold as it is built, whether they are said or not.

    Args:
        one: Somebody, with its side.
        meets: How it comes to meet the ego.
    """
    at = f"others.{one.id}"
    comes = one.starts.where is Where.ONCOMING and one.starts.facing is Facing.AGAINST
    if comes or (one.starts.facing is not None and FACES.get(meets) is one.starts.facing):
        yield f"{at}.starts.facing"
    for k, deed in enumerate(one.does):
        comes_from = Side.LEFT if one.starts.where is Where.ONCOMING else one.starts.side
        if deed.act in TO_A_SIDE and deed.to is not None and deed.to is not comes_from:
            yield f"{at}.does.{k}.to"
