"""Blocks are written as the run goes; the tables are folded from them at the end.

A block is two files: its tracks, and then its part, which says that the block is done. Each appears whole or
not at all, so that a kill at any moment loses at most the block in progress. Nobody waits for the disk before the
folder is finished: a power cut may damage the blocks of the last seconds, which their digests tell, and they are run
again.
"""

from __future__ import annotations

import shutil
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from itertools import chain, groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pyarrow as pa
from pydantic import ValidationError

from chatscene.errors import RunError
from chatscene.files.atomic import make_lasting
from chatscene.runs.atomic import json_of, read_bytes, sweep, writing
from chatscene.runs.digests import CHANGED, DRAWN, KEPT, MISSING, digest_of, digests, is_sealed, write_sealed
from chatscene.runs.record import MapRecord, Record, Status, first_problem
from chatscene.runs.rows import EventRow, Part, RangeRow, SceneRow, SignalRow
from chatscene.runs.tables import (
    EVENTS,
    RANGES,
    SCENES,
    SIGNALS,
    Among,
    Names,
    Table,
    copied,
    each_row,
    events_table,
    names_in,
    ranges_table,
    read_some,
    read_table,
    route_id,
    route_index,
    rows_by,
    rows_of,
    scan_table,
    scenes_table,
    signals_table,
    write_table,
    writing_table,
)
from chatscene.runs.tracks import EPISODES, episode_of, episodes_table, tracks_of
from chatscene.runs.workspace import Workspace, read_record, update
from chatscene.terms.criticality import Fault
from chatscene.terms.episode import Ending, Episode, EventKind, Role, Track
from chatscene.terms.outcome import Outcome
from chatscene.terms.scene import Rejected
from chatscene.terms.snippet import ParameterRange

if TYPE_CHECKING:
    from chatscene.measure.drive import Ran
    from chatscene.search.explore import Block

AT_ONCE = 5_000  # scenes that are folded at a time, which takes some 17 kB each
AHEAD = 64, 512  # drives that are read at a time, at first and at most; a block has several of them
ON_A_PAGE = 10_000  # scenes that are read for a page, beside those that were kept


@dataclass(frozen=True, slots=True, kw_only=True)
class Damaged:
    """A part of an unfinished run that does not count.

    Attributes:
        file: The one that is wrong: the part or its tracks.
    """

    part: Path
    file: Path
    why: str


def write_block(run: Workspace, block: Block) -> None:
    """Keep a finished block. Blocks may be written in any order and by any process.

    Raises:
        RunError: The file system refuses; the block then counts as not done.
    """
    where = (block.scenario_id, block.route, block.number)
    tracks = write_table(run.episodes(*where), episodes_table([ran.episode for ran in block.ran]))
    part = _part(block, tracks).model_dump(exclude={"digest"})
    write_sealed(run.part(*where), part, for_a_person=False, lasting=False)


def _part(block: Block, tracks: str) -> Part:
    return Part(
        scenario_id=block.scenario_id,
        route=block.route,
        block=block.number,
        ranges=[_range_row(r) for r in block.ranges],
        scenes=[*(_ran_row(ran) for ran in block.ran), *(_rejected_row(r) for r in block.rejected)],
        events=[row for ran in block.ran for row in _event_rows(ran.episode)],
        signals=[row for ran in block.ran for row in _signal_rows(ran.episode)],
        tracks=tracks,
    )


def _range_row(declared: ParameterRange) -> RangeRow:
    return RangeRow(
        parameter=declared.name,
        low=declared.low,
        high=declared.high,
        unit=declared.unit,
        meaning=declared.meaning,
    )


def _ran_row(ran: Ran) -> SceneRow:
    crash = ran.episode.collision
    return SceneRow(
        scene_id=ran.scene.id,
        seed=ran.scene.seed,
        values=dict(ran.scene.values),
        meaning_failures=list(ran.meaning),
        collision=crash is not None,
        impact_speed=crash.impact_speed if crash else None,
        ego=ran.episode.ego,
        ending=ran.episode.ending.value,
        route_completion=float(ran.episode.route_completion),
        dt=ran.episode.dt,
        **_plain(ran.episode.surroundings),
        metrics={name: float(value) for name, value in ran.metrics.items()},
        measurements=_plain(ran.measurements),
        criticality={
            name: value for name, value in _plain(ran.criticality).items() if name not in ("impact_speed", "severity")
        },
        speeds={name: value for name, value in _plain(ran.speeds).items() if not name.endswith("_kind")},
        ego_kind=ran.speeds.ego_kind,
        other_kind=ran.speeds.other_kind,
        severity=ran.criticality.severity,
        fault=ran.fault,
        avoidable=ran.avoidable,
        crash_type=ran.crash_type,
        happened=ran.happened.kind,
        happened_at=ran.happened.step * ran.episode.dt,
        gap_in_time=ran.happened.seconds,
        waits=ran.waits,
        cut=ran.cut,
        touch=ran.touch,
        stepped=ran.episode.stepped.by,
        instead=ran.episode.stepped.instead,
        unplayed=list(ran.unplayed),
    )


def _plain(noun: Any) -> dict[str, Any]:
    """A noun of numbers and words by its fields; `asdict` copies each of them."""
    return {name: getattr(noun, name) for name in noun.__slots__}


def _rejected_row(rejected: Rejected) -> SceneRow:
    scene = rejected.scene
    return SceneRow(scene_id=scene.id, seed=scene.seed, values=dict(scene.values), reason=rejected.reason)


def _event_rows(episode: Episode) -> list[EventRow]:
    return [
        EventRow(
            scene_id=episode.scene_id,
            ego=episode.ego,
            step=event.step,
            kind=event.kind.value,
            actor=episode.ego_track.actor,
            other=event.other,
            side=event.side,
            impact_speed=float(event.impact_speed),
            earlier=float(event.earlier),
        )
        for event in episode.events
    ]


def _signal_rows(episode: Episode) -> list[SignalRow]:
    return [
        SignalRow(
            scene_id=episode.scene_id,
            ego=episode.ego,
            role=signal.role,
            x0=signal.x0,
            y0=signal.y0,
            x1=signal.x1,
            y1=signal.y1,
            state=signal.state,
        )
        for signal in episode.signals
    ]


def read_parts(run: Workspace) -> list[Part]:
    """The blocks that are done and whole, by scenario, route and block; none once the run is finished."""
    parts = [found for found in _parts(run) if isinstance(found, Part)]
    return sorted(parts, key=lambda part: (part.scenario_id, part.route, part.block))


def damaged_parts(run: Workspace) -> list[Damaged]:
    """The parts of an unfinished run that do not count: they or their tracks are not as they were written."""
    return [found for found in _parts(run) if isinstance(found, Damaged)]


def _parts(run: Workspace) -> Iterator[Part | Damaged]:
    for path in sorted(run.file("parts").glob("*.json")):
        try:
            written = read_bytes(path)
            part = Part.model_validate(json_of(path, written))
        except (RunError, ValidationError) as error:
            why = str(error) if isinstance(error, RunError) else f"it is not a block: {first_problem(error)}"
            yield Damaged(part=path, file=path, why=why)
            continue
        tracks = run.episodes(part.scenario_id, part.route, part.block)
        if not is_sealed(written, part.digest):
            yield Damaged(part=path, file=path, why=CHANGED)
        elif not tracks.is_file():
            yield Damaged(part=path, file=tracks, why=MISSING)
        elif digest_of(tracks) != part.tracks:
            yield Damaged(part=path, file=tracks, why=CHANGED)
        else:
            yield part


def resume(
    run: Workspace, *, told: Callable[[str], None] = lambda _: None
) -> dict[tuple[str, int], list[list[Outcome]]]:
    """Make an unfinished run ready to go on, and say what is done.

    Half-written files of killed processes are removed, so are blocks that were damaged since, and the status is
    ``running`` again. If every block is done and folded, the status is ``done`` again, even if what came after failed,
    and the answer is empty: ask `read_record` for the status next.

    Returns:
        By scenario and route: for each block done, from block 0 without a gap, what came of its scenes, in order;
        what `chatscene.search.explore.explore` takes as ``done``.
    """
    sweep(run.path)
    record = read_record(run, Record)
    if record.status is Status.DONE or record.files:
        _drop_parts(run)
        update(run, status=Status.DONE)
        return {}
    update(run, status=Status.RUNNING)
    for found in damaged_parts(run):
        told(f"{found.file}: {found.why}; its block is run again")
        found.part.unlink()
    groups = groupby(read_parts(run), key=lambda part: (part.scenario_id, part.route))
    return {job: [_outcomes(p) for n, p in enumerate(parts) if p.block == n] for job, parts in groups}


def _outcomes(part: Part) -> list[Outcome]:
    return [
        Outcome(
            values=dict(scene.values),
            collided=bool(scene.collision),
            distance=scene.criticality["distance"],
            impact_speed=scene.impact_speed or 0.0,
            completion=scene.route_completion or 0.0,
            avoidable=scene.avoidable,
            by_ego=scene.fault is not None and Fault(scene.fault).by_ego,
            crash_type=scene.crash_type,
            waits=scene.waits,
            touch=scene.touch,
        )
        for scene in part.scenes
        if scene.reason is None
    ]


def finish(
    run: Workspace,
    *,
    selected: Mapping[str, bool] | Callable[[Iterable[Part]], Mapping[str, bool]],
    expected: Iterable[tuple[str, int, int]],
) -> Record:
    """Fold the blocks into the tables and set the status to ``done``. Safe to call again after a kill.

    Args:
        run: Which run.
        selected: The scenes kept, by id, or what chooses them of the blocks; True for a fill-in, which was kept
            although nothing collided.
        expected: Scenario, route and number of every block that there has to be.

    Raises:
        RunError: A block is missing, or the file system refuses; the blocks are still there then.
    """
    record = read_record(run, Record)
    if record.status is not Status.DONE and not record.files:
        kept = _Kept(run)
        _require(run, kept.there, list(expected))
        record = update(run, status=Status.DONE, **_fold(run, kept, selected))
    _drop_parts(run)
    return record


class _Kept:
    """The blocks of a run in order, read again each time that they are asked for, unless they are few.

    Attributes:
        there: Scenario, route and number of each.
        names: The parameters of their scenes, sorted; and the metrics, in the order in which they come.
    """

    def __init__(self, run: Workspace) -> None:
        self._run = run
        self._few: list[Part] | None = []
        names, scenes, told = list[Names](), 0, list[tuple[str, int, int]]()
        for part in _parts(run):
            if isinstance(part, Damaged):
                continue
            told.append((part.scenario_id, part.route, part.block))
            scenes += len(part.scenes)
            if (own := names_in([part])) not in names:
                names.append(own)
            if self._few is not None:
                self._few.append(part)
                self._few = self._few if scenes <= AT_ONCE else None
        self.there = sorted(told)
        if self._few is not None:
            self._few.sort(key=lambda part: (part.scenario_id, part.route, part.block))
            names = [names_in(self._few)]
        parameters, metrics = (dict.fromkeys(name for own in names for name in own[of]) for of in (0, 1))
        self.names: Names = sorted(parameters), list(metrics)

    def __iter__(self) -> Iterator[Part]:
        if self._few is not None:
            return iter(self._few)
        paths = (self._run.part(*place) for place in self.there)
        return (Part.model_validate(json_of(path, read_bytes(path))) for path in paths)

    def some(self) -> Iterator[list[Part]]:
        """They, so many at a time that they hold `AT_ONCE` scenes; at least once."""
        some, scenes, none = list[Part](), 0, True
        for part in self:
            some.append(part)
            scenes += len(part.scenes)
            if scenes >= AT_ONCE:
                yield some
                some, scenes, none = [], 0, False
        if some or none:
            yield some


def _fold(
    run: Workspace, kept: _Kept, selected: Mapping[str, bool] | Callable[[Iterable[Part]], Mapping[str, bool]]
) -> dict[str, Any]:
    """Write the tables, some blocks at a time; what the record says of them."""
    chosen = selected(kept) if callable(selected) else selected
    counts, stepped = Counter[str](), Counter[str]()
    instead, unplayed = dict[str, dict[str, None]](), dict[str, list[str]]()
    with ExitStack() as open_tables:
        tables = [open_tables.enter_context(writing_table(run.file(f"{name}.parquet"))) for name in _TABLES]
        for parts in kept.some():
            scenes = scenes_table(parts, chosen, kept.names)
            for table, rows in zip(
                tables, (events_table(parts), signals_table(parts), ranges_table(parts), scenes), strict=True
            ):
                table(rows)
            counts.update(_counts(scenes, parts))
            for scene in (scene for part in parts for scene in part.scenes):
                stepped.update([scene.stepped] if scene.stepped else [])
                if scene.stepped and scene.instead:
                    instead.setdefault(scene.instead, {})[scene.scene_id] = None
                for what in scene.unplayed:
                    unplayed.setdefault(what, []).append(scene.scene_id)
    files = digests(run.path, (*KEPT, *DRAWN))
    with writing(run.path):
        make_lasting(run.file(name) for name in files if name.endswith(".parquet"))
    return {
        "counts": dict(counts),
        "stepped": dict(sorted(stepped.items())),
        "instead": {why: list(scenes) for why, scenes in instead.items()},
        "unplayed": unplayed,
        "files": files,
    }


_TABLES = ("events", "signals", "ranges", "scenes")


def _require(run: Workspace, there: Sequence[tuple[str, int, int]], expected: Sequence[tuple[str, int, int]]) -> None:
    done = set(there)
    missing = [place for place in expected if place not in done]
    if missing:
        scenario_id, route, block = missing[0]
        raise RunError(
            f"{run.path} lacks {len(missing)} of its {len(expected)} blocks, the first of them block {block} of "
            f"{scenario_id}/{route_id(route)}: files were removed or damaged while the run went on; run what is "
            f"missing with: chatscene resume {run.path}"
        )


def _drop_parts(run: Workspace) -> None:
    folder = run.file("parts")
    if folder.is_dir():
        with writing(folder):
            shutil.rmtree(folder)


def _counts(scenes: Table, parts: Sequence[Part]) -> dict[str, int]:
    rows = rows_of(scenes.drop_columns(["meaning_failures"]))
    events = [{"scene_id": row.scene_id, "ego": row.ego, "kind": row.kind} for part in parts for row in part.events]
    waiting = sum(scene.waits for part in parts for scene in part.scenes)
    return counts_of(rows, events) | {"waiting": waiting}


def counts_of(scenes: Sequence[Mapping[str, Any]], events: Sequence[Mapping[str, Any]]) -> dict[str, int]:
    """What drives came to, in numbers: what every summary, page and script shows."""
    off_road = {(row["scene_id"], row["ego"]) for row in events if row["kind"] == EventKind.OFF_ROAD}
    return {
        "scenes": len(scenes),
        "ran": sum(row["status"] == "ran" for row in scenes),
        "rejected": sum(row["status"] == "rejected" for row in scenes),
        "collided": sum(row["collision"] is True for row in scenes),
        "off_road": sum((row["scene_id"], row["ego"]) in off_road for row in scenes),
        "timeout": sum(row["ending"] == Ending.TIMEOUT for row in scenes),
        "selected": sum(row["selected"] for row in scenes),
        "selected_shown": sum(row["selected"] and row["meaning_ok"] is True for row in scenes),
        "fill_in": sum(row["fill_in"] for row in scenes),
    }


def read_counts(run: Workspace) -> dict[str, int]:
    """What its drives came to so far; what an older folder did not count is counted from its tables.

    Those who wait behind somebody are counted only in the record, as no table of an older folder says it.
    """
    record = read_record(run, MapRecord)
    if "off_road" in record.counts:
        return record.counts
    return counts_of(read_scenes(run), read_events(run))


def read_scenes(
    run: Workspace, *, selected: bool = False, some: bool = False, ids: Iterable[str] | None = None
) -> list[dict[str, Any]]:
    """A row per scene with the columns of `scenes.parquet`; of an unfinished run, those done so far.

    Args:
        run: Which run.
        selected: Whether to read those alone that were kept.
        some: Whether to read, of a run with more than `ON_A_PAGE` scenes, those that were kept and at most as many of
            the others, evenly over the run.
        ids: Those to read, in the order of the table; all if None. It is given alone.
    """
    if some and (every := -(-read_record(run, MapRecord).counts.get("scenes", 0) // ON_A_PAGE)) > 1:
        return rows_of(read_some(run.file("scenes.parquet"), SCENES, every=every, always="selected"))
    among = ("selected", (True,)) if selected else _among(ids)
    return list(chain.from_iterable(_rows(run, "scenes.parquet", SCENES, scenes_table, among)))


def each_scene(run: Workspace, names: Sequence[str] = ()) -> Iterator[dict[str, Any]]:
    """A row per scene with some columns of `scenes.parquet`, read as they are asked for: there may be any number."""
    return chain.from_iterable(_rows(run, "scenes.parquet", SCENES, scenes_table, names=names))


def each_event(run: Workspace, names: Sequence[str] = ()) -> Iterator[dict[str, Any]]:
    """A row per event with some columns of `events.parquet`, read as they are asked for."""
    return chain.from_iterable(_rows(run, "events.parquet", EVENTS, events_table, names=names))


def read_events(run: Workspace, ids: Iterable[str] | None = None) -> list[dict[str, Any]]:
    """A row per event with the columns of `events.parquet`, of all scenes or of some."""
    return list(chain.from_iterable(_rows(run, "events.parquet", EVENTS, events_table, _among(ids))))


def read_signals(run: Workspace, ids: Iterable[str] | None = None) -> list[dict[str, Any]]:
    """A row per drive and traffic signal with the columns of `signals.parquet`, of all scenes or of some."""
    return list(chain.from_iterable(_rows(run, "signals.parquet", SIGNALS, signals_table, _among(ids))))


def read_ranges(run: Workspace) -> list[dict[str, Any]]:
    """A row per block and parameter with the columns of `ranges.parquet`."""
    return list(chain.from_iterable(_rows(run, "ranges.parquet", RANGES, ranges_table)))


def _among(ids: Iterable[str] | None) -> Among | None:
    return None if ids is None else ("scene_id", ids)


def _rows(
    run: Workspace,
    name: str,
    columns: Any,
    fold: Callable[[list[Part]], Table],
    among: Among | None = None,
    names: Sequence[str] = (),
) -> Iterator[Iterable[dict[str, Any]]]:
    """The rows of a table, part by part."""
    record = read_record(run, Record)
    if record.status is Status.DONE or record.files:
        for table in scan_table(run.file(name), columns, names=names, among=among):
            yield each_row(table)
    else:
        rows = rows_of(fold(read_parts(run)))
        wanted = among and frozenset(among[1])
        yield [row for row in rows if not among or (wanted and row[among[0]] in wanted)]


def read_episode(run: Workspace, scene_id: str) -> Episode:
    """The drive through one scene, exactly as it was simulated.

    Raises:
        RunError: The run has no scene of that id, or it was rejected and never driven.
    """
    return next(read_episodes(run, [scene_id]))


def read_episodes(run: Workspace, scene_ids: Iterable[str]) -> Iterator[Episode]:
    """The drives through some scenes, in the order asked for, some tens or hundreds read at a time."""
    scene_ids = list(scene_ids)
    scenes = {row["scene_id"]: row for row in read_scenes(run, ids=scene_ids)}
    events, signals = _by_scene(read_events(run, scene_ids)), _by_scene(read_signals(run, scene_ids))
    first, many = 0, AHEAD[0]
    while first < len(scene_ids):
        some = scene_ids[first : first + many]
        first, many = first + many, min(2 * many, AHEAD[1])
        tracks = _tracks(run, [scenes[scene_id] for scene_id in some if scene_id in scenes])
        for scene_id in some:
            scene = _driven(run, scene_id, scenes.get(scene_id))
            rows = tracks.get(scene_id, EPISODES.empty_table())
            try:
                episode = episode_of(rows, scene, events.get(scene_id, []), signals.get(scene_id, []))
            except (ValueError, IndexError) as error:
                raise RunError(
                    f"{_tracks_of(run, scene)} and the tables do not hold a drive of {scene_id!r} ({error}); they were "
                    "changed or damaged after they were written"
                ) from error
            yield episode


def _tracks(run: Workspace, scenes: Iterable[Mapping[str, Any]]) -> dict[str, Table]:
    """The rows of the drives through some scenes, by scene; each block is read once."""
    there = dict[Path, list[str]]()
    for scene in scenes:
        if scene["status"] == "ran":
            there.setdefault(_tracks_of(run, scene), []).append(scene["scene_id"])
    found = dict[str, Table]()
    for path, names in there.items():
        rows = pa.concat_tables(scan_table(path, EPISODES, among=("scene_id", names)))
        own = rows_by(rows, "scene_id")
        found |= own if len(there) == 1 else {name: copied(one) for name, one in own.items()}
    return found


def _tracks_of(run: Workspace, scene: Mapping[str, Any]) -> Path:
    return run.episodes(scene["scenario_id"], route_index(scene["route_id"]), scene["block"])


def read_adversaries(run: Workspace, scenario_id: str, route: int, block: int, scene_ids: Iterable[str]) -> list[Track]:
    """The track of the first adversary in each of some scenes of one block, in the order asked for."""
    rows = read_table(run.episodes(scenario_id, route, block), EPISODES, role=Role.ADVERSARY.value)
    tracks = dict(tracks_of(rows))
    return [tracks[scene_id] for scene_id in scene_ids if scene_id in tracks]


def done_blocks(run: Workspace) -> set[tuple[str, int, int]]:
    """Scenario, route and number of every part that is kept, of a run that is not finished."""
    return {(part.scenario_id, part.route, part.block) for part in read_parts(run)}


def drop_blocks(run: Workspace, block: int) -> None:
    """Forget every part of that number: an ego that failed leaves no half results."""
    for part in read_parts(run):
        if part.block == block:
            run.part(part.scenario_id, part.route, block).unlink(missing_ok=True)
            run.episodes(part.scenario_id, part.route, block).unlink(missing_ok=True)


def _driven(run: Workspace, scene_id: str, scene: dict[str, Any] | None) -> dict[str, Any]:
    if scene is None:
        raise RunError(f"{run.path} has no scene {scene_id!r}; scenes.parquet and report.html list them")
    if scene["status"] != "ran":
        raise RunError(f"scene {scene_id!r} was rejected and never driven: {scene['reason']}")
    return scene


def _by_scene(rows: list[dict[str, Any]]) -> dict[str, list[dict[str, Any]]]:
    grouped: dict[str, list[dict[str, Any]]] = {}
    for row in rows:
        grouped.setdefault(row["scene_id"], []).append(row)
    return grouped
