"""What a recording leaves open: missing rows, speeds and an ego that are not told, what is between two rows."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from chatscene.errors import ScenarioError, SettingsError
from chatscene.imports.recording import Poses, recording
from chatscene.settings import VerifySettings
from chatscene.terms.arrays import Array
from chatscene.terms.episode import Ending
from chatscene.testing.exporters import awkward_scenes
from chatscene.verdict.recorded import watch_recording
from chatscene.verdict.sources import watching


def poses(name: str, *rows: tuple[float, float, float, float, float], **more: Any) -> Poses:
    """One road user by time, x, y, heading and speed."""
    time, x, y, heading, speed = np.array(rows).T
    return Poses(name=name, kind="car", time=time, x=x, y=y, heading=heading, speed=speed, **more)


def steadily(name: str, times: Array, at: float = 0.0, speed: float = 10.0, **more: Any) -> Poses:
    return poses(name, *((float(t), at + speed * float(t), 0.0, 0.0, speed) for t in times), **more)


EVERY = np.arange(101) * 0.1


def test_who_is_not_there_for_some_seconds_is_nowhere_meanwhile() -> None:
    there = np.concatenate((EVERY[:11], EVERY[90:]))
    other = steadily("a", there, 100.0, 0.0)
    found = recording((steadily("ego", EVERY, ego=True), other), "theirs.csv")
    missing = np.isnan(found.tracks[1].x)
    assert not missing[:11].any()
    assert missing[11:90].all()
    assert not missing[90:].any()


@pytest.mark.parametrize("step", [1, 5, 10])
def test_who_is_there_at_each_of_few_rows_is_there_between_them(step: int) -> None:
    found = recording((steadily("ego", EVERY, ego=True), steadily("a", EVERY[::step], 100.0)), "theirs.csv")
    assert np.isfinite(found.tracks[1].x).all()


def test_who_is_told_by_a_few_turning_points_is_there_between_them() -> None:
    points = steadily("a", np.array([0.0, 1.5, 1.6, 10.0]), 100.0)
    found = recording((steadily("ego", EVERY, ego=True), points), "theirs.csv")
    assert np.isfinite(found.tracks[1].x).all()


def test_an_ego_that_is_not_there_for_some_seconds_is_refused() -> None:
    with pytest.raises(ScenarioError, match=r"the ego, ego, is not there from 1 to 9 s; cut the drive there"):
        recording((steadily("ego", np.concatenate((EVERY[:11], EVERY[90:])), ego=True),), "theirs.csv")


def test_who_grazes_the_ego_between_two_rows_touches_it() -> None:
    ego = poses("ego", *((0.1 * i, 0.0, 0.0, 0.0, 0.0) for i in range(21)), ego=True, length=4.0, width=2.0)
    by = poses("a", *((0.1 * i, -38.25 + 4.5 * i, 1.4, 0.0, 45.0) for i in range(21)), length=0.4, width=0.9)
    touched = watch_recording(recording((ego, by), "theirs.csv"), "theirs").episode
    assert touched.ending is Ending.COLLISION
    wide = poses("a", *((0.1 * i, -38.25 + 4.5 * i, 1.5, 0.0, 45.0) for i in range(21)), length=0.4, width=0.9)
    assert watch_recording(recording((ego, wide), "theirs.csv"), "theirs").episode.ending is Ending.TIMEOUT


def test_a_folder_that_is_called_as_a_recording_is_told_to_be_one(tmp_path: Path) -> None:
    (tmp_path / "theirs.csv").mkdir()
    with pytest.raises(SettingsError, match=r"is a folder; give a file that ends in \.csv"):
        watching(tmp_path / "theirs.csv", VerifySettings())


def changed(folder: Path, change: Callable[[Any], None]) -> Path:
    """A trace of OSI of ours, each of its messages changed."""
    pytest.importorskip("osi3.osi_groundtruth_pb2", reason="the extra 'osi' is not installed")
    pytest.importorskip("mcap.reader", reason="the extra 'osi' is not installed")
    from mcap.reader import make_reader
    from mcap.writer import Writer
    from osi3.osi_groundtruth_pb2 import GroundTruth

    from chatscene.exports.osi_trace import OsiTrace

    scene = awkward_scenes()[-1]
    (folder / "ours.mcap").write_bytes(OsiTrace().files(scene)[f"{scene.stem}_gt.mcap"])
    with (folder / "ours.mcap").open("rb") as ours, (folder / "theirs.mcap").open("wb") as theirs:
        writer = Writer(theirs)
        writer.start()
        schema = writer.register_schema("osi3.GroundTruth", "protobuf", b"")
        channel = writer.register_channel("ground_truth", "protobuf", schema)
        for _, _, message in make_reader(ours).iter_messages():
            truth = GroundTruth.FromString(message.data)
            change(truth)
            writer.add_message(channel, message.log_time, truth.SerializeToString(), message.publish_time)
        writer.finish()
    return folder / "theirs.mcap"


def test_speeds_that_a_trace_does_not_tell_are_those_of_its_places(tmp_path: Path) -> None:
    from chatscene.imports.osi_trace import read_trace

    def without(truth: Any) -> None:
        for one in truth.moving_object:
            one.base.ClearField("velocity")

    (ego,) = [one for one in read_trace(changed(tmp_path, without)) if one.ego]
    gone = math.dist((ego.x[0], ego.y[0]), (ego.x[-1], ego.y[-1]))
    assert gone > 1.0
    assert float(np.abs(ego.speed).max()) > 0.5 * gone / (ego.time[-1] - ego.time[0])


def test_a_trace_that_names_no_host_has_no_ego(tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match=r"marks 0 road users as the ego.*--ego-id"):
        watching(changed(tmp_path, lambda truth: truth.ClearField("host_vehicle_id")), VerifySettings())
