"""The drawing of a run's map: kept in its folder, and held to a form when it is read."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any

from pydantic import BaseModel, Field, ValidationError

from chatscene.errors import RunError
from chatscene.runs.atomic import read_json, write_json
from chatscene.runs.record import first_problem
from chatscene.runs.workspace import Workspace

FARTHEST = 1e6  # [m] from the map's origin: no road is longer, and what draws must end
_Metres = Annotated[float, Field(ge=-FARTHEST, le=FARTHEST)]
_Points = Annotated[list[tuple[_Metres, _Metres]], Field(min_length=2)]
_Areas = list[Annotated[list[_Points], Field(min_length=1)]]


class _Line(BaseModel):
    kind: str = ""
    points: _Points


class _Drawing(BaseModel):
    """What `chatscene.maps.drawing.map_drawing` gives, and the routes by name."""

    roads: _Areas = []
    junctions: _Areas = []
    shoulders: _Areas = []
    sidewalks: _Areas = []
    cycle_lanes: _Areas = []
    driveways: _Areas = []
    crosswalks: _Areas = []
    rails: _Areas = []
    lane_boundaries: list[_Line] = []
    stop_lines: list[_Line] = []
    routes: dict[str, _Points] = {}


def write_drawing(run: Workspace, drawing: Mapping[str, Any]) -> None:
    """Keep the drawing of the map as `map.json`; `docs/run-folder.md` has its shape. Metres, map frame."""
    write_json(run.file("map.json"), drawing)


def read_drawing(run: Workspace) -> dict[str, Any]:
    """The drawing of the map; empty if there is none.

    Raises:
        RunError: It is none.
    """
    path = run.file("map.json")
    content = read_json(path) if path.is_file() else {}
    try:
        _Drawing.model_validate(content)
    except ValidationError as error:
        raise RunError(
            f"{path} is not the drawing of a map: {first_problem(error)}; it was changed or damaged after it was"
            " written"
        ) from error
    return content
