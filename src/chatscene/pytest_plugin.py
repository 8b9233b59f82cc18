"""pytest runs scenes as tests; see `chatscene.testing.scenes.scene` for how one is written.

This is the one module that imports pytest, which loads it by an entry point. Nothing else is imported before a test
is met that has scenes, so that other tests do not pay for it; ``-p no:chatscene`` switches it off.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Generator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from chatscene.errors import EgoError
    from chatscene.testing.scenes import Driven, Found, Marked

_ASKED = "__chatscene__"  # as `chatscene.testing.scenes.ASKED`, which costs more to load
_NUMBER, _DRIVEN = "chatscene_number", "chatscene_driven"


def _marked(function: Any) -> Marked | None:
    return getattr(function, _ASKED, None)


def pytest_addoption(parser: pytest.Parser) -> None:
    """Where drives that fail are shown."""
    group = parser.getgroup("chatscene", "scenes as tests")
    group.addoption("--scene-replays", metavar="DIR", help="write a GIF of each drive that fails into this folder")


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """A test for each scene, numbered: the scenes are looked for when the first of them runs."""
    if (marked := _marked(metafunc.function)) is not None:
        numbers = range(marked.asked.scenes)
        metafunc.fixturenames.append(_NUMBER)
        metafunc.parametrize(_NUMBER, numbers, ids=[f"scene-{number}" for number in numbers])


@pytest.hookimpl(tryfirst=True)  # before pytest-xdist looks for groups
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Every test with scenes is driven, also where its function does not ask for what came of it."""
    for item in items:
        if isinstance(item, pytest.Function) and (marked := _marked(item.function)) is not None:
            item.fixturenames.append(_DRIVEN)
            if config.pluginmanager.hasplugin("xdist"):
                item.add_marker(pytest.mark.xdist_group(str(marked.asked.of)))


@pytest.fixture
def scene(request: pytest.FixtureRequest) -> Driven:
    """What the ego did in the scene and in its twin: a `chatscene.testing.scenes.Driven`."""
    if _marked(request.function) is None:
        pytest.fail("the fixture `scene` is for tests that are marked with @chatscene.scene(…)", pytrace=False)
    return request.getfixturevalue(_DRIVEN)


@pytest.fixture(name=_DRIVEN)
def _driven(request: pytest.FixtureRequest) -> Driven | EgoError:
    """A drive in the scene and in its twin, or how the ego failed, which is no error of set-up."""
    from chatscene.errors import EgoError
    from chatscene.testing.egos import ego_of
    from chatscene.testing.scenes import gif_of, judge

    marked, number = _marked(request.function), request.getfixturevalue(_NUMBER)
    assert marked is not None
    told = request.node.user_properties
    told.append(("sentence", str(marked.asked.of)))
    found, ego = _found(marked), marked.ego
    told[:] = [("sentence", found.text)]
    if not found.scenes:
        pytest.fail(f"nothing is tested: {found.why_fewer()}", pytrace=False)
    if number >= len(found.scenes):
        pytest.skip(found.why_fewer())
    one = found.scenes[number]
    told += [("scene", one.scene.id), ("seed", one.scene.seed)]
    if ego is None:
        ego = request.getfixturevalue("ego")
    try:
        driven = judge(found, one, ego_of(ego), must=marked.must)
    except EgoError as error:
        return error
    told[:] = driven.properties.items()
    if driven.failures and (folder := request.config.getoption("--scene-replays")):
        path = Path(folder) / f"{request.node.path.stem}-{request.node.name.partition('@')[0]}.gif"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(gif_of(found, driven))
        told.append(("replay", str(path)))
    return driven


def _found(marked: Marked) -> Found:
    from chatscene.errors import ChatSceneError
    from chatscene.testing.scenes import find

    try:
        return find(marked.asked)
    except ChatSceneError as error:
        why = f"there are no scenes of {str(marked.asked.of)!r}: {error}"
    pytest.fail(why, pytrace=False)


@pytest.hookimpl(wrapper=True)
def pytest_pyfunc_call(pyfuncitem: pytest.Function) -> Generator[None, object, object]:
    """The verdict comes before the body."""
    if _marked(pyfuncitem.function) is not None:
        driven: Any = pyfuncitem.funcargs[_DRIVEN]
        if isinstance(driven, Exception):
            raise driven
        if driven.failures:
            again = f"  again     pytest '{pyfuncitem.nodeid.partition(']')[0]}]'"
            shown = [f"  replay    {path}" for name, path in pyfuncitem.user_properties if name == "replay"]
            pytest.fail("\n".join((driven.in_words(), again, *shown)), pytrace=False)
    return (yield)


def pytest_terminal_summary(terminalreporter: Any) -> None:
    """A line per sentence: what became of its scenes, and the worst impact."""
    became: dict[str, Counter[str]] = {}
    worst: dict[str, float] = {}
    for outcome in ("passed", "failed", "error", "skipped"):
        for report in terminalreporter.stats.get(outcome, ()):
            told = dict(getattr(report, "user_properties", ()))  # a file that cannot be collected has none
            if (text := told.get("sentence")) is not None and report.when != "teardown":
                became.setdefault(text, Counter())[outcome] += 1
                worst[text] = max(worst.get(text, 0.0), float(told.get("impact_speed", 0.0)))
    if not became:
        return
    from chatscene.report.terminal import visible

    terminalreporter.section("scenes")
    for text, counts in became.items():
        fastest = f"; worst impact {worst[text]:.1f} m/s" if worst[text] else ""
        said = ", ".join(f"{count} {outcome}" for outcome, count in counts.items())
        terminalreporter.write_line(f"{said}{fastest}: {visible(text)}")
