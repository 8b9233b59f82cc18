"""Sentences that were once served wrongly, and how they are served."""

from __future__ import annotations

import pytest

from chatscene.errors import NothingFits
from chatscene.report.understood import understand


@pytest.mark.parametrize(
    ("text", "behavior", "spawn"),
    [
        ("From the right a van fails to come to a full stop and drives into the intersection.", "cross", "from-right"),
        ("A car from the left crosses without coming to a full stop at the stop sign.", "cross", "from-left"),
        ("At a four-way stop a truck fails to stop and crosses from the left.", "cross", "from-left"),
        ("A car from the left has STOP, never slows down, and crosses.", "cross", "from-left"),
        ("The car ahead has a stop.", "hard-stop", "ahead-in-lane"),
        ("An oncoming car moves into our half of the road.", "oncoming-swerve", "oncoming-lane"),
        ("A child on a scooter shoots out between parked cars on the left.", "cross", "behind-parked-car-left"),
        ("The cyclist on our right wobbles toward us when the bus passes.", "wobble", "right-edge"),
        (
            "We turn right and a cyclist who comes from behind on our right goes straight on.",
            "follow-lane",
            "rider-straight-on-behind",
        ),
    ],
)
def test_who_was_misread_is_served_as_told(text: str, behavior: str, spawn: str) -> None:
    retrieval = understand(text).retrieval
    assert retrieval is not None
    assert behavior in retrieval.behavior.snippet.id
    assert spawn in retrieval.spawn.snippet.id


@pytest.mark.parametrize(
    "text",
    [
        "A car turns left out of a side road on our left and ends up in our lane.",
        "A cyclist comes towards us on the right and swerves.",
    ],
)
def test_who_was_served_from_the_other_side_is_refused_for_it(text: str) -> None:
    with pytest.raises(NothingFits, match="side: said"):
        understand(text)
