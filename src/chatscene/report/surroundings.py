"""Light, weather and road in words, and what they change of the drives."""

from __future__ import annotations

from chatscene.ego.observation import RANGE, SIGHT
from chatscene.terms.surroundings import Surroundings


def surroundings_in_words(around: Surroundings) -> str:
    """What is not as it is where nothing is said, and what comes of it; empty if all is."""
    if not str(around):
        return ""
    changes: list[str] = []
    if around.surface.row.friction < 1.0:
        changes.append(
            f"the road limits what tyres brake, steer and accelerate by to {around.grip:.1f} m/s²; drag adds to braking"
        )
    lit, unlit = around.sight(lit=True), around.sight(lit=False)
    if unlit < RANGE:
        who = "others are" if lit < RANGE else "who carries no lamps is"
        changes.append(
            f"{who} seen from {unlit:g} m, which means nothing to an ego that sees four numbers: it looks {SIGHT:g} m "
            "ahead at any time"
        )
    return f"{around}: {'; '.join(changes) or 'nothing that the drives would show'}"
