"""Where across the road somebody is: a start or a deed that was said to be elsewhere than in the middle of a lane."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING

from chatscene.build.asked import Asked, Meets, Stand
from chatscene.build.deeds import OWN, Steps
from chatscene.build.over_lanes import side_beside
from chatscene.build.place import LANE
from chatscene.terms.actors import Limits
from chatscene.terms.amount import Amount
from chatscene.terms.lateral import PLACED, PLACED_IN_OURS, aside_of_ego
from chatscene.terms.situation import LATERALS, Lateral, Other
from chatscene.terms.vocabulary import ASIDE, INTO_OURS, Act, Side, Where

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

_MOVED = re.compile(r"\.offset\([-\d.]+\)$")
_ON_FOOT = "pointOn(egoRoute, level{i})"
SIDEWAYS = 0.4  # [m] from the middle of its lane at least, who is said to be to one side of it
_LEAST, _MOST = {"overlap": 0.05, "clearance": 0.2}, {"overlap": 0.95, "clearance": 2.0}
"""Where a bound of a number is left open: from and to; of a length within the lane, from 0 to its edge."""
_FARTHEST = 10.0  # [m] beside the lanes that somebody is, where only a least was said
ON_LINE = 0.01  # [m] from the middle of a lane up to which somebody is in it
_MEANING = "how far to the left of the middle of its lane it is"


def placed(asked: Asked, stand: Stand) -> tuple[Stand, str]:
    """A start that is where it was said to be across the road; the same where nothing was said or builds that.

    Args:
        asked: Of whom.
        stand: Where it is along the road.

    Returns:
        The start, then what was chosen, in words; empty for nothing.
    """
    lateral, one = asked.one.starts.lateral, asked.one
    if lateral is not None and lateral.beyond is not None and "$X" in stand.point:
        ends = lateral.beyond.drawn(0.0, _FARTHEST)
        asked.numbers.measure("X", *ends, "m", "how far beside the lanes it starts", f"others.{one.id}.starts.lateral")
    if lateral is None or lateral.beyond is not None or one.starts.where not in PLACED:
        return stand, ""
    if stand.meets is Meets.KERB and one.starts.side is Side.LEFT:
        return stand, ""  # at the edge of the lane of those who come the other way
    side, chosen = _side(lateral, one)
    middle = {Side.LEFT: LANE, Side.RIGHT: -LANE}.get(one.starts.side or Side.LEFT, 0.0)
    lane = 0.0 if one.starts.where in PLACED_IN_OURS or asked.rides else middle
    ego = LANE if asked.swings_out and one.starts.where in PLACED_IN_OURS else 0.0
    low, high = in_lane(lateral, side, asked.numbers.row.limits, asked.situation.ego.body.row.limits.width, ego - lane)
    toward = stand.meets is Meets.TOWARD
    if toward:
        low, high = -high, -low
    low = high = 0.5 * (low + high)  # a line is laid when a program is compiled, before numbers are drawn
    if abs(low) < ON_LINE:
        chosen = ""  # nothing is to a side, as where all of it is in line with the ego
    asked.numbers.measure("ASIDE", low, high, "m", _MEANING, f"others.{one.id}.starts.lateral")
    if stand.point == _ON_FOOT:
        return replace(stand, point="pointOn(egoRoute, level{i}, $ASIDE)"), chosen
    if stand.meets is Meets.KERB:
        return replace(stand, way=f"{OWN}.offset($ASIDE)"), chosen
    if stand.meets in (Meets.ALONG, Meets.TOWARD) and not stand.point:
        line = "egoRoute.line" if stand.way == "egoRoute" else _MOVED.sub("", stand.way)
        return replace(stand, way=f"{line}.offset($ASIDE)"), chosen
    return stand, ""


def led_aside(actor: Actor, k: int, steps: Steps) -> Steps:
    """How a deed is done that leads to where it was said to go on across the road."""
    deed, one = actor.deeds[k], actor.one
    if (lateral := deed.lateral) is None or actor.stand.meets not in (Meets.ALONG, Meets.TOWARD, Meets.KERB):
        return steps
    side, chosen = _side(lateral, one)
    toward = actor.stand.meets is Meets.TOWARD
    texts = (*steps.does, *steps.last)
    if deed.act in INTO_OURS and (line := next((line for line in (OWN, "{ours}") if line in "".join(texts)), "")):
        low, high = in_lane(lateral, side, actor.limits, actor.ego_limits.width, 0.0)
    elif deed.act is Act.OVERTAKE and lateral.clearance is not None and "{beside}" in "".join(texts):
        line, (side, _) = "{beside}", side_beside(actor, deed.to)
        low, high = in_lane(lateral, side, actor.limits, actor.ego_limits.width, -LANE if side is Side.LEFT else LANE)
        chosen = ""
    else:
        return steps
    if toward:
        low, high = -high, -low
    name, at = f"ASIDE_{k}", f"{actor.path}.does.{k}.lateral"
    actor.numbers.measure(name, low, high, "m", _MEANING, at)
    if chosen:
        actor.ledger.assume(chosen)
    does, last = (
        tuple(one.replace(line, f"{line}.offset(${name})") for one in row) for row in (steps.does, steps.last)
    )
    return replace(steps, does=does, last=last, way=steps.way.replace(line, f"{line}.offset(${name})"))


def goes_aside(actor: Actor, k: int) -> tuple[float, float] | None:
    """How far [m] from its line somebody drifts or swerves who was said to go on elsewhere across the road."""
    deed = actor.deeds[k]
    if deed.lateral is None or deed.act not in ASIDE or actor.stand.meets not in (Meets.ALONG, Meets.TOWARD):
        return None
    side, _ = _side(deed.lateral, actor.one)
    start = actor.one.starts
    lane = 0.0 if start.where in PLACED_IN_OURS else -LANE if start.side is Side.RIGHT else LANE
    ends = in_lane(deed.lateral, side, actor.limits, actor.ego_limits.width, -lane)
    began = actor.numbers.middle("ASIDE") if "ASIDE" in actor.numbers.ranges else 0.0
    if actor.stand.meets is Meets.TOWARD:
        began = -began
    far = sorted(abs(end - began) for end in ends)
    return far[0], far[1]


def _side(lateral: Lateral, one: Other) -> tuple[Side, str]:
    """To which side of its lane somebody is, and what was chosen for it, in words."""
    if (side := lateral.side or one.starts.side) is not None:
        return side, ""
    usual = Side.LEFT if one.starts.where in (Where.ONCOMING, Where.ONCOMING_IN_OUR_LANE) else Side.RIGHT
    return usual, f"{one.id} is to the {usual} across the road"


def in_lane(lateral: Lateral, side: Side, limits: Limits, own: float, ego: float) -> tuple[float, float]:
    """How far [m] to the left of the middle of a lane somebody is, from and to.

    Args:
        lateral: What was said.
        side: To which side.
        limits: What its body can do.
        own: How wide the ego is [m].
        ego: How far to the left of that middle the ego's line is [m].
    """
    sign = 1.0 if side is Side.LEFT else -1.0
    name, said = next(((name, one) for name in LATERALS if (one := getattr(lateral, name)) is not None), ("", None))
    if not isinstance(said, Amount):  # only to a side, and still in its lane
        ends = SIDEWAYS, max(SIDEWAYS, 0.5 * (LANE - limits.width))
        return min(sign * end for end in ends), max(sign * end for end in ends)
    ends = said.drawn(_LEAST.get(name, 0.0), _MOST.get(name, 0.5 * LANE))
    if name in ("overlap", "clearance"):
        far = [ego + sign * aside_of_ego(name, end, own, limits.width) for end in ends]
    else:
        far = [sign * (0.5 * LANE - end if name == "edge" else end) for end in ends]
    return min(far), max(far)
