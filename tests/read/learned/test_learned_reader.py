"""The learned reader: what it makes of a text, and what it refuses."""

from __future__ import annotations

import dataclasses
import math
import shutil
from pathlib import Path

import numpy as np
import pytest

from chatscene.errors import SettingsError, SnippetError
from chatscene.read.learned.decoder import WIDTH, Decoder, Written
from chatscene.read.learned.reader import LearnedReader, ranked_of
from chatscene.read.learned.text import prepared
from chatscene.read.learned.weights import PACKAGED, load, save, trust_file
from chatscene.read.quotes import not_in_words
from chatscene.read.reader import Reader
from chatscene.report.filled import filled, is_filled
from chatscene.settings import OFFLINE, RetrievalSettings
from chatscene.situations.check import faults_of
from chatscene.situations.form import from_plain
from chatscene.terms.amount import Acceleration, Duration
from chatscene.terms.reading import Verdict
from chatscene.terms.scenario import Side
from chatscene.terms.surroundings import Weather
from chatscene.terms.vocabulary import Act, Feature, Where
from making.reader.sequence import steps_of

TEXT = "The van ahead brakes at 6 m/s²."


@pytest.fixture(scope="module")
def reader() -> Reader:
    return LearnedReader()


def test_a_text_becomes_ranked_situations(reader: Reader) -> None:
    made = reader.read(TEXT)
    assert (made.reader, made.verdict) == (OFFLINE, Verdict.SITUATION)
    first = made.ranked[0].situation
    assert (first.others[0].starts.where, first.others[0].does[-1].act) == (Where.AHEAD, Act.BRAKE)
    sure = [one.probability for one in made.ranked]
    assert sure == sorted(sure, reverse=True)
    assert sum(sure) <= 1.0 + 1e-6


def test_an_amount_is_that_of_the_text_and_its_words_are_quoted(reader: Reader) -> None:
    first = reader.read(TEXT).ranked[0].situation
    (path,) = [path for path, words in first.evidence.quoted.items() if "6 m/s²" in words]
    assert path == f"others.A.does.{len(first.others[0].does) - 1}.acceleration"
    assert first.others[0].does[-1].acceleration == Acceleration.of("6 m/s²")


def test_no_situation_is_against_itself(reader: Reader) -> None:
    for one in reader.read("A pedestrian overtakes a parked tree, a dog opens its door, and the ego is a ball.").ranked:
        assert not list(faults_of(one.situation))


def test_the_same_text_is_read_the_same(reader: Reader) -> None:
    assert reader.read(TEXT) == reader.read(TEXT)


@pytest.mark.parametrize("text", ["", "   ", "x" * 2001])
def test_a_text_that_is_empty_or_too_long_is_refused(reader: Reader, text: str) -> None:
    with pytest.raises(SettingsError):
        reader.read(text)


def test_what_is_not_about_traffic_is_no_situation(reader: Reader) -> None:
    made = reader.read("Please book a table for two at seven tonight.")
    assert made.verdict is not Verdict.SITUATION
    assert not made.ranked
    assert not made.ranked


def test_the_beam_is_sorted_and_as_wide_as_it_may_be() -> None:
    written = Decoder(load()).written(prepared(TEXT))
    assert 0 < len(written) <= WIDTH
    assert [one.likely for one in written] == sorted((one.likely for one in written), reverse=True)


def test_the_file_holds_what_was_saved(tmp_path: Path) -> None:
    weights = load()
    save(weights, tmp_path / "again.npz")
    for one in dataclasses.fields(weights):
        assert getattr(load(tmp_path / "again.npz"), one.name) == getattr(weights, one.name)


def test_a_damaged_file_is_refused(tmp_path: Path) -> None:
    with np.load(PACKAGED) as arrays:
        np.savez(tmp_path / "old.npz", **{name: value for name, value in arrays.items() if name != "text"})
    shutil.copy(trust_file(PACKAGED), trust_file(tmp_path / "old.npz"))
    with pytest.raises(SnippetError, match=r"cannot be read \(.*text"):
        load(tmp_path / "old.npz")


@pytest.mark.parametrize("trust", [None, "", "[]", '{"whole": [1.0, 0.0]}', '{"whole": [1.0], "in parts": [1.0, 0.0]}'])
def test_weights_without_how_sure_they_may_be_are_refused(trust: str | None, tmp_path: Path) -> None:
    shutil.copy(PACKAGED, tmp_path / "reader.npz")
    if trust is not None:
        trust_file(tmp_path / "reader.npz").write_text(trust)
    with pytest.raises(SnippetError, match="install chatscene again"):
        load(tmp_path / "reader.npz")


def test_a_missing_file_is_told_with_how_to_get_it(tmp_path: Path) -> None:
    with pytest.raises(SnippetError, match="install chatscene again"):
        load(tmp_path / "none.npz")


def test_a_text_is_filled_by_it_and_built() -> None:
    settings = RetrievalSettings(refuse_below=0.0)
    assert is_filled(TEXT, settings)
    made = filled(TEXT, settings)
    assert made.reader == OFFLINE
    assert "brake" in str(steps_of(Verdict.SITUATION, made.situation))


def test_a_file_that_changes_the_encoder_elsewhere_is_refused() -> None:
    packaged = load()
    moved = dataclasses.replace(packaged, changes={1_000_000: b"\1"})
    with pytest.raises(ValueError, match="share"):
        Decoder(moved).written(prepared(TEXT))


def test_what_the_vocabulary_has_gained_since_is_not_written() -> None:
    old = load()
    gone = ("Deed.act", "brake")
    tokens = tuple(("Deed.act", "of another time") if one == gone else one for one in old.tokens)
    written = Decoder(dataclasses.replace(old, tokens=tokens)).written(prepared(TEXT))
    assert written
    assert not [step for one in written for step in one.steps if step.token in (gone, ("Deed.act", "of another time"))]


def test_what_leaves_a_fact_open_is_not_the_sum_of_all_that_say_it() -> None:
    def written(likely: float, **side: str) -> Written:
        starts = {"where": "roadside", **side}
        other = {"id": "A", "kind": "bicycle", "starts": starts, "does": [{"act": "cross"}]}
        steps = steps_of(Verdict.SITUATION, from_plain({"others": [other]}))
        return Written(steps, math.log(likely), (), ())

    read = prepared("a cyclist crosses from the left")
    left, right = ranked_of(read, [written(0.1), written(0.5, side="left"), written(0.3, side="right")])
    assert (left.situation["A"].starts.side, right.situation["A"].starts.side) == (Side.LEFT, Side.RIGHT)
    assert (left.probability, right.probability) == (pytest.approx(0.6), pytest.approx(0.3))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("Ego shall avoid contact with a pedestrian crossing from the left.", "avoid contact"),
        ("A cyclist crosses from the right, and a collision must be avoided.", "collision must be avoided"),
    ],
)
def test_what_somebody_shall_avoid_is_no_contact_that_is_denied_and_is_told_as_not_read(text: str, words: str) -> None:
    read = LearnedReader().read(text)
    assert read.ranked[0].situation.contact is None
    assert words in read.unread


def test_a_contact_that_a_text_denies_of_the_scene_is_read() -> None:
    for text in (
        "There should be no contact with the pedestrian who crosses from the left.",
        "A cyclist crosses from the right and we just miss him, no contact.",
    ):
        contact = LearnedReader().read(text).ranked[0].situation.contact
        assert contact is not None
        assert contact.happens is False


def test_a_weather_whose_word_names_another_is_told_as_what_it_is_read_as() -> None:
    told = not_in_words(LearnedReader().read("A hailstorm starts and the car ahead brakes.").ranked[0].situation)
    assert "'hailstorm' is read as rain" in told
    told = not_in_words(
        LearnedReader().read("In heavy rain at night the car ahead brakes on the wet road.").ranked[0].situation
    )
    assert not told


@pytest.mark.parametrize(
    ("text", "time"),
    [
        ("We follow a truck for 20 s, then it brakes hard.", None),
        ("We follow a truck at a time gap of 2 s, then it brakes hard.", Duration(2, 2)),
    ],
)
def test_how_long_somebody_follows_is_no_gap(text: str, time: Duration | None, reader: Reader) -> None:
    (deed,) = reader.read(text).ranked[0].situation.ego.does
    assert (deed.act, deed.time) == (Act.FOLLOW, time)


def test_two_parked_cars_are_not_a_row_of_them_as_well(reader: Reader) -> None:
    first = reader.read("Ego at 50 km/h, pedestrian crosses from the right behind two parked cars.").ranked[0].situation
    assert [one.count for one in first.others] == [1, 2]
    assert first.road.has == ()
    both = "A boy runs out behind two parked vans in a street with parked cars."
    assert Feature.PARKED_CARS in reader.read(both).ranked[0].situation.road.has


def test_a_headway_is_no_time_that_somebody_brakes_for_and_is_told_as_not_read() -> None:
    read = LearnedReader().read("A lead vehicle at 60 km/h decelerates with 0.6 g at a time headway of 1.2 s.")
    (lead,) = read.ranked[0].situation.others
    assert [deed.time for deed in lead.does] == [None]
    assert any("headway" in words for words in read.unread)


def test_an_overcast_sky_is_not_read_as_a_clear_one() -> None:
    read = LearnedReader().read("Under an overcast sky, a car comes out of a driveway on the right.")
    assert read.ranked[0].situation.around.weather is Weather.OVERCAST
