"""Joints that no car could drive are cut out of a map that was made of an extract."""

from __future__ import annotations

from pathlib import Path

import pytest

from chatscene.errors import MapError, UnreadRoad
from chatscene.maps.joints import write_loadable
from chatscene.maps.network import load_network

WIDENING = Path(__file__).with_name("osm") / "widening.xodr"  # three lanes become five at node 5


def test_such_a_map_is_refused_by_its_road_as_it_is() -> None:
    with pytest.raises(UnreadRoad, match=r"road 34, lane -3: .* outside its area") as refused:
        load_network(WIDENING)
    assert refused.value.road == "34"


def test_the_joint_is_cut_out_and_told_and_the_streets_stay(tmp_path: Path) -> None:
    made = tmp_path / "street.xodr"
    cuts = write_loadable(made, WIDENING.read_bytes(), Path("street.osm"))
    assert [cut.node for cut in cuts] == ["5"]
    assert cuts[0].why.startswith("road 34, lane -3: ")
    assert {len(road.lanes) for road in load_network(made).roads} == {2, 3, 5}
    assert b"OpenStreetMap contributors" in made.read_bytes()  # whose streets they are


def test_what_is_no_joint_is_refused_and_leaves_nothing(tmp_path: Path) -> None:
    as_streets = WIDENING.read_bytes().replace(b'junction="1"', b'junction="-1"')
    with pytest.raises(MapError, match=r"street\.osm becomes a map that .* road 34, lane -3.*; leave that part out"):
        write_loadable(tmp_path / "street.xodr", as_streets, Path("street.osm"))
    assert not list(tmp_path.iterdir())
