from __future__ import annotations

import json
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chatscene.errors import SettingsError
from chatscene.interpret.decide import scenario_of as decided
from chatscene.read.decompose import LONGEST, hear
from chatscene.read.lexicon import edits, mended
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.scenario import BaseScenario, Component, Maneuver, Position, Scenario, Side, Site, Why
from outright import decompose
from places import FIXTURES, SHARED

SENTENCES: dict[str, Any] = json.loads((FIXTURES / "sentences.json").read_text("utf-8"))
PAPER = SHARED / "data" / "paper_descriptions.json"

PED, CYC, MOTO, CAR = (
    AdversaryKind.PEDESTRIAN,
    AdversaryKind.BICYCLE,
    AdversaryKind.MOTORCYCLE,
    AdversaryKind.CAR,
)
LEFT, RIGHT = Side.LEFT, Side.RIGHT
# Facts of the paper's 40 sentences by their place: who, and on which side where one is said.
FACTS: list[tuple[AdversaryKind, Side | None]] = [
    *((PED, side) for side in (RIGHT, RIGHT, LEFT, RIGHT, RIGHT)),
    *((MOTO, RIGHT), (PED, RIGHT), (PED, LEFT), (CYC, LEFT), (MOTO, RIGHT)),
    *((CAR, side) for side in (None, None, RIGHT, None, None)),
    *((kind, None) for kind in (PED, MOTO, CAR, CAR, PED)),
    *((CAR, side) for side in (None, LEFT, LEFT, RIGHT, LEFT)),
    *((CAR, side) for side in (None, None, None, None, RIGHT)),
    *((CAR, side) for side in (None, RIGHT, RIGHT, RIGHT, LEFT)),
    *((CAR, side) for side in (LEFT, RIGHT, None, RIGHT, RIGHT)),
]
MANEUVERS: dict[BaseScenario, tuple[Maneuver, ...]] = {
    BaseScenario.STRAIGHT_OBSTACLE: (Maneuver.STRAIGHT,) * 5,
    BaseScenario.TURNING_OBSTACLE: tuple(
        Maneuver.LEFT_TURN if i in (0, 1, 3) else Maneuver.RIGHT_TURN for i in range(5)
    ),
    BaseScenario.LANE_CHANGING: tuple(
        Maneuver.LANE_CHANGE_RIGHT if i in (1, 2) else Maneuver.LANE_CHANGE_LEFT for i in range(5)
    ),
    BaseScenario.VEHICLE_PASSING: (Maneuver.BYPASS,) * 5,
    BaseScenario.RED_LIGHT_RUNNING: (Maneuver.STRAIGHT,) * 5,
    BaseScenario.UNPROTECTED_LEFT_TURN: (Maneuver.LEFT_TURN,) * 5,
    BaseScenario.RIGHT_TURN: (Maneuver.RIGHT_TURN,) * 5,
    BaseScenario.CROSSING_NEGOTIATION: (Maneuver.STRAIGHT,) * 5,
}


def name_of(row: dict[str, Any]) -> str:
    return row["text"][:40]


def slot(scenario: Scenario, name: str) -> object:
    value = getattr(scenario.slots, name)
    return None if value in (None, ()) else sorted(value) if isinstance(value, tuple) else value


def wanted(value: object) -> object:
    return sorted(value) if isinstance(value, list) else value


@pytest.mark.parametrize("row", SENTENCES["tuned"], ids=name_of)
def test_every_slot_of_a_sentence_is_read(row: dict[str, Any]) -> None:
    scenario = decompose(row["text"])
    got = {name: slot(scenario, name) for name in row["slots"]}
    assert got == {name: wanted(value) for name, value in row["slots"].items()}


def test_nine_slots_in_ten_are_read_in_sentences_kept_apart() -> None:
    right = [
        slot(decompose(row["text"]), name) == wanted(value)
        for row in SENTENCES["held"]
        for name, value in row["slots"].items()
    ]
    assert sum(right) >= 0.9 * len(right)


@pytest.mark.skipif(not PAPER.exists(), reason="the paper's descriptions are not beside this checkout")
def test_the_forty_sentences_of_the_paper_are_read() -> None:
    sentences = json.loads(PAPER.read_text("utf-8"))["descriptions"]
    facts = iter(FACTS)
    for base, maneuvers in MANEUVERS.items():
        for text, maneuver in zip(sentences[base], maneuvers, strict=True):
            scenario = decompose(text)
            slots = scenario.slots
            assert (slots.adversary, slots.side) == next(facts), text
            assert slots.maneuver is maneuver, text
            assert slots.actions, text
            if "red light" in text or base != BaseScenario.RED_LIGHT_RUNNING:
                assert scenario.base is base, text


@pytest.mark.parametrize(
    ("text", "does", "does_not"),
    [
        ("A pedestrian crosses from the left without stopping.", Action.CROSS, Action.STOP),
        ("The car ahead does not brake but swerves.", Action.SWERVE, Action.BRAKE),
        ("The car ahead doesn't stop; it reverses.", Action.REVERSE, Action.STOP),
        ("A cyclist neither stops nor slows down and crosses from the right.", Action.CROSS, Action.STOP),
        ("A motorcyclist on the right pretends to cross the road but brakes at its edge.", Action.BRAKE, Action.CROSS),
    ],
)
def test_what_is_denied_is_not_done(text: str, does: Action, does_not: Action) -> None:
    actions = decompose(text).slots.actions
    assert does in actions
    assert does_not not in actions


def test_the_egos_turn_is_not_the_adversarys() -> None:
    slots = decompose("We turn left; a car from the right turns right.").slots
    assert slots.maneuver is Maneuver.LEFT_TURN
    assert (slots.side, slots.actions) == (Side.RIGHT, (Action.TURN_RIGHT,))


def test_where_the_adversary_turns_to_is_not_where_it_is() -> None:
    text = "The ego goes straight at an intersection; a car on the left front makes an abrupt right turn."
    slots = decompose(text).slots
    assert slots.side is Side.LEFT
    assert Action.TURN_RIGHT in slots.actions


def test_how_the_ego_has_to_react_is_no_part_of_the_situation() -> None:
    slots = decompose("The car ahead brakes hard, forcing the ego vehicle to change lanes and turn left.").slots
    assert slots.maneuver not in (Maneuver.LEFT_TURN, Maneuver.LANE_CHANGE_LEFT)
    assert slots.actions == (Action.BRAKE,)


@pytest.mark.parametrize(
    ("text", "done"),
    [
        ("A van pulled into our lane and made us brake.", Action.BRAKE),
        ("A cyclist crossed ahead, which forced us to stop.", Action.STOP),
        ("The lorry cut in and had us standing on the brakes.", Action.BRAKE),
        ("The truck changed lanes, got us to slow down.", Action.SLOW),
        ("A jogger ran across and left us no choice but to stop.", Action.STOP),
    ],
)
def test_what_the_ego_is_made_to_do_is_not_what_the_adversary_does(text: str, done: Action) -> None:
    assert done not in decompose(text).slots.actions


@pytest.mark.parametrize(
    ("text", "done"),
    [
        ("The van made us brake, then it reversed.", Action.REVERSE),
        ("A car cut us off and braked.", Action.BRAKE),
        ("The truck left the ego's lane and stopped.", Action.STOP),
    ],
)
def test_what_the_adversary_does_beside_is_still_heard(text: str, done: Action) -> None:
    assert done in decompose(text).slots.actions


@pytest.mark.parametrize(
    ("typo", "word"),
    [
        ("pedestrain", "pedestrian"),
        ("biycle", "bicycle"),
        ("intersecton", "intersection"),
        ("rigth", "right"),
        ("crosess", "crosses"),
        ("motorcylist", "motorcyclist"),
        ("acelerates", "accelerates"),
    ],
)
def test_a_typo_is_mended(typo: str, word: str) -> None:
    assert mended(typo) == word


@pytest.mark.parametrize("word", ["track", "light", "steps", "streets", "packed", "baking", "river", "cross", "breaks"])
def test_a_real_word_is_left_alone(word: str) -> None:
    assert mended(word) == word


def test_a_mended_typo_is_told() -> None:
    assert "read 'pedestrain' as 'pedestrian'" in map(str, decompose("A pedestrain crosses from the right.").notes)


@given(st.text("abcd", max_size=6), st.text("abcd", max_size=6))
@settings(max_examples=100)
def test_the_edit_distance_is_symmetric_and_nothing_only_between_equals(one: str, other: str) -> None:
    assert edits(one, other) == edits(other, one)
    assert (edits(one, other) == 0) == (one == other)
    assert edits(one, other) <= max(len(one), len(other))


def test_who_is_unknown_to_the_library_is_named() -> None:
    scenario = decompose("A dragon lands on the hood.")
    assert scenario.slots.said() == {}
    assert any("dragon" in str(note) for note in scenario.notes)


@pytest.mark.parametrize("text", ["", "   ", "\n\t", "\u200b"])
def test_an_empty_text_is_refused(text: str) -> None:
    with pytest.raises(SettingsError, match="empty"):
        decompose(text)


def test_a_text_that_is_no_sentence_but_a_book_is_refused() -> None:
    with pytest.raises(SettingsError, match=f"at most {LONGEST}"):
        decompose("car " * 2600)


@given(st.text(max_size=300))
@settings(max_examples=100)
def test_any_text_is_read_or_refused_and_always_the_same_way(text: str) -> None:
    try:
        first = decompose(text)
    except SettingsError:
        return
    assert decompose(text) == first
    assert all(first.parts[component].strip() for component in Component)


@pytest.mark.parametrize("row", SENTENCES["tuned"][:8], ids=name_of)
def test_letter_case_and_spaces_do_not_matter(row: dict[str, Any]) -> None:
    text: str = row["text"]
    assert decompose(text.upper().replace(" ", "  ")).slots == decompose(text).slots


def test_ids_are_stable_readable_and_differ() -> None:
    one, other = decompose("A car brakes ahead."), decompose("A car brakes ahead!")
    assert one.id == decompose("A car brakes ahead.").id
    assert one.id.startswith("a-car-brakes-ahead-")
    assert one.id != other.id


@pytest.mark.parametrize(
    ("text", "acts"),
    [
        ("The car ahead brakes hard and then accelerates.", (Action.BRAKE, Action.ACCELERATE)),
        ("The car ahead accelerates and then brakes hard.", (Action.ACCELERATE, Action.BRAKE)),
        ("A truck from the left runs the red light and brakes.", (Action.RUN_LIGHT, Action.BRAKE)),
    ],
)
def test_acts_are_in_the_order_in_which_words_say_them(text: str, acts: tuple[Action, ...]) -> None:
    assert decompose(text).slots.actions == acts


def test_who_stands_at_first_stops_where_a_stop_is_said() -> None:
    slots = decompose(
        "A pedestrian stands behind a bus stop on the right, then sprints across the road and stops."
    ).slots
    crossing, stopping = (slots.actions.index(action) for action in (Action.CROSS, Action.STOP))
    assert crossing < stopping


@pytest.mark.parametrize(
    ("text", "side"), [("brakes right in our face", None), ("on the right in our lane stops", RIGHT)]
)
def test_right_before_us_is_no_side(text: str, side: object) -> None:
    assert hear(f"A motorbike {text}.").outright.side == side


@pytest.mark.parametrize(
    ("text", "site"),
    [
        ("Wrong-way driver on the interstate, in my lane.", Site.MOTORWAY),
        ("I-80 E, 4pm, a Civic from the right lane squeezes in front of us.", Site.MOTORWAY),
        ("A lorry moves into my lane on the M62.", Site.MOTORWAY),
        ("We are on the on-ramp and the car ahead stops.", Site.ON_RAMP),
        ("At the roundabout a tractor rolls in from the left.", Site.ROUNDABOUT),
        ("Mid-block zebra crossing, a pedestrian from the left.", Site.CROSSWALK),
        ("A pedestrian on the crosswalk at the junction into which we turn.", None),
        ("A highway patrol car cuts in ahead of us.", None),
        ("A car comes out of a lane near the motorway.", None),
    ],
)
def test_a_site_is_heard_by_its_name(text: str, site: Site | None) -> None:
    assert hear(text).outright.site is site


@pytest.mark.parametrize(
    ("text", "lead"),
    [
        (
            "The car ahead stops, we move to the left lane and the car behind in the left lane speeds up.",
            "the car ahead stops",
        ),
        (
            "We change lanes to the left since the lead vehicle brakes, and the car behind in that lane speeds up.",
            "the lead vehicle brakes",
        ),
    ],
)
def test_who_brakes_ahead_is_not_who_comes_up_from_behind(text: str, lead: str) -> None:
    heard = hear(text)
    assert heard.outright.actions == (Action.ACCELERATE,)
    assert heard.outright.position is Position.BEHIND_BESIDE
    assert (lead, Why.ROAD_USER) in [(one.said, one.why) for one in heard.unused]


def test_two_whom_the_account_tells_apart_are_both_kept() -> None:
    heard = hear("The bus ahead stops, after that a motorcycle behind us overtakes.")
    assert not [one for one in heard.unused if one.why is Why.ROAD_USER]


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("A truck moves over to the left in front of us.", RIGHT),
        ("A coach merges right, into the path of our car.", LEFT),
        ("A pickup swerved to the right into our path.", LEFT),
        ("The estate car shifted to the left lane, cutting off our vehicle.", RIGHT),
        ("The car changes to the right lane right in front of us.", LEFT),
    ],
)
def test_who_moves_to_a_side_and_to_where_we_are_comes_from_the_other(text: str, side: Side) -> None:
    assert hear(text).outright.side is side
    assert decided(text).slots.side is side


@pytest.mark.parametrize(
    "text",
    [
        "An oncoming car drifts to the left into our lane.",
        "We move to the left lane in front of our queue.",
        "A car moves over to the left to let us pass.",
        "A van swerves to the right into our lane at the junction.",
        "We are changing to the left lane ahead of our exit and a car brakes in front of us.",
        "The lead car swerves right in front of us to avoid a box.",
        "The car in our lane changes to the right lane ahead of us.",
        "A bus at a bus stop moves out to the left in front of us.",
        "A pedestrian wanders to the left in front of us.",
        "A car approaching head-on veers to its left into our lane.",
    ],
)
def test_whither_somebody_goes_who_is_not_beside_us_is_left_as_it_is(text: str) -> None:
    assert "from the" not in hear(text).told
