"""Where a text is not sure enough: what it may say, told in sentences, and taken by number or by stating a fact."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from chatscene.errors import NothingFits, SettingsError
from chatscene.interpret.known import offered, once_known
from chatscene.interpret.situation_of import in_a_situation
from chatscene.read.learned.reader import LearnedReader
from chatscene.report.filled import filled
from chatscene.runs import RunRecord, asked_run, scenario_of, settings_of
from chatscene.search.generator import load_generator
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings, Settings
from chatscene.situations.facts import with_fact
from chatscene.situations.form import from_plain
from chatscene.situations.main_facts import same_in_the_main
from chatscene.situations.words import told as told_of
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.reading import Ranked, SituationReading, Verdict
from chatscene.terms.scenario import Maneuver, Position, Scenario, Side, Slots
from chatscene.terms.situation import Ego, Evidence, Situation
from chatscene.terms.surroundings import Light, Surroundings
from chatscene.terms.vocabulary import Act

TEXT = "A cyclist crosses from the left while we turn right."
STRICT = RetrievalSettings(refuse_below=1.0)


def _meant(where: str, acts: str, likely: float) -> Ranked:
    """A reading of `TEXT`: where its cyclist is, on the left, and what it does."""
    cyclist: dict[str, object] = {"id": "A", "kind": "bicycle", "starts": {"where": where, "side": "left"}}
    cyclist["does"] = [{"act": act} for act in acts.split()]
    situation = from_plain({"about": TEXT, "ego": {"route": "right-turn"}, "others": [cyclist]})
    return Ranked(situation=situation, probability=likely)


RANKED = (
    _meant("roadside", "cross", 0.6),
    _meant("driveway", "cross", 0.25),
    _meant("roadside", "cross stop", 0.1),
)


@pytest.fixture(autouse=True)
def _unsure(monkeypatch: pytest.MonkeyPatch) -> None:  # pyright: ignore[reportUnusedFunction]
    """Let `TEXT` be read as `RANKED`, whatever was learned, and all else as it is."""
    whole = LearnedReader.read

    def read_so(self: LearnedReader, text: str) -> SituationReading:
        if text != TEXT:
            return whole(self, text)
        return SituationReading(text=text, reader=self.name, verdict=Verdict.SITUATION, ranked=RANKED)

    monkeypatch.setattr(LearnedReader, "read", read_so)


def read(text: str, reading: int = 0, stated: str = "") -> Scenario:
    return Retrieved().read(text, RetrievalSettings(reading=reading, stated=stated))


def ranked(text: str) -> tuple[Ranked, ...]:
    return LearnedReader().read(text).ranked


def refusal(text: str, settings: RetrievalSettings = STRICT, **facts: object) -> NothingFits:
    with pytest.raises(NothingFits) as error:
        filled(text, settings, facts)
    return error.value


def test_a_refusal_tells_what_was_understood_and_the_likeliest_readings_in_sentences() -> None:
    first, second, third = RANKED
    error = refusal(TEXT)
    assert error.understood == told_of(first.situation)
    assert error.confidence == first.probability
    assert [(one.number, one.told) for one in error.readings] == [
        (1, told_of(first.situation)),
        (2, told_of(second.situation)),
        (3, told_of(third.situation)),
    ]
    assert error.readings[0].probability >= error.readings[1].probability


def test_a_refusal_that_has_no_reading_to_choose_says_why_the_likeliest_is_not_built() -> None:
    away = with_fact(RANKED[0].situation, "others.A.does.0.speed", "90 km/h")
    read_as = SituationReading(
        text=TEXT, reader="offline", verdict=Verdict.SITUATION, ranked=(replace(RANKED[0], situation=away),)
    )
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(LearnedReader, "read", lambda _reader, _text: read_as)  # pyright: ignore[reportUnknownLambdaType]
        error = refusal(TEXT)
    assert error.readings == ()
    assert "as it is read it cannot be built: others.A.does.0.speed: 90 km/h" in str(error)


@pytest.mark.parametrize("number", [1, 2, 3])
def test_a_reading_that_is_taken_is_what_was_offered_and_is_not_doubted_again(number: int) -> None:
    offered = refusal(TEXT).readings[number - 1]
    made = filled(TEXT, replace(STRICT, reading=number))
    assert made.told == offered.told
    assert made.readings == ()
    chosen = read(TEXT, reading=number)
    assert chosen.frame is not None
    assert chosen.frame.sure == 1.0
    assert any(f"the user took reading {number}" in str(note) for note in chosen.notes)


def test_of_what_is_served_only_the_other_of_the_two_likeliest_is_told() -> None:
    first, second, _ = RANKED
    made = filled(TEXT, RetrievalSettings())
    assert made.told == told_of(first.situation)
    assert [(one.number, one.told) for one in made.readings] == [(2, told_of(second.situation))]


def _in_part(likely: float) -> SituationReading:
    """`TEXT` with one part of the first reading, of which what the ego does is left open."""
    part = replace(RANKED[2].situation, ego=Ego(), evidence=Evidence(open=("We turn right.",)))
    parts = (Ranked(situation=part, probability=likely),)
    return SituationReading(text=TEXT, reader="offline", verdict=Verdict.SITUATION, ranked=RANKED, parts=parts)


def test_a_part_that_is_sure_enough_is_served_with_what_is_left_open_and_with_the_whole_to_take() -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(LearnedReader, "read", lambda _reader, _text: _in_part(0.8))  # pyright: ignore[reportUnknownLambdaType]
        made = filled(TEXT, RetrievalSettings(refuse_below=0.7))
        assert made.situation.ego.route is None
        assert "left open, since it is not sure enough: “We turn right.”" in made.told_first
        assert [one.told for one in made.readings] == [told_of(one.situation) for one in RANKED[:2]]
        assert filled(TEXT, RetrievalSettings(reading=1)).told == told_of(RANKED[0].situation)
        assert refusal(TEXT, RetrievalSettings(refuse_below=0.85)).confidence == RANKED[0].probability
        assert filled(TEXT, RetrievalSettings()).told == told_of(RANKED[0].situation)


def _lacking(likely: float, *parts: Ranked) -> SituationReading:
    """A text of two road users, of whom one is read."""
    text = "A cyclist crosses and a pedestrian waits."
    one = replace(RANKED[0].situation, about=text, evidence=Evidence(quoted={"others.A.kind": "cyclist"}))
    read = SituationReading(text=text, reader="offline", verdict=Verdict.SITUATION, parts=parts)
    return replace(read, ranked=(Ranked(situation=one, probability=likely),))


def test_a_reading_without_a_road_user_that_was_said_is_served_only_as_a_part() -> None:
    part = replace(RANKED[0].situation, evidence=Evidence(open=("pedestrian",)))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(LearnedReader, "read", lambda _reader, _text: _lacking(0.99))  # pyright: ignore[reportUnknownLambdaType]
        assert "the reading (confidence 99%) has nobody for 'pedestrian'" in str(refusal(TEXT, RetrievalSettings()))
        assert filled(TEXT, RetrievalSettings(reading=1)).told == told_of(RANKED[0].situation)
    with pytest.MonkeyPatch.context() as patch:
        read = _lacking(0.6, Ranked(situation=part, probability=0.8))
        patch.setattr(LearnedReader, "read", lambda _reader, _text: read)  # pyright: ignore[reportUnknownLambdaType]
        made = filled(TEXT, RetrievalSettings())
    assert "left open, since it is not sure enough: “pedestrian”" in made.told_first
    assert made.readings == ()


def test_a_third_reading_is_offered_by_a_refusal_if_it_is_not_much_fainter_than_the_first() -> None:
    assert [one.number for one in refusal(TEXT).readings] == [1, 2, 3]
    fainter = (*RANKED[:2], replace(RANKED[2], probability=0.05))
    assert [one.number for one in offered(fainter, STRICT)] == [1, 2]


def test_no_part_is_served_that_has_otherwise_what_the_user_states() -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(LearnedReader, "read", lambda _reader, _text: _in_part(0.8))  # pyright: ignore[reportUnknownLambdaType]
        refusal(TEXT, RetrievalSettings(refuse_below=0.75), **{"others.A.starts.side": "right"})


def test_what_cannot_be_built_is_not_offered() -> None:
    text = "A tram overtakes us on the pavement and a boat parks on the roundabout."
    error = refusal(text)
    assert all(filled(text, replace(STRICT, reading=one.number)).told == one.told for one in error.readings)


def test_the_fact_that_settles_a_reading_is_enough_for_it_to_be_served() -> None:
    first, second, _ = RANKED
    settings = RetrievalSettings(refuse_below=first.probability + second.probability / 2)
    settling = [one for one in refusal(TEXT, settings).readings if one.settled_by]
    assert settling
    for one in settling:
        path, _, value = one.settled_by.partition("=")
        assert filled(TEXT, settings, {path: value}).told == one.told


def test_readings_that_agree_in_all_but_what_is_stated_are_one_and_as_likely_as_all_of_them() -> None:
    first, second, third = RANKED

    def at_the_roadside(situation: Situation) -> Situation:
        return with_fact(with_fact(situation, "others.A.starts.where", "roadside"), "others.A.starts.side", "left")

    known, other = once_known(RANKED, at_the_roadside)
    assert known.situation == first.situation
    assert known.probability == pytest.approx(first.probability + second.probability)
    assert not same_in_the_main(other.situation, first.situation)
    assert other.probability == third.probability


def test_a_stated_fact_is_read_whatever_the_text_says_and_the_rest_stays() -> None:
    text = "A cyclist comes off the pavement on the left and crosses the road."
    before, after = filled(text, RetrievalSettings()), filled(text, RetrievalSettings(), {"side": "right"})
    (was,), (now,) = before.situation.others, after.situation.others
    assert now == replace(was, starts=replace(was.starts, side=now.starts.side))
    assert (str(was.starts.side), str(now.starts.side)) == ("left", "right")
    chosen = read(text, stated="side=right")
    assert (chosen.slots.side, chosen.slots.adversary) == (Side.RIGHT, AdversaryKind.BICYCLE)
    assert any("stated by the user: side=right" in str(note) for note in chosen.notes)


def test_acts_are_stated_in_their_order_and_light_as_well() -> None:
    made = filled("the car ahead", RetrievalSettings(), {"actions": ["reverse", "stop"], "light": "night"}).situation
    assert [deed.act for deed in made["A"].does] == [Act.REVERSE, Act.STOP]
    assert made.around.light is Light.NIGHT
    scenario = read("the car ahead", stated="actions=brake,stop light=night position=ahead")
    assert scenario.slots.actions == (Action.STOP,)  # who stops has braked
    assert scenario.slots.position is Position.AHEAD
    assert scenario.surroundings.light is Light.NIGHT


def test_stating_a_fact_does_not_make_a_situation_of_what_is_none() -> None:
    assert "tells no dangerous traffic situation" in str(refusal("What is the capital of France?", side="left"))


@pytest.mark.parametrize(
    ("stated", "said"),
    [
        ("sid=left", "there is no fact 'sid'; did you mean 'side'"),
        ("side=up", "there is no side 'up'; known: left, right"),
        ("leader=maybe", "there is no leader 'maybe'; known: yes"),
        ("side=left,right", "side can be one thing only"),
        ("side", "say a fact as NAME=VALUE"),
        ("side=left side=right", "side is set twice"),
        ("place=road maneuver=left-turn", "place=road has no place in what was read"),
    ],
)
def test_what_cannot_be_stated_is_told_with_what_can(stated: str, said: str) -> None:
    with pytest.raises(SettingsError, match=said):
        read("A car brakes ahead of us.", stated=stated)


def test_a_reading_that_is_not_there_cannot_be_taken() -> None:
    only = ranked("The car ahead of us reverses.")[:1]
    read_so = replace(LearnedReader().read("The car ahead of us reverses."), ranked=only)
    from chatscene.interpret.known import taken

    with pytest.raises(SettingsError, match="there is no reading 2 of this text; offline gives 1"):
        taken(read_so, lambda situation: situation, RetrievalSettings(reading=2))


def test_a_run_keeps_the_choice_of_its_user_and_reads_the_same_by_it_again() -> None:
    settings = Settings(retrieval=RetrievalSettings(reading=2, stated="light=dusk"))
    record = RunRecord.model_validate_json(asked_run(TEXT, settings=settings).model_dump_json())
    assert settings_of(record) == settings
    again = scenario_of(record, load_generator(record.generator))
    assert again.slots == read(TEXT, reading=2).slots
    assert again.slots.maneuver is Maneuver.RIGHT_TURN
    assert again.surroundings.light is Light.DUSK


@pytest.mark.parametrize("action", Action)
def test_every_act_can_be_told(action: Action) -> None:
    for kind in (AdversaryKind.CAR, AdversaryKind.BICYCLE, AdversaryKind.PEDESTRIAN):
        slots = Slots(adversary=kind, actions=(action,), position=Position.AHEAD)
        assert re.fullmatch(r"(?:[A-Z][^{}\[\]]+\.)+", told_of(in_a_situation(slots, (), Surroundings())))
