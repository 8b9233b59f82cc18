"""Errors name the remedy: who lacks an extra is told the command that brings it, from where the package came."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from chatscene.errors import MissingExtra


@pytest.mark.parametrize(
    ("origin", "command"),
    [
        (
            {"url": "file:///home/me/my%20work/chatscene", "dir_info": {"editable": True}},
            'pip install -e "/home/me/my work/chatscene[gym]"',
        ),
        ({"url": "file:///home/me/chatscene", "dir_info": {}}, 'pip install "/home/me/chatscene[gym]"'),
        (
            {"url": "file:///tmp/dist/other-0.2.0-py3-none-any.whl", "archive_info": {}},
            'pip install "/tmp/dist/other-0.2.0-py3-none-any.whl[gym]"',
        ),
        (
            {"url": "https://example.org/other.git", "vcs_info": {"vcs": "git", "commit_id": "a"}},
            'pip install "other[gym] @ git+https://example.org/other.git"',
        ),
        (None, 'pip install "other[gym]"'),
    ],
)
def test_an_extra_comes_from_where_its_package_came(
    origin: dict[str, object] | None, command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    metadata = tmp_path / "other-0.2.0.dist-info"
    metadata.mkdir()
    (metadata / "METADATA").write_text("Metadata-Version: 2.1\nName: other\nVersion: 0.2.0\n")
    if origin:
        (metadata / "direct_url.json").write_text(json.dumps(origin))
    monkeypatch.syspath_prepend(tmp_path)
    assert str(MissingExtra("this", extra="gym", package="other")).endswith(f"install it with: {command}")


def test_what_was_never_installed_is_installed_from_its_checkout() -> None:
    told = str(MissingExtra("this", extra="gym", package="no-such-package"))
    assert told.endswith('pip install -e ".[gym]" in a checkout of no-such-package')
