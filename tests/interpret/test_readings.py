"""Where a text is not sure enough: what it may say, told in sentences, and taken by number or by stating a fact."""

from __future__ import annotations

import pytest

from chatscene.errors import NothingFits, SettingsError
from chatscene.read.decompose import hear
from chatscene.runs import RunRecord, asked_run, scenario_of, settings_of
from chatscene.search.generator import load_generator
from chatscene.search.generators.retrieved import Retrieved
from chatscene.sentences.plain import told
from chatscene.settings import RetrievalSettings, Settings
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.conclusions import concluded
from chatscene.terms.scenario import Maneuver, Occluder, Place, Position, Scenario, Side, Site, Slots
from chatscene.terms.surroundings import Light

VAGUE = (
    "We had been stopped for a bit when the pickup that had come off the forecourt somehow ended up against our wing."
)


def read(text: str, reading: int = 0, stated: str = "") -> Scenario:
    return Retrieved().read(text, RetrievalSettings(reading=reading, stated=stated))


def confidence(text: str, reading: int = 0, stated: str = "") -> float:
    settings = RetrievalSettings(reading=reading, stated=stated)
    retrieval = Retrieved().write(Retrieved().read(text, settings), settings).retrieval
    assert retrieval is not None
    return retrieval.confidence


def refusal(text: str, stated: str = "") -> NothingFits:
    with pytest.raises(NothingFits) as error:
        confidence(text, stated=stated)
    return error.value


def test_a_refusal_tells_what_was_understood_and_what_not_and_the_likeliest_readings() -> None:
    error = refusal(VAGUE)
    assert "ego: stands" in error.understood
    assert any("forecourt" in reason for reason in error.reasons)
    assert [one.number for one in error.readings] == [1, 2]
    assert error.readings[0].told.startswith("We wait")
    assert error.readings[0].probability >= error.readings[1].probability
    assert len({one.told for one in error.readings}) == 2


@pytest.mark.parametrize("number", [1, 2])
def test_a_reading_that_is_taken_is_served_as_it_was_told_and_is_not_doubted_again(number: int) -> None:
    offered = refusal(VAGUE).readings[number - 1]
    taken = read(VAGUE, reading=number)
    assert told(taken.slots) == offered.told
    assert confidence(VAGUE, reading=number) == 1.0
    assert any(f"the user took reading {number}" in str(note) for note in taken.notes)


def test_the_fact_that_settles_a_reading_is_enough_to_be_served() -> None:
    silly = "a bike does something silly beside us at the lights"
    settling = [one for one in refusal(silly).readings if one.settled_by]
    assert settling
    for one in settling:
        assert confidence(silly, stated=one.settled_by) >= RetrievalSettings().refuse_below


def test_a_stated_fact_is_read_whatever_the_text_says_and_the_rest_stays() -> None:
    text = "A cyclist crosses from the left while we turn right."
    before, after = read(text), read(text, stated="side=right")
    assert (before.slots.side, after.slots.side) == (Side.LEFT, Side.RIGHT)
    assert after.slots.adversary is AdversaryKind.BICYCLE
    assert after.slots.maneuver is Maneuver.RIGHT_TURN
    assert any("stated by the user: side=right" in str(note) for note in after.notes)


def test_acts_are_stated_in_their_order_and_light_as_well() -> None:
    scenario = read("the car ahead", stated="actions=brake,stop light=night position=ahead")
    assert scenario.slots.actions == (Action.BRAKE, Action.STOP)
    assert scenario.slots.position is Position.AHEAD
    assert scenario.surroundings.light is Light.NIGHT


def test_who_states_every_fact_is_not_refused() -> None:
    assert "pushes" in " ".join(refusal("some idiot pushes in").reasons)
    assert (
        confidence("some idiot pushes in", stated="adversary=car actions=cut-in position=beside maneuver=straight")
        == 1.0
    )


def test_stating_a_fact_does_not_make_an_impossible_sentence_possible() -> None:
    assert refusal("a dragon lands on the bonnet", stated="side=left").confidence < 0.5  # type: ignore[operator]


@pytest.mark.parametrize(
    ("stated", "said"),
    [
        ("sid=left", "there is no fact 'sid'; did you mean 'side'"),
        ("side=up", "there is no side 'up'; known: left, right"),
        ("leader=maybe", "there is no leader 'maybe'; known: yes"),
        ("side=left,right", "side can be one thing only"),
        ("side", "say a fact as NAME=VALUE"),
        ("side=left side=right", "side is set twice"),
        ("place=road maneuver=left-turn", "place=road does not go with the rest"),
    ],
)
def test_what_cannot_be_stated_is_told_with_what_can(stated: str, said: str) -> None:
    with pytest.raises(SettingsError, match=said):
        read("A car brakes ahead of us.", stated=stated)


def test_a_second_road_user_that_was_not_read_is_asked_back() -> None:
    error = refusal("a cyclist and a pedestrian both cross from the right")
    assert "another road user" in error.reasons[0]
    assert {told.split()[1] for told in (one.told for one in error.readings)} == {"pedestrian", "bicycle"}
    assert [word["text"] for word in error.words if "unread" in word] in (["cyclist"], ["pedestrian"])


def test_who_hides_leads_or_stands_in_the_way_is_not_asked_back() -> None:
    assert confidence("A child runs out from behind a parked lorry on the right.") >= 0.5
    assert confidence("We go around a parked van while an oncoming car accelerates.") >= 0.5


def test_a_reading_that_is_not_there_cannot_be_taken() -> None:
    with pytest.raises(SettingsError, match="there is no reading 1 of this text; there is none to choose"):
        read("The car ahead brakes hard.", reading=1)


def test_a_run_keeps_the_choice_of_its_user_and_reads_the_same_by_it_again() -> None:
    settings = Settings(retrieval=RetrievalSettings(reading=2, stated="light=dusk"))
    record = RunRecord.model_validate_json(asked_run(VAGUE, settings=settings).model_dump_json())
    assert settings_of(record) == settings
    again = scenario_of(record, load_generator(record.generator))
    assert again.slots == read(VAGUE, reading=2).slots
    assert again.surroundings.light is Light.DUSK


PLAINLY = (
    Slots(adversary=AdversaryKind.CAR, actions=(Action.BRAKE, Action.STOP), position=Position.AHEAD),
    Slots(
        adversary=AdversaryKind.PEDESTRIAN,
        actions=(Action.CROSS,),
        side=Side.RIGHT,
        occluder=Occluder.PARKED_CAR,
        place=Place.ROAD,
    ),
    Slots(
        adversary=AdversaryKind.CAR,
        actions=(Action.RUN_LIGHT,),
        side=Side.LEFT,
        position=Position.CROSSING,
        place=Place.FOUR_WAY,
    ),
    Slots(
        adversary=AdversaryKind.TRUCK,
        actions=(Action.CUT_IN,),
        side=Side.LEFT,
        position=Position.BESIDE,
        site=Site.MOTORWAY,
        place=Place.ROAD,
    ),
    Slots(
        adversary=AdversaryKind.CAR,
        actions=(Action.TURN_LEFT,),
        position=Position.ONCOMING,
        maneuver=Maneuver.STRAIGHT,
        place=Place.JUNCTION,
    ),
    Slots(
        adversary=AdversaryKind.PEDESTRIAN,
        actions=(Action.CROSS,),
        side=Side.RIGHT,
        position=Position.ROADSIDE,
        maneuver=Maneuver.RIGHT_TURN,
        place=Place.THREE_WAY,
        group=True,
    ),
)


@pytest.mark.parametrize("slots", PLAINLY, ids=told)
def test_what_is_told_plainly_is_read_whole_as_just_that(slots: Slots) -> None:
    heard = hear(told(concluded(slots)))
    assert heard.whole
    assert concluded(heard.outright) == concluded(slots)


@pytest.mark.parametrize("action", Action)
def test_every_act_can_be_told(action: Action) -> None:
    for kind in (AdversaryKind.CAR, AdversaryKind.BICYCLE, AdversaryKind.PEDESTRIAN):
        sentence = told(Slots(adversary=kind, actions=(action,), position=Position.AHEAD))
        assert "{" not in sentence and "[" not in sentence
