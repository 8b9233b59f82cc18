"""ASAM Open Simulation Interface: who was where, from a trace of ground truth in an MCAP file."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from chatscene.errors import MissingExtra, ScenarioError
from chatscene.files.bounded import check_file
from chatscene.imports.recording import Poses
from chatscene.terms.actors import LIMITS, PROPS, AdversaryKind

MOST_BYTES = 256 * 2**20
MOST_MESSAGES = 60_000
GROUND_TRUTH = "osi3.GroundTruth"
OURS = "chatscene"
_Row = tuple[float, float, float, float, float]


def read_trace(path: Path) -> tuple[Poses, ...]:
    """Who was where and when; the ego is the vehicle that the trace calls its host.

    Raises:
        MissingExtra: The package of the format is not installed.
        ScenarioError: It cannot be read, or holds no ground truth.
    """
    rows, bodies, ego = defaultdict[int, list[_Row]](list), dict[int, Any](), set[int]()
    try:
        check_file(path)
        if path.stat().st_size > MOST_BYTES:
            raise ScenarioError(f"{path} has more than {MOST_BYTES // 2**20} MB; cut it down to the drive")
        for truth in _messages(path):
            if truth.HasField("host_vehicle_id"):
                ego.add(truth.host_vehicle_id.value)
            now = truth.timestamp.seconds + truth.timestamp.nanos * 1e-9
            for one in (*truth.moving_object, *truth.stationary_object):
                bodies.setdefault(one.id.value, one)
                rows[one.id.value].append((now, *_pose(one)))
    except (OSError, ValueError) as error:
        raise ScenarioError(f"{path} cannot be read: {getattr(error, 'strerror', None) or error}") from error
    if not rows:
        raise ScenarioError(f"{path} holds no message {GROUND_TRUTH} with a road user in it")
    return tuple(_poses(path, body, rows[name], ego == {name}) for name, body in bodies.items())


def _messages(path: Path) -> Iterator[Any]:
    try:
        from google.protobuf.message import DecodeError
        from mcap.exceptions import McapError
        from mcap.reader import make_reader
        from osi3.osi_groundtruth_pb2 import GroundTruth
    except ImportError as error:
        raise MissingExtra(f"a trace of OSI needs {error.name}", extra="osi") from error
    count = 0
    try:
        with path.open("rb") as file:
            for schema, _, message in make_reader(file).iter_messages():
                if schema is None or schema.name != GROUND_TRUTH:
                    continue
                count += 1
                if count > MOST_MESSAGES:
                    raise ScenarioError(f"{path} has more than {MOST_MESSAGES:,} messages; cut it down to the drive")
                yield GroundTruth.FromString(message.data)
    except (McapError, DecodeError) as error:
        raise ScenarioError(f"{path} is not an OSI trace in an MCAP file: {error}") from error


def _pose(one: Any) -> tuple[float, float, float, float]:
    base = one.base
    heading = float(base.orientation.yaw)
    if one.DESCRIPTOR.name != "MovingObject":
        along = 0.0
    elif base.HasField("velocity"):
        along = base.velocity.x * math.cos(heading) + base.velocity.y * math.sin(heading)
    else:
        along = math.nan  # which is told by where it goes
    return float(base.position.x), float(base.position.y), heading, float(along)


def _poses(path: Path, body: Any, rows: list[_Row], ego: bool) -> Poses:
    time, x, y, heading, speed = np.array(sorted(rows)).T
    untold = np.isnan(speed)
    if untold.any() and len(time) > 1 and (np.diff(time) > 0.0).all():
        vx, vy = np.gradient(x, time), np.gradient(y, time)
        speed = np.where(untold, vx * np.cos(heading) + vy * np.sin(heading), speed)
    speed = np.nan_to_num(speed, nan=0.0)
    if not np.isfinite([time, x, y, heading, speed]).all() or (np.diff(time) <= 0.0).any():
        raise ScenarioError(
            f"{path}: the object {body.id.value} is twice at a time, or at a position that is not a number"
        )
    name, kind = _named(body)
    size = body.base.dimension
    return Poses(
        name=name,
        kind=kind,
        time=time,
        x=x,
        y=y,
        heading=heading,
        speed=speed,
        ego=ego,
        length=float(size.length) or None,
        width=float(size.width) or None,
    )


def _named(body: Any) -> tuple[str, str]:
    """What a body is called and what it is: as we wrote it, else its number and what the format says of it."""
    for source in body.source_reference:
        if source.type == OURS and len(source.identifier) == 3:
            name, _, kind = source.identifier
            return name, kind if kind in LIMITS or kind in PROPS else _kind(body)
    return str(body.id.value), _kind(body)


def _kind(body: Any) -> str:
    kind = body.DESCRIPTOR.name
    if kind != "MovingObject":
        return "object"
    told = body.DESCRIPTOR.enum_types_by_name["Type"].values_by_number[body.type].name
    if told != "TYPE_VEHICLE":
        return {"TYPE_PEDESTRIAN": "pedestrian", "TYPE_ANIMAL": "animal"}.get(told, "vehicle")
    classes = type(body.vehicle_classification).DESCRIPTOR.enum_types_by_name["Type"].values_by_number
    vehicle = classes[body.vehicle_classification.type].name.removeprefix("TYPE_")
    return next((one.row.scenic for one in AdversaryKind if one.row.osi == vehicle), "vehicle")
