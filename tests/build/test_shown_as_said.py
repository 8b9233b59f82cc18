"""What was said is what drives show: kinds that were built and not shown, judged as `verify` judges."""

from __future__ import annotations

import pytest
import yaml
from test_building import drive, simulator

from chatscene.build.build import build
from chatscene.errors import NotBuilt
from chatscene.settings import VerifySettings
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode
from chatscene.verdict.said import Asked
from chatscene.verdict.verify import weighed
from chatscene.verdict.watched import Watched, Watching

SHOWN = {
    "by a ramp, over our lane": """
        road: {kind: motorway, has: [off-ramp]}
        others:
        - {id: A, kind: car, starts: {where: ahead-beside, side: left}, does: [{act: cut-in}, {act: exit}]}""",
    "by a ramp, out of our lane": """
        road: {kind: motorway}
        others: [{id: A, kind: truck, starts: {where: ahead}, does: [{act: slow-down}, {act: exit}]}]""",
    "passes, comes in, brakes, and is off by a ramp": """
        road: {kind: motorway, has: [off-ramp]}
        others:
        - id: A
          kind: car
          starts: {where: behind-beside, side: left}
          does: [{act: overtake}, {act: cut-in}, {act: brake}, {act: exit}]""",
    "backs up in a queue": """
        ego: {does: [{act: stand}]}
        others: [{id: A, kind: truck, starts: {where: ahead}, does: [{act: reverse}]}]
        contact: {whom: A, ego: front, other: rear, striker: other}""",
    "pulls out behind who stands in our lane": """
        others:
        - {id: A, kind: car, starts: {where: kerb, side: left}, does: [{act: stand}, {act: pull-out}]}
        - {id: B, kind: truck, role: supporting, starts: {where: ahead}, does: [{act: stand}]}""",
    "comes driving, and stops before it meets us": """
        road: {kind: junction}
        others:
        - {id: A, kind: car, starts: {where: arm, side: right}, does: [{act: go-straight, speed: 70 km/h}]}
        - id: B
          kind: car
          role: supporting
          starts: {where: oncoming, speed: 60 km/h}
          does: [{act: stop}, {act: set-off}]""",
    "slows behind us, passes and comes in with a gap": """
        others:
        - id: A
          kind: emergency-vehicle
          starts: {where: behind-beside, side: left}
          does: [{act: slow-down}, {act: overtake}, {act: cut-in, distance: 6 m}]""",
    "gains speed behind us while we merge": """
        ego: {route: merge}
        road: {kind: motorway, has: [on-ramp]}
        others: [{id: A, kind: van, starts: {where: behind-beside, side: left}, does: [{act: accelerate}]}]""",
    "comes along behind us at a walking pace": """
        others: [{id: A, kind: car, starts: {where: behind}, does: [{act: go-along, speed: 15 km/h}]}]""",
    "stays in its lane as we change ours": """
        ego: {route: lane-change-left}
        others: [{id: A, kind: van, starts: {where: behind}, does: [{act: go-along}]}]""",
    "is slow before us until we change lanes": """
        ego: {route: lane-change-left}
        road: {kind: motorway}
        others:
        - {id: A, kind: motorcycle, starts: {where: behind-beside, side: left}, does: [{act: overtake}]}
        - id: B
          kind: car
          role: supporting
          starts: {where: ahead}
          does: [{act: go-along, manner: slow}]""",
    "turns back and falls in our lane": """
        others:
        - id: A
          kind: pedestrian
          starts: {where: crossing, side: right}
          does: [{act: cross, speed: 5 km/h}, {act: turn-back}, {act: fall}]""",
    "hidden from a slow ego": """
        ego: {does: [{act: go-along, manner: slow}]}
        others:
        - {id: A, kind: pedestrian, starts: {where: roadside, side: right}, hidden_by: B, does: [{act: cross}]}
        - {id: B, kind: bus, role: hides, starts: {where: kerb, side: right}, does: [{act: stand}]}""",
    "behind a lorry that passes": """
        road: {kind: four-way, control: signal}
        others:
        - {id: A, kind: car, starts: {where: oncoming}, hidden_by: B, does: [{act: turn-left}]}
        - {id: B, kind: truck, role: supporting, starts: {where: oncoming}, does: [{act: go-straight}]}""",
    "behind a van that is half parked": """
        others:
        - {id: A, kind: pedestrian, starts: {where: roadside, side: right}, hidden_by: B, does: [{act: cross}]}
        - id: B
          kind: van
          role: hides
          starts: {where: kerb, side: right, lateral: {side: right, overlap: 30 %}}
          does: [{act: stand}]""",
    "tailgates at a distance": """
        others: [{id: A, kind: car, starts: {where: behind}, does: [{act: tailgate, distance: 12 m}]}]""",
    "runs a red light before us": """
        road: {kind: four-way, control: signal}
        others:
        - {id: A, kind: motorcycle, starts: {where: oncoming}, does: [{act: go-along}]}
        - id: B
          kind: car
          role: supporting
          starts: {where: arm, side: left}
          does: [{act: go-straight, breaks: red-light}]""",
    "opens a door in our lane": """
        others: [{id: A, kind: car, starts: {where: ahead}, does: [{act: stand}, {act: open-door}]}]""",
    "we gain speed to what was said": """
        ego: {route: left-turn, speed: 10 km/h, does: [{act: accelerate, speed: 24 km/h}]}
        road: {kind: four-way}
        others: [{id: A, kind: car, starts: {where: oncoming}, does: [{act: go-straight, speed: 15 km/h}]}]""",
}
"""Situations, by what they are of."""
DRAWS = 4


@pytest.mark.parametrize("name", SHOWN)
def test_most_drives_show_what_was_said(name: str) -> None:
    said = from_plain(yaml.safe_load(SHOWN[name]))
    one = build(said)
    route = simulator(one.map, "native").route(one.program, 0)
    drives = [drive(one, seed=seed, ego="planner") for seed in range(DRAWS)]
    watched = tuple(Watched(episode=made, route=route) for made in drives if isinstance(made, Episode))
    assert len(watched) == DRAWS, drives
    verdict = weighed(Watching(kind="program", drives=watched), name, Asked(situation=said), VerifySettings())
    assert verdict.failing == ()


@pytest.mark.parametrize(
    ("written", "told"),
    [
        (
            "{ego: {speed: 90 km/h}, road: {kind: junction}, others: [{id: A, kind: car, starts: {where: behind-beside,"
            " side: left}, does: [{act: overtake}, {act: cut-in, distance: 5 m}, {act: brake}]}]}",
            "others.A: its deeds take",
        ),
        (
            "{ego: {route: overtake}, others: [{id: A, kind: car, starts: {where: oncoming}}]}",
            "impossible: ego.route: there is nobody to overtake",
        ),
        (
            "{others: [{id: A, kind: car, starts: {where: oncoming}, does: [{act: overtake}, {act: overtake}]}]}",
            "impossible: others.A.does.1.act: after overtake it is already in our lane or past it",
        ),
        (
            "{road: {kind: four-way}, others: [{id: A, kind: car, starts: {where: ahead}, does: [{act: exit}]}]}",
            "cannot be built yet: others.A.does.0.act: exit at a junction; say turn-right",
        ),
        (
            "{road: {kind: four-way, control: signal, ego_light: green}, others: [{id: A, kind: car,"
            " starts: {where: oncoming}, does: [{act: go-straight, breaks: red-light}]}]}",
            "cannot be built yet: others.A.does.0.breaks: red-light, oncoming: its light shows",
        ),
        (
            "{ego: {speed: 50 km/h}, others: [{id: A, kind: car, starts: {where: behind},"
            " does: [{act: go-along, speed: 15 km/h}]}]}",
            "others.A: at 15 km/h an ego at 50 km/h leaves it behind",
        ),
    ],
)
def test_what_cannot_be_shown_is_refused_by_its_fact(written: str, told: str) -> None:
    with pytest.raises(NotBuilt) as refused:
        build(from_plain(yaml.safe_load(written)))
    assert str(refused.value).startswith(told)
