"""The record that a new folder begins with: what a user asks for by name, worked out.

Whatever is named is loaded here, so that what does not exist is told before there is a folder.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from chatscene.ego.asking import wanting
from chatscene.ego.observation import USUAL
from chatscene.ego.policy import FILES, load_ego, senses_of
from chatscene.errors import EditRefused, RunError, SettingsError
from chatscene.maps.left_hand import keeps_left
from chatscene.maps.network import map_with, name_of, resolve_map
from chatscene.runs.digests import digest_of
from chatscene.runs.record import (
    BenchmarkRecord,
    Driven,
    EvaluationRecord,
    ProgramRecord,
    ReportRecord,
    RunRecord,
    SimulatorRecord,
    SituationRecord,
    SourceRecord,
    settings_of,
)
from chatscene.search.climb import simulator_of
from chatscene.search.generator import Generator, load_generator
from chatscene.search.sampler import load_sampler
from chatscene.settings import EGO, Settings
from chatscene.simulate.simulator import load_simulator
from chatscene.situations.file import read_text
from chatscene.terms.conflict import Conflict
from chatscene.terms.scenario import Scenario
from chatscene.terms.scene import CAR, ScenicProgram


def asked_run(
    text: str | Conflict = "",
    *,
    program: ProgramRecord | None = None,
    situation: SituationRecord | None = None,
    settings: Settings | None = None,
    map_name: str | None = None,
    ego: str = EGO,
    generator: str = "chatscene",
    edits: Sequence[str] = (),
) -> RunRecord:
    """A run of a sentence and edits of it, of a program of the user's own, or of a situation that has its edits.

    If no map is named, it is on the packaged one with the site that is said. A conflict of a report is read as a
    sentence, and what is in no conflict of that report is kept beside it.

    Raises:
        ChatSceneError: Something that is named is not there, the sentence is none, or an edit was not understood.
    """
    settings = settings or Settings()
    report: dict[str, Any] = {}
    if isinstance(text, Conflict):
        told = ReportRecord(name=text.report, number=text.number, of=text.of, left_out=list(text.left_out))
        text, report = text.text, {"report": told}
    maker = load_generator(generator)
    load_sampler(settings.search.sampler)
    stated = situation.text if situation is not None else program.source if program is not None else str(text)
    if edits and situation is None:
        raise EditRefused("this run has no situation, and only situations can be edited; start again with the text")
    read = maker.read(stated, settings.retrieval)
    if situation is None and program is None:
        _check_keeps_right(map_name or map_with(read.slots.site))
    return RunRecord(
        text=text if situation is None else "",
        edits=list(edits),
        program=program,
        situation=situation,
        generator=generator,
        egos=[ego],
        **report,
        **_on_a_map(
            map_name or map_with(read.slots.site),
            [ego],
            settings,
            maker,
            _driven(situation, program),
            told_speed=situation is not None or _wants(program),
        ),
    )


def _driven(situation: SituationRecord | None, program: ProgramRecord | None) -> str:
    """The class of what the ego of a run drives."""
    if situation is not None:
        return read_text(situation.text).ego.body.row.scenic
    return CAR if program is None else _as_read(program).ego_kind


def _wants(program: ProgramRecord | None) -> bool:
    """Whether a program says what its ego drives at."""
    return program is not None and _as_read(program).wanted_speed is not None


def _as_read(program: ProgramRecord) -> ScenicProgram:
    return ScenicProgram(scenario_id="", source=program.source, parameters=(), snippet_ids=())


def scenario_of(record: RunRecord, generator: Generator) -> Scenario:
    """What a run's generator reads in its sentence; a program of the user's own goes by its name.

    Raises:
        RunError: It is of a version that edited what snippets had been chosen for.
    """
    reading = settings_of(record).retrieval
    if not record.stated:
        if record.edits:
            raise RunError(
                "this run was edited by an older version, so it can only be shown; start again with its text"
            )
        return generator.read(record.text, reading)
    read = generator.read(record.stated, reading)
    return replace(read, id=record.program.name) if record.program is not None else read


def asked_evaluation(
    sources: Sequence[SourceRecord],
    *,
    scenes: Driven,
    egos: Iterable[str],
    settings: Settings,
    speed: float | None = None,
    told_speeds: bool = False,
) -> EvaluationRecord:
    """An evaluation of egos on the scenes of runs.

    Args:
        sources: The runs, with their maps; at least one.
        scenes: Which of theirs.
        egos: Who drives.
        settings: How.
        speed: What they drive at [km/h] where none was said; None for what the programs have.
        told_speeds: Whether a program of theirs says what its ego drives at.

    Raises:
        ChatSceneError: Something that is named is not there.
    """
    named = list(egos)
    common = _on_a_map(sources[0].map_name, named, settings, told_speed=told_speeds or speed is not None)
    return EvaluationRecord(scenes=scenes, sources=list(sources), egos=named, speed=speed, **common)


def asked_benchmark(
    generator: str, budget: str, *, egos: Iterable[str], surrogate: str, settings: Settings, map_name: str
) -> BenchmarkRecord:
    """A benchmark of a generator, by the name of its budget.

    Raises:
        ChatSceneError: Something that is named is not there.
    """
    maker, named = load_generator(generator), list(egos)
    load_sampler(settings.search.sampler)
    _check_keeps_right(map_name)
    return BenchmarkRecord(
        generator=generator,
        budget=budget,
        egos=named,
        surrogate=surrogate,
        **_on_a_map(map_name, [surrogate, *named], settings, maker),
    )


def _check_keeps_right(map_name: str) -> None:
    """Refuse a map of left-hand traffic to those who make no situation of a text."""
    if keeps_left(resolve_map(map_name)):
        raise SettingsError(
            f"map {map_name!r} keeps to the left, and what is chosen for a text is of right-hand traffic; on this map "
            "drive texts of which situations are made (leave out --reader and --library), situations and programs"
        )


def _on_a_map(
    map_name: str,
    egos: list[str],
    settings: Settings,
    generator: Generator | None = None,
    kind: str = CAR,
    *,
    told_speed: bool = False,
) -> dict[str, Any]:
    """What drives and where; in the simulator that the generator has its programs run in, if there is one.

    An ego that is told a speed, whichever, may see another preset than by itself.
    """
    path = resolve_map(map_name)
    simulator = simulator_of(generator, path, settings) if generator else load_simulator(path, settings.simulation)
    return {
        "map_name": name_of(path),  # by which it is found from any folder
        "map_digest": digest_of(path),
        "senses": {
            ego: senses_of(
                wanting(load_ego(ego), USUAL if told_speed else None), kind, occlusion=settings.simulation.occlusion
            )
            for ego in egos
        },
        "ego_digests": ego_digests(egos),
        "simulator": SimulatorRecord.of(simulator.identity),
        "settings": asdict(settings),
    }


def ego_digests(egos: Iterable[str]) -> dict[str, str]:
    """The SHA-256 of each ego that is a file."""
    return {ego: digest_of(Path(ego)) for ego in egos if Path(ego).suffix in FILES}
