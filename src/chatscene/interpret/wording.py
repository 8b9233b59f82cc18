"""Facts put into the words the library uses, so that the encoder compares like with like.

An embedding hardly tells left from right (decision 0006): for geometry and spawn the facts are said in one fixed way,
rather than in the many ways of users.
"""

from __future__ import annotations

from chatscene.terms.frame import Frame
from chatscene.terms.nouns import with_article
from chatscene.terms.scenario import Control, Maneuver, Place, Position, Slots, SubDescriptions


def parts_of(frame: Frame, slots: Slots) -> SubDescriptions:
    """A text per component: what is said of the adversary, and facts in the words of the library."""
    return SubDescriptions(
        behavior=frame.clauses.adversary or frame.clauses.whole,
        geometry=geometry_in_words(slots, frame.clauses.ego),
        spawn=spawn_in_words(slots),
    )


def geometry_in_words(slots: Slots, said: str) -> str:
    """Where the ego drives and what it does there; `said` is added where facts alone do not tell roads apart."""
    does = {
        Maneuver.LEFT_TURN: "turns left",
        Maneuver.RIGHT_TURN: "turns right",
        Maneuver.LANE_CHANGE_LEFT: "changes to the left lane",
        Maneuver.LANE_CHANGE_RIGHT: "changes to the right lane",
        Maneuver.BYPASS: "goes around a vehicle parked in its lane",
    }.get(slots.maneuver or Maneuver.STRAIGHT, "drives straight")
    where = {
        Place.CURVE: "around a curve",
        Place.THREE_WAY: "at a three-way intersection",
        Place.FOUR_WAY: "at a four-way intersection",
        Place.JUNCTION: "at an intersection",
    }.get(slots.place or Place.ROAD, "on a road")
    how = (
        {
            Control.SIGNAL: " with traffic lights",
            Control.STOP_SIGN: " with stop signs",
            Control.NONE: " without traffic lights",
        }.get(slots.control, "")
        if slots.control
        else ""
    )
    facts = f"The ego {does} {where}{how}."
    # Kinds of open road differ in what no slot says: how many lanes, what lies beside.
    return facts if slots.place not in (None, Place.ROAD) else f"{facts} {said}".strip()


def spawn_in_words(slots: Slots) -> str:
    """Where the adversary starts, and what stands or drives about it."""
    side = f" on the {slots.side}" if slots.side else ""
    where = (
        {
            Position.AHEAD: "ahead of the ego in the same lane",
            Position.ROADSIDE: f"at the side of the road{side} ahead of the ego",
            Position.BESIDE: f"level with the ego in the neighbouring lane{side}",
            Position.AHEAD_BESIDE: f"ahead of the ego in the neighbouring lane{side}",
            Position.BEHIND: "behind the ego in the same lane",
            Position.BEHIND_BESIDE: f"behind the ego in the neighbouring lane{side}",
            Position.ONCOMING: "coming toward the ego from the opposite direction",
            Position.CROSSING: f"coming from the {slots.side or 'side'} arm of the intersection",
            Position.FAR_CORNER: f"on the opposite sidewalk{side} of the road the ego turns into",
        }.get(slots.position, f"ahead of the ego{side}")
        if slots.position
        else f"ahead of the ego{side}"
    )
    hidden = f", hidden behind {with_article(slots.occluder.replace('-', ' '))}" if slots.occluder else ""
    leader = ", and a slow car leads the ego" if slots.leader else ""
    blocked = ", beyond a car parked in the ego's lane" if slots.blocker else ""
    return f"The adversary is {where}{hidden}{leader}{blocked}."
