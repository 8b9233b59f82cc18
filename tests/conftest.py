"""What holds for every test: none depends on the clock, and none on which modules another has loaded."""

import gc
import importlib
import pkgutil

import pytest
from hypothesis import HealthCheck, settings

import chatscene
from chatscene.ego.policy import cut_off

settings.register_profile("any machine", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("any machine")


def pytest_configure(config: pytest.Config) -> None:
    """Load everything, but where others run the tests.

    A module that is first loaded while a test has put something in the place of a function keeps that for good. So all
    are there before.
    """
    if config.getoption("numprocesses", None) and not hasattr(config, "workerinput"):
        return
    for found in pkgutil.walk_packages(chatscene.__path__, "chatscene."):
        try:
            importlib.import_module(found.name)
        except ModuleNotFoundError:  # an extra that is not installed, or a module of Scenic's
            continue
    gc.collect()
    gc.freeze()  # what is loaded stays
    gc.set_threshold(20_000, 20, 5)  # maps and libraries, which stay too, are looked through less often


@pytest.fixture(autouse=True)
def told_of_nobody() -> None:
    """What is told once in a run is told in each test, whatever ran before it."""
    cut_off.clear()
