"""What `run.json` says of each kind of folder, and what one finished block leaves until the tables are written."""

from __future__ import annotations

import os
from collections.abc import Mapping
from enum import StrEnum
from pathlib import Path
from typing import Annotated, Any, ClassVar, TypeVar

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, ValidationError, ValidationInfo, field_validator

from chatscene.errors import SettingsError
from chatscene.settings import READ_AS, RetrievalSettings, SearchSettings, Settings, SimulationSettings
from chatscene.terms.edit import with_edits
from chatscene.terms.nouns import with_article
from chatscene.terms.simulator import SimulatorIdentity

MOST_TEXT = 20_000  # characters of a record's sentence; what reads one takes a tenth of that
SCHEMA_VERSION = 3


def _short(text: str) -> str:
    """A text, if it is not too long; by hand, as pydantic's own check refuses what is not a character."""
    if len(text) > MOST_TEXT:
        raise ValueError(f"it has {len(text):,} characters, and at most {MOST_TEXT:,} are read")
    return text


class Kind(StrEnum):
    """What a folder holds."""

    RUN = "run"
    EVALUATION = "evaluation"
    COMPARISON = "comparison"
    BENCHMARK = "benchmark"
    REPRODUCTION = "reproduction"
    FINETUNING = "finetuning"
    TRAINING = "training"

    def in_words(self) -> str:
        """With its article."""
        if self is Kind.COMPARISON:
            return "an evaluation of an imported folder"
        return with_article(self.value)


class Status(StrEnum):
    """How far the work came."""

    RUNNING = "running"  # or killed: a dead process cannot say so, see `chatscene.runs.workspace.standing`
    DONE = "done"
    FAILED = "failed"  # an error ended it; may be continued
    REFUSED = "refused"  # no program shows what was read in the sentence


STOPPED = "stopped"
"""What stands for `Status.RUNNING` where it is told of a folder that no process works on; no record has it."""


class Driven(StrEnum):
    """Which scenes of a run an evaluation drives."""

    KEPT = "kept"
    EVERY = "every"  # that ran


class _Frozen(BaseModel):
    model_config = ConfigDict(frozen=True, extra="ignore")


class ProgramRecord(_Frozen):
    """A program of the user's own."""

    name: str
    source: str


class SituationRecord(_Frozen):
    """A situation that was stated.

    Attributes:
        text: All of it, in YAML, with the map that it is built on.
        read_by: Who read it in the text by which it is called; empty if it was stated.
    """

    name: str
    text: str
    read_by: str = ""


class ReportRecord(_Frozen):
    """The report that a text was found in; see `chatscene.terms.conflict.Conflict`."""

    name: str
    number: int
    of: int
    left_out: list[str]


class SourceRecord(_Frozen):
    """A run whose scenes an evaluation drives.

    Attributes:
        folder: Its folder as seen from the evaluation's, so that both can be moved together; an absolute path in
            records of before.
        first_route: Scenes on earlier routes are left out.
        kept_for: The ego against which its scenes were selected; empty where every scene is driven.
        map_name: The map that its scenes lie on; in records of before that of the evaluation.
        map_digest: SHA-256 of the file of that map.
    """

    folder: str
    scenario_id: str
    base: str
    generator: str
    first_route: int = 0
    kept_for: str = ""
    map_name: str = ""
    map_digest: str = ""

    def path_from(self, evaluation: Path) -> Path:
        """Where the run is, for an evaluation in a folder; an absolute `folder` is that, wherever the evaluation is."""
        return path_from(evaluation, self.folder)


def seen_from(evaluation: Path, folder: Path) -> str:
    """What an evaluation calls a folder that it drives; either path may lead through symbolic links."""
    return os.path.relpath(folder.resolve(), evaluation.resolve())


def path_from(evaluation: Path, called: str) -> Path:
    """The folder that an evaluation calls so."""
    return Path(os.path.normpath(evaluation.resolve() / called))


class SimulatorRecord(_Frozen):
    """What ran the scenes; see `chatscene.terms.simulator.SimulatorIdentity`.

    Attributes:
        name: Its name in the table of simulators.
        version: Version of what its numbers depend on; empty in the records of older versions.
        physics: How it moves bodies, in a few words; empty in the records of older versions.
    """

    name: str = SimulationSettings().simulator
    version: str = ""
    physics: str = ""

    @classmethod
    def of(cls, identity: SimulatorIdentity) -> SimulatorRecord:
        """What a simulator says it is."""
        return cls(name=identity.name, version=identity.version, physics=identity.physics)


class Record(_Frozen):
    """What `run.json` says of any folder; there is a class for each kind, with what that kind has besides.

    A field without a default is what was asked for, and whoever goes on in the folder must ask for the same again; a
    field with one says what has become of it, or may be another the next time.

    Attributes:
        timings: Seconds by phase, and whatever else differs between two equal runs.
        files: SHA-256 of every other file that the work left, by its path in the folder; empty until it is done.
        inside: The folders in it that have a `run.json` of their own, by path; empty until the work is done.
        digest: SHA-256 of `run.json` itself, while this one is empty.
    """

    kind: ClassVar[Kind]
    schema_version: int = SCHEMA_VERSION
    status: Status = Status.RUNNING
    reason: str = ""
    settings: dict[str, Any]
    versions: dict[str, str] = {}
    timings: dict[str, float] = {}
    files: dict[str, str] = {}
    inside: list[str] = []
    digest: str = ""

    @classmethod
    def asked(cls) -> frozenset[str]:
        """The fields that say what was asked for."""
        return frozenset(name for name, field in cls.model_fields.items() if field.is_required())

    def egos_named(self) -> dict[str, str]:
        """The egos that are loaded where this is followed, each with the SHA-256 of its file; empty if it is none."""
        return {}

    def code_named(self) -> dict[str, str]:
        """What else is loaded where this is followed, by the name of its option."""
        return {}


class MapRecord(Record):
    """What has egos drive on a map.

    Attributes:
        map_digest: SHA-256 of its file; empty in the records of older versions.
        egos: As they were given: the surrogate of a run, or those that are measured.
        ego_digests: SHA-256 of each ego that is a file, by the ego as it was given.
        senses: What each ego sees and brakes with, by ego, as `chatscene.ego.policy.senses_of` names it.
        counts: scenes, ran, rejected, collided, off_road, timeout, waiting, selected, selected_shown, fill_in; empty
            until there are some. Older records lack some of them.
        stepped: How many drives each simulator stepped; empty in the records of older versions.
        instead: The scenes that another simulator stepped than the one that was asked for, by why.
        unplayed: The scenes in which a part of a program of one's own did not take place, or somebody did what tyres
            cannot, by what it is.
    """

    map_name: str
    map_digest: str
    egos: list[str]
    ego_digests: dict[str, str]
    senses: dict[str, dict[str, str]]
    simulator: SimulatorRecord
    counts: dict[str, int] = {}
    stepped: dict[str, int] = {}
    instead: dict[str, list[str]] = {}
    unplayed: dict[str, list[str]] = {}

    def egos_named(self) -> dict[str, str]:
        """Those that drive."""
        return {ego: self.ego_digests.get(ego, "") for ego in self.egos}

    def code_named(self) -> dict[str, str]:
        """What its settings name."""
        settings = settings_of(self)
        reading = settings.retrieval
        return {
            "sampler": settings.search.sampler,
            "simulator": settings.simulation.simulator,
            "library": reading.library,
            "embedder": reading.embedder,
            "language_model": reading.language_model,
        }


class RunRecord(MapRecord):
    """A run: one sentence, or one program, and the scenes searched with it.

    Attributes:
        text: The sentence; empty for a program of the user's own and for a situation.
        edits: What was changed of the sentence, edit by edit; asked for, though older records have none.
        edited_from: Absolute path of the run that the last edit was of; empty if none was.
        report: The report that the sentence was found in; None for one that was given by itself.
    """

    kind = Kind.RUN
    egos: Annotated[list[str], Field(min_length=1)]
    text: Annotated[str, AfterValidator(_short)]
    program: ProgramRecord | None
    situation: SituationRecord | None = None
    generator: str
    edits: list[str] = []
    edited_from: str = ""
    report: ReportRecord | None = None

    @classmethod
    def asked(cls) -> frozenset[str]:
        """The fields that say what was asked for."""
        return super().asked() | {"edits", "situation"}

    @property
    def ego(self) -> str:
        """The surrogate."""
        return self.egos[0]

    @property
    def title(self) -> str:
        """The sentence with its edits, or the name of the program or of the situation."""
        stated = self.program or self.situation
        return with_edits(stated.name if stated else self.text.strip(), self.edits)

    @property
    def stated(self) -> str:
        """What its generator reads in place of a sentence: a program, a situation; else empty."""
        if self.situation is not None:
            return self.situation.text
        return self.program.source if self.program is not None else ""

    def code_named(self) -> dict[str, str]:
        """What its settings name, and the generator."""
        return super().code_named() | {"generator": self.generator}


class EvaluationRecord(MapRecord):
    """An evaluation: egos on the scenes of runs, those of each on its own map; `map_name` is that of the first.

    Attributes:
        speed: What egos drive at [km/h] where none was said; None for what the programs have. Asked for, though older
            records have none.
    """

    kind = Kind.EVALUATION
    scenes: Driven
    sources: list[SourceRecord]
    speed: float | None = None
    failures: dict[str, str] = {}

    @field_validator("sources")
    @classmethod
    def _each_on_a_map(cls, sources: list[SourceRecord], others: ValidationInfo) -> list[SourceRecord]:
        """Sources with their maps; those of before have none of their own."""
        usual = {name: others.data.get(name, "") for name in ("map_name", "map_digest")}
        return [one if one.map_name else one.model_copy(update=usual) for one in sources]

    @classmethod
    def asked(cls) -> frozenset[str]:
        """The fields that say what was asked for."""
        return super().asked() | {"speed"}


class ComparisonRecord(Record):
    """An evaluation of a folder that was imported: egos on its programs, each on its own map.

    Attributes:
        imported: The folder as seen from this one, so that both can be moved together.
        programs: SHA-256 of each program, by its path in that folder.
        maps: SHA-256 of each of their maps, by the path of the first program on it.
        egos: Who drives, as they were given; none where each program is only driven as its file says.
        ego_digests: SHA-256 of each ego that is a file, by the ego as it was given.
        senses: What each ego sees and brakes with, by ego, as `chatscene.ego.policy.senses_of` names it.
    """

    kind = Kind.COMPARISON
    imported: str
    programs: dict[str, str]
    maps: dict[str, str]
    egos: list[str]
    ego_digests: dict[str, str]
    senses: dict[str, dict[str, str]]
    failures: dict[str, str] = {}

    def egos_named(self) -> dict[str, str]:
        """Those that drive."""
        return {ego: self.ego_digests.get(ego, "") for ego in self.egos}


class BenchmarkRecord(MapRecord):
    """A benchmark: a generator's runs for all base scenarios, and an evaluation of them.

    Attributes:
        surrogate: The ego that scenes are searched against.
        refused: Scenarios that could not be searched with, and why, by text.
    """

    kind = Kind.BENCHMARK
    generator: str
    budget: str
    surrogate: str
    refused: dict[str, str] = {}

    def egos_named(self) -> dict[str, str]:
        """Those that are measured, and the surrogate."""
        return {ego: self.ego_digests.get(ego, "") for ego in (self.surrogate, *self.egos)}

    def code_named(self) -> dict[str, str]:
        """What its settings name, and the generator."""
        return super().code_named() | {"generator": self.generator}


class ReproductionRecord(Record):
    """A reproduction: benchmarks of all methods, fine-tunings, and the paper's tables of them.

    Attributes:
        tables: Which were asked for last.
        preset: How often its fine-tunings learn, as asked for last; other ones lie beside.
        choice: Who chooses their checkpoint, as asked for last; other ones lie beside.
    """

    kind = Kind.REPRODUCTION
    tables: list[str] = []
    preset: str = ""
    choice: str = ""


Numbers = dict[str, int | float]


class LessonsRecord(_Frozen):
    """Which scenes a fine-tuning has."""

    digest: str
    train: int
    choice: int
    test: int


class FinetuningRecord(Record):
    """A fine-tuning of an ego on kept scenes.

    Attributes:
        ego_digests: SHA-256 of each ego that is a file, by the ego as the settings name it.
        sources: Absolute paths of the runs that they were read from last.
        before: Figures of the start policy, by what was driven: ``train``, ``choice``, ``test``, ``ordinary``.
        chosen: The row of the ego that was kept; empty until one is.
        after: The figures of the chosen ego, as `before`.
    """

    kind = Kind.FINETUNING
    ego_digests: dict[str, str]
    scenes: LessonsRecord
    sources: list[str] = []
    warm_up: Numbers = {}
    before: dict[str, Numbers] = {}
    skipped: dict[str, str] = {}
    curve: list[Numbers] = []
    chosen: Numbers = {}
    chosen_why: str = ""
    after: dict[str, Numbers] = {}

    def egos_named(self) -> dict[str, str]:
        """Who is fine-tuned, and the teacher."""
        named = [str(self.settings.get(name, "")) for name in ("ego", "teacher")]
        return {ego: self.ego_digests.get(ego, "") for ego in named if ego}

    def code_named(self) -> dict[str, str]:
        """The simulator; none where it is that of the runs."""
        return {"simulator": str(self.settings["simulator"])} if self.settings.get("simulator") else {}


class TrainingRecord(Record):
    """A training of an ego on ordinary drives.

    Attributes:
        steps: How long it is to be; it may go on for longer.
    """

    kind = Kind.TRAINING
    map_digest: str
    simulator: SimulatorRecord
    steps: int = 0
    curve: list[Numbers] = []

    def code_named(self) -> dict[str, str]:
        """The simulator."""
        return {"simulator": str(self.settings.get("simulator", SimulationSettings().simulator))}


RECORDS: dict[Kind, type[Record]] = {
    of.kind: of
    for of in (
        RunRecord,
        EvaluationRecord,
        ComparisonRecord,
        BenchmarkRecord,
        ReproductionRecord,
        FinetuningRecord,
        TrainingRecord,
    )
}


def upgraded(content: Mapping[str, Any]) -> dict[str, Any]:
    """The record of a run or an evaluation of schema 2 as schema 3 has it."""
    ego, text = str(content.get("ego", "")), str(content.get("text", ""))
    common = {"map_digest": "", "ego_digests": {}, "senses": {}, "simulator": {}, "generator": "chatscene", **content}
    common["schema_version"] = SCHEMA_VERSION
    if content.get("command") == "evaluate":
        scenes = Driven.EVERY if text == "all scenes" else Driven.KEPT
        return {**common, "kind": Kind.EVALUATION, "egos": ego.split(","), "scenes": scenes}
    program = None
    if content.get("generator") == "program":
        name, _, source = text.removeprefix("## program ").partition("\n")
        text, program = "", {"name": name, "source": source}
    return {**common, "kind": Kind.RUN, "egos": [ego], "text": text, "program": program}


def settings_of(record: MapRecord) -> Settings:
    """The settings that work on a map was started with, to continue it.

    Raises:
        SettingsError: They name something this version does not know, or are out of range.
    """
    given = record.settings
    return Settings(
        search=settings_from(SearchSettings, {"objective": "collision"} | given.get("search", {})),  # as before 0088
        simulation=settings_from(SimulationSettings, {"occlusion": False} | given.get("simulation", {})),  # 0188
        retrieval=settings_from(RetrievalSettings, _as_called_now(given.get("retrieval", {}))),
    )


def _as_called_now(reading: Mapping[str, Any]) -> Mapping[str, Any]:
    """How a text is read, as a record of whichever version has it: what was called so before 0134 is the usual way."""
    return {**reading, "reader": READ_AS[0]} if reading.get("reader") in ("facts", "learned") else reading


S = TypeVar("S")


def settings_from(kind: type[S], given: Mapping[str, Any]) -> S:
    """Settings of some kind as a record has them.

    Raises:
        SettingsError: They name something this version does not know, or are out of range.
    """
    try:
        return kind(**given)
    except TypeError as error:
        raise SettingsError(f"the settings in run.json are not those of this version of chatscene: {error}") from error


def first_problem(error: ValidationError) -> str:
    """The first complaint of pydantic, as ``field: what is wrong``."""
    problem = error.errors()[0]
    return f"{'.'.join(str(part) for part in problem['loc'])}: {problem['msg'].lower()}"
