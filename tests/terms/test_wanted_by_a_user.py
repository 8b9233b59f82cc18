"""A program whose ego is told a speed that nobody has said."""

from __future__ import annotations

import pytest

from chatscene.terms.scene import ScenicProgram, at_speed

HEAD = "model chatscene.world.model\negoRoute = selectRoute(maneuver='straight')\n"
TAIL = "\nother = new Car at pointOn(egoRoute, 20), with speed 14, with behavior AdvBehavior()\n"


def program(ego: str, **more: object) -> ScenicProgram:
    source = f"{HEAD}{ego}{TAIL}"
    return ScenicProgram(scenario_id="a", source=source, parameters=(), snippet_ids=(), **more)  # pyright: ignore[reportArgumentType]


def told(ego: str) -> str:
    made = at_speed(program(ego), 20.0)
    assert made.source.startswith(HEAD)
    assert made.source.endswith(TAIL)
    assert made.wanted_speed == 20.0
    return made.source[len(HEAD) : -len(TAIL)]


def test_an_ego_of_which_nothing_is_said_wants_it() -> None:
    assert told("ego = new Car at startOf(egoRoute), with route egoRoute") == (
        "ego = new Car with wantedSpeed 20, at startOf(egoRoute), with route egoRoute"
    )
    assert told("ego = new Bus") == "ego = new Bus with wantedSpeed 20"
    assert told("ego = new Car at startOf(egoRoute),\n    with route egoRoute").count("wantedSpeed") == 1


def test_the_speed_of_the_road_gives_way_with_what_the_ego_begins_at() -> None:
    road = "ego = new Car at startOf(egoRoute), with speed 14, with wantedSpeed 14, with keepsLimits True"
    assert program(road).keeps_limits
    assert (
        told(road) == "ego = new Car at startOf(egoRoute), with speed 20, with wantedSpeed 20, with keepsLimits False"
    )
    assert not at_speed(program(road), 20.0).keeps_limits
    begun = road.replace("with speed 14", "with speed speedOn(egoRoute, 0, 14)")
    assert told(begun) == told(road)
    slower = "ego = new Car at startOf(egoRoute), with speed 9, with wantedSpeed 14, with keepsLimits True"
    assert "with speed 9, with wantedSpeed 20" in told(slower)


@pytest.mark.parametrize("limits", ["", ", with keepsLimits False"])
def test_what_was_said_stays(limits: str) -> None:
    said = program(f"ego = new Car at startOf(egoRoute), with wantedSpeed 14{limits}")
    assert at_speed(said, 20.0) == said


def test_so_does_a_program_whose_own_ego_drives_or_in_which_nothing_can_be_wanted() -> None:
    for one in (
        program("ego = new Car at startOf(egoRoute)", as_written=True),
        program("ego = new Car at startOf(egoRoute)", model="scenic.domains.driving.model"),
        program("ego = theirCar(egoRoute)"),
    ):
        assert at_speed(one, 20.0) is one
