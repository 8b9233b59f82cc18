"""A refusal that names a number names one that is built once it is said."""

from __future__ import annotations

import re
from typing import Any

import pytest
from test_starting import someone

from chatscene.build.build import build
from chatscene.errors import NotBuilt
from chatscene.situations.form import from_plain

BAY = someone("bus-bay", "pull-out", kind="bus")
CROSSWALK = someone("crossing", "cross", kind="pedestrian", side="right")
BLOCKED = someone("ahead", "stand", kind="truck") | {"ego": {"route": "bypass"}}
PARKED = someone("kerb", "stand", side="right") | {"ego": {"route": "bypass"}}
_NAMED = re.compile(r"say (\d+) m|is (\d+) to (\d+) m ahead")


def _at(said: dict[str, Any], metres: int) -> None:
    other = said["others"][0]
    starts = other["starts"] | {"distance": f"{metres} m"}
    build(from_plain(said | {"others": [other | {"starts": starts}]}))


@pytest.mark.parametrize("said", [BAY, CROSSWALK, BLOCKED, PARKED], ids=["bay", "crosswalk", "ahead", "kerb"])
@pytest.mark.parametrize("metres", [40, 90, 160])
def test_somebody_is_as_far_ahead_as_was_said_where_the_road_has_something(said: dict[str, Any], metres: int) -> None:
    _at(said, metres)


@pytest.mark.parametrize("said", [BAY, CROSSWALK, BLOCKED, PARKED], ids=["bay", "crosswalk", "ahead", "kerb"])
@pytest.mark.parametrize("metres", [3, 12, 300])
def test_a_refused_distance_names_one_that_is_built(said: dict[str, Any], metres: int) -> None:
    try:
        _at(said, metres)
    except NotBuilt as refused:
        named = _NAMED.search(str(refused))
        assert named is not None, refused
        for number in filter(None, named.groups()):
            _at(said, int(number))
