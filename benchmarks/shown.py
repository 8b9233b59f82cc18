"""How many of the scenes that are kept show what their sentence says, acts in order.

    python benchmarks/shown.py src/chatscene/search/generators/benchmark_scenarios.json

A file of sentences, one a line or strings in lists of JSON, however nested. Each is searched as a run does, by
default 50 scenes on one route with seed 0 against the ego `sac`; of the same scenes, it is told what the run would
keep with a look at what was shown, and by the paper's rule, which does not look. Prints a line per sentence and totals.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import click

from chatscene import pipeline, runs
from chatscene.errors import ChatSceneError, MeansSomethingElse, NothingFits
from chatscene.maps.network import resolve_map
from chatscene.program.meaning import check_meaning
from chatscene.runs.executor import ONE
from chatscene.runs.rebuild import rebuild
from chatscene.search.climb import simulator_of
from chatscene.search.generators.retrieved import Retrieved
from chatscene.search.select import Candidate, select
from chatscene.settings import SearchSettings, Settings

RULES = ("worst", "shown")  # the paper's selection, and a run's


@click.command()
@click.argument("sentences", type=click.Path(path_type=Path, exists=True, dir_okay=False))
@click.option("--scenes", default=50, show_default=True)
@click.option("--seed", default=0, show_default=True)
@click.option("--ego", default="sac", show_default=True)
def main(sentences: Path, scenes: int, seed: int, ego: str) -> None:
    """Search with every sentence of a file and count what the kept scenes show."""
    settings = Settings(search=SearchSettings(scenes=scenes, seed=seed))
    total: Counter[str] = Counter()
    for number, text in enumerate(texts_in(sentences), 1):
        found, line = searched(text, settings, ego)
        total += found
        click.echo(f"{number:3} {line}")
    click.echo(f"{total['served']} sentences served, {total['refused']} refused, {total['failed']} failed")
    click.echo(
        f"{total['ran']} scenes, {total['collided']} collisions, of which {total['shown crashes']} show what was said"
    )
    for rule in RULES:
        kept = total[f"kept {rule}"]
        click.echo(
            f"kept by {rule!r}: {kept}, of which {total[f'collided {rule}']} collided; "
            f"{total[f'shown {rule}']} show what was said "
            f"({total[f'done {rule}']} of them to the end of each act, before any contact), "
            f"{total[f'no act {rule}']} not even one of its acts"
        )


def texts_in(path: Path) -> list[str]:
    """The sentences of a file: strings in lists of a JSON file, lines of any other."""
    content = path.read_text(encoding="utf-8")
    if path.suffix != ".json":
        return [line.strip() for line in content.splitlines() if line.strip()]
    return list(_strings(json.loads(content)))


def _strings(value: Any) -> Iterator[str]:
    inside = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    for one in inside:
        if isinstance(one, str) and isinstance(value, list):
            yield one
        else:
            yield from _strings(one)


def searched(text: str, settings: Settings, ego: str) -> tuple[Counter[str], str]:
    """What one sentence adds to the totals, and its line."""
    with TemporaryDirectory() as folder:
        run = runs.create(Path(folder) / "run", runs.asked_run(text, settings=settings, ego=ego))
        try:
            pipeline.search(run, ONE, silent)
        except (NothingFits, MeansSomethingElse) as error:
            return Counter(refused=1), f"refused: {error}: {text}"
        except ChatSceneError as error:
            return Counter(failed=1), f"failed: {type(error).__name__}: {error}: {text}"
        rows = {row["scene_id"]: row for row in runs.read_scenes(run) if row["status"] == "ran"}
        candidates = [
            Candidate(
                scene_id=name,
                collided=row["collision"],
                shown=row["meaning_ok"],
                avoidable=row["avoidable"],
                overall_score=row["overall_score"],
            )
            for name, row in rows.items()
        ]
        chosen = {rule: select(candidates, count=settings.search.keep, selection=rule) for rule in RULES}
        made = rebuild(run)
        scenario, program = made.scenario, made.program
        route = simulator_of(Retrieved(), resolve_map("town"), settings).route(program, 0)
        done = {
            one.scene_id: not check_meaning(scenario.slots, runs.read_episode(run, one.scene_id), route, through=True)
            for one in {*chosen["worst"], *chosen["shown"]}
        }
    acts = len(scenario.slots.actions)
    crashes = [row for row in rows.values() if row["collision"]]
    counts = Counter(served=1, ran=len(rows), collided=len(crashes))
    counts["shown crashes"] = sum(row["meaning_ok"] for row in crashes)
    for rule in RULES:
        kept = [rows[one.scene_id] for one in chosen[rule]]
        counts[f"kept {rule}"] = len(kept)
        counts[f"collided {rule}"] = sum(row["collision"] for row in kept)
        counts[f"shown {rule}"] = sum(row["meaning_ok"] for row in kept)
        counts[f"done {rule}"] = sum(done[row["scene_id"]] for row in kept)
        missing = [
            sum(f.startswith("action") and "other way" not in f for f in row["meaning_failures"]) for row in kept
        ]
        counts[f"no act {rule}"] = sum(acts > 0 and lacks == acts for lacks in missing)
    lacking = Counter(f for row in rows.values() if not row["meaning_ok"] for f in row["meaning_failures"])
    often = f"; most often {lacking.most_common(1)[0][0]!r} ({lacking.most_common(1)[0][1]})" if lacking else ""
    return counts, (
        f"ran {counts['ran']}, collided {counts['collided']}, of these shown {counts['shown crashes']}; kept shown: "
        f"worst {counts['shown worst']}/{counts['kept worst']}, shown {counts['shown shown']}/{counts['kept shown']}"
        f"{often}; {' + '.join(program.snippet_ids)}: {text}"
    )


def silent(what: str, done: int, total: int) -> None:
    """No progress: a line per sentence says enough."""


if __name__ == "__main__":
    main()
