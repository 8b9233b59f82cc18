"""A folder for files of others, with the map that they name."""

from __future__ import annotations

from pathlib import Path

import pytest

from chatscene.maps.network import resolve_map


@pytest.fixture
def beside(tmp_path: Path) -> Path:
    """A folder with the town beside whatever is put there."""
    (tmp_path / "town.xodr").symlink_to(resolve_map("town"))
    return tmp_path
