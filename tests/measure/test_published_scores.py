"""The five published overall scores from the ten published columns (paper, diagnostic table)."""

import json

import pytest

from chatscene.terms.metrics import Metrics
from places import SHARED

NAMES = (
    "collision_rate", "red_light", "stop_sign", "off_road", "route_following",
    "completion", "time_spent", "acceleration", "yaw_velocity", "lane_invasion",
)  # fmt: skip
PUBLISHED = {
    "LC": ((0.584, 0.326, 0.158, 0.032, 0.894, 0.731, 0.216, 0.211, 0.243, 0.112), 0.619),
    "AS": ((0.586, 0.300, 0.160, 0.025, 0.891, 0.745, 0.261, 0.203, 0.245, 0.127), 0.620),
    "CS": ((0.676, 0.313, 0.161, 0.036, 0.890, 0.741, 0.244, 0.215, 0.243, 0.131), 0.573),
    "AT": ((0.627, 0.312, 0.158, 0.028, 0.893, 0.726, 0.279, 0.219, 0.248, 0.137), 0.596),
    "ChatScene": ((0.831, 0.179, 0.143, 0.035, 0.833, 0.544, 0.223, 0.705, 0.532, 0.243), 0.482),
}
TABLES = SHARED / "data" / "paper_tables.json"


@pytest.mark.parametrize("method", PUBLISHED)
def test_the_overall_score_of_the_paper_follows_from_its_ten_columns(method: str) -> None:
    columns, published = PUBLISHED[method]
    assert Metrics(**dict(zip(NAMES, columns, strict=True))).overall_score == pytest.approx(published, abs=0.001)


def test_the_columns_are_those_of_the_paper() -> None:
    if not TABLES.exists():
        pytest.skip("the paper's tables are not beside this checkout")
    table = json.loads(TABLES.read_text())["tables"]["tab:diagnostic"]
    for method, (columns, score) in PUBLISHED.items():
        assert (*columns, score) == tuple(table[method].values())
