"""Who drove, and what they could see: without that no collision rate means anything."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from chatscene.ego.policy import in_words


def ego_in_words(name: str, explanation: Mapping[str, Any]) -> str:
    """An ego by its name, with what it sees and how hard it brakes, as a run's `explanation.json` has them."""
    return f"{name} {in_words(explanation.get('egos', {}).get(name, {}))}"
