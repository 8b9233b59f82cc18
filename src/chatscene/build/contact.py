"""What was said of a contact: who is to touch the ego, and who is not; and who has the ego slow down or stand."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from chatscene.terms.actors import Manner as Moves
from chatscene.terms.amount import Length
from chatscene.terms.situation import Lateral, Other, Situation
from chatscene.terms.vocabulary import (
    COMES_IN,
    GOES_ON,
    HALTS,
    LOSES,
    SIDES_OF,
    STOPS,
    Act,
    EgoRoute,
    Heads,
    Part,
    Role,
    Side,
    Striker,
    Tempo,
    Where,
    acts_of,
)

_LOSES = LOSES | acts_of(Tempo.BACKS)
_STANDS = HALTS | acts_of(Tempo.LIES)
_PASSES = frozenset((EgoRoute.BYPASS, EgoRoute.OVERTAKE, EgoRoute.LANE_CHANGE_LEFT, EgoRoute.LANE_CHANGE_RIGHT))
"""Ways on which the ego goes round whoever stands in its lane."""
_GETS_IN_THE_WAY = COMES_IN | acts_of(Tempo.BACKS)
_BESIDE = frozenset(
    (Where.ROADSIDE, Where.KERB, Where.DRIVEWAY, Where.CROSSING, Where.MEDIAN, Where.BUS_BAY, Where.AHEAD)
)


def touches(situation: Situation, one: Other) -> bool:
    """Whether it was said that somebody and the ego touch."""
    contact = situation.contact
    return contact is not None and contact.happens and contact.whom in (None, one.id)


def misses(situation: Situation, one: Other) -> bool:
    """Whether it was said that somebody and the ego do not touch."""
    contact = situation.contact
    return contact is not None and not contact.happens and contact.whom in (None, one.id)


def all_but_strikes(situation: Situation, one: Other) -> bool:
    """Whether somebody behind the ego in its lane all but runs into it, as it was said that these two do not touch."""
    named = situation.contact.whom if situation.contact is not None else None
    meant = one.id == (named or next((other.id for other in situation.adversaries), None))
    return meant and misses(situation, one) and one.starts.where is Where.BEHIND


_LEVEL = {
    Part.LEFT_FRONT: 0.5, Part.LEFT: 0.0, Part.LEFT_REAR: -0.2,
    Part.RIGHT_FRONT: 0.5, Part.RIGHT: 0.0, Part.RIGHT_REAR: -0.2,
}  # fmt: skip
"""How far ahead of the ego's middle that of who strikes a part of its side is, as a share of the ego's length."""


def sideswiped_at(situation: Situation, one: Other) -> float | None:
    """How far ahead of the ego's middle, as a share of its length, somebody strikes its side that it passes.

    None of who does not, or of whose contact nothing of the kind was said.
    """
    contact = situation.contact
    if contact is None or not touches(situation, one) or contact.striker is Striker.EGO:
        return None
    if contact.ego is None or contact.ego not in _LEVEL:
        return None
    own_side = one.starts.where in (Where.BEHIND_BESIDE, Where.BESIDE) and str(contact.ego).startswith(
        str(one.starts.side)
    )
    return _LEVEL[contact.ego] if own_side else None


def strikes_from_behind(situation: Situation, one: Other) -> bool:
    """Whether it was said that somebody behind the ego, in its lane, touches it, and not that the ego strikes."""
    contact = situation.contact
    by_ego = contact is not None and contact.striker is Striker.EGO
    return touches(situation, one) and not by_ego and one.starts.where is Where.BEHIND


_IN_LINE = {
    Where.BEHIND: (Part.REAR, Part.FRONT),
    Where.AHEAD: (Part.FRONT, Part.REAR),
    Where.ONCOMING_IN_OUR_LANE: (Part.FRONT, Part.FRONT),
}
"""Of who is in the ego's lane and stays in it: which part of the ego it touches, and with which of its own."""
_STAYS = _LOSES | GOES_ON | acts_of(Tempo.STANDS, Tempo.GAINS, Tempo.SETS_OFF, Heads.CLOSE)


_KEEPS_ON_FOOT = acts_of(Tempo.STANDS, Tempo.HALTS, Tempo.LIES, Tempo.PAUSES, Heads.ALONG)
"""What somebody on foot, or an animal, does who stays in line with the ego."""
_CORNERS = {
    Part.LEFT_REAR: (Part.REAR, Side.LEFT),
    Part.RIGHT_REAR: (Part.REAR, Side.RIGHT),
    Part.LEFT_FRONT: (Part.FRONT, Side.LEFT),
    Part.RIGHT_FRONT: (Part.FRONT, Side.RIGHT),
}
_FACES = {
    Part.LEFT_REAR: Part.RIGHT_FRONT,
    Part.RIGHT_REAR: Part.LEFT_FRONT,
    Part.LEFT_FRONT: Part.RIGHT_REAR,
    Part.RIGHT_FRONT: Part.LEFT_REAR,
}
"""The corner of who goes the ego's way that touches a corner of the ego."""
_CORNER = Length(0.8, 0.8)  # [m] that two in one lane are aside of each other who touch at a corner of the ego


def at_a_corner(situation: Situation) -> Situation:
    """The same; who is in line with the ego and is to touch it at a corner is as far aside of it."""
    contact, whom = situation.contact, _in_line(situation)
    if contact is None or contact.ego is None or whom is None or whom.starts.lateral is not None:
        return situation
    if contact.ego not in _CORNERS:
        return situation
    part, side = _CORNERS[contact.ego]
    if part is not _IN_LINE[whom.starts.where][0] or Act.REVERSE in _acts(whom):
        return situation
    aside = replace(whom, starts=replace(whom.starts, lateral=Lateral(side=side, offset=_CORNER)))
    others = tuple(aside if one is whom else one for one in situation.others)
    return replace(situation, others=others)


def parts_in_line(situation: Situation) -> Iterator[str]:
    """The paths of what was said of a contact that is so because the two are in line with each other."""
    contact, whom = situation.contact, _in_line(situation)
    if contact is None:
        return
    if contact.other is Part.REAR and any(touches(situation, one) and _backs_first(one) for one in situation.others):
        yield "contact.other"  # which is what comes first
    if whom is None:
        yield from _turns_round(situation)
        return
    ego, other = _IN_LINE[whom.starts.where]
    aside = whom.starts.lateral is not None and _CORNERS.get(contact.ego or ego, (None, None))[0] is ego
    if contact.ego is ego or aside:
        yield "contact.ego"
    if contact.other is other or (aside and contact.other is _FACES.get(contact.ego or ego)):
        yield "contact.other"
    if contact.striker in _strikers(situation, whom):
        yield "contact.striker"


def _turns_round(situation: Situation) -> Iterator[str]:
    """The same, where somebody before the ego turns round to the left: across its way, that side faces the ego."""
    contact = situation.contact
    whom = next((one for one in situation.adversaries if touches(situation, one)), None)
    if contact is None or whom is None or whom.starts.where not in (Where.AHEAD, Where.KERB):
        return
    if not whom.does or whom.does[-1].act is not Act.U_TURN:
        return
    if contact.ego is Part.FRONT:
        yield "contact.ego"
    if contact.other is not None and str(Side.LEFT) in SIDES_OF[contact.other]:
        yield "contact.other"
    if contact.striker is Striker.EGO:
        yield "contact.striker"


def _strikers(situation: Situation, whom: Other) -> tuple[Striker, ...]:
    """Who runs into whom, of somebody in line with the ego: each into the other if both come on."""
    if Act.REVERSE in _acts(whom) or whom.starts.where is Where.BEHIND:
        return (Striker.OTHER,)
    if whom.starts.where is Where.AHEAD or (whom.does and whom.does[-1].act in _STANDS):
        return (Striker.EGO,)
    return (Striker.OTHER,) if _halts(situation) else (Striker.EGO, Striker.OTHER)


def _in_line(situation: Situation) -> Other | None:
    """Who is to touch the ego and stays in line with it."""
    whom = next((one for one in situation.adversaries if touches(situation, one)), None)
    if whom is None or whom.starts.where not in _IN_LINE or not _STAYS.issuperset(_acts(whom)):
        return None
    walks_off = whom.kind.moves is Moves.WALKS and not (whom.does and _acts(whom) <= _KEEPS_ON_FOOT)
    return None if walks_off or situation.ego.route in _PASSES else whom


def _backs_first(one: Other) -> bool:
    """Whether somebody backs as it begins to move."""
    return next((deed.act for deed in one.does if deed.act is not Act.STAND), None) is Act.REVERSE


def _halts(situation: Situation) -> bool:
    """Whether it was said that the ego stands, or comes to stand."""
    return any(deed.act in HALTS | acts_of(Tempo.WAITS) for deed in situation.ego.does)


def parts_of_door(situation: Situation, one: Other) -> Iterator[str]:
    """The paths of what was said of a contact with the door of somebody at the kerb that is so by where that is."""
    contact = situation.contact
    if contact is None:
        return
    right = one.starts.side is Side.RIGHT
    if contact.striker is not None:
        yield "contact.striker"
    if contact.ego is (Part.RIGHT_FRONT if right else Part.LEFT_FRONT):
        yield "contact.ego"
    if contact.other is (Part.LEFT if right else Part.RIGHT):
        yield "contact.other"


def is_held_up(situation: Situation) -> bool:
    """Whether somebody before the ego has it lose speed: who does so in its lane, stands there, or comes into it."""
    return _stands_ahead(situation) or any(
        (one.starts.where is Where.AHEAD and not _LOSES.isdisjoint(_acts(one)))
        or (one.starts.where in _BESIDE and not _GETS_IN_THE_WAY.isdisjoint(_acts(one)))
        for one in situation.others
        if one.role is not Role.HIDES
    )


def is_braked_for(situation: Situation, one: Other) -> bool:
    """Whether the ego is to brake for somebody: by what was said of it, or as another is to run into its rear then."""
    answered = [name[1].partition(".")[0] for deed in situation.ego.does if (name := situation.answered(deed))]
    struck = any(strikes_from_behind(situation, other) for other in situation.others)
    return one.id in answered or (struck and not answered)


def comes_to_stand(situation: Situation) -> bool:
    """Whether the ego drives at first and stands then, whoever drives it: by an order, or as somebody is in its way."""
    does = situation.ego.does
    if does and does[0].act is Act.STAND:
        return False
    ordered = {deed.act for deed in does if situation.answered(deed) is None}
    return not STOPS.isdisjoint(ordered) or _stands_ahead(situation)


def _stands_ahead(situation: Situation) -> bool:
    """Whether somebody stands in the ego's lane, or comes to stand there, whom the ego does not go round."""
    if situation.ego.route in _PASSES:
        return False
    ahead = (one for one in situation.others if one.starts.where is Where.AHEAD and one.role is not Role.HIDES)
    return any(not _STANDS.isdisjoint(_acts(one)) for one in ahead)


def _acts(one: Other) -> frozenset[Act]:
    return frozenset(deed.act for deed in one.does)
