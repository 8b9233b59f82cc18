"""Who is asked which reading is meant sees what differs between them."""

from __future__ import annotations

from chatscene.errors import OfferedReading
from chatscene.report.terminal import readings_in_words


def test_what_all_readings_say_is_told_once() -> None:
    told = (
        "We turn right. A cyclist is on our left. The cyclist crosses our path.",
        "We turn left. A cyclist is on our left. The cyclist stops.",
    )
    lines = readings_in_words([OfferedReading(number=i, told=one, probability=0.3) for i, one in enumerate(told, 1)])
    assert lines[:3] == [
        "It may say, in each case “A cyclist is on our left.”, and:",
        "  1  (30%)  We turn right. … The cyclist crosses our path.",
        "  2  (30%)  We turn left. … The cyclist stops.",
    ]


def test_one_reading_is_told_whole() -> None:
    told = "A cyclist is on our left. The cyclist stops."
    lines = readings_in_words([OfferedReading(number=1, told=told, probability=0.3)], also=True)
    assert lines[:2] == ["It may also say:", f"  1  (30%)  {told}"]
