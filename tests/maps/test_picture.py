"""A moment of a drive as a picture."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from chatscene.maps.picture import HEIGHT, OVERSAMPLE, TILE, WIDEST, WIDTH, Camera, draw_frame, draw_ground, reduced
from chatscene.terms.episode import Ending, Episode, Role, Track

STEPS = 70
SHOWN = list(range(STEPS - 10))  # the drive goes on when nothing is shown any more


def going(role: Role, x: float, y: float, speed_x: float, speed_y: float = 0.0) -> Track:
    time = np.arange(STEPS) * 0.1
    return Track(
        actor=str(role), role=role, kind="Car", length=4.5, width=2.0, x=x + speed_x * time, y=y + speed_y * time,
        heading=np.full(STEPS, np.arctan2(speed_y, speed_x)), speed=np.full(STEPS, float(np.hypot(speed_x, speed_y))),
    )  # fmt: skip


def driven(*tracks: Track) -> Episode:
    return Episode(
        scene_id="s", ego="e", dt=0.1, tracks=tracks, events=(), signals=(), route_completion=0.5,
        ending=Ending.TIMEOUT, distance_to_route=np.zeros(STEPS), off_road=np.zeros(STEPS, dtype=np.bool_),
    )  # fmt: skip


def seen(*tracks: Track) -> NDArray[Any]:
    """Where the ego is in the picture at each step that is shown [px]."""
    camera, ego = Camera.on(driven(*tracks), SHOWN, WIDEST), tracks[0]
    return np.array(camera.points([(ego.x[step], ego.y[step]) for step in SHOWN])) / OVERSAMPLE


def inside(points: NDArray[Any]) -> bool:
    return bool((points > 0).all() and (points < (WIDTH, HEIGHT)).all())


@pytest.mark.parametrize(
    "other", [(20.0, 0.0, 40.0), (20.0, 0.0, -40.0), (0.0, 150.0, 0.0, -10.0), (0.0, -150.0, 5.0, 30.0)]
)
def test_an_ego_is_seen_from_its_first_step_to_the_last_however_far_the_other_goes(other: tuple[float, ...]) -> None:
    assert inside(seen(going(Role.EGO, 0.0, 0.0, 8.0), going(Role.ADVERSARY, *other)))


def test_of_an_ego_that_goes_too_far_itself_the_end_is_seen() -> None:
    way = seen(going(Role.EGO, 0.0, 0.0, 40.0), going(Role.ADVERSARY, 20.0, 0.0, 8.0))
    assert not inside(way)
    assert inside(way[-1:])


def test_of_many_frames_each_is_as_it_would_be_drawn_by_itself() -> None:
    assert (WIDTH % TILE, HEIGHT % TILE) == (0, 0)
    episode = driven(going(Role.EGO, 0.0, 0.0, 8.0), going(Role.ADVERSARY, 60.0, 3.3, -6.0, 0.5))
    camera = Camera.on(episode, SHOWN, WIDEST)
    road = [[-50.0, -7.1], [90.0, -5.3], [90.0, 6.2], [-50.0, 5.7]]
    ground = draw_ground(camera, {"roads": [[road]], "lane_boundaries": [{"kind": "dashed", "points": road[1:3]}]})
    for step in range(0, STEPS, 7):
        alone = draw_frame(camera, ground, episode, step)
        assert draw_frame(camera, ground, episode, step, reduced(ground)).tobytes() == alone.tobytes()
