"""The best triple is found without looking at every triple."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from chatscene.interpret.joint_choice import highest
from chatscene.library.compatibility import compatibility
from chatscene.library.load import Library, load_library
from chatscene.terms.snippet import Tried
from places import FIXTURES


def doubled(library: Library) -> Library:
    """Every snippet twice, under two names."""
    again = (replace(snippet, id=f"{snippet.id}-again") for snippet in library)
    return Library(tuple(sorted((*library, *again), key=lambda snippet: snippet.id)))


@pytest.mark.parametrize("seed", range(12))
def test_it_is_the_one_that_is_found_by_looking_at_every_triple(seed: int) -> None:
    joint = compatibility(doubled(load_library(FIXTURES / "library")))
    rng = np.random.default_rng(seed)
    axes = (joint.behaviors, joint.geometries, joint.spawns)
    scores = [rng.integers(0, 4, len(axis)).astype(float) for axis in axes]  # few numbers, so that many are equal
    allowed = [rng.random(len(axis)) < 0.8 for axis in axes]
    b, g, s = (int(i) for i in rng.choice(np.argwhere(joint.mask)))
    tried = [
        Tried(snippet_ids=(joint.behaviors[b].id, joint.geometries[g].id, joint.spawns[s].id), reason="not shown"),
        Tried(snippet_ids=(joint.behaviors[b - 1].id, joint.spawns[s].id), reason="not shown"),
    ]
    sums = scores[0][:, None, None] + scores[1][:, None] + scores[2]
    able = joint.mask & allowed[0][:, None, None] & allowed[1][:, None] & allowed[2]
    able[b, g, s] = able[b - 1, :, s] = False
    found = highest(joint, scores, allowed, tried)
    assert (found is None) is not able.any()
    if found is not None:
        assert able[found]
        assert sums[found] == sums[able].max()


def test_snippets_that_differ_in_name_alone_are_of_one_sort() -> None:
    library = load_library()
    once, twice = compatibility(library), compatibility(doubled(library))
    assert [int(sorts.max()) for sorts in twice.sorts] == [int(sorts.max()) for sorts in once.sorts]
    assert [len(sorts) for sorts in twice.sorts] == [2 * len(sorts) for sorts in once.sorts]


def test_a_library_without_a_component_joins_nothing() -> None:
    library = load_library(FIXTURES / "library")
    joint = compatibility(Library(tuple(s for s in library if not s.id.startswith("spawn/"))))
    assert joint.mask.shape == (len(joint.behaviors), len(joint.geometries), 0)
    assert highest(joint, [np.zeros(n) for n in joint.mask.shape], [np.ones(n, bool) for n in joint.mask.shape]) is None
