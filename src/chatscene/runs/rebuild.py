"""What a run was made of, made again from its record: its map, its scenario, its program, who drove and where."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from chatscene.ego.policy import EgoPolicy, load_ego
from chatscene.errors import Diverged, MapError, RunError, SnippetError
from chatscene.files.bounded import is_there
from chatscene.maps.network import resolve_map
from chatscene.runs.blocks import read_ranges
from chatscene.runs.digests import digest_of
from chatscene.runs.explanation import read_choice
from chatscene.runs.record import MapRecord, Record, SourceRecord, settings_of
from chatscene.runs.workspace import Workspace, changed_versions, read_programs, read_record
from chatscene.search.climb import simulator_of
from chatscene.search.generator import load_generator
from chatscene.simulate.simulator import Simulator
from chatscene.terms.scenario import Scenario
from chatscene.terms.scene import ScenicProgram

AS_KEPT = "program"  # the generator of a program that is a stranger's
_COMPOSED = re.compile(r"^behavior/composed\.|\+")  # ids of snippets that earlier versions made of acts


def map_of(record: MapRecord | SourceRecord) -> Path:
    """The map that a run was made on, or that the scenes lie on that an evaluation has from it.

    Raises:
        MapError: There is none of that name.
        RunError: It is another file by now.
    """
    try:
        path = resolve_map(record.map_name)
    except MapError:
        path = Path(record.map_name.replace("\\", "/").rpartition("/")[2])  # the run came here with its map
        if not (record.map_digest and is_there(path)):
            raise
    if record.map_digest and digest_of(path) != record.map_digest:
        raise RunError(
            f"the map {record.map_name} is not the file that the run was made on (its SHA-256 differs); put that one "
            f"back{'' if isinstance(record, SourceRecord) else f', or {_remedy(record)}'}"
        )
    return path


@dataclass(frozen=True, slots=True, kw_only=True)
class Rebuilt:
    """What a run drove.

    Attributes:
        generator: Whose program it is now, which says whether it runs in the sandbox.
    """

    scenario: Scenario
    program: ScenicProgram
    generator: str


def rebuild(run: Workspace) -> Rebuilt:
    """The scenario and the program of a run, from what was understood and chosen then; the text is not read again.

    The program is joined again, of snippets of the library, and compared with the one that lies in the folder. That one
    is executed only where an earlier version composed one of its snippets, and then as any stranger's: in the sandbox.

    Raises:
        RunError: The run did not come that far, or what it tells was changed.
        Diverged: This version makes another program than the one that was kept.
    """
    record = read_record(run)
    generator = load_generator(record.generator)
    settings = settings_of(record).retrieval
    scenario, choice = read_choice(run)
    if record.situation is not None:
        scenario = generator.read(record.stated, settings)
    elif record.stated:
        scenario = replace(scenario, text=record.stated)
    kept = read_programs(run)
    ranges = {row["parameter"]: (row["low"], row["high"]) for row in read_ranges(run) if row["block"] == 0}
    if choice is not None and any(map(_COMPOSED.search, choice.snippet_ids)) and scenario.id in kept:
        as_kept = load_generator(AS_KEPT).write_again(replace(scenario, text=kept[scenario.id]), None, settings)
        program = replace(as_kept, scenario_id=scenario.id, own="")
        return Rebuilt(scenario=scenario, program=program, generator=AS_KEPT)
    try:
        program = generator.write_again(scenario, choice and replace(choice, ranges=ranges), settings)
    except SnippetError as error:
        raise Diverged(f"the library has changed since {run.path} was made: {error}; {_remedy(record)}") from error
    if kept.get(scenario.id) != program.source:
        raise Diverged(
            f"the library has changed since {run.path} was made: the same snippets now make another program; "
            f"{_remedy(record)}"
        )
    return Rebuilt(scenario=scenario, program=program, generator=record.generator)


@dataclass(frozen=True, slots=True, kw_only=True)
class Remade:
    """What drives the scenes of a run again."""

    program: ScenicProgram
    simulator: Simulator
    ego: EgoPolicy


def remade(run: Workspace) -> Remade:
    """What drives the scenes of a run again; what it names is loaded, so `chatscene.runs.trust.follow` comes first.

    Raises:
        ChatSceneError: As `rebuild`, or what it names cannot be loaded.
    """
    record = read_record(run)
    made = rebuild(run)
    simulator = simulator_of(load_generator(made.generator), map_of(record), settings_of(record))
    return Remade(program=made.program, simulator=simulator, ego=load_ego(record.ego))


def _remedy(record: Record) -> str:
    return f"install the version of chatscene that run.json names{since(changed_versions(record))}"


def since(versions: Mapping[str, tuple[str, str]]) -> str:
    """The versions that changed, to end a sentence with; empty if none did."""
    changed = ", ".join(f"{name} {then} then, {now} now" for name, (then, now) in versions.items())
    return f" ({changed})" if changed else ""
