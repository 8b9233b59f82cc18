"""What the learned reader's file unpacks to is kept between processes, and damage to it does no harm."""

from __future__ import annotations

from pathlib import Path

import pytest

from chatscene.files.caches import cache_folder
from chatscene.read.learned import weights
from chatscene.read.learned.weights import Weights, load


@pytest.fixture(autouse=True)
def _own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))


def _read() -> Weights:
    return load.__wrapped__(weights.PACKAGED)  # as a process that has read nothing


def _told(read: Weights) -> tuple[object, ...]:
    return read.changes, read.text, read.following, read.tokens, read.places, read.trust, read.trust_in_parts


def test_it_is_unpacked_once(monkeypatch: pytest.MonkeyPatch) -> None:
    first = _read()
    assert len(list(cache_folder("weights").iterdir())) == 1

    def unpack() -> None:
        pytest.fail("it is unpacked again")

    monkeypatch.setattr(weights.zlib, "decompressobj", unpack)
    assert _told(_read()) == _told(first) == _told(load())


def test_what_another_version_unpacked_is_not_taken(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    first = _read()
    (other := tmp_path / "weights.py").write_text("# of another version")
    monkeypatch.setattr(weights, "__file__", str(other))
    assert _told(_read()) == _told(first)
    assert len(list(cache_folder("weights").iterdir())) == 2


def test_what_is_damaged_is_unpacked_anew() -> None:
    first = _read()
    (kept,) = cache_folder("weights").iterdir()
    whole = kept.read_bytes()
    for harmed in (b"", whole[: len(whole) // 2], whole[:-1] + bytes([whole[-1] ^ 1])):
        kept.write_bytes(harmed)
        assert _told(_read()) == _told(first)
        assert kept.read_bytes() == whole
