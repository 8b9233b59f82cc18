"""The road users that a text names and that nobody is for in what was read."""

from __future__ import annotations

import pytest

from chatscene.read.users_unread import users_unread
from chatscene.situations.form import from_plain
from chatscene.terms.situation import Situation


def _read(kind: str, quoted: dict[str, str]) -> Situation:
    """A situation with one other, and the words of a text for its facts."""
    other = {"id": "A", "kind": kind, "starts": {"where": "ahead"}, "does": [{"act": "brake"}]}
    return from_plain({"others": [other], "evidence": {"quoted": quoted}})


@pytest.mark.parametrize(
    ("text", "kind", "quoted", "unread"),
    [
        ("A cyclist and a pedestrian both brake.", "bicycle", {"others.A.kind": "cyclist"}, ("pedestrian",)),
        ("A cyclist and a truck ahead brake.", "bicycle", {"others.A.starts.where": "ahead"}, ("truck",)),
        ("A cyclist brakes in the bus lane.", "bicycle", {"others.A.starts.where": "lane"}, ()),
        ("A cyclist brakes at the bus stop.", "bicycle", {"others.A.kind": "cyclist"}, ()),
        ("A pickup truck brakes.", "van", {"others.A.kind": "pickup"}, ()),
        ("A cyclist brakes before our truck.", "bicycle", {"others.A.kind": "cyclist"}, ()),
        ("A cyclist brakes, no other pedestrians are there.", "bicycle", {"others.A.kind": "cyclist"}, ()),
        ("A cyclist brakes without lights; a pedestrian waits.", "bicycle", {}, ("pedestrian",)),
        ("A cyclist brakes behind another cyclist.", "bicycle", {"others.A.kind": "A cyclist"}, ()),
        ("A vehicle brakes behind a truck.", "vehicle", {"others.A.kind": "vehicle"}, ()),
        ("A cyclist brakes at a cone.", "bicycle", {"others.A.kind": "cyclist"}, ()),
    ],
)
def test_a_road_user_is_unread_unless_it_names_a_place_somebody_there_or_the_ego_or_is_denied(
    text: str, kind: str, quoted: dict[str, str], unread: tuple[str, ...]
) -> None:
    assert users_unread(_read(kind, quoted), text) == unread
