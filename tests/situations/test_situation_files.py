"""Situations as files: what is written is read again, and what is wrong is told with its line."""

from __future__ import annotations

import json
from dataclasses import fields
from itertools import pairwise
from pathlib import Path

import pytest
from hypothesis import given, settings

from chatscene.errors import SituationError
from chatscene.situations.check import faults_of
from chatscene.situations.facts import with_fact
from chatscene.situations.file import MOST_BYTES, read_file, read_text, to_yaml
from chatscene.situations.form import from_plain, schema, to_plain
from chatscene.terms import vocabulary
from chatscene.terms.act_amounts import amounts_of
from chatscene.terms.amount import Length, Speed
from chatscene.terms.situation import (
    Around,
    Contact,
    Deed,
    Ego,
    Evidence,
    Other,
    Road,
    Situation,
    Start,
    When,
)
from chatscene.terms.vocabulary import Act, Side, Word
from drawn import situations
from pages import Written, steps_of
from places import ROOT

WRITTEN = """\
ego: {route: right-turn, speed: 50 km/h, does: [{act: stand}, {act: set-off}]}
road: {kind: four-way, control: signal, ego_light: green, lanes: 2, two_way: true, speed_limit: 50 km/h}
others:
- {id: A, kind: bicycle, starts: {where: beside, side: right, distance: 10 m},
   does: [{act: go-straight, speed: 18 km/h},
          {act: brake, acceleration: 3 m/s², when: {after: ego.set-off}}]}
- {id: B, kind: truck, role: supporting, starts: {where: ahead}, does: [{act: stand}]}
contact: {ego: right-front, other: front, striker: ego}
around: {light: dusk, weather: rain, surface: wet}
"""

BOMB = "a: &a [1, 1, 1, 1, 1, 1, 1, 1]\n" + "".join(
    f"{new}: &{new} [*{old}, *{old}, *{old}, *{old}]\n" for old, new in pairwise("abcdefghijk")
)


def test_a_file_is_read_as_it_is_meant(tmp_path: Path) -> None:
    (tmp_path / "one.yaml").write_text(WRITTEN, encoding="utf-8")
    situation = read_file(tmp_path / "one.yaml")
    rider = situation["A"]
    assert rider.starts.side is Side.RIGHT
    assert rider.starts.distance == Length(10.0, 10.0)
    assert rider.does[0].speed == Speed.of("18 km/h")
    assert situation.deed("A.brake") is rider.does[1]
    assert situation.deed("ego.1").act is Act.SET_OFF
    assert situation.adversaries == (rider,)


@given(situations())
@settings(max_examples=60, deadline=None)
def test_whatever_can_be_said_is_written_and_read_again(situation: Situation) -> None:
    assert tuple(faults_of(situation)) == ()
    assert read_text(to_yaml(situation)) == situation
    assert read_text(json.dumps(to_plain(situation))) == situation
    assert from_plain(to_plain(situation)) == situation


def test_a_file_of_json_may_be_indented_with_tabs(tmp_path: Path) -> None:
    file = tmp_path / "one.json"
    file.write_text(json.dumps(to_plain(read_text(WRITTEN)), indent="\t"), encoding="utf-8")
    assert read_file(file) == read_text(WRITTEN)


def test_every_fault_of_a_file_is_told_with_its_line_and_with_what_was_meant() -> None:
    wrong = WRITTEN.replace("bicycle", "bycicle").replace("right-turn", "right turn").replace("18 km/h", "18 m")
    wrong = wrong.replace("lanes:", "lane:")
    with pytest.raises(SituationError) as refused:
        read_text(wrong, "one.yaml")
    told = str(refused.value).splitlines()
    assert told[0] == "one.yaml has 4 faults:"
    assert told[1].startswith("  line 1, ego.route: 'right turn' is none of straight")
    assert told[1].endswith("did you mean right-turn?")
    assert told[2] == "  line 2, road.lane: there is no 'lane' here; did you mean lanes?"
    assert told[3].startswith("  line 4, others.A.kind: 'bycicle' is none of car")
    assert (
        told[4] == "  line 5, others.A.does.0.speed: 'm' is not a unit of a speed, which has km/h, kph, kmh, mph, m/s"
    )


@pytest.mark.parametrize(
    ("there", "instead", "told"),
    [
        ("ego.set-off", "ego.go", "there is no deed 'ego.go'"),
        ("{after: ego.set-off}", "{after: A.1}", "a deed cannot wait for itself"),
        ("{where: ahead}", "{where: ahead, side: left}", "line 7, others.B.starts.side: ahead has no side"),
        ("id: B", "id: A", "'A' is used twice"),
        ("id: B", "id: a", "'a' is used twice"),
        ("id: B", "id: A-1", "'A-1' is reserved for a member of a group"),
        ("speed: 50 km/h,", "speed: -50 km/h,", "speed is never below 0"),
        ("speed: 50 km/h,", "speed: 5 km/h more than the ego,", "only others can be relative to the ego"),
        ("distance: 10 m", "distance: 10 m more than the ego", "only a speed is measured against the ego's"),
        ("act: brake", "act: brake, breaks: stop-sign", "there is no stop-sign with road.control: signal"),
        ("{act: stand}]}", "{act: stand, when: {after: B.0}}]}", "a deed cannot wait for itself"),
        ("act: go-straight,", "act: go-straight, when: {after: A.1},", "it waits for a deed that waits for it"),
        ("id: B", "id: ego", "'ego' is not a name"),
        ("kind: truck", "kind: cone, hidden_by: D", "there is no 'D' in it, but A, B"),
        ("kind: truck", "kind: truck, hidden_by: B", "nobody hides itself"),
        ("kind: truck", "kind: truck, count: 1000000000", "1000000000 is too many; at most 20"),
        ("kind: truck", "kind: truck, count: -1", "-1 is not a number of road users"),
        (
            "act: brake",
            "act: cut-in",
            "cut-in has no acceleration, but speed (how fast it does that), distance (the gap",
        ),
        ("act: go-straight,", "act: go-straight, whom: B,", "go-straight has no other party"),
        ("kind: bicycle", "kind: pedestrian", "pedestrian walks, and cannot go-straight"),
        ("[{act: stand}, {act: set-off}]", "[{act: cross}]", "the ego cannot cross"),
        ("kind: four-way", "kind: road", "it cannot turn at a junction where the road is a road"),
        ("control: signal", "control: stop-sign", "there is no light with road.control: stop-sign"),
        ("lanes: 2", "lanes: 0", "a road has at least one lane"),
        ("lanes: 2", "lanes: 2, ego_lane: 3", "it is 3, and the road has 2 lanes; 1 is the outermost"),
        ("striker: ego", "striker: ego, whom: C", "there is no 'C' in it"),
        ("id: A,", "id: A, role: supporting,", "nobody is the adversary"),
    ],
)
def test_what_cannot_be_together_is_refused(there: str, instead: str, told: str) -> None:
    assert there in WRITTEN
    with pytest.raises(SituationError, match=r"^one\.yaml") as refused:
        read_text(WRITTEN.replace(there, instead), "one.yaml")
    assert told in str(refused.value)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("ego: [", "line 1: "),
        ("- 1", "a situation is a mapping"),
        ("ego: {}\nego: {}", "line 2, ego: 'ego' is here twice"),
        ("ego: 3", "3 is not a mapping; write one with kind, route, exit, speed, does"),
        ("[1]: 2", "a name is a word"),
        ("version: 99", "version 99 is from another chatscene"),
        ("ego: " + "[" * 5000, "it is nested too deeply"),
        (BOMB, "more than 20,000 values"),
        ("ego: &e {route: *e}", "or in itself"),
        ("ego: !!python/object/apply:os.system [id]", "has no meaning in a situation"),
        ('"a[b]": 1', "there is no 'a[b]' here"),
        ('version: "9"', "version '9' is from another chatscene"),
        ("road: {has: crosswalk}", "a list stands here"),
        (f"ego: {{speed: 1{'0' * 400}}}", "it is not a number"),
        ("road: {has: 2026-13-45}", "month must be in 1..12"),
    ],
)  # fmt: skip
def test_what_is_no_situation_is_refused_in_words(text: str, told: str) -> None:
    with pytest.raises(SituationError) as refused:
        read_text(text, "one.yaml")
    assert told in str(refused.value)


@pytest.mark.parametrize(
    ("there", "instead", "told"),
    [
        ("kind: truck", "kind: lorry", "did you mean truck?"),
        ("kind: truck", "kind: ambulance", "did you mean emergency-vehicle?"),
        ("kind: truck, ", "", "kind: is missing; write one of car, van"),
        ("where: ahead", "where: in front", "did you mean ahead or ahead-beside?"),
        ("ego: right-front", "ego: front-right", "did you mean right-front?"),
        ("kind: truck", "kind: truck, speed: 3 m/s", "did you mean starts.speed or does.speed?"),
        ("kind: truck", "kind: truck, weather: rain", "did you mean around.weather?"),
        ("kind: truck", "kind: truck, colour: red", "there is no 'colour' here, but id, kind, count"),
        ("lanes: 2", "lanes: two", "'two' is not a whole number"),
        ("two_way: true", "two_way: perhaps", "'perhaps' is neither true nor false"),
        ("id: B", "id: 2", "2 is not text; write it in quotes"),
        ("after: ego.set-off", "after: ego.sets-off", "but ego.stand, ego.set-off, A.go-straight"),
        ("striker: ego", "striker: ego, whom: a", "but A, B; did you mean A?"),
        ("3 m/s²", "3 km/h", "is not a unit of an acceleration"),
        ("act: go-straight,", "act: go-straight, whom: B,", "leave this out; stand, go-along"),
        ("act: brake", "act: brake, to: left", "leave this out; cross, cut-in"),
    ],
)
def test_a_wrong_word_is_told_with_its_line_with_what_can_stand_there_and_with_what_was_meant(
    there: str, instead: str, told: str
) -> None:
    assert there in WRITTEN
    with pytest.raises(SituationError, match=r"^one\.yaml: line \d") as refused:
        read_text(WRITTEN.replace(there, instead), "one.yaml")
    assert told in str(refused.value)


def test_a_file_that_cannot_be_read_is_refused_in_words(tmp_path: Path) -> None:
    with pytest.raises(SituationError, match="No such file"):
        read_file(tmp_path / "none.yaml")
    (tmp_path / "large.yaml").write_bytes(b"#" * (MOST_BYTES + 1))
    with pytest.raises(SituationError, match="more than 1 MB"):
        read_file(tmp_path / "large.yaml")
    (tmp_path / "bytes.yaml").write_bytes(b"ego: \xff")
    with pytest.raises(SituationError, match="not UTF-8 text"):
        read_file(tmp_path / "bytes.yaml")


def test_a_fact_is_set_by_its_path_and_loses_the_words_it_was_read_from() -> None:
    words = {"others.A.kind": "a cyclist", "road": "at a crossing"}
    evidence = {"quoted": words, "assumed": ["others.A.starts"]}
    read = from_plain({**to_plain(read_text(WRITTEN)), "evidence": evidence})
    changed = with_fact(read, "others.A.does.0.speed", "25 km/h")
    assert changed["A"].does[0].speed == Speed.of("25 km/h")
    assert changed.evidence == read.evidence
    scooter = with_fact(changed, "others.A.kind", "e-scooter")
    kept = {"road": "at a crossing", "about": "a cyclist"}  # which was read all the same, and gave no fact that is left
    assert scooter.evidence == Evidence(quoted=kept, assumed=("others.A.starts",))
    assert with_fact(scooter, "others.A.starts.side", "left").evidence.assumed == (
        "others.A.starts.where",
        "others.A.starts.distance",
    )
    assert with_fact(read, "others.B", None).others == (read["A"],)
    assert with_fact(read, "others.A.starts.side", None)["A"].starts.side is None


@pytest.mark.parametrize(
    ("path", "value", "told"),
    [
        ("others.C.kind", "car", "there is no 'C' here, but A, B"),
        ("ego.route", "lefft-turn", "did you mean left-turn?"),
        ("ego.colour", "red", "there is no 'colour' here"),
        ("ego.route.x", "red", "there is nothing in 'right-turn'"),
        ("others.A.does.7.speed", "1 m/s", "there is no '7' here"),
    ],
)
def test_a_path_that_leads_nowhere_is_refused(path: str, value: str, told: str) -> None:
    with pytest.raises(SituationError) as refused:
        with_fact(read_text(WRITTEN), path, value)
    assert told in str(refused.value)


def test_the_schema_says_what_every_word_and_field_means() -> None:
    made = schema()
    for name, part in made["$defs"].items():
        words = getattr(vocabulary, name, None)
        if words is not None and issubclass(words, Word):
            assert all(f"{word}: {word.meaning}" in part["description"] for word in words if word.meaning)
        for field in part.get("properties", {}).values():
            assert field["description"]
    assert json.loads(json.dumps(made)) == made


PAGE = ROOT / "docs" / "situation.md"


def test_every_amount_of_an_act_has_a_meaning() -> None:
    assert all(set(amounts_of(act)) == act.row.takes for act in Act)


def test_the_page_names_every_field_and_has_a_small_file_for_each_part_that_is_read() -> None:
    page = PAGE.read_text(encoding="utf-8")
    nouns = (Situation, Ego, Road, Other, Start, Deed, When, Contact, Around)
    for name in {one.name for noun in nouns for one in fields(noun)} - {"version"}:
        assert f"`{name}`" in page, name
    files = [step for step in steps_of(PAGE) if isinstance(step, Written) and "lorry" not in step.content]
    read = [read_text(step.content, step.name) for step in files]
    assert sum(bool(line) for line in files[0].content.splitlines()) <= 10
    assert max(len(step.content.splitlines()) for step in files) <= 20
    every = [deed for one in read for _, deeds in one.everybody() for deed in deeds]
    assert any(one.contact for one in read)
    assert any(one.ego.does for one in read)
    assert any(one.around != Around() for one in read)
    assert any(other.hidden_by for one in read for other in one.others)
    for name in ("after", "during", "ego_within"):
        assert any(getattr(deed.when, name, None) is not None for deed in every), name
