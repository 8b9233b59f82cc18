"""A map that may take long is read by another process, which ends with its time; what comes of it is the same."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from chatscene.errors import MapError
from chatscene.maps import apart, network
from chatscene.maps.furniture import furniture_of
from chatscene.maps.network import load_network

LANE = '<lane id="-1" type="driving" level="false"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane>'
SECTION = f'<laneSection s="0"><center><lane id="0" type="none"/></center><right>{LANE}</right></laneSection>'
LIGHT = '<signals><signal id="5" type="1000001" dynamic="yes" s="99" t="0" orientation="+"/></signals>'


def written(folder: Path, road: str = "", *, lane: str = LANE, lanes: str = "", pieces: int = 1) -> Path:
    line = "".join(
        f'<geometry s="{100 * n}" x="{100 * n}" y="0" hdg="0" length="100"><line/></geometry>' for n in range(pieces)
    )
    path = folder / "theirs.xodr"
    path.write_text(
        '<OpenDRIVE><header revMajor="1" revMinor="4"/>'
        f'<road name="" length="{100 * pieces}" id="7" junction="-1"><planView>{line}</planView>'
        f"<lanes>{lanes}{SECTION.replace(LANE, lane)}</lanes>{road}</road><!-- {folder} --></OpenDRIVE>"
    )
    return path


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path / "cache"


@pytest.fixture
def elsewhere(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(apart, "FEW_PARTS", 0)


def test_a_map_that_takes_longer_than_it_is_given_is_refused_by_its_road(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(apart, "START", 1)
    monkeypatch.setattr(apart, "PER_PART", 0)
    offsets = "".join(f'<laneOffset s="{n / 10}" a="0" b="0" c="0" d="0"/>' for n in range(20_000))
    path = written(tmp_path, lanes=offsets, pieces=100)  # 2,000 points, and at each all offsets are looked through
    with pytest.raises(MapError) as refused:
        load_network(path)
    said = str(refused.value)
    assert said.startswith("map 'theirs.xodr' cannot be made into lanes: that takes more than 1 s of the processor")
    assert "when it ended, it was at road '7'; cut the map down" in said


@pytest.mark.usefixtures("elsewhere")
def test_a_map_that_is_read_elsewhere_is_the_same_and_is_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    first = load_network(written(tmp_path, LIGHT))
    assert [lane.polygon.area for lane in first.lanes] == [pytest.approx(350)]
    assert furniture_of(first).lights == {(7, True): ("5",)}
    vars(network)["_parse"].cache_clear()
    monkeypatch.setattr(network, "read_apart", None)  # not once more
    assert [lane.uid for lane in load_network(written(tmp_path, LIGHT)).lanes] == [lane.uid for lane in first.lanes]


@pytest.mark.usefixtures("elsewhere")
def test_a_kept_network_that_is_damaged_is_made_anew(tmp_path: Path, cache: Path) -> None:
    load_network(written(tmp_path))
    (kept,) = cache.rglob("*.snet")
    whole = kept.read_bytes()
    kept.write_bytes(whole[: len(whole) // 2])
    vars(network)["_parse"].cache_clear()
    assert load_network(written(tmp_path)).lanes
    assert len(kept.read_bytes()) >= len(whole) - 64


@pytest.mark.usefixtures("elsewhere")
def test_a_map_is_read_elsewhere_where_nothing_can_be_kept(tmp_path: Path, cache: Path) -> None:
    cache.write_text("a file where the cache folder should be")
    assert load_network(written(tmp_path)).lanes


@pytest.mark.usefixtures("elsewhere")
def test_what_is_wrong_with_a_map_is_told_from_elsewhere_as_here(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = written(tmp_path, lane=LANE.replace("width", "height"))
    with pytest.raises(MapError, match="lane '-1' has no <width>") as there:
        load_network(path)
    monkeypatch.undo()
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    with pytest.raises(MapError) as here:
        load_network(path)
    assert str(there.value) == str(here.value)


@pytest.mark.usefixtures("elsewhere")
@pytest.mark.parametrize(
    ("script", "why"),
    [
        ("kill -9 $$", "the process for it was killed, perhaps for want of memory; when it ended, it had not begun"),
        (
            'echo \'{"at": "it was at road 8"}\'',
            "that takes more memory than this machine has; when it ended, it was at",
        ),
        ("echo something broke >&2; exit 3", "the process for it failed: something broke; when it ended"),
    ],
)
def test_a_process_that_ends_early_is_a_fault_of_the_map(
    script: str, why: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    program = tmp_path / "python"
    program.write_text(f"#!/bin/sh\n{script}\n")
    program.chmod(0o700)
    monkeypatch.setattr(sys, "executable", str(program))
    with pytest.raises(MapError) as refused:
        load_network(written(tmp_path))
    assert why in str(refused.value)


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux ends a process with the one that asked for it")
def test_a_reading_ends_with_whoever_asked_for_it(tmp_path: Path) -> None:
    offsets = "".join(f'<laneOffset s="{n / 10}" a="0" b="0" c="0" d="0"/>' for n in range(20_000))
    path = written(tmp_path, lanes=offsets, pieces=100)
    asks = (
        "import os, subprocess, sys, signal\n"
        "from chatscene.maps import apart\n"
        "with apart._running(*map(__import__('pathlib').Path, sys.argv[1:]), 60, subprocess.DEVNULL) as process:\n"
        "    process.stdout.readline()\n"  # it has begun
        "    print(process.pid, flush=True)\n"
        "    os.kill(os.getpid(), signal.SIGKILL)\n"
    )
    asking = [sys.executable, "-c", asks, str(path), str(tmp_path / "made")]
    reading = int(subprocess.run(asking, stdout=subprocess.PIPE, check=False).stdout)
    for _ in range(1000):
        if _state(reading) == "Z":
            break
        time.sleep(0.01)
    else:
        os.kill(reading, signal.SIGKILL)
        pytest.fail("it goes on by itself")


def _state(process: int) -> str:
    """What the kernel says of a process: Z if it has ended."""
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(") ")[2][0]
    except OSError:
        return "Z"
