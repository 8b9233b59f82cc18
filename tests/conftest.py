"""What holds for every test: none depends on the clock, and none on which modules another has loaded."""

import gc
import importlib
import pkgutil
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import chatscene
from chatscene.ego.policy import cut_off

# What takes longest: begun first, or one core of two waits at the end for the other. The others follow in any order.
LONG = [
    "test_pages",
    "test_docs",
    "runs/test_working_folder",
    "simulate/confined/test_sandbox",
    "report/test_sql",
    "models/language/test_language_models",
    "simulate/confined/test_red_team",
    "simulate/carla/test_lost_servers",
    "learn/test_finetune",
    "commands/test_end_to_end",
    "studies/test_evaluation",
    "grow/test_lint",
    "build/test_page",
    "report/test_report",
    "view/test_in_a_browser",
    "simulate/test_threads",
    "test_pipeline",
    "ego/test_ego_files",
    "simulate/native/test_native",
    "test_site",
    "studies/test_reproduce",
    "runs/test_rate",
    "verdict/test_verify",
    "imports/test_foreign_scenarios",
    "agents/test_protocol",
]

settings.register_profile("any machine", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("any machine")


def pytest_configure(config: pytest.Config) -> None:
    """Load everything, but where others run the tests.

    A module that is first loaded while a test has put something in the place of a function keeps that for good. So all
    are there before.
    """
    if config.getoption("numprocesses", None) and not hasattr(config, "workerinput"):
        return
    gc.disable()  # what is loaded stays: nothing is to be found in it
    for found in pkgutil.walk_packages(chatscene.__path__, "chatscene."):
        try:
            importlib.import_module(found.name)
        except ModuleNotFoundError:  # an extra that is not installed, or a module of Scenic's
            continue
    gc.collect()
    gc.freeze()
    gc.enable()
    gc.set_threshold(20_000, 20, 5)  # maps and libraries, which stay too, are looked through less often


@given(st.none())
def any_example(_: None) -> None:
    """Have Hypothesis register its sources of chance, for which it asks the collector who holds them."""


@pytest.hookimpl(trylast=True)
def pytest_sessionstart(session: pytest.Session) -> None:
    """Begin to look through once: what is left out is not seen by Hypothesis, which has registered all it will."""
    if session.config.getoption("numprocesses", None) and not hasattr(session.config, "workerinput"):
        return
    any_example()
    gc.callbacks.append(look_through_once)


def look_through_once(phase: str, collection: dict[str, Any]) -> None:
    """Leave out of later collections what a full one has left, which is maps, libraries and networks: they stay."""
    if phase == "stop" and collection["generation"] == 2:
        gc.freeze()


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Put the tests that take longest first, without another order among themselves."""
    order = {f"tests/{name}.py": place for place, name in enumerate(LONG)}
    items.sort(key=lambda item: order.get(item.nodeid.partition("::")[0], len(order)))


@pytest.fixture(autouse=True)
def told_of_nobody() -> None:
    """What is told once in a run is told in each test, whatever ran before it."""
    cut_off.clear()
