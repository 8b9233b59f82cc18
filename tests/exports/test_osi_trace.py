"""What leaves as an OSI trace is what was driven, a message per step."""

from __future__ import annotations

import io
import math
from typing import Any

import numpy as np
import pytest

from chatscene.terms.actors import AdversaryKind
from chatscene.testing.exporters import awkward_scenes

missing = "the extra 'osi' is not installed"
groundtruth = pytest.importorskip("osi3.osi_groundtruth_pb2", reason=missing)
reading = pytest.importorskip("mcap.reader", reason=missing)

LONG = awkward_scenes()[-1]


@pytest.fixture(scope="module")
def trace() -> Any:
    from chatscene.exports.osi_trace import OsiTrace

    return reading.make_reader(io.BytesIO(OsiTrace().files(LONG)[f"{LONG.stem}_gt.mcap"]))


@pytest.fixture(scope="module")
def messages(trace: Any) -> list[Any]:
    return [groundtruth.GroundTruth.FromString(message.data) for _, _, message in trace.iter_messages()]


def test_every_step_has_a_message_at_its_time(trace: Any, messages: list[Any]) -> None:
    times = [message.log_time for _, _, message in trace.iter_messages()]
    assert times == [round(step * 1e8) for step in range(40)]
    assert [m.timestamp.seconds * 1_000_000_000 + m.timestamp.nanos for m in messages] == times


def test_everybody_is_where_the_track_is_and_as_fast(messages: list[Any]) -> None:
    for step, message in enumerate(messages):
        things = {
            thing.source_reference[0].identifier[0]: thing
            for thing in (*message.moving_object, *message.stationary_object)
        }
        assert len(things) == len(LONG.episode.tracks)
        for track in LONG.episode.tracks:
            base = things[track.actor].base
            assert (base.position.x, base.position.y) == (track.x[step], track.y[step])
            assert (base.dimension.length, base.dimension.width) == (track.length, track.width)
            assert math.isclose(math.cos(base.orientation.yaw - track.heading[step]), 1.0)
            assert abs(base.orientation.yaw) <= math.pi
            assert things[track.actor].source_reference[0].identifier[2] == track.kind
        for mover in message.moving_object:
            track = LONG.episode.tracks[mover.id.value]
            velocity = mover.base.velocity
            along = velocity.x * np.cos(track.heading[step]) + velocity.y * np.sin(track.heading[step])
            assert along == pytest.approx(track.speed[step])


def test_the_host_vehicle_is_the_ego(messages: list[Any]) -> None:
    for message in messages:
        (host,) = (one for one in message.moving_object if one.id.value == message.host_vehicle_id.value)
        assert list(host.source_reference[0].identifier) == ["ego", "ego", "Car"]


def test_the_file_says_what_the_standard_asks_a_trace_to_say(trace: Any) -> None:
    ((name, told),) = ((record.name, record.metadata) for record in trace.iter_metadata())
    assert name == "net.asam.osi.trace"
    versions = {"version", *(f"{end}_{of}_version" for end in ("min", "max") for of in ("osi", "protobuf"))}
    assert versions <= told.keys()
    ((schema, channel, _), *_) = trace.iter_messages()
    assert (schema.name, schema.encoding) == ("osi3.GroundTruth", "protobuf")
    assert "net.asam.osi.trace.channel.osi_version" in channel.metadata


def test_every_kind_that_moves_has_a_type(messages: list[Any]) -> None:
    moving = messages[0].moving_object
    assert len(moving) == 1 + sum(not kind.lies for kind in AdversaryKind)
    assert all(one.type > 1 for one in moving)
    vehicles = [one for one in moving if one.HasField("vehicle_classification")]
    assert all(one.vehicle_classification.type > 1 for one in vehicles)
    assert [one.base.dimension.height / 2 for one in moving] == [one.base.position.z for one in moving]
