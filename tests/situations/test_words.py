"""A situation in plain English: each fact that was said is told once, in words of its own."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from enum import StrEnum
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chatscene.build.ledger import said_in
from chatscene.errors import SituationError
from chatscene.situations import phrases
from chatscene.situations.facts import with_fact
from chatscene.situations.file import read_text
from chatscene.situations.phrases import ACTS, KINDS, ROUTES, Voice
from chatscene.situations.words import TITLE, facts_told, title, told
from chatscene.terms import surroundings, vocabulary
from chatscene.terms.situation import EGO, Situation
from chatscene.terms.vocabulary import Role, Word
from drawn import situations

GOLDEN = {
    """\
ego: {route: straight, speed: 50 km/h}
road: {kind: motorway}
others: [{id: A, kind: truck, starts: {where: ahead-beside, side: right},
   does: [{act: cut-in}, {act: brake, acceleration: 4 m/s²}]}]
""": (
        "We drive straight ahead at 50 km/h on a motorway. A truck is ahead of us in the next lane on our right. It "
        "cuts in ahead of us, then brakes at 4 m/s²."
    ),
    """\
ego: {speed: 25 km/h}
others: [{id: A, kind: van, starts: {where: kerb, side: right},
   does: [{act: stand}, {act: pull-out, manner: sudden, when: {ego_within: 20 m}}]}]
""": (
        "We drive at 25 km/h. A van is at the kerb on our right. It stands still, then suddenly pulls out into "
        "our lane when we are 20 m away."
    ),
    """\
ego: {route: right-turn, speed: 50 km/h, does: [{act: stand}, {act: set-off}]}
road: {kind: four-way, control: signal, ego_light: green, lanes: 2, two_way: true, speed_limit: 50 km/h}
others:
- {id: A, kind: bicycle, starts: {where: beside, side: right, distance: 10 m},
   does: [{act: go-straight, speed: 18 km/h}, {act: brake, acceleration: 3 m/s², when: {after: ego.set-off}}]}
- {id: B, kind: truck, role: supporting, starts: {where: ahead}, does: [{act: stand}]}
contact: {ego: right-front, other: front, striker: ego}
around: {light: dusk, weather: rain, surface: wet}
""": (
        "We drive at 50 km/h and turn right at a four-way junction. There are traffic lights, and ours is green. "
        "There are two lanes in our direction. The road is two-way and has a speed limit of 50 km/h. We stand "
        "still, then set off. A cyclist is beside us on our right, 10 m away. The cyclist goes straight on at 18 "
        "km/h, then brakes at 3 m/s² after we set off. A truck is ahead of us in our lane. It is not the danger. "
        "It stands still. We run into the front of the cyclist with our right front. It is dusk, it is raining "
        "and the road is wet."
    ),
    """\
road: {kind: road}
others:
- {id: A, kind: car, starts: {where: ahead}, does: [{act: swerve, to: left, when: {after: B.stop}}]}
- {id: B, kind: car, role: supporting, starts: {where: ahead}, does: [{act: stop, acceleration: 5 m/s²}]}
""": (
        "We are on a road between junctions. A car is ahead of us in our lane. It is not the danger. It stops at "
        "5 m/s². A second car is ahead of us in our lane. It swerves to our left after the first car stops."
    ),
    """\
ego: {speed: 20 to 30 km/h}
road: {setting: residential, speed_limit: 30 km/h, has: [parked-cars, school]}
others:
- {id: child, kind: child, hidden_by: van, starts: {where: roadside, side: right, distance: 25 m, facing: across},
   does: [{act: cross, manner: fast, speed: 10 km/h}, {act: hesitate, time: 1 s}]}
- {id: van, kind: van, role: hides, starts: {where: kerb, side: right, distance: 20 m}}
contact: {happens: false}
around: {light: day}
""": (
        "We drive at 20 to 30 km/h in a residential area. The road has a speed limit of 30 km/h, parked cars "
        "along the kerb and a school beside it. A van is at the kerb on our right, 20 m ahead. It only blocks the "
        "view. A child is at the roadside on our right, 25 m ahead, facing our lane, at first hidden from us by "
        "the van. The child crosses our path fast at 10 km/h, then hesitates for 1 s. There is no contact. It is "
        "daytime."
    ),
    """\
ego: {route: straight, speed: 60 km/h}
road: {kind: four-way, control: signal, ego_light: turns-green}
others: [{id: A, kind: motorcycle, starts: {where: arm, side: left, speed: at least 70 km/h},
   does: [{act: go-straight, breaks: red-light}]}]
contact: {striker: other, ego: left, other: front}
""": (
        "We drive straight ahead at 60 km/h at a four-way junction. There are traffic lights, and ours turns from "
        "red to green. A motorcyclist is on a side road of the junction on our left. The motorcyclist rides at 70 "
        "km/h or more, then goes straight on against a red light. The motorcyclist runs into our left side with "
        "the front."
    ),
    """\
ego: {route: overtake, speed: 90 km/h}
road: {setting: rural, lanes: 1, two_way: true}
others:
- {id: A, kind: truck, role: supporting, starts: {where: ahead, speed: 30 km/h less than the ego}}
- {id: B, kind: car, starts: {where: oncoming, distance: 150 m},
   does: [{act: accelerate, speed: at most 100 km/h}]}
""": (
        "We drive at 90 km/h and overtake in the country. There is one lane in our direction. The road is "
        "two-way. A truck is ahead of us in our lane and drives 30 km/h slower than us. It is not the danger. A "
        "car is coming the other way, 150 m away. It accelerates to 100 km/h or less."
    ),
    """\
ego: {route: merge}
road: {kind: motorway, lanes: 3, ego_lane: 1}
others:
- {id: A, kind: truck, starts: {where: behind, distance: 15 m}, does: [{act: tailgate, distance: 3 to 5 m}]}
- {id: B, kind: car, role: supporting, starts: {where: beside, side: left},
   does: [{act: keep-level, whom: A, time: 5 s}]}
""": (
        "We merge on a motorway. There are three lanes in our direction, and we are in the outermost lane. A "
        "truck is 15 m behind us in our lane. It tailgates us at a distance of 3 to 5 m. A car is beside us on "
        "our left. It is not the danger. It stays level with the truck for 5 s."
    ),
    """\
ego: {route: roundabout}
road: {kind: roundabout, control: yield-sign}
others: [{id: A, kind: e-scooter, count: 2, starts: {where: in-roundabout},
   does: [{act: weave}, {act: fall, when: {during: A.0}}]}]
""": (
        "We drive through a roundabout. There is a give-way sign. Two e-scooter riders are in the roundabout. "
        "They weave from side to side, then fall over while they are weaving from side to side."
    ),
    """\
ego: {speed: 40 km/h, does: [{act: yield, whom: A}, {act: set-off, speed: 30 km/h, when: {after: A.cross}}]}
others:
- {id: A, kind: pedestrian, count: 0, starts: {where: crossing, side: left},
   does: [{act: cross, manner: slow}]}
- {id: B, kind: pedestrian, starts: {where: crossing, side: right},
   does: [{act: cross, when: {after: A.cross}}]}
contact: {whom: B, ego: front, striker: ego}
""": (
        "We drive at 40 km/h. Several pedestrians are at a crosswalk in front of us on our left. They slowly "
        "cross our path. A pedestrian is at a crosswalk in front of us on our right. The pedestrian crosses our "
        "path after the pedestrians cross our path. We give way to the pedestrians, then set off and reach 30 "
        "km/h after the pedestrians cross our path. We run into the pedestrian with our front."
    ),
    """\
road: {kind: motorway}
others:
- {id: A, kind: car, starts: {where: ahead, distance: 40 m}, does: [{act: cut-out, to: left}]}
- {id: B, kind: debris, role: adversary, hidden_by: A, starts: {where: ahead, distance: 80 m}}
around: {weather: fog, surface: ice}
""": (
        "We are on a motorway. A car is 40 m ahead of us in our lane. It moves out of our lane to our left. A "
        "piece of debris is 80 m ahead of us in our lane, at first hidden from us by the car. It is foggy and the "
        "road is icy."
    ),
    """\
others:
- {id: A, kind: car, starts: {where: ahead}, does: [{act: slow-down, when: {after: B.cut-in}}, {act: stop}]}
- {id: B, kind: car, starts: {where: behind-beside, side: left},
   does: [{act: overtake, whom: A, speed: 20 km/h more than the ego},
          {act: cut-in, whom: A, distance: 5 m},
          {act: brake, when: {during: A.slow-down}}]}
""": (
        "A car is ahead of us in our lane. A second car is behind us in the next lane on our left. The first car "
        "slows down after the second car cuts in, then stops. The second car overtakes the first car 20 km/h "
        "faster than us, then cuts in ahead of the first car with a gap of 5 m. After that, the second car brakes "
        "while the first car is slowing down."
    ),
    "others: [{id: A, kind: car, starts: {where: ahead}, does: [{act: stop, time: 3 s}]}]": (
        "A car is ahead of us in our lane. It stops for 3 s."
    ),
    "{ego: {does: [{act: follow, whom: A, time: 2 s}]}, others: [{id: A, kind: car, starts: {where: ahead}}]}": (
        "A car is ahead of us in our lane. We follow the car with a gap of 2 s."
    ),
}


TABLES = [
    (phrases.ROUTES, vocabulary.EgoRoute),
    (phrases.ROADS, vocabulary.RoadKind),
    (phrases.SETTINGS, vocabulary.Setting),
    (phrases.CONTROLS, vocabulary.RightOfWay),
    (phrases.EGO_LIGHTS, vocabulary.EgoLight),
    (phrases.FEATURES, vocabulary.Feature),
    (phrases.LIGHTS, surroundings.Light),
    (phrases.WEATHERS, surroundings.Weather),
    (phrases.SURFACES, surroundings.Surface),
    (phrases.KINDS, vocabulary.UserKind),
    (phrases.ROLES, vocabulary.Role),
    (phrases.SIDES, vocabulary.Side),
    (phrases.PLACES, vocabulary.Where),
    (phrases.FACINGS, vocabulary.Facing),
    (phrases.MANNERS, vocabulary.Manner),
    (phrases.BREACHES, vocabulary.Breach),
    (phrases.ACTS, vocabulary.Act),
    (phrases.PARTS, vocabulary.Part),
]


@pytest.mark.parametrize(("table", "words"), TABLES, ids=lambda one: getattr(one, "__name__", ""))
def test_every_word_has_a_phrase_and_no_two_have_the_same(table: Mapping[Any, object], words: type[StrEnum]) -> None:
    assert set(table) == set(words)
    assert len(set(map(str, table.values()))) == len(words)


def test_every_table_of_words_is_one_of_phrases() -> None:
    tables = {one for one in vars(vocabulary).values() if isinstance(one, type) and issubclass(one, Word) and len(one)}
    assert tables == {words for _, words in TABLES if issubclass(words, Word)} | {vocabulary.Striker}
    assert set(phrases.STRIKERS) == {None, *vocabulary.Striker}
    assert set(phrases.VOICES) == set(Voice)


def test_every_verb_has_three_forms() -> None:
    verbs = [*(one.does for one in ACTS.values()), *(one.does for one in ROUTES.values())]
    for phrase in (*verbs, *(one.goes for one in KINDS.values()), *filter(None, phrases.STRIKERS.values())):
        for piece in phrase.split("[")[1:]:
            assert piece.partition("]")[0].count("/") == 2, phrase


@pytest.mark.parametrize("written", GOLDEN)
def test_a_situation_reads_as_somebody_would_say_it(written: str) -> None:
    assert told(read_text(written)) == GOLDEN[written]


def test_a_protocol_speaks_of_a_subject_vehicle_and_of_targets() -> None:
    first, *_, later = list(GOLDEN)[:5]
    assert told(read_text(first), Voice.PROTOCOL) == (
        "The subject vehicle (SV) drives straight ahead at 50 km/h on a motorway. Target A, a truck, is ahead of the "
        "SV in the next lane on the SV's right. Target A cuts in ahead of the SV, then brakes at 4 m/s²."
    )
    assert "Target van, a van, is at the kerb on the SV's right, 20 m ahead." in told(read_text(later), Voice.PROTOCOL)
    lit = "road: {ego_light: red}"
    assert told(read_text(lit), Voice.PROTOCOL) == "The subject vehicle's (SV's) traffic light is red."


@given(situation=situations())
@settings(max_examples=60)  # each has some ten facts
def test_every_fact_that_was_said_is_told_once_and_nothing_else_in_each_voice(situation: Situation) -> None:
    roles = {f"others.{one.id}.role" for one in situation.others if one.role is not Role.ADVERSARY}
    said = Counter({*(path for path, _ in said_in(situation)), *roles})
    for voice in Voice:
        whole, facts = told(situation, voice), list(facts_told(situation, voice))
        assert Counter(path for path, _ in facts) == said
        for path, words in facts:
            assert words, path
            assert words in whole
            assert words == words.strip(" ,.")
        assert not set("<>[]{}") & set(whole)
        assert "  " not in whole


@given(situation=situations(), data=st.data())
@settings(max_examples=60)  # each has some ten facts
def test_without_one_of_its_facts_a_situation_is_told_otherwise(situation: Situation, data: st.DataObject) -> None:
    said = [path for path, _ in said_in(situation) if not _follows(situation, path)]
    if not said:
        return
    path = data.draw(st.sampled_from(said))
    try:
        other = with_fact(situation, path, None)
    except SituationError:
        return  # without it, it is none
    assert told(other) != told(situation)
    assert told(other, Voice.PROTOCOL) != told(situation, Voice.PROTOCOL)


def _follows(situation: Situation, path: str) -> bool:
    """Whether a fact is so, too, where it was not said."""
    route = situation.ego.route
    if path == "road.kind" and route is not None:
        return ROUTES[route].at is situation.road.kind
    if path == "contact.whom" and situation.contact is not None:
        return situation.contact.whom == situation.adversaries[0].id
    return path.endswith(".whom") and dict(said_in(situation))[path] == EGO


def test_a_situation_that_says_nothing_is_told_in_no_words() -> None:
    assert told(Situation()) == title(Situation()) == ""


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ("50 km/h", "We drive at 50 km/h."),
        ("20 to 30 mph", "We drive at 20 to 30 mph."),
        ("at most 50 km/h", "We drive at 50 km/h or less."),
        ("at least 50 km/h", "We drive at 50 km/h or more."),
    ],
)
def test_an_amount_is_told_as_it_was_said(said: str, words: str) -> None:
    assert told(read_text(f"ego: {{speed: {said}}}")) == words


def test_those_of_a_kind_are_told_apart_also_where_some_are_a_group() -> None:
    others = ", ".join(
        f"{{id: {name}, kind: bus, count: {count}, starts: {{where: oncoming}}, does: [{{act: stop}}]}}"
        for name, count in (("A", 1), ("B", 1), ("C", 2), ("D", 2), ("E", 0))
    )
    whole = told(read_text(f"others: [{others}]\ncontact: {{whom: D}}"))
    assert "A bus is coming the other way. It stops. A second bus is coming the other way. It stops." in whole
    assert "Two buses are coming the other way. They stop. A second group of two buses are coming" in whole
    assert "Several buses are coming" in whole
    assert whole.endswith("We touch the second group of two buses.")


def test_of_several_deeds_that_are_alike_it_is_told_which_another_waits_for() -> None:
    assert "We stand still after the car stops for the second time." in told(
        read_text(
            "ego: {does: [{act: stand, when: {after: A.2}}]}\n"
            "others: [{id: A, kind: car, starts: {where: ahead}, does: [{act: stop}, {act: set-off}, {act: stop}]}]"
        )
    )


def test_those_who_speak_of_each_other_are_put_in_their_places_first() -> None:
    whole = told(
        read_text(
            "others:\n"
            "- {id: A, kind: car, starts: {where: ahead}, does: [{act: brake, when: {after: B.cut-in}}]}\n"
            "- {id: B, kind: van, starts: {where: beside}, does: [{act: cut-in, whom: A}]}\n"
        )
    )
    assert whole == (
        "A car is ahead of us in our lane. A van is beside us. The car brakes after the van cuts in. "
        "The van cuts in ahead of the car."
    )


def test_who_hides_somebody_is_named_before_also_where_they_speak_of_each_other() -> None:
    assert told(
        read_text(
            "others:\n"
            "- {id: A, kind: dog, hidden_by: B, starts: {where: roadside}, does: [{act: cross}]}\n"
            "- {id: B, kind: van, starts: {where: kerb}, does: [{act: set-off, when: {after: A.cross}}]}\n"
        )
    ) == (
        "A van is at the kerb. A dog is at the roadside, at first hidden from us by the van. "
        "The van sets off after the dog crosses our path. The dog crosses our path."
    )


def test_a_title_is_as_many_whole_sentences_as_there_is_room_for() -> None:
    situation = read_text(list(GOLDEN)[2])
    whole = told(situation)
    assert len(title(situation)) <= TITLE
    assert title(situation).endswith(".")
    assert whole.startswith(title(situation))
    assert title(situation, 30) == "We drive at 50 km/h and turn…"
    assert title(situation, len(whole)) == whole
