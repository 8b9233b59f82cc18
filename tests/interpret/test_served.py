"""Sentences that were once served wrongly, and how they are served."""

from __future__ import annotations

import pytest

from chatscene.errors import NothingFits
from chatscene.report.understood import understand


@pytest.mark.parametrize(
    ("text", "behavior", "spawn"),
    [
        ("A car from the left crosses without coming to a full stop at the stop sign.", "cross", "from-left"),
        ("The car ahead has a stop.", "stop", "ahead-in-lane"),
    ],
)
def test_who_was_misread_is_served_as_told(text: str, behavior: str, spawn: str) -> None:
    retrieval = understand(text).retrieval
    assert retrieval is not None
    assert behavior in retrieval.behavior.snippet.id
    assert spawn in retrieval.spawn.snippet.id


def test_who_was_served_from_the_other_side_is_refused_for_it() -> None:
    with pytest.raises(NothingFits, match="nothing in the library does this"):
        understand("A car turns left out of a side road on our left and ends up in our lane.")
