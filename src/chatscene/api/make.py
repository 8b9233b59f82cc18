"""Make scenes: what is said is read, explained, run, and gone on with."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

from chatscene import runs
from chatscene.api.arguments import Name, Names, again, changed, folder_for, names_of, path_of, read_by
from chatscene.errors import SettingsError, no_such
from chatscene.runs.executor import Workers
from chatscene.runs.progress import Progress, silent
from chatscene.settings import EGO, EXECUTOR, SIMULATOR, RetrievalSettings, Settings, SimulationSettings
from chatscene.terms.conflict import Conflict
from chatscene.terms.description import Description
from chatscene.terms.scenario import BaseScenario
from chatscene.terms.scene import ScenicProgram, at_speed
from chatscene.terms.situation import Situation

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
    text: str | Conflict | Situation = "",
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
        text: The sentence, a conflict of a report (`conflicts`), or a situation.
        folder: Run folder, new or empty, or one to go on in.
        report: File of a report that tells one conflict, in place of the sentence; of several, see `conflicts`.
        program: File of a Scenic program of one's own, in place of the sentence.
        trust: Whether the program may use all of Scenic and Python, in this process; else it runs in the sandbox.
        as_written: Whether the program's own ego drives, of an imported scenario as its file says; else `ego` does, on
            a route that follows from the program.
        within: The folder in which the map lies that the program names, if it may lie nowhere else.
        param: Values, by name, of parameters that the program uses and does not define; only with a program.
        edit: What is to differ from the text or the situation, in words: one edit, or several that are applied one
            after the other. None and ``[]`` change nothing.
        map: Packaged ``town``, ``outskirts`` or ``region``, or an ``.xodr`` file; None for the town, or for the
            outskirts where the text names what the town has not, such as a motorway. Where a program names a map that
            is there, that one is taken.
        ego: An ego by name, file or ``package.module:factory``.
        speed: What it drives at [km/h] if that was not said, whatever the road allows; None for the speed of the road.
        scenes: Simulations per scenario and route.
        routes: Routes per scenario.
        seed: What everything random derives from.
        avoidable: Whether to keep no crash that a careful driver would not have avoided.
        sampler: Who says where to look next.
        simulator: What scenes run in; ``native`` where neither this nor ``settings`` is given.
        physics: How bodies answer to pedals and wheel: ``kinematic`` or ``lagged``.
        library: Folder of one's own snippets, beside the packaged ones.
        embedder: Who measures wording.
        language_model: ``openai:MODEL`` or ``gguf:FILE``, which fills a situation from the text; ``offline``;
            or another reader, ``package.module:factory``.
        reader: ``situation``, or ``paper`` for the paper's own way, by wording alone, which refuses nothing.
        reading: Which of the readings that are offered is taken whole, from 1.
        set: Facts beside the text, by name, which are sure: ``{"side": "left"}``; of a situation, stated or
            filled, by path: ``{"others.A.starts.side": "left"}``.
        settings: All other settings; the keywords above come before them.
        jobs: How many work at a time; any number gives the same files. A script that starts more than one needs the
            guard ``if __name__ == "__main__":``.
        executor: Who they are, one of `chatscene.runs.executor.EXECUTORS`; anyone gives the same files.
        progress: Told what is done.

    Raises:
        NothingFits: It is not sure what the text says, nothing is built of it, or a model says that it tells nothing.
        ChatSceneError: Anything else that went wrong; the folder can be resumed.
    """
    from chatscene import pipeline

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
    from chatscene.report.filled import explain_text, is_filled, read_already
    from chatscene.report.stated import Stated, explain_stated, stated

    edits, made = names_of(edit or ()), None
    on = None if map is None else str(map)
    if isinstance(text, Situation):
        made = explain_stated(stated(text, set, on, speed), edits=edits)
    elif is_filled(str(text), chosen) or (speed is not None and program is None):
        reads = replace(settings, retrieval=chosen)
        made = explain_text(str(text), reads, facts=set, edits=edits, map_name=on, speed=speed)
        chosen = read_already(chosen)
    else:
        chosen = read_by(chosen, stated=set)
    looking = changed(
        settings.search, scenes=scenes, routes=routes, seed=seed, avoidable_only=avoidable, sampler=sampler
    )
    simulation = changed(settings.simulation, simulator=simulator, physics=physics)
    where = folder_for(folder)
    own = None if program is None else _own(path_of(program), trusted=trust, as_written=as_written, given=param)
    if own and within is not None:
        own.check_map(path_of(within))
    if own and speed is not None:
        own = replace(own, program=_at_speed(own.program, speed))
    if own:
        from chatscene.imports.collection import map_for
        from chatscene.search.generators.their_map import their_map

        map, notes = their_map(own.map_path, map_for(own, on, shut_in=within is not None))  # noqa: A001
        for line in (*own.changed(), *notes):
            progress(f"{line}\n", 0, 0)
    situation = made.record if isinstance(made, Stated) else None
    if isinstance(made, Stated):
        map = made.built.map  # noqa: A001
    asked = runs.asked_run(
        "" if isinstance(text, Situation) else text,
        program=None if own is None else runs.ProgramRecord(name=own.program.scenario_id, source=own.program.source),
        settings=replace(settings, search=looking, simulation=simulation, retrieval=chosen),
        situation=situation,
        map_name=None if map is None else str(map),
        ego=str(ego),
        generator=_generator_of(situation, own, trusted=trust, as_written=as_written),
        edits=edits,
    )
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


def read_situation(file: Name) -> Situation:
    """The situation in a file of YAML or JSON.

    Raises:
        SituationError: It cannot be read, or is none; the message lists each fault with its line.
    """
    from chatscene.report.stated import stated

    return stated(path_of(file))


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
def explain(text: str | Conflict | Situation = "", **options: Any) -> Understood | Stated: ...
def explain(  # pyright: ignore[reportInconsistentOverload] - **options are its keywords
    text: str | Conflict | Situation = "",
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

    With a library of one's own, or in the paper's way, it is the snippets that are chosen for a sentence, and why.

    As text (``print``) it reads as the command prints it; in a notebook it shows as the report does.

    Args:
        text: The sentence, a conflict of a report (`conflicts`), or a situation, of which the program is built.
        report: File of a report that tells one conflict, in place of the sentence; of several, see `conflicts`.
        edit: What is to be another than it says, in words, edit by edit, as in `run`; so does `edit` of the answer.
        map: The map that it is to be built on, as in `run`; None for the first packaged one that has such a place.
        library: Folder of one's own snippets, beside the packaged ones.
        embedder: Who measures wording.
        language_model: ``openai:MODEL`` or ``gguf:FILE``, which fills a situation from the text; ``offline``;
            or another reader, ``package.module:factory``.
        reader: ``situation``, or ``paper`` for the paper's own way, by wording alone, which refuses nothing.
        reading: Which of the readings that are offered is taken whole, from 1.
        set: Facts beside the text, by name, which are sure: ``{"side": "left"}``; of a situation, stated or filled, by
            path.
        settings: All other settings; the keywords above come before them.

    Raises:
        EditRefused: An edit was not understood.
        NothingFits: It is not sure what the text says, nothing is built of it, or a model says that it tells nothing.
    """
    on = None if map is None else str(map)
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
    """The conflicts that a report tells, each to be run or explained, with what is in none of them.

    Args:
        report: A file: text in UTF-8, of any length up to 1 MB.
        progress: Told how many of its sentences are read.

    Raises:
        SettingsError: There is no such file, or it is no text.
        NothingFits: It tells no conflict.
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
    """Make up scenarios for `run`, each with a sentence of its own (``text``) that the library serves.

    Args:
        n: How many.
        base: Base scenario they belong to; any if None.
        instruction: What they are to be about, in words.
        seed: Another seed, other sentences.
        library: Folder of one's own snippets, beside the packaged ones.
        embedder: Who measures wording.
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
    """Go on with what was killed or failed; the result is that of an uninterrupted one.

    Args:
        folder: Folder of a run, an evaluation, a benchmark, a reproduction, a fine-tuning or a training.
        jobs: How many work at a time; any number gives the same files. A fine-tuning and a training are one process.
        executor: As `run`.
        ego: Egos again that the folder names and that may run code of their own: that its files say so is not enough.
        generator: Generator again, if it names one that is none of ours.
        sampler: Sampler again, if it names one that is none of ours.
        simulator: Simulator again, if it names one that is none of ours.
        library: Folder of snippets again, if it names one.
        embedder: Embedder again, if it names another than the packaged one.
        language_model: Language model again, if it names one.
        progress: Told what is done.

    Raises:
        RunError: There is nothing to go on with in the folder, it is damaged, another process is at work on it, or it
            names what must be repeated.
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
    done = go_on(where, workers=Workers(jobs, executor), progress=progress, repeated=repeated)
    if kind is runs.Kind.RUN:
        from chatscene.api.results import Run

        return Run(where, ego=ego, generator=generator, simulator=simulator, library=library)
    return done


ONE_READING = "`reading` is about a text; there is one way to read a situation or a program"
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

    Raises:
        SettingsError: There is such a thing.
    """
    if driven and not program:
        raise SettingsError("`trust`, `as_written`, `within` and `param` are about a program, and none is run")
    if changed and program:
        raise SettingsError("`edit` and `set` are about what is said, and a program is run as it is; leave them out")
    if reading and (program or told):
        raise SettingsError(ONE_READING)
    if reads and (program or told):
        what = "a program is run as it is" if program else "a situation is not read"
        raise SettingsError(f"`{reads}` is about how a text is read, and {what}; leave it out")


def _only_conflict(report: Name) -> Conflict:
    """The conflict of a report that tells one."""
    from chatscene.interpret.conflicts import conflicts_in, read_report

    found, *others = conflicts_in(read_report(path_of(report)), path_of(report).name)
    if others:
        raise SettingsError(
            f"{report} tells {found.of} conflicts; run them one by one: "
            f"[chatscene.run(one) for one in chatscene.conflicts({str(report)!r})]"
        )
    return found


def _generator_of(situation: object | None, own: ForeignProgram | None, *, trusted: bool, as_written: bool) -> str:
    from chatscene.search.generators.own_program import generator_for

    if situation is not None:
        return "situation"
    return "chatscene" if own is None else generator_for(trusted=trusted, as_written=as_written)


def _at_speed(program: ScenicProgram, speed: float) -> ScenicProgram:
    """A program whose ego wants a speed [km/h], if it says none.

    Raises:
        SettingsError: Nothing can be wanted of its ego.
    """
    if program.drawn or program.as_written:
        why = "drives as it is written" if program.as_written else "is written for another world model"
        raise SettingsError(f"{program.called} {why}, so that its ego is not told a speed")
    return at_speed(program, speed / 3.6)


def _own(path: Path, *, trusted: bool, as_written: bool, given: Mapping[str, object] | None) -> ForeignProgram:
    """A program of the user's own."""
    from chatscene.search.generators.foreign import foreign_files, read_foreign

    file, *others = foreign_files(path)
    if others:
        raise SettingsError(f"{path} holds {len(others) + 1} programs; run them one by one")
    return read_foreign(file, trusted=trusted, as_written=as_written, given=given)
