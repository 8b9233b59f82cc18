"""A sentence that works, for whoever wrote one that does not: the nearest of some that the library serves."""

from __future__ import annotations

import numpy as np

from chatscene.models.encoders.embedding import Embedder

# Plain words for what is asked for most; the tests read every one of them and drive it.
SERVED = (
    "The car ahead brakes hard.",
    "The truck ahead stops suddenly.",
    "A car cuts in from the right.",
    "A motorcycle overtakes us and brakes.",
    "A car overtakes us and cuts in.",
    "An oncoming car turns left across our path.",
    "An oncoming car swerves into our lane.",
    "A car comes toward us in our lane on the wrong side of the road.",
    "A car from the right runs the red light.",
    "A car from the left crosses the intersection in front of us.",
    "A pedestrian crosses the street from the right.",
    "A child runs out from behind a parked van on the right.",
    "A child dashes across the street from the left.",
    "We turn right and a cyclist on our right goes straight on.",
    "A cyclist ahead of us swerves.",
    "A car pulls out from the kerb.",
    "The car behind us drives too close.",
    "The car ahead of us reverses.",
    "We change lanes to the left and a car in that lane accelerates.",
    "An ambulance from the right runs the red light.",
)


def suggestion(text: str, embedder: Embedder) -> str:
    """The one of `SERVED` that is nearest to a text."""
    rows = embedder.encode([text, *SERVED])
    return SERVED[int(np.argmax(rows[1:] @ rows[0]))]
