"""What cannot be in a situation, wherever it is built: names of nobody, sides of what has none, rules that exclude."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from contextlib import suppress

from chatscene.situations.faults import Fault, Path
from chatscene.situations.meant import word_meant
from chatscene.situations.phrases import road_named
from chatscene.terms.act_amounts import AMOUNTS, amounts_of
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.amount import Amount
from chatscene.terms.pointing import meant
from chatscene.terms.situation import EGO, LATERALS, Deed, Lateral, Other, Road, Situation
from chatscene.terms.vocabulary import (
    ARMS_OF,
    ENDS_THERE,
    FOR_SOMEBODY,
    ROUNDABOUTS,
    Act,
    Breach,
    EgoRoute,
    Heads,
    RightOfWay,
    RoadKind,
    UserKind,
    Where,
    acts_of,
)

JUNCTIONS = frozenset(
    (
        *(RoadKind.JUNCTION, RoadKind.RAIL_CROSSING, *ARMS_OF, *ROUNDABOUTS),
        RoadKind.PARKING_LOT,  # whose aisles cross
    )
)
TURNS = frozenset((EgoRoute.LEFT_TURN, EgoRoute.RIGHT_TURN, EgoRoute.TURN))
MOST = 20  # of others, of one of them, and of the deeds of one: more is no situation that a person means
RULED_BY = {Breach.RED_LIGHT: RightOfWay.SIGNAL, Breach.STOP_SIGN: RightOfWay.STOP_SIGN}
"""What rules a junction where somebody breaks such a rule."""
TO_A_SIDE = acts_of(Heads.ACROSS, Heads.BEFORE)
"""Acts that lead from where somebody is at first to the other side."""
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_-]{0,30}")
_WAYS = {
    Moves.DRIVES: "drives",
    Moves.RIDES: "rides",
    Moves.WALKS: "walks",
    Moves.LIES: "only lies there (a ball rolls)",
}


def faults_of(situation: Situation) -> Iterator[Fault]:
    """What is wrong in a situation, whatever could be built of it; nothing if all is well."""
    ids = Counter(_plain(one.id) for one in situation.others)
    yield from _too_many(situation)
    yield from _against_itself(situation)
    yield from _in_a_circle(situation)
    for i, one in enumerate(situation.others):
        at: Path = ("others", i)
        if not _NAME.fullmatch(one.id) or one.id == EGO:
            yield Fault(
                (*at, "id"), f"{one.id!r} is not a name; take letters and digits, as in A or truck2, and not 'ego'"
            )
        elif ids[_plain(one.id)] > 1:
            yield Fault((*at, "id"), f"{one.id!r} is used twice, apart from capitals")
        elif any(_plain(one.id) == f"{_plain(other.id)}-{n}" for other in situation.others for n in range(MOST)):
            yield Fault((*at, "id"), f"{one.id!r} is reserved for a member of a group; take another name")
        yield from _of_other(situation, one, at)
    if situation.others and not situation.adversaries:
        yield Fault(("others",), "nobody is the adversary; give the road user that meets the ego the role 'adversary'")
    if (kind := situation.ego.kind) is not None and not kind.may_be_ego:
        kinds = ", ".join(one for one in UserKind if one.may_be_ego)
        no = "does not describe it, so leave it out" if kind.row.general else _WAYS[kind.moves]
        yield Fault(("ego", "kind"), f"{kind!s} {no}; the ego is one of {kinds}")
    for i, deed in enumerate(situation.ego.does):
        if not deed.act.row.ego:
            acts = ", ".join(act for act in Act if act.row.ego)
            yield Fault(("ego", "does", i, "act"), f"the ego cannot {deed.act!s}; it can {acts}")
        yield from _of_deed(situation, deed, ("ego", "does", i))
    yield from _of_road(situation)
    yield from _of_contact(situation)


def _of_contact(situation: Situation) -> Iterator[Fault]:
    contact = situation.contact
    if contact is None:
        return
    if contact.whom is not None:
        yield from _somebody(situation, contact.whom, ("contact", "whom"), ego=False)
    if contact.behind_nose is not None and contact.at is None:
        yield Fault(("contact", "behind_nose"), "add contact.at, the place on the ego's width")


def _against_itself(situation: Situation) -> Iterator[Fault]:
    """Numbers of the ego and of the road that are measured against the ego's."""
    said: list[tuple[Path, Amount | None]] = [
        (("ego", "speed"), situation.ego.speed),
        (("road", "speed_limit"), situation.road.speed_limit),
    ]
    for i, deed in enumerate(situation.ego.does):
        said += [(("ego", "does", i, name), getattr(deed, name)) for name in AMOUNTS]
    for path, amount in said:
        if amount is not None and amount.than_ego:
            yield Fault(path, f"{amount}: only others can be relative to the ego")


def _plain(name: str) -> str:
    """A name as far as names are told apart."""
    return name.lower().replace("_", "-")


def _too_many(situation: Situation) -> Iterator[Fault]:
    """What is more than anybody means, so that nothing without end is built."""
    if len(situation.others) > MOST:
        yield Fault(("others",), f"there are {len(situation.others)} of them, and {MOST} at most")
    listed: list[tuple[Path, tuple[Deed, ...]]] = [(("ego", "does"), situation.ego.does)]
    listed += [(("others", i, "does"), one.does) for i, one in enumerate(situation.others)]
    for path, does in listed:
        if len(does) > MOST:
            yield Fault(path, f"{len(does)} deeds are too many; at most {MOST}")


_AT_EDGE = frozenset((Where.KERB, Where.BUS_BAY))
"""Places beside the lane at the edge, out of which one comes over only to the other side."""


def goes_over(one: Other, k: int) -> bool:
    """Whether somebody goes by its k-th deed to the side on which it does not begin."""
    act = one.does[k].act
    return act in TO_A_SIDE or (k == 0 and one.starts.where in _AT_EDGE and act in acts_of(Heads.OVER))


def on_another_side(one: Other, at: Path) -> Iterator[Fault]:
    """That somebody is to begin on a side on which its place never lies, where traffic keeps to the right."""
    where, side = one.starts.where, one.starts.side
    if side is not None and not where.row.sided and side not in where.row.sides:
        lies = f"lies on the {' or the '.join(where.row.sides)}" if where.row.sides else "has no side"
        yield Fault((*at, "starts", "side"), f"{where!s} {lies}")


def _of_other(situation: Situation, one: Other, at: Path) -> Iterator[Fault]:
    if one.count > MOST:
        yield Fault((*at, "count"), f"{one.count} is too many; at most {MOST}, and 0 means several")
    if one.count < 0:
        yield Fault((*at, "count"), f"{one.count} is not a number of road users; 0 means several")
    where = one.starts.where
    if not where.row.sides or situation.map is None:  # a map may keep to the left
        yield from on_another_side(one, at)
    side = one.starts.side or (where.row.sides[0] if len(where.row.sides) == 1 else None)  # of a place that has one
    yield from _of_lateral(one.starts.lateral, (*at, "starts", "lateral"))
    if one.hidden_by is not None:
        yield from _somebody(situation, one.hidden_by, (*at, "hidden_by"), ego=False)
        if one.hidden_by == one.id:
            yield Fault((*at, "hidden_by"), "nobody hides itself")
    for k, deed in enumerate(one.does):
        if goes_over(one, k) and deed.to is not None and deed.to is side:
            yield Fault((*at, "does", k, "to"), f"it starts on the {deed.to}, so it can only move to the other side")
        if not one.kind.can(deed.act):
            yield Fault((*at, "does", k, "act"), f"{one.kind!s} {_WAYS[one.kind.moves]}, and cannot {deed.act!s}")
        if deed.whom == one.id:
            yield Fault((*at, "does", k, "whom"), f"nobody does this to itself: {deed.act!s}")
        yield from _of_deed(situation, deed, (*at, "does", k))


def _of_deed(situation: Situation, deed: Deed, at: Path) -> Iterator[Fault]:
    row = deed.act.row
    if deed.to is not None and not row.sided:
        some = ", ".join(act for act in Act if act.row.sided)
        yield Fault((*at, "to"), f"{deed.act!s} has no side, so leave this out; {some} have one")
    ruled = RULED_BY.get(deed.breaks) if deed.breaks is not None else None
    at_side = situation.road.control in (RightOfWay.NONE, RightOfWay.PRIORITY)
    theirs = deed.breaks is Breach.STOP_SIGN and at_side  # whoever comes has the sign
    if ruled is not None and situation.road.control not in (None, ruled) and not theirs:
        yield Fault((*at, "breaks"), f"there is no {deed.breaks!s} with road.control: {situation.road.control}")
    if deed.whom is not None:
        if not row.whom and deed.act not in FOR_SOMEBODY:
            some = ", ".join(act for act in Act if act.row.whom or act in FOR_SOMEBODY)
            yield Fault((*at, "whom"), f"{deed.act!s} has no other party, so leave this out; {some} have one")
        else:
            yield from _somebody(situation, deed.whom, (*at, "whom"), ego=True)
    for name in AMOUNTS:
        if getattr(deed, name) is not None and name not in row.takes:
            has = ", ".join(f"{one} ({says})" for one, says in amounts_of(deed.act).items())
            yield Fault((*at, name), f"{deed.act!s} has no {name}, but {has or 'none of the amounts'}")
    yield from _of_lateral(deed.lateral, (*at, "lateral"), placed=row.placed)
    yield from _of_when(situation, deed, (*at, "when"))


def _of_when(situation: Situation, deed: Deed, at: Path) -> Iterator[Fault]:
    """When a deed begins: of whom and of what there is."""
    if (when := deed.when) is None:
        return
    if when.of is not None:
        yield from _somebody(situation, when.of, (*at, "of"), ego=False)
        if when.ego_within is None:
            yield Fault((*at, "of"), "it needs ego_within, the distance to the ego")
    for name in ("after", "during"):
        if (reference := getattr(when, name)) is not None:
            yield from _some_deed(situation, reference, deed, (*at, name))


def _of_lateral(lateral: Lateral | None, at: Path, *, placed: bool = True) -> Iterator[Fault]:
    """Where across the road somebody is, which one number says, or a side; of a deed, if it leads to such a place."""
    if lateral is None:
        return
    if not placed:
        some = ", ".join(act for act in Act if act.row.placed)
        yield Fault(at, f"it has no lateral position, so leave this out; {some} have")
    said = [name for name in LATERALS if getattr(lateral, name) is not None]
    if len(said) > 1 or (not said and lateral.side is None):
        told = f"has {', '.join(said)}, which are" if said else "says nothing, and is"
        yield Fault(at, f"it {told} no place; say one of {', '.join(LATERALS)}")


def _some_deed(situation: Situation, reference: str, of: Deed, at: Path) -> Iterator[Fault]:
    try:
        if situation.deed(reference) is of:
            yield Fault(at, "a deed cannot wait for itself")
    except KeyError:
        known = [f"{who}.{deed.act}" for who, deeds in situation.everybody() for deed in deeds]
        yield Fault(at, f"there is no deed {reference!r}, but {', '.join(known)}{meant(reference, known, alike=0.5)}")


def _in_a_circle(situation: Situation) -> Iterator[Fault]:
    """Deeds that wait for each other, so that none of them begins."""
    places = {id(deed): (who, i) for who, does in situation.everybody() for i, deed in enumerate(does)}

    def before(deed: Deed) -> Iterator[Deed]:
        who, i = places[id(deed)]
        if i:
            yield situation.does(who)[i - 1]
        for reference in (deed.when.after, deed.when.during) if deed.when is not None else ():
            with suppress(KeyError):
                yield situation.deed(reference or "")

    for k, one in enumerate(situation.others):
        for i, deed in enumerate(one.does):
            waits, seen = list(before(deed)), set[int]()
            while waits:
                if (earlier := waits.pop()) is deed and deed.when is not None:
                    yield Fault(("others", k, "does", i, "when"), "it waits for a deed that waits for it")
                    break
                if id(earlier) not in seen:
                    seen.add(id(earlier))
                    waits += before(earlier)


def _somebody(situation: Situation, name: str, at: Path, *, ego: bool) -> Iterator[Fault]:
    known = [one.id for one in situation.others] + [EGO] * ego
    if name not in known:
        yield Fault(at, f"there is no {name!r} in it, but {', '.join(known) or 'nobody'}{word_meant(name, known)}")


def _of_road(situation: Situation) -> Iterator[Fault]:
    road, route = situation.road, situation.ego.route
    elsewhere = None if road.kind is None or road.kind in JUNCTIONS else road_named(road.kind)
    if elsewhere is not None and route in TURNS:
        yield Fault(("ego", "route"), f"it cannot turn at a junction where the road is {elsewhere}")
    yield from _of_arms(situation)
    for i, one in enumerate(situation.others):
        if one.starts.where.row.junction and elsewhere is not None:
            yield Fault(
                ("others", i, "starts", "where"),
                f"{one.starts.where!s} is at a junction, and the road is {elsewhere}",
            )
    if road.ego_light is not None and road.control not in (None, RightOfWay.SIGNAL):
        yield Fault(("road", "ego_light"), f"there is no light with road.control: {road.control}")
    if road.lanes is not None and road.lanes < 1:
        yield Fault(("road", "lanes"), "a road has at least one lane")
    if road.ego_lane is not None and not 1 <= abs(road.ego_lane) <= (road.lanes or abs(road.ego_lane)):
        lanes = "any number of" if road.lanes is None else road.lanes
        told = f"it is {road.ego_lane}, and the road has {lanes} lanes; 1 is the outermost, -1 the innermost"
        yield Fault(("road", "ego_lane"), told)


FEWEST_ARMS, MOST_ARMS = 3, 5


def arms_said(road: Road) -> int | None:
    """How many arms were said, by their number or by the kind of the junction."""
    return road.arms if road.kind is None else ARMS_OF.get(road.kind, road.arms)


def _of_arms(situation: Situation) -> Iterator[Fault]:
    """What is wrong in what was said of the arms of a junction or a roundabout, and of the exit from that."""
    road, ego = situation.road, situation.ego
    round_about = road.kind in ROUNDABOUTS or (road.kind is None and ego.route is EgoRoute.ROUNDABOUT)
    arms = arms_said(road)
    if road.arms is not None and not FEWEST_ARMS <= road.arms <= MOST_ARMS:
        yield Fault(("road", "arms"), f"{road.arms} arms cannot be built; {FEWEST_ARMS} to {MOST_ARMS} can")
    elif road.arms is not None and road.arms != arms and road.kind is not None:
        yield Fault(("road", "arms"), f"it has {arms} arms where the road is {road_named(road.kind)}")
    if road.arms is not None and road.kind is not None and road.kind not in JUNCTIONS:
        yield Fault(("road", "arms"), f"there are no arms where the road is {road_named(road.kind)}")
    if road.kind is not None and road.kind in ENDS_THERE and ego.route is EgoRoute.STRAIGHT:
        yield Fault(("ego", "route"), f"there is no way straight on where the road is {road_named(road.kind)}")
    if road.side_road is not None and road.kind not in (None, RoadKind.JUNCTION, RoadKind.THREE_WAY):
        yield Fault(("road", "side_road"), f"it is the third arm of a junction; say {RoadKind.THREE_WAY}")
    elsewhere = "only a roundabout has one; say road.kind: roundabout"
    if road.diameter is not None and not round_about:
        yield Fault(("road", "diameter"), elsewhere)
    if ego.exit is not None and not round_about:
        yield Fault(("ego", "exit"), elsewhere)
    elif ego.exit is not None and not 1 <= ego.exit <= (arms or MOST_ARMS):
        yield Fault(("ego", "exit"), f"{ego.exit} is none of its exits: it has {arms or MOST_ARMS} at most")
