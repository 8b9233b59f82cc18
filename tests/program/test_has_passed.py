"""Who slows or swerves for what another does has that one before it, and has not passed it by."""

from __future__ import annotations

from dataclasses import replace

import pytest
from test_encounter import found, one, other
from test_meaning import episode, moving

from chatscene.terms.episode import Role as Plays
from chatscene.terms.episode import Track
from chatscene.terms.situation import Deed, When
from chatscene.terms.vocabulary import Act, Side, Where

BRAKES = Deed(act=Act.BRAKE, when=When(during="adversary.cross"))
LEADER = other(Where.AHEAD, Deed(act=Act.GO_ALONG), BRAKES, name="B")


def leader(brakes_at: int) -> Track:
    """A car 20 m ahead that goes at 10 m/s for so many steps, and then brakes to a stand."""
    still = 70 - brakes_at
    track = moving(20.0, 0.0, (brakes_at, 10.0, 0.0), (30, 0.0, 0.0), (still, 0.0, 0.0), speed=10.0)
    return replace(track, actor="B", role=Plays.BACKGROUND)


@pytest.mark.parametrize(("brakes_at", "answers"), [(10, True), (60, False)])
def test_who_brakes_for_somebody_who_crosses_has_that_one_before_it(brakes_at: int, answers: bool) -> None:
    crosses = moving(55.0, -8.0, (100, 1.5, 90.0), facing=90.0, speed=1.5, kind="Pedestrian")
    said = one(other(Where.ROADSIDE, Deed(act=Act.CROSS), side=Side.RIGHT), LEADER)
    seen = episode(crosses)
    finding = found("encounter.B", said, replace(seen, tracks=(*seen.tracks, leader(brakes_at))))
    assert (finding is None or finding.shown is not False) is answers
