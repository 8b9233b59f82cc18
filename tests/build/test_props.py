"""Things that stand beside the road and block the view."""

from __future__ import annotations

import pytest
from test_towards import deed, driven, others, track

from chatscene.terms.actors import PROPS
from chatscene.terms.vocabulary import UserKind


@pytest.mark.parametrize("kind", [kind for kind in UserKind if kind.row.prop in PROPS])
def test_a_thing_has_the_size_of_its_row(kind: UserKind) -> None:
    starts = {"where": "roadside", "side": "right"}
    walker = {"id": "A", "kind": "pedestrian", "starts": starts, "hidden_by": "B", "does": [deed("cross")]}
    thing = {"id": "B", "kind": str(kind), "role": "hides", "starts": starts}
    stands = track(driven(others(walker, thing)), "B")
    assert (stands.length, stands.width) == (PROPS[kind.row.prop].length, PROPS[kind.row.prop].width)
