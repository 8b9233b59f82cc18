"""One stand-in for CARLA for all who do not spoil it, and a fresh world in it for each test."""

from __future__ import annotations

from collections.abc import Generator
from typing import Any

import pytest
from standing_in import connected, serving


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
