"""Who passes the ego on a side that was said is in the lane on that side."""

from __future__ import annotations

import pytest

from chatscene.build.build import build
from chatscene.situations.form import from_plain


@pytest.mark.parametrize("side", ["left", "right"])
def test_who_overtakes_from_the_next_lane_is_in_the_lane_on_the_side_that_was_said(side: str) -> None:
    rider = {
        "id": "A",
        "kind": "motorcycle",
        "starts": {"where": "behind-beside"},
        "does": [{"act": "overtake", "to": side}],
    }
    built = build(from_plain({"others": [rider]}))
    assert f'neighbourPath(egoRoute, "{side}")' in built.program.source
    assert not built.left_out
