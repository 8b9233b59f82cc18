"""Situations at random, from all the words there are; each is well formed."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from hypothesis import strategies as st

from chatscene.situations.check import JUNCTIONS, TURNS, goes_over
from chatscene.terms.act_amounts import AMOUNTS
from chatscene.terms.amount import Acceleration, Amount, Duration, Length, Share, Speed
from chatscene.terms.situation import (
    LATERALS,
    Around,
    Contact,
    Deed,
    Ego,
    Lateral,
    Other,
    Road,
    Situation,
    Start,
    When,
)
from chatscene.terms.surroundings import Light, Surface, Weather
from chatscene.terms.vocabulary import (
    ENDS_THERE,
    Act,
    Breach,
    EgoLight,
    EgoRoute,
    Facing,
    Feature,
    Manner,
    Part,
    RightOfWay,
    RoadKind,
    Role,
    Setting,
    Side,
    Striker,
    UserKind,
    Where,
)

_KINDS_OF_AMOUNT: dict[str, type[Amount]] = dict(zip(AMOUNTS, (Speed, Acceleration, Length, Duration), strict=True))


def maybe(what: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    """It, or what was not said."""
    return st.none() | what


@st.composite
def amounts(draw: st.DrawFn, kind: type[Amount], of_ego: bool = False) -> Amount:
    """One as people say it."""
    unit = draw(st.sampled_from([unit for unit in kind.UNITS if unit]))
    low, more = draw(st.integers(1, 90)), draw(st.sampled_from((0, 0, 5)))
    number = f"{low} to {low + more}" if more else str(low)
    bound = "" if more else draw(st.sampled_from(("", "", "at most ", "at least ")))
    than = (
        draw(st.sampled_from(("", "", " more than the ego", " less than the ego")))
        if kind.RELATIVE and not (bound or of_ego)
        else ""
    )
    return kind.of(f"{bound}{number} {unit}{than}")


@st.composite
def laterals(draw: st.DrawFn) -> Lateral:
    """Where across the road somebody is."""
    kinds = dict.fromkeys(LATERALS, Length) | {"overlap": Share}
    name = draw(st.sampled_from(LATERALS))
    made: dict[str, Any] = {name: draw(amounts(kinds[name]))}
    return Lateral(side=draw(maybe(st.sampled_from(Side))), **made)


@st.composite
def deeds(
    draw: st.DrawFn,
    acts: list[Act],
    earlier: list[str],
    whom: list[str],
    breaches: list[Breach],
    of_ego: bool = False,
) -> Deed:
    """What somebody does who can do some acts, perhaps to some, and after or while something that was done earlier."""
    act = draw(st.sampled_from(acts))
    said = {name: draw(maybe(amounts(_KINDS_OF_AMOUNT[name], of_ego))) for name in sorted(act.row.takes)}
    when = None
    if draw(st.booleans()):
        names = maybe(st.sampled_from(earlier)) if earlier else st.none()
        near = draw(maybe(amounts(Length) | amounts(Duration)))
        when = When(
            after=draw(names),
            during=draw(names),
            delay=draw(maybe(amounts(Duration))),
            ego_within=near,
            of=draw(maybe(st.sampled_from([one for one in whom if one != "ego"] or [None]))) if near else None,
        )
    return Deed(
        act=act,
        to=draw(maybe(st.sampled_from(Side))) if act.row.sided else None,
        whom=draw(maybe(st.sampled_from(whom))) if act.row.whom and whom else None,
        manner=draw(maybe(st.sampled_from(Manner))),
        breaks=draw(maybe(st.sampled_from(breaches))),
        when=when,
        lateral=draw(maybe(laterals())) if act.row.placed else None,
        **said,
    )


@st.composite
def situations(draw: st.DrawFn) -> Situation:
    """One with up to three others, each with up to four deeds."""
    road = draw(
        st.builds(
            Road,
            kind=maybe(st.sampled_from(RoadKind)),
            setting=maybe(st.sampled_from(Setting)),
            control=maybe(st.sampled_from(RightOfWay)),
            lanes=maybe(st.integers(1, 4)),
            two_way=maybe(st.booleans()),
            speed_limit=maybe(amounts(Speed, of_ego=True)),
            has=st.lists(st.sampled_from(Feature), unique=True, max_size=2).map(tuple),
        )
    )
    light = draw(maybe(st.sampled_from(EgoLight))) if road.control in (None, RightOfWay.SIGNAL) else None
    lane = draw(maybe(st.integers(1, road.lanes))) if road.lanes else None
    road = replace(road, ego_light=light, ego_lane=lane)
    at_junction = road.kind is None or road.kind in JUNCTIONS
    routes = [route for route in EgoRoute if at_junction or route not in TURNS]
    if road.kind in ENDS_THERE:
        routes.remove(EgoRoute.STRAIGHT)
    earlier: list[str] = []
    lit = road.control in (None, RightOfWay.SIGNAL)
    signed = road.control in (None, RightOfWay.STOP_SIGN)
    ruled = {Breach.RED_LIGHT: lit, Breach.STOP_SIGN: signed}
    breaches = [one for one in Breach if ruled.get(one, True)]
    own = draw(st.lists(deeds([act for act in Act if act.row.ego], [], [], breaches, of_ego=True), max_size=2))
    earlier += [f"ego.{i}" for i in range(len(own))]
    others: list[Other] = []
    for name in "ABC"[: draw(st.integers(0, 3))]:
        kind = draw(st.sampled_from(UserKind))
        where = draw(st.sampled_from([one for one in Where if at_junction or not one.row.junction]))
        acts = [act for act in Act if kind.moves in act.row.by]
        whom = ["ego", *(one.id for one in others)]
        does = draw(st.lists(deeds(acts, list(earlier), whom, breaches), max_size=4))
        earlier += [f"{name}.{i}" for i in range(len(does))]
        start = Start(
            where=where,
            side=draw(maybe(st.sampled_from(Side))) if where.row.sided else None,
            distance=draw(maybe(amounts(Length))),
            speed=draw(maybe(amounts(Speed))),
            facing=draw(maybe(st.sampled_from(Facing))),
            lateral=draw(maybe(laterals())),
        )
        side = start.side or (where.row.sides[0] if len(where.row.sides) == 1 else None)
        made = Other(id=name, kind=kind, starts=start, does=tuple(does))
        does = [replace(one, to=None) if goes_over(made, k) and one.to is side else one for k, one in enumerate(does)]
        role = Role.ADVERSARY if not others else draw(st.sampled_from(Role))
        hidden = draw(maybe(st.sampled_from([one.id for one in others]))) if others else None
        count = draw(st.sampled_from((1, 1, 1, 2, 0)))
        others.append(
            Other(id=name, kind=kind, count=count, role=role, starts=start, hidden_by=hidden, does=tuple(does))
        )
    contact = st.builds(
        Contact,
        whom=maybe(st.sampled_from([one.id for one in others])) if others else st.none(),
        ego=maybe(st.sampled_from(Part)),
        other=maybe(st.sampled_from(Part)),
        striker=maybe(st.sampled_from(Striker)),
        happens=st.booleans(),
        at=maybe(amounts(Share)),
    )
    around = st.builds(
        Around,
        light=maybe(st.sampled_from(Light)),
        weather=maybe(st.sampled_from(Weather)),
        surface=maybe(st.sampled_from(Surface)),
    )
    return Situation(
        ego=Ego(
            kind=draw(maybe(st.sampled_from([kind for kind in UserKind if kind.may_be_ego]))),
            route=draw(maybe(st.sampled_from(routes))),
            speed=draw(maybe(amounts(Speed, of_ego=True))),
            does=tuple(own),
        ),
        road=road,
        others=tuple(others),
        contact=draw(maybe(contact)),
        around=draw(around),
    )
