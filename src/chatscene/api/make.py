"""Make scenes: what is said is read, explained, run, and gone on with."""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping
from contextlib import contextmanager
from dataclasses import asdict, replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

from chatscene import runs
from chatscene.api.arguments import Name, Names, again, changed, folder_for, name_of, names_of, path_of, read_by
from chatscene.errors import SettingsError, Unsatisfiable, no_such
from chatscene.files.bounded import is_there
from chatscene.runs.executor import Workers
from chatscene.runs.progress import Progress, silent
from chatscene.settings import EGO, EXECUTOR, SIMULATOR, RetrievalSettings, SearchSettings, Settings, SimulationSettings
from chatscene.terms.conflict import Conflict
from chatscene.terms.description import Description
from chatscene.terms.scenario import BaseScenario
from chatscene.terms.scene import ScenicProgram, at_speed
from chatscene.terms.situation import Situation

SITUATION_SUFFIXES = (".yaml", ".yml", ".json")

if TYPE_CHECKING:
    from chatscene.api.results import Run
    from chatscene.learn.finetune import Finetuned
    from chatscene.learn.train import Trained
    from chatscene.report.stated import Stated
    from chatscene.report.understood import Understood
    from chatscene.search.generators.foreign import ForeignProgram
    from chatscene.studies.benchmark import Benchmarked
    from chatscene.studies.collection import Compared
    from chatscene.studies.evaluation import Evaluated
    from chatscene.studies.reproduce import Reproduced


def run(
    text: str | Path | Conflict | Situation = "",
    folder: Name | None = None,
    *,
    report: Name | None = None,
    program: Name | None = None,
    trust: bool = False,
    as_written: bool = False,
    within: Name | None = None,
    param: Mapping[str, object] | None = None,
    edit: Names | None = None,
    map: Name | None = None,  # noqa: A002 - the word of the command line
    ego: Name = EGO,
    speed: float | None = None,
    scenes: int | None = None,
    routes: int | None = None,
    seed: int | None = None,
    avoidable: bool | None = None,
    sampler: str | None = None,
    simulator: str | None = None,
    physics: str | None = None,
    occlusion: bool | None = None,
    library: Name | None = None,
    embedder: str | None = None,
    language_model: str | None = None,
    reader: str | None = None,
    reading: int | None = None,
    set: Mapping[str, object] | None = None,  # noqa: A002 - the word of the command line
    settings: Settings | None = None,
    jobs: int = 1,
    executor: str = EXECUTOR,
    progress: Progress = silent,
) -> Run:
    """Understand a sentence, search for crash scenes, keep the ones worth testing on, and write a report.

    Args:
        text: The sentence, a conflict of a report (`conflicts`), a situation, or its file (.yaml, .json).
        folder: Run folder: new, empty, or one to continue.
        report: File of a report with one conflict, instead of the sentence; for several, see `conflicts`.
        program: File of your own Scenic program, instead of the sentence.
        trust: Whether the program may use all of Scenic and Python, in this process; else it runs in the sandbox.
        as_written: Whether the program's own ego drives (an imported one as its file says); else `ego` does, on a route
            derived from the program.
        within: Folder outside which the program's map may not lie; None for anywhere.
        param: Values, by name, of parameters that the program uses and does not define; only with a program.
        edit: Changes to the text or the situation, in words: one edit, or several that are applied in order. None and
            ``[]`` change nothing.
        map: Packaged ``town``, ``outskirts`` or ``region``, a road such as ``road:2+1``, or an ``.xodr`` file; None for
            the first packaged map that has what the text names, else a road with it, and for a program's own map.
            Given, it takes the place of a program's own map.
        ego: An ego by name, file or ``package.module:factory``.
        speed: Speed of the ego [km/h] if the text gives none, whatever the road allows; None for the speed of the road.
        scenes: Simulations per scenario and route.
        routes: Routes per scenario.
        seed: Seed of everything random.
        avoidable: Whether to keep only crashes that a careful driver would have avoided.
        sampler: How to search, one of `chatscene.search.sampler` by name, or ``package.module:factory``.
        simulator: Simulator of the scenes; ``native`` if neither this nor ``settings`` is given.
        physics: How vehicles respond to pedals and steering: ``kinematic`` or ``lagged``.
        occlusion: Whether bodies hide other road users from the ego.
        library: Folder of your own snippets: they serve a text that they do; any other becomes a situation.
        embedder: Text encoder.
        language_model: Reader of the text: ``offline``, ``openai:MODEL``, ``gguf:FILE``, or ``package.module:factory``.
        reader: ``situation``, or ``paper`` to choose snippets by wording alone, as the paper does, and refuse nothing.
        reading: Number of the offered reading to use, from 1.
        set: Facts that are certain, by name (``{"side": "left"}``) or by path in the situation
            (``{"others.A.starts.side": "left"}``).
        settings: All other settings; the keywords above override them.
        jobs: Number of worker processes; any number gives the same files. A script that starts more than one needs the
            guard ``if __name__ == "__main__":``.
        executor: Where they run, one of `chatscene.runs.executor.EXECUTORS`; each gives the same files.
        progress: Called with what is done.

    Raises:
        NothingFits: The text is not understood well enough, cannot be built, or has no situation.
        ChatSceneError: Something else went wrong; the folder can be resumed.
    """
    from chatscene import pipeline

    text = _read_if_named(text)
    if sum((bool(text), report is not None, program is not None)) > 1:
        raise SettingsError("say what to run: a text, a report or a program, and only one of them")
    _check_asked(
        program is not None,
        told=isinstance(text, Situation),
        driven=trust or as_written or bool(param) or within is not None,
        changed=bool(edit) or bool(set),
        reading=reading or 0,
        reads=_reads(library, embedder, language_model, reader),
    )
    settings = settings or Settings(simulation=SimulationSettings(simulator=SIMULATOR))
    chosen = read_by(settings.retrieval, library, embedder, language_model, reader, reading)
    if report is not None:
        text = _only_conflict(report)
    from chatscene.report.filled import read_already, unless_by_snippets
    from chatscene.report.stated import Stated, explain_stated, stated

    edits, made = names_of(edit or ()), None
    on = None if map is None else str(map)
    if isinstance(text, Situation):
        made = explain_stated(stated(text, set, on, speed), edits=edits)
    elif program is None:
        reads = replace(settings, retrieval=chosen)
        made = unless_by_snippets(str(text), reads, facts=set, edits=edits, map_name=on, speed=speed)
    chosen = read_by(chosen, stated=set) if made is None else read_already(chosen)
    looking = changed(
        settings.search, scenes=scenes, routes=routes, seed=seed, avoidable_only=avoidable, sampler=sampler
    )
    simulation = changed(settings.simulation, simulator=simulator, physics=physics, occlusion=occlusion)
    where = folder_for(folder)
    own = None if program is None else _own(path_of(program), trusted=trust, as_written=as_written, given=param)
    if own and within is not None:
        own.check_map(path_of(within))
    if own and speed is not None:
        own = replace(own, program=_at_speed(own.program, speed))
    if own:
        map, looking, lines = _told_of(own, on, looking, shut_in=within is not None)  # noqa: A001
        for line in lines:
            progress(f"{line}\n", 0, 0)
    situation = None
    if isinstance(made, Stated):
        made = made.as_shown
        situation, map = made.record, made.built.map  # noqa: A001
    asked = runs.asked_run(
        "" if isinstance(text, Situation) else text,
        program=None if own is None else runs.ProgramRecord(name=own.program.scenario_id, source=own.program.source),
        settings=replace(settings, search=looking, simulation=simulation, retrieval=chosen),
        situation=situation,
        map_name=None if map is None else str(map),
        ego=name_of(ego),
        generator=_generator_of(situation, own, trusted=trust, as_written=as_written),
        edits=edits,
    )
    with _elsewhere_if_nowhere(own, asked.map_name, simulation, progress, trusted=trust):
        pipeline.run(asked, where, workers=Workers(jobs, executor), progress=progress)
    from chatscene.api.results import Run

    return Run(
        where,
        ego=ego,
        sampler=looking.sampler,
        simulator=simulation.simulator,
        library=chosen.library or (),
        embedder=chosen.embedder,
        language_model=chosen.language_model or (),
    )


def _told_of(
    own: ForeignProgram, chosen: str | None, search: SearchSettings, *, shut_in: bool
) -> tuple[str | None, SearchSettings, tuple[str, ...]]:
    """On which map a program of the user's own runs, what its search is set to, and lines for a person about it."""
    from chatscene.imports.collection import map_for
    from chatscene.search.generators.their_map import their_map

    there, notes = their_map(own.map_path, map_for(own, chosen, shut_in=shut_in))
    if own.varies():
        return there, search, (*own.changed(), *notes)
    once = f"nothing in {own.path.name} varies, so it is driven once on each of its routes"
    return there, replace(search, scenes=1), (*own.changed(), *notes, once)


@contextmanager
def _elsewhere_if_nowhere(
    own: ForeignProgram | None, on: str | None, settings: SimulationSettings, progress: Progress, *, trusted: bool
) -> Generator[None]:
    """Where a program cannot be drawn, say on which other maps at hand it can be; it is run on none of them."""
    try:
        yield
    except Unsatisfiable as error:
        if own is None or not own.program.drawn:
            raise
        from chatscene.maps.network import TOWN, resolve_map
        from chatscene.search.elsewhere import elsewhere
        from chatscene.simulate.confined.simulator import ConfinedSimulator
        from chatscene.simulate.simulator import load_simulator

        simulator = load_simulator if trusted else ConfinedSimulator
        found = elsewhere(own.program, resolve_map(on or TOWN), lambda path: simulator(path, settings), progress)
        raise Unsatisfiable(f"{error}{found}") from None


def read_situation(file: Name) -> Situation:
    """The situation in a file of YAML or JSON.

    Raises:
        SituationError: It cannot be read, or is not a situation; the message lists each fault with its line.
    """
    from chatscene.report.stated import stated

    return stated(path_of(file))


def named_in(text: str) -> Situation | None:
    """The situation in the file that a text names; None for a sentence.

    Raises:
        SituationError: It cannot be read, or is none.
        SettingsError: It is a file of another kind.
    """
    there = is_there(Path(text))
    if text.lower().endswith(SITUATION_SUFFIXES) and (there or " " not in text):
        return read_situation(text)
    if there:
        raise SettingsError(
            f"{text!r} is a file, but not of a situation (.yaml, .json); give a report with --report, and a program "
            "with --program"
        )
    return None


def _read_if_named(text: str | Conflict | Situation | Path) -> str | Conflict | Situation:
    """What is told, read from its file where a file is named."""
    if isinstance(text, (Conflict, Situation)):
        return text
    return named_in(str(text)) or str(text)


@overload
def explain(text: Situation, **options: Any) -> Stated: ...
@overload
def explain(
    text: str | Conflict = "",
    *,
    library: None = None,
    reader: None = None,
    settings: None = None,
    report: Name | None = None,
    edit: Names | None = None,
    map: Name | None = None,
    embedder: str | None = None,
    language_model: str | None = None,
    reading: int | None = None,
    set: Mapping[str, object] | None = None,
) -> Stated: ...
@overload
def explain(text: str | Path | Conflict | Situation = "", **options: Any) -> Understood | Stated: ...
def explain(  # pyright: ignore[reportInconsistentOverload] - **options are its keywords
    text: str | Path | Conflict | Situation = "",
    *,
    report: Name | None = None,
    edit: Names | None = None,
    map: Name | None = None,  # noqa: A002 - the word of the command line
    library: Name | None = None,
    embedder: str | None = None,
    language_model: str | None = None,
    reader: str | None = None,
    reading: int | None = None,
    set: Mapping[str, object] | None = None,  # noqa: A002 - the word of the command line
    settings: Settings | None = None,
) -> Understood | Stated:
    """How a text is understood: the situation, the words of each fact, the program. Runs nothing.

    Where snippets of your own library serve the text, or with the reader ``paper``, the answer has the chosen snippets,
    and why.

    Printed, the answer reads like the command's output; in a notebook it looks like the report.

    Args:
        text: The sentence, a conflict of a report (`conflicts`), a situation, or its file (.yaml, .json).
        report: File of a report with one conflict, instead of the sentence; for several, see `conflicts`.
        edit: Changes in words, as in `run`; the answer has a method `edit` as well.
        map: Map to build on, as in `run`; None for the first packaged map that has such a place.
        library: Folder of your own snippets: they serve a text that they do; any other becomes a situation.
        embedder: Text encoder.
        language_model: Reader of the text: ``offline``, ``openai:MODEL``, ``gguf:FILE``, or ``package.module:factory``.
        reader: ``situation``, or ``paper`` to choose snippets by wording alone, as the paper does, and refuse nothing.
        reading: Number of the offered reading to use, from 1.
        set: Facts that are certain, by name (``{"side": "left"}``) or by path in the situation.
        settings: All other settings; the keywords above override them.

    Raises:
        EditRefused: An edit was not understood.
        NothingFits: The text is not understood well enough, cannot be built, or has no situation.
    """
    on, text = None if map is None else str(map), _read_if_named(text)
    if isinstance(text, Situation):
        from chatscene.report.stated import explain_stated, stated

        if report is not None:
            raise SettingsError("say what to explain: a situation or a report, and only one of them")
        _check_asked(
            False,
            told=True,
            driven=False,
            changed=False,
            reading=reading or 0,
            reads=_reads(library, embedder, language_model, reader),
        )
        return explain_stated(stated(text, set, on), edits=names_of(edit or ()))
    from chatscene.report.filled import explain_text

    settings = settings or Settings()
    chosen = read_by(settings.retrieval, library, embedder, language_model, reader, reading)
    if report is not None:
        text = _only_conflict(report)
    reads = replace(settings, retrieval=chosen)
    return explain_text(str(text), reads, facts=set, edits=names_of(edit or ()), map_name=on)


def conflicts(
    report: Name,
    *,
    progress: Progress = silent,
) -> tuple[Conflict, ...]:
    """The conflicts in a report, each to be run or explained, and the passages outside all of them.

    Args:
        report: A file: text in UTF-8, of any length up to 1 MB.
        progress: Told how many of its sentences are read.

    Raises:
        SettingsError: There is no such file, or it is not text.
        NothingFits: It has no conflict.
    """
    from chatscene.interpret.conflicts import conflicts_in, read_report

    path = path_of(report)
    return conflicts_in(read_report(path), path.name, progress)


def describe(
    n: int = 10,
    *,
    base: BaseScenario | str | None = None,
    instruction: str = "",
    seed: int = 0,
    library: Name | None = None,
    embedder: str | None = None,
    language_model: str | None = None,
) -> tuple[Description, ...]:
    """Make up scenarios for `run`, each with its own sentence (``text``) about a different combination of snippets.

    Args:
        n: How many.
        base: Base scenario they belong to; any if None.
        instruction: What the sentences should be about, in words.
        seed: Seed; another seed gives other sentences.
        library: Folder of your own snippets, in addition to the packaged ones.
        embedder: Text encoder.
        language_model: as `explain`.

    Raises:
        NothingFits: The library has no such scenario, or nothing in the instruction was understood.
    """
    from chatscene.sentences.describe_with_model import describe_for

    settings = read_by(RetrievalSettings(), library, embedder, language_model)
    if n < 0:
        raise SettingsError(f"n is {n}; ask for 0 scenarios or more")
    if base and base not in set(BaseScenario):
        raise SettingsError(no_such("base scenario", str(base), tuple(BaseScenario)))
    wanted = BaseScenario(base) if base else None
    return describe_for(settings, wanted, n, seed=seed, instruction=instruction).descriptions


def resume(
    folder: Name,
    *,
    jobs: int = 1,
    executor: str = EXECUTOR,
    ego: Names = (),
    generator: Names = (),
    sampler: Names = (),
    simulator: Names = (),
    library: Names = (),
    embedder: Names = (),
    language_model: Names = (),
    progress: Progress = silent,
) -> Run | Evaluated | Compared | Benchmarked | Reproduced | Finetuned | Trained:
    """Continue work that was killed or failed; the result is the same as without the interruption.

    Args:
        folder: Folder of a run, an evaluation, a benchmark, a reproduction, a fine-tuning or a training.
        jobs: Number of worker processes; any number gives the same files. Fine-tuning and training use one process.
        executor: As `run`.
        ego: Egos of the folder that may run their own code, repeated to confirm that you trust them.
        generator: Generator of the folder, repeated if it is not packaged.
        sampler: Sampler of the folder, repeated if it is not packaged.
        simulator: Simulator of the folder, repeated if it is not packaged.
        library: Snippet folder of the folder, repeated if it has one.
        embedder: Encoder of the folder, repeated if it is not the packaged one.
        language_model: Language model of the folder, repeated if it has one.
        progress: Called with what is done.

    Raises:
        RunError: The folder has nothing to continue, is damaged, is in use by another process, or names code that must
            be repeated.
    """
    where = path_of(folder)
    repeated = again(
        ego=ego,
        generator=generator,
        sampler=sampler,
        simulator=simulator,
        library=library,
        embedder=embedder,
        language_model=language_model,
    )
    kind = runs.read_record(runs.Workspace(where), runs.Record).kind
    go_on: Callable[..., Any] = import_module(_RESUMES[kind]).resume
    shared = {} if kind in _ONE_PROCESS else {"workers": Workers(jobs, executor)}
    done = go_on(where, progress=progress, repeated=repeated, **shared)
    if kind is runs.Kind.RUN:
        from chatscene.api.results import Run

        return Run(where, **asdict(repeated))
    return done


ONE_READING = "`reading` is for a text; a situation or a program has only one reading"
_RESUMES = {
    "run": "chatscene.pipeline",
    "evaluation": "chatscene.studies.evaluation",
    "comparison": "chatscene.studies.collection",
    "benchmark": "chatscene.studies.benchmark",
    "reproduction": "chatscene.studies.reproduce",
    "finetuning": "chatscene.learn.finetune",
    "training": "chatscene.learn.train",
}
"""Whose `resume` goes on with each kind of folder (`chatscene.runs.Kind`); loaded when it does."""
_ONE_PROCESS = frozenset(("finetuning", "training"))  # kinds by name, so that who reads a sentence loads no records


def _reads(library: Name | None, embedder: str | None, language_model: str | None, reader: str | None) -> str:
    """The first of what says how a text is read that is not as usual; empty if none is."""
    usual = RetrievalSettings()
    said = {"library": library, "embedder": embedder, "language_model": language_model, "reader": reader}
    return next((name for name, value in said.items() if value and str(value) != getattr(usual, name)), "")


def _check_asked(program: bool, *, told: bool, driven: bool, changed: bool, reading: int, reads: str) -> None:
    """Refuse what is asked of a run that has no place in what is run, which would else be dropped.

    Args:
        program: Whether a program is run.
        told: Whether a situation is.
        driven: Whether it is said how a program is driven.
        changed: Whether facts or edits are said.
        reading: Which reading of a text is taken; 0 where that is not said.
        reads: What says how a text is read; empty where nothing does.
    """
    if driven and not program:
        raise SettingsError("`trust`, `as_written`, `within` and `param` are for a program, and none is given")
    if changed and program:
        raise SettingsError("`edit` and `set` change a text or situation, not a program; leave them out")
    if reading and (program or told):
        raise SettingsError(ONE_READING)
    if reads and (program or told):
        what = "a program is run as it is" if program else "a situation is not read"
        raise SettingsError(f"`{reads}` is for reading a text, and {what}; leave it out")


def _only_conflict(report: Name) -> Conflict:
    """The conflict of a report that tells one."""
    from chatscene.interpret.conflicts import conflicts_in, read_report

    found, *others = conflicts_in(read_report(path_of(report)), path_of(report).name)
    if others:
        raise SettingsError(
            f"{report} has {found.of} conflicts; run them one by one: "
            f"[chatscene.run(one) for one in chatscene.conflicts({str(report)!r})]"
        )
    return found


def _generator_of(situation: object | None, own: ForeignProgram | None, *, trusted: bool, as_written: bool) -> str:
    from chatscene.search.generators.own_program import generator_for

    if situation is not None:
        return "situation"
    return "chatscene" if own is None else generator_for(trusted=trusted, as_written=as_written)


def _at_speed(program: ScenicProgram, speed: float) -> ScenicProgram:
    """A program whose ego wants a speed [km/h], if it says none."""
    if program.drawn or program.as_written:
        why = "drives as it is written" if program.as_written else "is written for another world model"
        raise SettingsError(f"{program.called} {why}, so its ego gets no speed")
    return at_speed(program, speed / 3.6)


def _own(path: Path, *, trusted: bool, as_written: bool, given: Mapping[str, object] | None) -> ForeignProgram:
    """A program of the user's own."""
    from chatscene.search.generators.foreign import foreign_files, read_foreign

    file, *others = foreign_files(path)
    if others:
        raise SettingsError(f"{path} holds {len(others) + 1} programs; run them one by one")
    return read_foreign(file, trusted=trusted, as_written=as_written, given=given)
