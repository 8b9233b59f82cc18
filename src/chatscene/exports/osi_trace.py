"""ASAM Open Simulation Interface: what was driven as a trace of ground truth, a message per step, in an MCAP file.

Positions are the centres of bounding boxes on a flat ground at height 0. Velocity and acceleration are those of the
tracks, along the heading.
"""

from __future__ import annotations

import io
from collections.abc import Mapping
from typing import Any

import google.protobuf
import numpy as np
from google.protobuf.descriptor_pb2 import FileDescriptorSet
from mcap.well_known import MessageEncoding, SchemaEncoding
from mcap.writer import Writer
from osi3.osi_environment_pb2 import EnvironmentalConditions
from osi3.osi_groundtruth_pb2 import GroundTruth
from osi3.osi_object_pb2 import MovingObject, StationaryObject
from osi3.osi_version_pb2 import DESCRIPTOR as VERSIONED
from osi3.osi_version_pb2 import current_interface_version

from chatscene.exports.bodies import height_of, wheelbase_of
from chatscene.exports.exporter import KeptScene
from chatscene.terms.actors import BY_CLASS, AdversaryKind, Manner
from chatscene.terms.episode import Track
from chatscene.terms.surroundings import Light, Surroundings, Weather

PLUGIN = {
    "name": "osi",
    "makes": "OsiTrace",
    "needs": "osi",
    "what": "a ground-truth trace, as for sensor models",
    "per scene": "`_gt.mcap`, ASAM OSI 3.8",
    "also": "the map, `.xodr`",
}

# Nominal, as the hour and the intensity: drives know no lux and no mm/h.
_ILLUMINATION = {
    Light.DAY: (EnvironmentalConditions.AMBIENT_ILLUMINATION_LEVEL9, 12),
    Light.DUSK: (EnvironmentalConditions.AMBIENT_ILLUMINATION_LEVEL6, 18),
    Light.NIGHT: (EnvironmentalConditions.AMBIENT_ILLUMINATION_LEVEL4, 0),
}
_FALLS = (Weather.RAIN, Weather.SNOW)


class OsiTrace:
    """One ``_gt.mcap`` per scene, and the map."""

    def files(self, scene: KeptScene) -> Mapping[str, bytes]:
        """The trace of a scene, and the map that it names."""
        return {f"{scene.stem}_gt.mcap": _trace(scene), scene.map.name: scene.map.content}


def _trace(scene: KeptScene) -> bytes:
    extension: Any = current_interface_version
    version = VERSIONED.GetOptions().Extensions[extension]
    osi = f"{version.version_major}.{version.version_minor}.{version.version_patch}"
    protobuf = google.protobuf.__version__
    out = io.BytesIO()
    writer = Writer(out)
    writer.start()
    writer.add_metadata(
        "net.asam.osi.trace",
        {
            "version": osi,
            "min_osi_version": osi,
            "max_osi_version": osi,
            "min_protobuf_version": protobuf,
            "max_protobuf_version": protobuf,
            "description": f"{scene.episode.scene_id}: {scene.text}",
            "authors": "chatscene",
        },
    )
    schema = writer.register_schema("osi3.GroundTruth", SchemaEncoding.Protobuf, _schema())
    channel = writer.register_channel(
        "ground_truth",
        MessageEncoding.Protobuf,
        schema,
        {
            "net.asam.osi.trace.channel.osi_version": osi,
            "net.asam.osi.trace.channel.protobuf_version": protobuf,
            "net.asam.osi.trace.channel.description": "a message per step",
        },
    )
    written = [_Written(number, track, scene.episode.dt) for number, track in enumerate(scene.episode.tracks)]
    for step in range(len(scene.episode.ego_track.x)):
        now = round(step * scene.episode.dt * 1e9)  # [ns]
        message = GroundTruth()
        message.version.CopyFrom(version)
        message.timestamp.seconds, message.timestamp.nanos = divmod(now, 1_000_000_000)
        message.host_vehicle_id.value = 0  # the ego's track is the first
        message.map_reference = scene.map.name
        _surround(message.environmental_conditions, scene.episode.surroundings)
        for one in written:
            one.add_to(message, step)
        writer.add_message(channel, now, message.SerializeToString(deterministic=True), now, step)
    writer.finish()
    return out.getvalue()


def _schema() -> bytes:
    """The definition of the message, with those that it stands on before it."""
    files: dict[str, Any] = {}

    def collect(file: Any) -> None:
        for below in file.dependencies:
            collect(below)
        files.setdefault(file.name, file)

    collect(GroundTruth.DESCRIPTOR.file)
    found = FileDescriptorSet()
    for file in files.values():
        file.CopyToProto(found.file.add())
    return found.SerializeToString(deterministic=True)


def _surround(conditions: EnvironmentalConditions, surroundings: Surroundings) -> None:
    illumination, hour = _ILLUMINATION[surroundings.light]
    falls, fog = surroundings.weather in _FALLS, surroundings.weather in (Weather.FOG, Weather.DUST)
    conditions.ambient_illumination = illumination
    conditions.time_of_day.seconds_since_midnight = hour * 3600
    conditions.precipitation = (
        EnvironmentalConditions.PRECIPITATION_MODERATE if falls else EnvironmentalConditions.PRECIPITATION_NONE
    )
    conditions.fog = EnvironmentalConditions.FOG_DENSE if fog else EnvironmentalConditions.FOG_EXCELLENT_VISIBILITY


class _Written:
    """An actor, as every message has it."""

    def __init__(self, number: int, track: Track, dt: float) -> None:
        self._track, self._kind, self._number = track, BY_CLASS.get(track.kind), number
        self._height = height_of(track)
        self._acceleration, self._yaw_rate = track.acceleration(dt), track.yaw_rate(dt)

    def add_to(self, message: GroundTruth, step: int) -> None:
        """The actor at a step."""
        if self._kind is None or self._kind.lies:
            thing = message.stationary_object.add()
            thing.classification.type = StationaryObject.Classification.TYPE_OTHER
            self._place(thing, step)
            return
        mover = message.moving_object.add()
        self._place(mover, step)
        heading = float(self._track.heading[step])
        for vector, along in (
            (mover.base.velocity, float(self._track.speed[step])),
            (mover.base.acceleration, float(self._acceleration[step])),
        ):
            vector.x, vector.y, vector.z = along * float(np.cos(heading)), along * float(np.sin(heading)), 0.0
        mover.base.orientation_rate.yaw = float(self._yaw_rate[step])
        self._classify(mover, self._kind)

    def _place(self, thing: MovingObject | StationaryObject, step: int) -> None:
        track, base = self._track, thing.base
        thing.id.value = self._number
        base.dimension.length, base.dimension.width = track.length, track.width
        base.dimension.height = self._height
        base.position.x, base.position.y = float(track.x[step]), float(track.y[step])
        base.position.z = self._height / 2
        base.orientation.roll = base.orientation.pitch = 0.0
        base.orientation.yaw = float(np.remainder(track.heading[step] + np.pi, 2 * np.pi) - np.pi)
        source = thing.source_reference.add()
        source.type = "chatscene"
        source.identifier.extend([track.actor, track.role.value, track.kind])

    def _classify(self, mover: MovingObject, kind: AdversaryKind) -> None:
        if kind.row.osi:
            named, classification = MovingObject.VehicleClassification, mover.vehicle_classification
            mover.type = MovingObject.TYPE_VEHICLE
            classification.type = getattr(named, f"TYPE_{kind.row.osi}")
            classification.role = getattr(named, f"ROLE_{kind.row.role.upper() or 'CIVIL'}")
        elif kind.row.openscenario == "animal":
            mover.type = MovingObject.TYPE_ANIMAL
        else:
            mover.type = MovingObject.TYPE_PEDESTRIAN
        if kind.row.manner in (Manner.DRIVES, Manner.RIDES):
            axle, height = wheelbase_of(self._track) / 2, (kind.row.wheel - self._height) / 2
            attributes = mover.vehicle_attributes
            attributes.radius_wheel = kind.row.wheel / 2
            attributes.number_wheels = 2 if kind.row.manner is Manner.RIDES else 4
            for vector, along in ((attributes.bbcenter_to_rear, -axle), (attributes.bbcenter_to_front, axle)):
                vector.x, vector.y, vector.z = along, 0.0, height
