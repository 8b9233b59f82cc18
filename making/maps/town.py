"""The town that comes with chatscene: a plan, and the map file made from it.

Four by four blocks without corners: four four-way junctions in the middle, eight three-way ones around, rounded
streets at the four corners. One avenue each way has two lanes per direction, everything else one.

``python -m making.maps.town`` writes the packaged file anew.
"""

from __future__ import annotations

from chatscene.maps.network import PACKAGED
from chatscene.maps.writing.opendrive import write_opendrive
from chatscene.maps.writing.streets import Node, Street
from chatscene.terms.scenario import Control

BLOCK = 270.0  # [m] between junctions: straights of 230 m between the setbacks
AVENUE = 1  # the row and the column with two lanes per direction
CORNER_RADIUS = 60.0  # [m]

_CONTROL = {
    (1, 1): Control.SIGNAL,
    (2, 2): Control.SIGNAL,
    (2, 1): Control.NONE,
    (1, 2): Control.STOP_SIGN,
    (0, 1): Control.SIGNAL,
    (3, 2): Control.SIGNAL,
    (1, 3): Control.STOP_SIGN,
    (2, 0): Control.STOP_SIGN,
}


def plan() -> tuple[Street, ...]:
    """The streets of the town."""
    cells = [(i, j) for j in range(4) for i in range(4) if not (i in (0, 3) and j in (0, 3))]
    nodes = {
        (i, j): Node(
            id=number,
            x=(i - 1.5) * BLOCK,
            y=(j - 1.5) * BLOCK,
            control=_CONTROL.get((i, j), Control.NONE),
        )
        for number, (i, j) in enumerate(cells, start=1)
    }
    pairs = [((i, j), (i + 1, j)) for i, j in cells if (i + 1, j) in nodes]
    pairs += [((i, j), (i, j + 1)) for i, j in cells if (i, j + 1) in nodes]
    streets = [
        Street(id=number, start=nodes[a], end=nodes[b], lanes=2 if _on_avenue(a, b) else 1)
        for number, (a, b) in enumerate(pairs, start=1)
    ]
    corners = [
        ((0, 1), (1, 0), (0, 0)),
        ((2, 0), (3, 1), (3, 0)),
        ((3, 2), (2, 3), (3, 3)),
        ((1, 3), (0, 2), (0, 3)),
    ]
    for a, b, (i, j) in corners:
        corner = ((i - 1.5) * BLOCK, (j - 1.5) * BLOCK)
        streets.append(
            Street(
                id=len(streets) + 1,
                start=nodes[a],
                end=nodes[b],
                lanes=1,
                via=((*corner, CORNER_RADIUS),),
            )
        )
    return tuple(streets)


def _on_avenue(a: tuple[int, int], b: tuple[int, int]) -> bool:
    return a[1] == b[1] == AVENUE or a[0] == b[0] == AVENUE


if __name__ == "__main__":
    PACKAGED["town"].write_text(write_opendrive("town", plan()), encoding="utf-8")
