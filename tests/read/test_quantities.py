"""Numbers in sentences are found, and narrow the ranges they speak of."""

from __future__ import annotations

from decimal import Decimal

import pytest
from hypothesis import given
from hypothesis import strategies as st

from chatscene.errors import NothingFits, SnippetError
from chatscene.interpret.decide import understood
from chatscene.library.bind import Triple, bound, distances, narrowed, out_of_reach
from chatscene.library.load import load_library, names_of
from chatscene.read.decompose import hear
from chatscene.read.quantities import quantities_of
from chatscene.report.understood import understand
from chatscene.search.generator import Choice, load_generator
from chatscene.settings import RetrievalSettings, Settings
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.frame import Frame
from chatscene.terms.scenario import FAR, NEAR, NEAR_ONCOMING, Distance, Measure, Quantity, Scenario, Slots, Unused, Why

LIBRARY = load_library()
TRIPLE = (
    LIBRARY.get("behavior/cross-and-stop"),
    LIBRARY.get("geometry/straight-road"),
    LIBRARY.get("spawn/roadside-right"),
)


@pytest.mark.parametrize(
    ("text", "measure", "value"),
    [
        ("A pedestrian about ten metres ahead crosses.", Measure.DISTANCE, 10.0),
        ("The cyclist is 30m in front of us and swerves.", Measure.DISTANCE, 30.0),
        ("An oncoming truck doing 50 mph drifts over the line.", Measure.SPEED, 22.352),
        ("A kid runs across at 10 km/h.", Measure.SPEED, 2.778),
        ("The car ahead is driving with 36 kmph.", Measure.SPEED, 10.0),
        ("A cyclist 12 mtrs ahead swerves.", Measure.DISTANCE, 12.0),
        ("The car ahead stops for three seconds and drives on.", Measure.TIME, 3.0),
        ("The car ahead brakes when we are fifteen metres away.", Measure.TRIGGER, 15.0),
        ("A woman steps out at a distance of 25 meters from the right.", Measure.DISTANCE, 25.0),
        ("A cyclist 60 feet ahead swerves.", Measure.DISTANCE, 18.288),
        ("A pedestrian crosses from the left at 1.5 m/s.", Measure.SPEED, 1.5),
        ("A pedestrian crosses from the left at 1,5 m/s.", Measure.SPEED, 1.5),
        ("A car cuts in 12.5 m ahead.", Measure.DISTANCE, 12.5),
        ("A truck 1,200 m ahead brakes.", Measure.DISTANCE, 1200.0),
        ("The car ahead brakes with 6 m/s².", Measure.DECELERATION, 6.0),
        ("The car ahead brakes hard at about 4.5 m/s2 to a standstill.", Measure.DECELERATION, 4.5),
        ("A bus ahead decelerates at 0.3 g.", Measure.DECELERATION, 2.943),
    ],
)
def test_a_number_with_its_unit_is_a_quantity(text: str, measure: Measure, value: float) -> None:
    found = {q.measure: q.value for q in hear(text).quantities}
    assert found == {measure: pytest.approx(value)}


@pytest.mark.parametrize(
    "text",
    [
        "Two kids run across.",
        "We drive at 50 km/h; a car ahead brakes.",
        "V2 brakes.",
        "A car accelerates with 4 m/s².",
    ],
)
def test_other_numbers_are_no_quantity_of_the_adversary(text: str) -> None:
    assert hear(text).quantities == ()


@given(st.decimals(min_value="0.1", max_value=99, places=2))
def test_a_number_is_read_whole_wherever_its_point_stands(number: Decimal) -> None:
    frame = hear(f"We turn right. A pedestrian crosses from the left at {number} m/s, and then stops.")
    assert [q.value for q in frame.quantities] == [pytest.approx(float(number))]
    assert not [one for one in frame.unused if one.why is Why.NUMBER]
    assert frame.clauses.ego == "we turn right"


@pytest.mark.parametrize(
    ("text", "low", "high"),
    [
        ("A cyclist ahead of us swerves suddenly to the right.", -2.5, -1.5),
        ("A cyclist ahead of us swerves suddenly to the left.", 1.5, 2.5),
        ("A cyclist ahead of us swerves right in front of us.", 1.5, 2.5),
        ("The car ahead swerves right and brakes.", -2.6, -1.5),
        ("A cyclist ahead of us swerves to the right because of a pothole.", -1.8, -1.1),
        ("An oncoming car swerves to the right, into our lane.", 1.5, 3.5),
        ("The ego swerves to the right and the oncoming car swerves into our lane.", 1.5, 3.5),
    ],
)
def test_who_swerves_does_so_to_the_side_that_is_said(text: str, low: float, high: float) -> None:
    generator, settings = load_generator("chatscene"), RetrievalSettings()
    scenario = generator.read(text, settings)
    written = generator.write(scenario, settings)
    (swerve,) = (p for p in written.program.parameters if p.name == "OPT_SWERVE")
    assert (swerve.low, swerve.high) == (low, high)
    assert scenario.frame is not None
    again = generator.write_again(scenario, Choice.of(written), settings)
    assert again.source == written.program.source


@pytest.mark.parametrize(
    "text",
    [
        "The car ahead brakes and we swerve to the right.",
        "The car ahead does not swerve to the left, it brakes.",
        "A motorbike behind us is lurching left and right.",
    ],
)
def test_nobody_swerves_to_a_side_whose_swerve_is_the_egos_denied_or_to_both(text: str) -> None:
    frame = load_generator("chatscene").read(text, RetrievalSettings()).frame
    assert frame is not None
    assert Measure.ASIDE not in {one.measure for one in frame.quantities}


@pytest.mark.parametrize(
    ("edit", "sides"),
    [
        ("at night", [-1.0]),
        ("swap left and right", [1.0]),
        ("it stops instead of swerving", []),
        ("it comes from the right", []),
    ],
)
def test_an_edit_keeps_turns_or_drops_the_side_of_a_swerve(edit: str, sides: list[float]) -> None:
    said = "A cyclist ahead of us swerves suddenly to the right."
    edited = understand(said, Settings(), edits=(edit,)).scenario.frame
    assert edited is not None
    assert [one.value for one in edited.quantities if one.measure is Measure.ASIDE] == sides


@pytest.mark.parametrize("low_high", [(-99.0, -1.5), (5.0, -1.5), (1.7, -1.5), (-2.6, -1.4)])
def test_a_stored_range_is_the_declared_one_within_it_or_that_to_the_other_side(low_high: tuple[float, float]) -> None:
    triple = (LIBRARY.get("behavior/lead-dodge-and-brake"), *TRIPLE[1:])
    assert narrowed(triple, {"OPT_SWERVE": (-2.6, -1.5)})[0].parameters != triple[0].parameters
    with pytest.raises(SnippetError):
        narrowed(triple, {"OPT_SWERVE": low_high})


def test_who_swerves_by_where_the_ego_is_does_it_toward_the_ego_or_what_was_said_is_told_as_not_used() -> None:
    for side, told in (("right", []), ("left", ["veers to the left"])):
        generator, settings = load_generator("chatscene"), RetrievalSettings()
        scenario = generator.read(f"The car next to us on the left suddenly veers to the {side}.", settings)
        written = generator.write(scenario, settings)
        assert written.retrieval is not None
        assert [one.said for one in written.retrieval.unused if "veers" in one.said] == told


def said(measure: Measure, value: float) -> Quantity:
    return Quantity(measure=measure, value=value, said="so much")


def scenario(*quantities: Quantity, distance: Distance | None = None) -> Scenario:
    return understood(Frame(text="A car brakes.", quantities=quantities), Slots(distance=distance), ())


def start_of(triple: Triple) -> tuple[float, float]:
    return next((p.low, p.high) for p in triple[2].parameters if p.name == "OPT_GEO_Y")


@pytest.mark.parametrize(
    ("spawn", "distance", "begins", "ends"),
    [
        ("ahead-right-edge", Distance.NEAR, 12.0, NEAR),
        ("oncoming-lane-close", Distance.NEAR, 24.0, NEAR_ONCOMING),
        ("roadside-right", Distance.FAR, FAR, 50.0),
    ],
)
def test_a_start_that_was_said_to_be_near_or_far_is_narrowed(
    spawn: str, distance: Distance, begins: float, ends: float
) -> None:
    triple = bound((*TRIPLE[:2], LIBRARY.get(f"spawn/{spawn}")), scenario(distance=distance)).triple
    assert start_of(triple) == (begins, ends)


def test_metres_that_were_said_count_before_near() -> None:
    triple = bound(TRIPLE, scenario(said(Measure.DISTANCE, 30.0), distance=Distance.FAR)).triple
    assert start_of(triple) == (27.0, 33.0)


def test_whoever_waits_beside_the_road_may_set_out_near_the_ego_from_where_it_is() -> None:
    assert distances(TRIPLE[2]) == {Distance.NEAR, Distance.FAR}
    assert bound(TRIPLE, scenario(distance=Distance.NEAR)).triple == TRIPLE


def test_a_start_that_cannot_be_far_is_not_told_to_be() -> None:
    ahead = LIBRARY.get("spawn/ahead-in-lane")
    assert distances(ahead) == {Distance.NEAR}
    assert bound((*TRIPLE[:2], ahead), scenario(distance=Distance.FAR)).triple[2] == ahead


def test_a_speed_narrows_header_and_code_alike() -> None:
    made = bound(TRIPLE, scenario(said(Measure.SPEED, 2.0)))
    behavior = made.triple[0]
    (speed,) = [p for p in behavior.parameters if p.name == "OPT_ADV_SPEED"]
    assert (speed.low, speed.high) == (1.8, 2.2)
    assert names_of(behavior.source, ()).parameters["OPT_ADV_SPEED"] == (1.8, 2.2)
    assert (made.notes, made.unused) == ((), ())


def test_a_speed_nobody_on_foot_can_reach_is_refused() -> None:
    with pytest.raises(NothingFits, match=r"'so much' \(14 m/s \(50 km/h\)\) cannot be done by .* lies between"):
        bound(TRIPLE, scenario(said(Measure.SPEED, 14.0)))


@pytest.mark.parametrize(("kind", "low", "high"), [(AdversaryKind.CAR, 0.45, 0.55), (AdversaryKind.TRUCK, 0.6, 0.734)])
def test_a_deceleration_is_a_share_of_what_the_brakes_of_its_kind_do(
    kind: AdversaryKind, low: float, high: float
) -> None:
    ahead = (LIBRARY.get("behavior/lane-brake"), TRIPLE[1], LIBRARY.get("spawn/ahead-in-lane"))
    four = understood(
        Frame(text="It brakes.", quantities=(said(Measure.DECELERATION, 4.0),)), Slots(adversary=kind), ()
    )
    (brake,) = [p for p in bound(ahead, four).triple[0].parameters if p.name == "OPT_BRAKE"]
    assert (brake.low, brake.high) == (low, high)
    assert brake.low * kind.row.limits.brake <= 4.0 <= brake.high * kind.row.limits.brake


def test_a_quantity_that_nothing_can_be_set_to_is_told() -> None:
    made = bound(TRIPLE, scenario(said(Measure.TIME, 3.0)))
    assert made.triple == TRIPLE
    assert made.unused == (Unused(said="so much", why=Why.NUMBER),)


def test_a_number_is_met_or_met_nearly_with_a_note_or_refused_with_the_range() -> None:
    (speed,) = [p for p in TRIPLE[0].parameters if p.name == "OPT_ADV_SPEED"]
    assert bound(TRIPLE, scenario(said(Measure.SPEED, speed.high))).notes == ()
    nearly = bound(TRIPLE, scenario(said(Measure.SPEED, speed.high * 1.05)))
    assert "met only nearly" in nearly.notes[0]
    assert "km/h" in nearly.notes[0]
    with pytest.raises(NothingFits, match="lies between"):
        bound(TRIPLE, scenario(said(Measure.SPEED, speed.high * 1.2)))


def test_metres_ahead_never_set_a_distance_behind() -> None:
    behind = (*TRIPLE[:2], LIBRARY.get("spawn/adjacent-lane-behind"))
    ahead = Quantity(measure=Measure.DISTANCE, value=10.0, said="10 meters ahead")
    made = bound(behind, scenario(ahead))
    assert made.triple == behind
    assert made.unused == (Unused(said="10 meters ahead", why=Why.NUMBER),)
    there = Quantity(measure=Measure.DISTANCE, value=10.0, said="10 meters behind")
    assert start_of(bound(behind, scenario(there)).triple) == (9.0, 11.0)


def test_seconds_of_standing_set_no_other_time() -> None:
    swerving = [s for s in LIBRARY if any("after how long it swerves" in p.meaning for p in s.parameters)]
    assert swerving
    for snippet in swerving:
        made = bound((snippet, *TRIPLE[1:]), scenario(said(Measure.TIME, 2.0)))
        assert made.unused


@given(st.floats(0.1, 60.0), st.sampled_from(list(Measure)))
def test_what_is_in_reach_stays_within_the_declared_ranges(value: float, measure: Measure) -> None:
    quantity = said(measure, value)
    if any(out_of_reach(part, [quantity], AdversaryKind.PEDESTRIAN) for part in TRIPLE):
        with pytest.raises(NothingFits):
            bound(TRIPLE, scenario(quantity))
        return
    triple = bound(TRIPLE, scenario(quantity)).triple
    for before, after in zip(TRIPLE, triple, strict=True):
        for old, new in zip(before.parameters, after.parameters, strict=True):
            assert old.low <= new.low <= new.high <= old.high


@pytest.mark.parametrize(
    "said", ["we 45 km/h on a road", "we: 45 km/h", "ego drives at about 45 km/h", "the vut at 45 km/h"]
)
def test_a_speed_behind_the_name_of_the_ego_is_not_the_adversarys(said: str) -> None:
    told = f"{said}; the other vehicle pulls out"
    assert quantities_of(told, told) == ()
    told += " at 10 km/h"
    assert [round(one.value, 2) for one in quantities_of(told, told)] == [2.78]
