import dataclasses

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from chatscene.terms import episode, metrics, route, scenario, scene, snippet
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.scenario import BaseScenario, Component, Side, Slots, SubDescriptions
from chatscene.terms.snippet import ParameterRange

NOUNS = [
    noun
    for module in (episode, metrics, route, scenario, scene, snippet)
    for noun in vars(module).values()
    if dataclasses.is_dataclass(noun) and isinstance(noun, type) and noun.__module__ == module.__name__
]


@pytest.mark.parametrize("noun", NOUNS, ids=lambda noun: noun.__name__)
def test_every_noun_is_frozen_and_takes_its_fields_by_name(noun: type) -> None:
    assert noun.__dataclass_params__.frozen  # type: ignore[attr-defined]
    assert all(field.kw_only for field in dataclasses.fields(noun))


def test_empty_slots_say_nothing() -> None:
    assert Slots().said() == {}


def test_slots_say_what_is_filled_and_nothing_else() -> None:
    slots = Slots(adversary=AdversaryKind.CAR, actions=(Action.BRAKE,), side=Side.LEFT)
    assert slots.said() == {"adversary": AdversaryKind.CAR, "actions": (Action.BRAKE,), "side": Side.LEFT}


def test_a_slot_that_is_denied_counts_as_said() -> None:
    assert Slots(leader=False).said() == {"leader": False}


def test_sub_descriptions_are_found_by_component() -> None:
    parts = SubDescriptions(behavior="b", geometry="g", spawn="s")
    assert [parts[component] for component in Component] == ["b", "g", "s"]


def test_there_are_eight_base_scenarios() -> None:
    assert len(BaseScenario) == 8


@given(st.floats(-10, 10), st.floats(0, 10), st.floats(-100, 100))
def test_clipping_gives_the_nearest_value_inside_the_range(low: float, width: float, value: float) -> None:
    declared = ParameterRange(name="OPT_X", low=low, high=low + width, unit="m")
    clipped = declared.clip(value)
    assert declared.low <= clipped <= declared.high
    assert clipped == value or clipped in (declared.low, declared.high)
    assert declared.clip(clipped) == clipped


def track(name: str, role: episode.Role, speed: list[float], heading: list[float]) -> episode.Track:
    return episode.Track(
        actor=name, role=role, kind="Car", length=4.5, width=1.9, x=np.zeros(len(speed)), y=np.zeros(len(speed)),
        heading=np.array(heading), speed=np.array(speed),
    )  # fmt: skip


def test_acceleration_and_yaw_rate_are_nothing_in_the_first_row() -> None:
    moved = track("ego", episode.Role.EGO, [1.0, 1.5, 1.5], [0.0, 0.0, 0.2])
    assert moved.acceleration(0.1).tolist() == pytest.approx([0.0, 5.0, 0.0])
    assert moved.yaw_rate(0.1).tolist() == pytest.approx([0.0, 0.0, 2.0])


def test_an_episode_knows_its_ego_its_adversaries_its_first_collision_and_its_duration() -> None:
    roles = (episode.Role.EGO, episode.Role.ADVERSARY, episode.Role.OCCLUDER)
    tracks = tuple(track(role.value, role, [0.0] * 3, [0.0] * 3) for role in roles)
    hits = tuple(episode.Event(kind=episode.EventKind.COLLISION, step=s, other="adversary") for s in (1, 2))
    lane = episode.Event(kind=episode.EventKind.LANE_INVASION, step=0)
    drive = episode.Episode(
        scene_id="s", ego="e", dt=0.1, tracks=tracks, events=(lane, *hits), signals=(), route_completion=0.0,
        ending=episode.Ending.COLLISION, distance_to_route=np.zeros(3), off_road=np.zeros(3, dtype=bool),
    )  # fmt: skip
    assert drive.ego_track is tracks[0]
    assert drive.adversaries == (tracks[1],)
    assert drive.collision is hits[0]
    assert drive.duration == pytest.approx(0.2)
    assert repr(drive) == "Episode(s, e, 3 steps, 3 actors, collision)"
