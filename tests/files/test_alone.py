"""A folder that one process at a time writes to."""

from __future__ import annotations

from pathlib import Path

import pytest

from chatscene.errors import RunError, SettingsError
from chatscene.files.alone import UNFINISHED, alone_in


def test_nobody_else_writes_to_a_folder_meanwhile(tmp_path: Path) -> None:
    with (
        alone_in(tmp_path / "new"),
        pytest.raises(SettingsError, match="something else writes to"),
        alone_in(tmp_path / "new"),
    ):
        pass
    assert not list((tmp_path / "new").iterdir())


def test_a_folder_in_which_nothing_was_written_is_taken_away_if_the_work_fails(tmp_path: Path) -> None:
    with pytest.raises(RunError), alone_in(tmp_path / "new"):
        raise RunError("it fails")
    assert not (tmp_path / "new").exists()


def test_a_folder_whose_work_was_interrupted_shows_it(tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt), alone_in(tmp_path / "new"):
        raise KeyboardInterrupt
    assert (tmp_path / "new" / UNFINISHED).exists()
