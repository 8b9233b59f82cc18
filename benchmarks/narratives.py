"""Crash narratives one by one: what was read, what was missed, and whether the drives show what people wrote down.

    python benchmarks/narratives.py narratives-kept FOLDER/dev.jsonl --count 50

The labels of a set are by id; the texts are in FOLDER. Every text that is served is searched as a run does, by default
10 scenes on one route with seed 0 against the ego `idm`; a scene shows the narrative if its tracks show every fact
that was written down, whatever the reader made of the text. Prints a line each, as a table, and totals.
"""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from tempfile import TemporaryDirectory

import click
from labelled import TEXTS, labelled
from shown import silent
from slots_read import differing

from chatscene import pipeline, runs
from chatscene.errors import ChatSceneError, NothingFits
from chatscene.maps.network import map_with, resolve_map
from chatscene.program.meaning import check_meaning
from chatscene.runs.executor import ONE
from chatscene.runs.rebuild import rebuild
from chatscene.search.climb import simulator_of
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings, SearchSettings, Settings
from chatscene.terms.scenario import Slots
from chatscene.terms.slots import SLOTS


@click.command()
@click.argument("name")
@click.argument("narratives", type=click.Path(exists=True, dir_okay=False, path_type=Path))
@click.option("--count", default=50, show_default=True)
@click.option("--scenes", default=10, show_default=True)
@click.option("--ego", default="idm", show_default=True)
def main(name: str, narratives: Path, count: int, scenes: int, ego: str) -> None:
    settings, totals = Settings(search=SearchSettings(scenes=scenes, seed=0)), Counter[str]()
    lines = (TEXTS / f"{name}.jsonl").read_text().splitlines()
    ids = [str(json.loads(line).get("id", number)) for number, line in enumerate(lines)]
    rows = labelled(name, narratives)
    print("| id | | confidence | read right | missed or wrong | scenes that show it |\n|---|---|---:|---|---|---|")
    for one, (_, text, in_scope, said) in list(zip(ids, rows, strict=True))[:count]:
        what, confidence, read = _read(text)
        totals[f"{what}, {'in' if in_scope else 'out of'} scope"] += 1
        wrong = differing(said, read) if in_scope else ()
        right = [slot for slot in (*SLOTS, "actions") if getattr(said, slot) and slot not in wrong] if in_scope else []
        shown = _shown(text, said, settings, ego) if what == "served" and in_scope else ""
        totals["every fact right"] += what == "served" and in_scope and not wrong
        totals["shown in some scene"] += bool(shown) and not shown.startswith(("0", "none"))
        scope = "" if in_scope else ", out of scope"
        print(
            f"| {one} | {what}{scope} | {confidence:.2f} | {', '.join(right)} | {', '.join(wrong)} | {shown} |",
            flush=True,
        )
    print(dict(totals))


def _read(text: str) -> tuple[str, float, Slots]:
    generator, settings = Retrieved(), RetrievalSettings()
    scenario = generator.read(text, settings)
    try:
        return "served", generator.write(scenario, settings).retrieval.confidence, scenario.slots
    except NothingFits as refusal:
        return "refused", refusal.confidence or 0.0, scenario.slots


def _shown(text: str, said: Slots, settings: Settings, ego: str) -> str:
    """How many of the scenes that ran show the facts that were written down."""
    with TemporaryDirectory() as folder:
        run = runs.create(Path(folder) / "run", runs.asked_run(text, settings=settings, ego=ego))
        try:
            pipeline.search(run, ONE, silent)
        except ChatSceneError as error:
            return f"none: {type(error).__name__}"
        made = rebuild(run)
        scenario, program = made.scenario, made.program
        where = resolve_map(map_with(scenario.slots.site))
        route = simulator_of(Retrieved(), where, settings).route(program, 0)
        ran = [row["scene_id"] for row in runs.read_scenes(run) if row["status"] == "ran"]
        shown = sum(not check_meaning(said, runs.read_episode(run, scene), route) for scene in ran)
        return f"{shown} of {len(ran)}"


if __name__ == "__main__":
    main()
