"""What can be composed can be said: a sentence made of the acts' own phrases is read as what it was made of."""

from __future__ import annotations

import runpy
from pathlib import Path
from random import Random

import pytest

from chatscene.terms.actors import AdversaryKind

COMPOSED = runpy.run_path(str(Path(__file__).parents[2] / "benchmarks" / "composed.py"))


@pytest.mark.parametrize("kind", [AdversaryKind.PEDESTRIAN, AdversaryKind.CAR])
def test_a_frame_that_is_said_is_read_back_with_its_number(kind: AdversaryKind) -> None:
    chance = Random(0)
    frames = COMPOSED["every"]([kind])
    for asked in chance.sample(frames, min(120, len(frames))):
        told = COMPOSED["told_of"](asked, chance)
        assert not COMPOSED["is_read"](told), told.sentence
