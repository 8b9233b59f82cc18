"""The page for those who write situations says what is built of the words, and what is not: tried, word by word."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

from chatscene.build.build import Built, build
from chatscene.errors import NotBuilt, SituationError
from chatscene.situations.form import from_plain
from chatscene.terms.vocabulary import Act, EgoRoute, Feature, RoadKind, Setting, Side, UserKind, Where

PAGE = Path(__file__).parents[2] / "docs" / "reference" / "words.md"
BEGINS, ENDS = "<!-- tried: UPDATE_GOLDEN=1 pytest tests/build/test_page.py writes this -->\n", "<!-- end of it -->\n"
LEAD: dict[str, Any] = {"id": "A", "kind": "car", "starts": {"where": "ahead"}, "does": [{"act": "brake"}]}
ANYWHERE = "anywhere"
ON_FOOT = (UserKind.PEDESTRIAN,)
WHEELS = (UserKind.CAR, UserKind.MOTORCYCLE)
HIDERS = (Where.KERB, Where.ROADSIDE, Where.AHEAD, Where.AHEAD_BESIDE, Where.ONCOMING)


@cache
def tried(kind: str, where: Where, act: str) -> bool:
    """Whether somebody is built who does one thing there, from either side."""
    sides = Side if where.row.sided else (None,)
    starts = ({"where": str(where)} | ({"side": str(side)} if side else {}) for side in sides)
    return any(made({"others": [LEAD | {"kind": kind, "starts": one, "does": [{"act": act}]}]}) for one in starts)


def made(plain: dict[str, Any]) -> Built | None:
    try:
        return build(from_plain(plain))
    except (NotBuilt, SituationError):
        return None


def from_where(act: Act, *kinds: UserKind) -> str:
    """Where an act can begin, of the places in which one of some kinds can be at all."""
    doing = [kind for kind in kinds if kind.moves in act.row.by]
    there = [where for where in Where if any(tried(kind, where, "stand") for kind in doing)]
    can = [where for where in there if any(tried(kind, where, act) for kind in doing)]
    cannot = [where for where in there if where not in can]
    if len(can) <= len(cannot):
        return listed(can)
    return f"anywhere but {listed(cannot)}" if cannot else ANYWHERE


def hidden(kind: str, where: Where, by: Where) -> bool:
    """Whether somebody is built who is hidden there by a van that stands, from either side."""
    does: dict[str, list[dict[str, str]]] = {"does": [{"act": "stand"}]}
    for side in Side:
        one = {"where": str(where)} | ({"side": str(side)} if where.row.sided else {})
        there = {"where": str(by)} | ({"side": str(side)} if by.row.sided else {})
        van = {"id": "B", "kind": "van", "role": "hides", "starts": there, **does}
        acts = [{"act": "pull-out"}] if where in (Where.KERB, Where.BUS_BAY) else []
        if made({"others": [{"id": "A", "kind": kind, "starts": one, "hidden_by": "B", "does": acts}, van]}):
            return True
    return False


def who_is_hidden() -> Iterator[str]:
    """The places of who can be hidden, each with those of who hides it."""
    for where in Where:
        kinds = ("car", "pedestrian")
        if by := [hider for hider in HIDERS if any(hidden(kind, where, hider) for kind in kinds)]:
            yield f"| `{where}` | {listed(by)} |"


def listed(words: Iterable[object]) -> str:
    return ", ".join(f"`{word}`" for word in words)


def by_field(words: Mapping[str, Iterable[object]]) -> str:
    told = {field: listed(some) for field, some in words.items()}
    return "; ".join(f"`{field}`: {some}" for field, some in told.items() if some) or "none"


def routes() -> Iterator[EgoRoute]:
    yield from (route for route in EgoRoute if made({"ego": {"route": str(route)}, "others": [LEAD]}) is None)


def of_road(field: str, words: Iterable[object], *, several: bool = False) -> tuple[list[object], list[object]]:
    """The words of a field of the road that are refused, and those that are left out."""
    refused, left = list[object](), list[object]()
    for word in words:
        built = made({"road": {field: [str(word)] if several else str(word)}, "others": [LEAD]})
        (refused if built is None else left if built.left_out else []).append(word)
    return refused, left


def waited_for(act: Act) -> bool:
    """Whether somebody can wait for a deed, done from some place by some kind."""
    brakes = LEAD | {"does": [{"act": "brake", "when": {"after": "B.0"}}]}
    for kind, where in ((kind, where) for kind in ("car", "motorcycle", "pedestrian") for where in Where):
        other = {"id": "B", "kind": kind, "role": "supporting", "does": [{"act": act}]}
        starts = ({"where": str(where)} | ({"side": side} if where.row.sided else {}) for side in ("right", "left"))
        if tried(kind, where, act) and any(made({"others": [brakes, other | {"starts": one}]}) for one in starts):
            return True
    return False


def begun() -> Iterator[tuple[Act, str, str]]:
    """Every act with where it can begin, on wheels and on foot."""
    yield from ((act, from_where(act, *WHEELS), from_where(act, *ON_FOOT)) for act in Act)


def page() -> str:
    """What the page says of what is built."""
    kinds, _ = of_road("kind", RoadKind)
    _, features = of_road("has", Feature, several=True)
    _, settings = of_road("setting", Setting)
    nobody = [where for where in Where if not any(tried(kind, where, "stand") for kind in WHEELS)]
    walks = [where for where in Where if tried(ON_FOOT[0], where, "stand")]
    refused = by_field({"ego.route": routes(), "road.kind": kinds, "starts.where": nobody})
    left = by_field({"road.has": features, "road.setting": settings})
    lines = [
        f"- Always refused: {refused}.",
        f"- Left out and reported, unless the map already has it: {left}.",
        f"- Pedestrians can start {listed(walks)}.",
        f"- No deed can wait (`after`, `during`) for {listed(act for act in Act if not waited_for(act))}.",
        "",
        "A road user in these places can be hidden by a standing van:",
        "",
        "| hidden | hiding |",
        "|---|---|",
        *who_is_hidden(),
        "",
        "An act can begin in these places, if it is the first, concerns only the ego, and the ego goes straight on. "
        "Elsewhere it is refused. Acts without a row can begin anywhere. An earlier deed may lead to another place: a "
        "car `ahead-beside` that does `cut-in` is ahead afterwards.",
        "",
        "| act | on wheels | on foot |",
        "|---|---|---|",
        *(f"| `{act}` | {there} | {on_foot} |" for act, there, on_foot in begun() if {there, on_foot} - {ANYWHERE, ""}),
    ]
    return "\n".join(lines) + "\n"


def test_the_page_says_which_words_are_not_built_and_from_where_each_act_is() -> None:
    written = PAGE.read_text(encoding="utf-8")
    before, _, rest = written.partition(BEGINS)
    said, _, after = rest.partition(ENDS)
    if os.environ.get("UPDATE_GOLDEN"):
        PAGE.write_text(f"{before}{BEGINS}{page()}{ENDS}{after}", encoding="utf-8")
        return
    assert said == page(), "what is built has changed: UPDATE_GOLDEN=1 pytest tests/build/test_page.py"
