"""Classes whose code is kept between processes are those that Python makes."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = """
import dataclasses, sys
from dataclasses import dataclass, field, replace
sys.path.insert(0, sys.argv[1])
if sys.argv[2:]:
    from chatscene.files.class_code import keep_class_code
    keep_class_code()

@dataclass(frozen=True, slots=True, kw_only=True, order=True)
class One:
    a: int
    b: list[int] = field(default_factory=list)

@dataclass
class Two(One.__base__):
    a: float = 0.5

for name in sys.argv[3:]:
    dataclasses.make_dataclass(name, [(name.lower(), int)])

print(One(a=1), replace(One(a=1), a=2), One(a=1) < One(a=2), hash(One(a=1, b=())), Two(), Two() == Two(0.5))
"""
SOURCE = str(Path(__file__).parents[2] / "src")


def said(cache: Path, *more: str) -> str:
    command = [sys.executable, "-c", PROGRAM, SOURCE, *more]
    environment = {"XDG_CACHE_HOME": str(cache), "HOME": str(cache)}
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=True).stdout


def test_they_do_the_same_at_first_later_and_where_the_cache_is_damaged(tmp_path: Path) -> None:
    own = said(tmp_path)
    assert said(tmp_path, "kept") == own
    (path,) = (tmp_path / "chatscene" / "code").glob("classes-*")
    whole = path.read_bytes()
    assert said(tmp_path, "kept") == own
    assert path.read_bytes() == whole
    path.write_bytes(whole[:-9])
    assert said(tmp_path, "kept") == own
    assert path.read_bytes() == whole


def test_what_no_class_has_any_more_is_dropped_once_that_is_most(tmp_path: Path) -> None:
    said(tmp_path, "kept", *(f"Old{number}" for number in range(40)))
    (path,) = (tmp_path / "chatscene" / "code").glob("classes-*")
    large = path.stat().st_size
    said(tmp_path, "kept")
    assert path.stat().st_size == large  # nothing new is to be kept
    said(tmp_path, "kept", "New")
    assert path.stat().st_size < large / 4
    small = path.read_bytes()
    said(tmp_path, "kept", "Newer")
    assert b"newer" in path.read_bytes()
    assert len(path.read_bytes()) > len(small)


@pytest.mark.skipif(sys.platform != "linux", reason="the cache lies elsewhere")
def test_nothing_is_kept_where_others_can_write(tmp_path: Path) -> None:
    (folder := tmp_path / "chatscene" / "code").mkdir(parents=True)
    folder.chmod(0o777)
    assert said(tmp_path, "kept") == said(tmp_path)
    assert not [*folder.iterdir()]
