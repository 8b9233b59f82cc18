"""Tools that drive and look: runs, verdicts, stories, causes, rates, coverage, exports."""

from __future__ import annotations

from pathlib import Path as Place
from typing import TYPE_CHECKING, Annotated, Any
from urllib.parse import quote

from pydantic import Field

import chatscene
from chatscene.errors import SettingsError
from chatscene.exports.exporter import EXPORTERS
from chatscene.mcp.tool import SCHEME, Answer, Desk, Path, first_of
from chatscene.mcp.writing import SITUATIONS, Facts, Given, Sentence, Variant, situation_in
from chatscene.settings import EGO

if TYPE_CHECKING:
    from chatscene.api.results import Run

Ego = Annotated[
    str, Field(max_length=60, description="Who drives: planner, idm, hardened, rule-based, sac, ppo or td3.")
]
Map = Annotated[
    str,
    Field(max_length=500, description="town, outskirts, region, road:2+1, or an .xodr file below the folder."),
]
Seed = Annotated[int, Field(ge=0, le=2**63 - 1, description="Of everything random.")]
SceneId = Annotated[str, Field(max_length=300, description="The id of a scene, as run and verify tell it.")]
RunFolder = Annotated[Path, Field(description="The folder of a run.")]
Picture = Annotated[bool, Field(description="Whether a picture from above comes with the answer.")]
REPORTS = (".txt", ".md")


def run(
    desk: Desk,
    sentence: Sentence | None = None,
    file: Annotated[
        Path, Field(description="Instead of a sentence: a situation (.yaml), program (.scenic) or report (.txt).")
    ]
    | None = None,
    out: Annotated[Path, Field(description="A new folder; one named after the sentence below runs/ if left out.")]
    | None = None,
    scenes: Annotated[int, Field(ge=1, le=1000, description="Simulations.")] = 20,
    ego: Ego | None = None,
    speed: Annotated[float, Field(ge=1, le=300, description="Of the ego [km/h], where nothing says it.")] | None = None,
    map: Map | None = None,  # noqa: A002
    seed: Seed | None = None,
    avoidable: Annotated[bool, Field(description="Keep only crashes that a careful driver avoids.")] = False,
    as_written: Annotated[bool, Field(description="Let a program's own ego drive.")] = False,
    facts: Facts | None = None,
    reading: Annotated[int, Field(ge=0, le=20, description="Which offered reading is taken.")] = 0,
) -> str:
    """Search a sentence, a situation or a program for crash scenes, and keep the ones worth testing on.

    A stranger's program runs in the sandbox. The answer counts what happened and lists the kept scenes by their ids:
    then call story, why or export with the folder.
    """
    from chatscene import runs

    if (sentence is None) == (file is None):
        raise SettingsError("say what to run: a `sentence` or a `file`, and only one of them")
    name = out or str(runs.free_folder(Place("runs"), sentence or Place(file or "").stem))
    where, on, driver = desk.folder.free(name), desk.folder.map(map), desk.folder.ego(ego)
    source = _source(desk, sentence, file)
    desk.folder.make_above(where)
    made = chatscene.run(
        **source,
        folder=where,
        reading=reading or None,
        as_written=as_written,
        map=on,
        ego=driver or EGO,
        speed=speed,
        scenes=scenes,
        seed=seed,
        avoidable=avoidable or None,
        set=facts or None,
        progress=desk.progress,
    )
    kept = first_of(kept_scenes(made), f"; {SCHEME}://report/{quote(str(where))} lists them")
    return "\n".join([str(made), "kept scenes:", *kept, f"next: story {where}, verify {where}"])


def verify(
    desk: Desk,
    what: Annotated[Path, Field(description="A program (.scenic, .xosc), run folder or recording (.csv, .mcap).")],
    said: Sentence | None = None,
    said_file: Annotated[Path, Field(description="Instead: a situation (.yaml) or report (.txt).")] | None = None,
    draws: Annotated[int, Field(ge=1, le=200, description="Number of drives to judge.")] = 10,
    seed: Seed | None = None,
    least: Annotated[float, Field(ge=0, le=1, description="Share of the drives that must show a fact.")] | None = None,
    ego: Ego | None = None,
    map: Map | None = None,  # noqa: A002
    ego_id: Annotated[str, Field(max_length=200, description="Whose track of a recording is the ego's.")] | None = None,
    scene: SceneId | None = None,
    param: Given | None = None,
    variant: Variant | None = None,
    page: Annotated[Path, Field(description="A new .html file with a picture of the moment of each fact.")]
    | None = None,
    facts: Facts | None = None,
) -> str:
    """Judge whether a program, a run or a recording shows what was said, fact by fact, from its tracks.

    Of a run, `said` may be left out: it is judged by what it was made of. The answer says of each fact in how many
    drives it is shown and when, or what is seen instead; what happened that nobody said; whether the two could meet.
    Prefer `said_file` with a situation: a sentence can be misread. After a fact that is not shown, call story.
    """
    where, on, wanted = seen(desk, what), desk.folder.map(map), _said(desk, said, said_file)
    out = None if page is None else desk.folder.free(page, ".html")
    if out is not None:
        desk.folder.make_above(out)
    verdict = chatscene.verify(
        where,
        wanted,
        draws=draws,
        seed=seed,
        least=least,
        ego=desk.folder.ego(ego),
        map=on,
        ego_id=ego_id,
        scene=scene,
        param=param,
        variant=variant,
        within=desk.folder.root,
        page=out,
        set=facts or None,
        **desk.reading,
    )
    nexts = f"\nnext: story {where}" * (verdict.status != 0)
    return f"{verdict}{nexts}"


def story(
    desk: Desk,
    what: Annotated[Path, Field(description="As with verify.")],
    scene: SceneId | None = None,
    seed: Seed | None = None,
    ego: Ego | None = None,
    map: Map | None = None,  # noqa: A002
    ego_id: Annotated[str, Field(max_length=200, description="Whose track of a recording is the ego's.")] | None = None,
    param: Given | None = None,
    variant: Variant | None = None,
    picture: Picture = False,
    at: Annotated[float, Field(ge=0, le=10_000, description="Moment of the picture [s].")] | None = None,
) -> Answer:
    """Say what happened in one drive, in words, with times and speeds: who was where, who did what, how it ended.

    Nothing is judged. Use it to see why verify says that a fact is not shown.
    """
    told = chatscene.story(
        seen(desk, what),
        scene=scene,
        seed=seed,
        ego=desk.folder.ego(ego),
        map=desk.folder.map(map),
        ego_id=ego_id,
        param=param,
        variant=variant,
        within=desk.folder.root,
    )
    return Answer(str(told), told.picture(at) if picture or at is not None else b"")


def why(desk: Desk, run: RunFolder, scene: SceneId | None = None) -> str:
    """Say why a scene of a run crashed: who struck whom, what it took, how the ego would have avoided it.

    The scene is driven again and again; this takes seconds. Without `scene` it is the first that is kept.
    """
    return chatscene.why(desk.folder.run(run), scene).in_words()


def rate(
    desk: Desk,
    run: RunFolder,
    scenes: Annotated[int, Field(ge=0, le=10_000, description="Scenes to draw in addition to the run's.")] = 200,
    seed: Seed = 0,
    exposure: Annotated[Path, Field(description="A .toml file that says how often values occur.")] | None = None,
) -> str:
    """Estimate how often the situation of a run ends in a crash, and in an avoidable one, if it comes about."""
    densities = None if exposure is None else desk.folder.file(exposure, ".toml")
    found = chatscene.rate(desk.folder.run(run), scenes=scenes, seed=seed, exposure=densities, progress=desk.progress)
    return found.in_words()


def coverage(
    desk: Desk,
    catalogue: Annotated[
        str,
        Field(max_length=500, description="nhtsa, ncap, r157, iso34502, leaderboard, challenge, or a .toml file."),
    ],
    drive: Annotated[bool, Field(description="Whether scenes of each entry are drawn and driven: minutes.")] = False,
) -> str:
    """Show which situations of a catalogue of traffic situations can be made, and why the others cannot."""
    from chatscene.settings import RetrievalSettings, Settings
    from chatscene.studies import coverage as desk_of
    from chatscene.studies.catalogue import PACKAGED, load_catalogue
    from chatscene.terms.coverage import Tally

    name = catalogue if catalogue in PACKAGED else str(desk.folder.file(catalogue, ".toml"))
    found = [load_catalogue(name)]
    asked = desk_of.Asked(
        settings=Settings(retrieval=RetrievalSettings(**desk.reading)), scenes=desk_of.SCENES if drive else 0
    )
    rows = desk_of.cover(found, asked, progress=desk.progress)
    why = (f" ({'; '.join(row.reasons) or row.entry.reason})" * bool(row.reasons or row.entry.reason) for row in rows)
    lines = [f"{row.answer}: {row.entry.name}{reason}" for row, reason in zip(rows, why, strict=True)]
    return "\n".join([f"{found[0].title}: {Tally.of(rows).in_words()}", *lines])


def export(
    desk: Desk,
    run: RunFolder,
    to: Annotated[
        str,
        Field(max_length=60, description=f"One of {', '.join(EXPORTERS.built_in)}."),
    ],
    out: Annotated[Path, Field(description="A new folder.")],
    scenes: Annotated[list[SceneId], Field(max_length=100, description="Ids; none for the kept scenes.")] | None = None,
) -> str:
    """Write scenes of a run as files that other tools read. Nothing is run."""
    from chatscene.errors import no_such

    if to not in EXPORTERS.built_in:
        raise SettingsError(no_such("format", to, EXPORTERS.built_in))
    where = desk.folder.free(out)
    desk.folder.make_above(where)
    return str(chatscene.export(desk.folder.run(run), scenes or (), to=to, out=where))


def seen(desk: Desk, what: str) -> Place:
    """What is to be judged or told.

    Raises:
        SettingsError: There is none, or it is a run that names what lies outside the folder.
    """
    path = desk.folder.there(what)
    return desk.folder.run(what) if (desk.folder.root / path).is_dir() else path


def kept_scenes(run: Run) -> list[str]:
    """The scenes that a run keeps, a line each: what happened, and the id."""
    from chatscene.report.what_happened import outcome_in_words

    return [f"  {outcome_in_words(one.row)}  {one.id}" for one in run.kept]


def _source(desk: Desk, sentence: str | None, file: str | None) -> dict[str, Any]:
    """What is run, as `chatscene.run` takes it."""
    if sentence is not None:
        return {"text": sentence, **desk.reading}
    path = desk.folder.file(file or "", *SITUATIONS, ".scenic", *REPORTS)
    if path.suffix.lower() == ".scenic":
        return {"program": path, "within": desk.folder.root}
    if path.suffix.lower() in REPORTS:
        return {"report": path, **desk.reading}
    return {"text": situation_in(desk, str(path))}


def _said(desk: Desk, said: str | None, said_file: str | None) -> Any:
    """What something is to show, as `chatscene.verify` takes it: never a text that names a file."""
    if said is not None and said_file is not None:
        raise SettingsError("say what it is to show in `said` or in `said_file`, and only one of them")
    if said_file is not None:
        path = desk.folder.file(said_file, *SITUATIONS, *REPORTS)
        return path if path.suffix.lower() in REPORTS else situation_in(desk, said_file)
    if said is not None and said.strip().lower().endswith((*SITUATIONS, *REPORTS)):
        raise SettingsError(f"{said[:60]!r} names a file; give it in `said_file`")
    return said
