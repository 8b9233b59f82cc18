"""How the speeds of those on the road stand to each other, by what each does to whom: a row for each relation.

Who passes is faster than whom it passes, who comes up from behind is faster than the ego, who is caught up is slower,
and who only goes with the traffic is as fast as the ego. Speeds that were said are kept, and those that were not are
chosen about them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from enum import Enum

from chatscene.build.contact import is_held_up, strikes_from_behind
from chatscene.build.place import NEXT_LANE
from chatscene.build.struck import SHARES, runs_into
from chatscene.build.timing import HELD, Body
from chatscene.errors import NotBuilt
from chatscene.maps.open_road import PASSING, SWING
from chatscene.situations.phrases import one_of
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.pace import NOMINAL
from chatscene.terms.seeing import SHARE_LOST
from chatscene.terms.situation import EGO, Deed, Other, Situation
from chatscene.terms.surroundings import FOLLOWS, Surface, Surroundings
from chatscene.terms.vocabulary import PLAIN, SIDEWAYS, SLOWS, Act, EgoRoute, Heads, Role, Tempo, Where, acts_of

PASSES = 1.5  # [m/s] that somebody is faster at least than whom it passes
GAINS = (3.0, 5.5)  # [m/s] by which it is, where that was not said, so that it is past before the road ends
GAINS_AGAINST = (5.0, 8.0)  # [m/s], of who passes in the lane of those who come against it
AGAINST = frozenset((Where.ONCOMING, Where.ONCOMING_IN_OUR_LANE))
AHEAD = frozenset((Where.AHEAD, Where.AHEAD_BESIDE))
BEHIND = frozenset((Where.BEHIND, Where.BEHIND_BESIDE))
ALONG = NEXT_LANE | {Where.AHEAD, Where.BEHIND, Where.ON_RAMP}
_SLOWS_TO = acts_of(Tempo.BRAKES, Tempo.SLOWS)
_GOES = PLAIN | acts_of(Heads.BEHIND)
_WITH = acts_of(Heads.LEVEL, Heads.BEHIND, Heads.CLOSE)
_BESIDE = 0.38  # of a swing, at its end, in which the ego is as far aside as it must be to pass
_SLOWER = 0.85  # of the most that somebody may have, from which on its speed is drawn
_ROOM = 2.0  # [m] between two of whom one has passed the other


class Relation(Enum):
    """How fast somebody is beside the ego, from and to which share of the ego's speed."""

    WITH = (0.95, 1.05)  # goes with the traffic
    AGAINST = (0.9, 1.15)  # comes against it
    CAUGHT_UP = (0.5, 0.75)  # the ego comes up to it
    PASSED = (0.5, 0.7)  # another passes it
    COMES_UP = (1.2, 1.5)  # comes up to the ego
    HAS_PASSED = (1.05, 1.2)  # goes on after it has passed the ego


def relation_of(situation: Situation, one: Other) -> Relation | None:
    """How fast somebody is beside the ego who goes along or against its way; None for others."""
    where, acts = one.starts.where, [deed.act for deed in one.does]
    if where not in ALONG | AGAINST or not (one.kind.row.body.row.motorised or goes_with(one)):
        return None
    only_goes = one.role is Role.ADVERSARY and all(act.row.lasting and act not in _WITH for act in acts)
    followed = any(deed.act is Act.FOLLOW for deed in situation.ego.does)
    slows = slows_on_its_way(situation)  # so that who does not comes up to it
    slows = slows or (strikes_from_behind(situation, one) and is_held_up(situation))
    rows = (
        (Relation.PASSED, any(True for _ in _passes(situation, one))),
        (Relation.AGAINST, where in AGAINST),
        (Relation.CAUGHT_UP, where in NEXT_LANE and any(_is_gone_past(one, deed) for deed in situation.ego.does)),
        (Relation.CAUGHT_UP, where in AHEAD and only_goes and not followed),
        (Relation.COMES_UP, where in BEHIND and only_goes and not slows),
        (Relation.HAS_PASSED, bool(acts) and acts[-1] is Act.OVERTAKE and one.does[-1].whom in (None, EGO)),
    )
    return next((relation for relation, holds in rows if holds), Relation.WITH)


def _is_gone_past(one: Other, deed: Deed) -> bool:
    """Whether the ego overtakes somebody by a deed."""
    return deed.act is Act.OVERTAKE and deed.whom in (None, one.id)


def goes_with(one: Other) -> bool:
    """Whether somebody who drives is to keep to the ego: to follow it, close or not, or to stay level with it."""
    keeps = any(deed.act in _WITH and deed.whom in (None, EGO) for deed in one.does)
    return keeps and one.starts.where in ALONG and one.kind.moves is not Moves.WALKS


def _comes_from_beside(one: Other) -> bool:
    """Whether somebody who drives level with the ego comes over: until then it is to stay level."""
    comes = any(deed.act in SIDEWAYS and deed.done_to == EGO for deed in one.does)
    return comes and one.starts.where is Where.BESIDE and one.kind.moves is not Moves.WALKS


def _holds(situation: Situation, one: Other) -> float:
    """The most [m/s] that somebody who drives holds."""
    return Body(situation.row_of(one).limits, walks=False).fastest


def _said_behind(situation: Situation, one: Other) -> float:
    """The speed [m/s] that was said of somebody who comes along behind the ego, and does nothing else; inf if none."""
    met = one.starts.where is Where.BEHIND and one.role is Role.ADVERSARY
    goes = met and bool(one.does) and all(deed.act in _GOES for deed in one.does)
    goes = goes and runs_into(situation, one) is None  # whom the ego lets come up by what it does
    said = said_speed(one, 0.0) if goes and not _than_ego(one) else None
    return math.inf if said is None or said <= 0.0 else said


def _than_ego(one: Other) -> bool:
    return any(said is not None and said.than_ego for said in (one.starts.speed, *(deed.speed for deed in one.does)))


def speed_kept_up(situation: Situation) -> float:
    """The most [m/s] at which all go who are to keep to the ego, or to be level with it when they come over.

    Or come along behind it. It is what they hold, or what was said of them.
    """
    held = (_holds(situation, one) for one in situation.others if goes_with(one) or _comes_from_beside(one))
    level = (said_speed(one, 0.0) for one in situation.others if _comes_from_beside(one) and not _than_ego(one))
    said = (speed for speed in level if speed)
    return min((*held, *said, *(_said_behind(situation, one) for one in situation.others)), default=math.inf)


def slows_on_its_way(situation: Situation) -> bool:
    """Whether the ego drives at first, and then slows down or stops by what was said of it."""
    acts = [deed.act for deed in situation.ego.does]
    return bool(acts) and acts[0] is not Act.STAND and not SLOWS.isdisjoint(acts)


def speed_beside(situation: Situation, one: Other, ego: float) -> tuple[float, float] | None:
    """How fast [m/s] somebody is, from and to, of whom no speed was said; None for who stands in no relation.

    Args:
        situation: What was said.
        one: Who.
        ego: What the ego drives at [m/s].
    """
    if is_passed_by_ego(situation, one):
        most = passed_share(situation, one) * ego
        return _SLOWER * most, most
    if (does := runs_into(situation, one)) is not None:
        low, high = SHARES[does]
        return low * ego, high * ego
    relation = relation_of(situation, one)
    if relation is None:
        return None
    row, own = one.kind.row.body.row, situation.ego.body.row
    slower = relation is Relation.AGAINST and own.fast < row.fast  # it is no measure of who comes against it
    low, high = (share * (max(ego, NOMINAL.speed) if slower else ego) for share in relation.value)
    for deed in _passes(situation, one):
        if deed.speed is not None:  # how fast it is passed
            high = min(high, deed.speed.beside(ego).least - PASSES)
            low = min(low, _SLOWER * high)
    return low, high


def is_passed_by_ego(situation: Situation, one: Other) -> bool:
    """Whether somebody is ahead of an ego that is to overtake."""
    return situation.ego.route is EgoRoute.OVERTAKE and one.starts.where is Where.AHEAD


def passed_share(situation: Situation, one: Other) -> float:
    """The most of the ego's speed that somebody may have whom it passes while it has swung out."""
    both = situation.ego.body.row.limits.length + one.kind.row.body.row.limits.length + _ROOM
    return max(0.1, 1.0 - both / (PASSING + 2.0 * _BESIDE * SWING))


def _passes(situation: Situation, one: Other) -> Iterator[Deed]:
    """The deeds by which others pass somebody."""
    yield from (d for other in situation.others for d in other.does if d.act is Act.OVERTAKE and d.whom == one.id)


def grip_of(situation: Situation) -> float:
    """The largest acceleration [m/s²] that the road lets anybody have; infinite where it does not limit it."""
    around = situation.around
    surface = around.surface or (FOLLOWS.get(around.weather) if around.weather else None)
    return Surroundings(surface=surface or Surface.DRY).grip


def said_speed(one: Other, ego: float) -> float | None:
    """The speed [m/s] that was said of somebody who goes on at it."""
    deeds = (deed.speed for deed in one.does if deed.act in PLAIN and deed.speed is not None)
    said = one.starts.speed or next(deeds, None)
    return None if said is None else said.beside(ego).least


def speed_of_traffic(situation: Situation) -> float:
    """The most [m/s] that was said of anybody who goes the ego's way, so far as the ego goes as fast; 0 if nothing was.

    Who passes the ego, or comes up to it, is faster than it is.
    """
    most = 0.0
    for one in situation.others:
        relation = relation_of(situation, one)
        if one.starts.where not in ALONG or relation in (None, Relation.CAUGHT_UP, Relation.PASSED):
            continue
        passes = any(deed.act is Act.OVERTAKE and deed.whom in (None, EGO) for deed in one.does)
        goes = (deed.speed for deed in one.does if deed.act in acts_of(Heads.ALONG, Heads.BY, Heads.DRIFTS))
        said = [speed.least for speed in (one.starts.speed, *goes) if speed is not None and not speed.than_ego]
        fastest = max((*said, *map(_had_before, one.does)), default=0.0)
        faster = passes or relation in (Relation.COMES_UP, Relation.HAS_PASSED)
        most = max(most, fastest - GAINS[0] if faster else fastest)
    return most


def _had_before(deed: Deed) -> float:
    """The speed [m/s] from which somebody clearly slows down to a speed that was said; 0 for other deeds."""
    if deed.act not in _SLOWS_TO or deed.speed is None or deed.speed.than_ego or deed.speed.least <= 0.0:
        return 0.0
    return deed.speed.least / (1.0 - SHARE_LOST)


def speed_of(situation: Situation, name: str, ego: float) -> float:
    """The most [m/s] at which somebody goes on, by what was said of it or by how it stands to the ego."""
    if name == EGO:
        waits = situation.ego.does and all(deed.act is Act.STAND for deed in situation.ego.does)
        return 0.0 if waits else ego
    one = situation[name]
    if (said := said_speed(one, ego)) is not None:
        return said
    beside = speed_beside(situation, one, ego)
    return beside[1] if beside is not None else ego


def falls_behind(situation: Situation, one: Other, ego: float) -> float:
    """By how much [m/s] the ego is faster than somebody can be who goes along on wheels with a motor."""
    row = situation.row_of(one)
    if not row.motorised:
        return 0.0
    most = Body(row.limits, walks=False).fastest
    return max(0.0, ego - min(most, said_speed(one, ego) or most))


def check_kept_up(situation: Situation, ego: float) -> None:
    """Refuse an ego that drives on faster than somebody holds who is to keep to it.

    Raises:
        NotBuilt: By what was said it does.
    """
    if situation.ego.does:  # by which it may be slower
        return
    for one in situation.others:
        if (most := _said_behind(situation, one)) < HELD * ego:
            raise NotBuilt(
                f"others.{one.id}: at {3.6 * most:.0f} km/h an ego at {3.6 * ego:.0f} km/h leaves it behind; say an"
                f" ego at {3.6 * most:.0f} km/h at most, or a faster {one.kind}"
            )
        if goes_with(one) and (most := _holds(situation, one)) < HELD * ego:
            k = next(k for k, deed in enumerate(one.does) if deed.act in _WITH)
            raise NotBuilt(
                f"others.{one.id}.does.{k}.act: {one.does[k].act}: {one_of(one.kind)} drives at most {3.6 * most:.0f} "
                f"km/h, so an ego at {3.6 * ego:.0f} km/h leaves it behind; say an ego at {3.6 * most:.0f} km/h at most"
            )


def check_passed_by_ego(situation: Situation, ego: float) -> None:
    """Refuse an ego that is no faster than whom it is to pass.

    Raises:
        NotBuilt: By what was said it is not.
    """
    for one in situation.others:
        said = said_speed(one, ego) if is_passed_by_ego(situation, one) else None
        if said is not None and said > (most := passed_share(situation, one) * ego):
            raise NotBuilt(
                f"others.{one.id}: the ego at {3.6 * ego:.0f} km/h does not overtake {one_of(one.kind)} at "
                f"{3.6 * said:.0f} km/h before it must return to its lane; say {3.6 * most:.0f} km/h at most, or a"
                " faster ego"
            )
