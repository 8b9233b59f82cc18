"""Lesser facts for which no drive shows what was said are left out, where that was read in a text."""

from __future__ import annotations

from dataclasses import replace

from chatscene.report.stated import explain_stated
from chatscene.situations.form import from_plain
from chatscene.terms.situation import Evidence

# so slow and so near that it is over the junction long before the ego comes
TOO_NEAR = from_plain(
    {
        "ego": {"route": "right-turn"},
        "road": {"kind": "junction", "has": ["cycle-lane"]},
        "others": [
            {
                "id": "A",
                "kind": "bicycle",
                "starts": {"where": "behind-beside", "side": "right", "distance": "40 m", "speed": "22 km/h"},
                "does": [{"act": "go-straight"}],
            }
        ],
        "evidence": {"quoted": {"others.A": "Cargo bike", "ego.route": "ego turns right"}},
    }
)


def test_a_distance_from_which_nobody_meets_the_ego_is_left_out_and_told() -> None:
    whole = explain_stated(TOO_NEAR)
    assert any("encounter.A" in one for one in whole.unseen)
    made = whole.as_shown
    assert made.situation.others[0].starts.where == TOO_NEAR.others[0].starts.where
    assert not made.unseen
    assert any("with it, no drive shows encounter.A" in one for one in made.told_first)
    assert "with it, no drive shows" in made.record.text
    assert whole.program.source == made.rehearsed.program.source


def test_what_somebody_stated_stays_and_is_told_as_unseen() -> None:
    made = explain_stated(replace(TOO_NEAR, evidence=Evidence()))
    assert made.as_shown is made
    assert made.unseen
