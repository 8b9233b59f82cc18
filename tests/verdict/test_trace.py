"""A trace of OSI is judged as a table of tracks is, and what is none is refused with one error."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from chatscene.errors import ScenarioError
from chatscene.settings import VerifySettings
from chatscene.terms.actors import LIMITS, PROPS
from chatscene.testing.exporters import awkward_scenes

missing = "the extra 'osi' is not installed"
pytest.importorskip("osi3.osi_groundtruth_pb2", reason=missing)
pytest.importorskip("mcap.reader", reason=missing)

LONG = awkward_scenes()[-1]


@pytest.fixture(scope="module")
def trace(tmp_path_factory: pytest.TempPathFactory) -> Path:
    from chatscene.exports.osi_trace import OsiTrace

    path = tmp_path_factory.mktemp("traces") / "drive.mcap"
    path.write_bytes(OsiTrace().files(LONG)[f"{LONG.stem}_gt.mcap"])
    return path


def test_what_was_written_is_read(trace: Path) -> None:
    from chatscene.imports.osi_trace import read_trace

    read = {one.name: one for one in read_trace(trace)}
    assert read.keys() == {track.actor for track in LONG.episode.tracks}
    assert [one.name for one in read.values() if one.ego] == ["ego"]
    for track in LONG.episode.tracks:
        one = read[track.actor]
        known = track.kind in LIMITS or track.kind in PROPS
        assert (one.kind, one.length, one.width) == (track.kind if known else "object", track.length, track.width)
        np.testing.assert_array_equal(one.x, track.x)
        np.testing.assert_array_equal(one.y, track.y)
        np.testing.assert_allclose(np.cos(one.heading - track.heading), 1.0)


def test_a_trace_is_watched_as_one_drive_without_a_map(trace: Path) -> None:
    from chatscene.verdict.sources import watching

    found = watching(trace, VerifySettings())
    assert found.kind == "trace of OSI"
    (drive,) = found.drives
    assert not drive.mapped
    assert {t.actor for t in drive.episode.tracks} == {track.actor for track in LONG.episode.tracks}


def test_what_is_no_trace_is_told(tmp_path: Path, trace: Path) -> None:
    from chatscene.imports.osi_trace import read_trace

    for content in (b"", b"no trace at all", trace.read_bytes()[:200]):
        wrong = tmp_path / "wrong.mcap"
        wrong.write_bytes(content)
        with pytest.raises(ScenarioError, match=r"wrong\.mcap"):
            read_trace(wrong)
