"""One stand-in for CARLA for all who do not spoil it, and a fresh world in it for each test."""

from __future__ import annotations

from collections.abc import Generator
from typing import Any

import pytest
from standing_in import connected, serving

from places import ROOT


@pytest.fixture(scope="session", autouse=True)
def processes_find_the_package() -> Generator[None]:
    with pytest.MonkeyPatch.context() as patched:
        patched.setenv("PYTHONPATH", str(ROOT / "packages" / "carla-stand-in" / "src"))
        yield


@pytest.fixture(scope="session")
def port() -> Generator[int]:
    with serving() as (port, _):
        yield port


@pytest.fixture
def client_and_world(port: int) -> tuple[Any, Any]:
    return connected(port)


@pytest.fixture
def world(client_and_world: tuple[Any, Any]) -> Any:
    return client_and_world[1]
