"""The table of road users is the only place that lists them."""

from __future__ import annotations

import ast
import gc
import re
import weakref
from collections.abc import Iterator
from dataclasses import replace

import pytest
from scenic.simulators.carla import blueprints

from chatscene.interpret.situation_rows import KINDS
from chatscene.read.kinds import is_named
from chatscene.simulate.confined.words import world_words
from chatscene.terms.actors import AIR_DRAG, BY_CLASS, AdversaryKind, kind_of
from chatscene.terms.actors import named as called
from places import ROOT

SOURCE = ROOT / "src" / "chatscene"
TABLE = {SOURCE / "terms" / "actors.py", SOURCE / "world" / "model.scenic"}
NAMES = {kind.name for kind in AdversaryKind} | {kind.value for kind in AdversaryKind} | set(BY_CLASS)
QUOTED = re.compile(rf"""\b(?:{"|".join(sorted(BY_CLASS))})\b(?=["']?\s*[,:\])])""")

NAMED = re.compile(rf"""AdversaryKind\.|["'](?:{"|".join(sorted(NAMES))})["']""")

every_kind = pytest.mark.parametrize("kind", AdversaryKind)


def named(node: ast.expr | None) -> str:
    """The kind that an expression names, if it names one."""
    if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "AdversaryKind":
        return node.attr
    return str(node.value) if isinstance(node, ast.Constant) and node.value in NAMES else ""


def listed(source: str) -> Iterator[int]:
    """The lines of a Python file where a list, a set or a table has more than one kind in it."""
    if not NAMED.search(source):  # which takes less time than to parse it
        return
    for node in ast.walk(ast.parse(source)):
        elements = node.keys if isinstance(node, ast.Dict) else getattr(node, "elts", [])
        if len({named(element) for element in elements} - {""}) > 1:
            yield node.lineno  # type: ignore[attr-defined]


def test_no_other_file_lists_the_kinds_of_road_users() -> None:
    found = [
        f"{path.name}:{line}" for path in SOURCE.rglob("*.py") if path not in TABLE for line in listed(path.read_text())
    ]
    pages = [path for ending in ("js", "html", "css", "scenic") for path in SOURCE.rglob(f"*.{ending}")]
    found += [
        f"{path.name}:{number}"
        for path in pages
        if path not in TABLE and "library" not in path.parts
        for number, line in enumerate(path.read_text().splitlines(), 1)
        if len(set(QUOTED.findall(line))) > 1
    ]
    assert not found


@pytest.mark.parametrize(
    "source",
    ["X = {AdversaryKind.CAR: 1, AdversaryKind.BUS: 2}", "x in ('Car', 'Truck')", "{'bicycle', AdversaryKind.CAR}"],
)
def test_a_list_of_kinds_is_recognised_as_one(source: str) -> None:
    assert list(listed(source)) == [1]
    assert not list(listed("f(AdversaryKind.CAR, AdversaryKind.BUS); x = ['Car', 'Wall']"))


@every_kind
def test_a_kind_has_a_class_in_the_world_and_a_blueprint_in_carla(kind: AdversaryKind) -> None:
    name = kind.row.scenic
    said = f"world/model.scenic: add `class {name}(…)`, with `kind: '{name}'`, as the others of its manner have it"
    assert kind.row.scenic in world_words(), said
    known = {name for models in vars(blueprints).values() if isinstance(models, list) for name in models}
    assert kind.row.blueprint in known, f"terms/actors.py: CARLA has no blueprint {kind.row.blueprint!r}"


def test_a_row_that_lacks_what_its_manner_asks_for_says_what() -> None:
    bicycle, dog = AdversaryKind.BICYCLE.row, AdversaryKind.DOG.row
    with pytest.raises(ValueError, match=r"Bicycle rides, so its row in terms/actors.py needs wheel, the diameter"):
        replace(bicycle, wheel=0.0)
    with pytest.raises(ValueError, match=r"Bicycle rides, .* needs osi, its type of vehicle in OSI"):
        replace(bicycle, osi="")
    with pytest.raises(ValueError, match=r"Dog walks, .* has no wheel"):
        replace(dog, wheel=0.3)


@every_kind
def test_what_a_kind_is_called_first_names_that_kind_in_a_text(kind: AdversaryKind) -> None:
    assert KINDS[kind].row.general or is_named(KINDS[kind], kind.row.noun)


def test_a_kind_survives_being_copied_and_written_down() -> None:
    for kind in AdversaryKind:
        assert AdversaryKind(str(kind)) is kind
        assert kind == kind.value


def test_who_acts_like_another_is_of_its_manner_and_no_other_acts_like_it() -> None:
    for kind in AdversaryKind:
        assert kind.acts_as.acts_as is kind.acts_as
        assert kind.acts_as.row.manner is kind.row.manner
        assert kind.row.limits.wheelbase == 0.0 or kind.row.limits.wheelbase < kind.row.limits.length


def test_an_id_of_a_situation_is_told_as_what_it_is() -> None:
    assert called("A", "Car", {"A": "Car", "B": "Truck"}) == "the car"
    assert called("A", "Car", {"A": "Car", "B": "Car"}) == "car A"
    assert called("B-2", "Pedestrian", {"B-1": "Pedestrian", "B-2": "Pedestrian"}) == "pedestrian B-2"
    assert called("adversary", "Car", {"adversary": "Car"}) == "the adversary (car)"
    assert called("bus-stop", "BusStop", {}) == "the bus-stop"


def test_parts_and_numbered_things_are_told_as_nouns() -> None:
    assert called("A-door", "Door", {"A-door": "Door"}) == "the door"
    assert called("B-door", "Door", {"A-door": "Door", "B-door": "Door"}) == "the door of B"
    assert called("bus-stop-0", "BusStop", {"bus-stop-0": "BusStop"}) == "the bus stop"
    assert called("parked-1", "Car", {"parked-0": "Car", "parked-1": "Car"}) == "parked car 2"


@pytest.mark.parametrize(("kind", "held"), [(AdversaryKind.TRUCK, 90.0), (AdversaryKind.BUS, 100.0)])
def test_lorries_and_buses_hold_the_speed_of_their_limiters(kind: AdversaryKind, held: float) -> None:
    body, speed = kind.row.limits, 0.0
    for _ in range(3000):
        force = body.throttle * (1.0 - speed / body.top_speed) - body.drag - AIR_DRAG * speed * speed
        speed += 0.1 * force
    assert speed * 3.6 == pytest.approx(held, abs=0.1)


def test_a_class_whose_kind_was_asked_for_is_let_go() -> None:
    class Car:
        """As each compiled program brings one of its own."""

    kept = weakref.ref(Car)
    assert kind_of(Car()) == "Car"
    del Car
    gc.collect()
    assert kept() is None
