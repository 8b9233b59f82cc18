"""What checkers and independent readers make of kept scenes: the table of docs/exports.md, from one folder of runs.

    python benchmarks/exported.py keep RUNS --kept 100
    python benchmarks/exported.py check RUNS --esmini libesminiLib.so --gym GYM --read READ --drive DRIVE

`keep` makes runs of the packaged held-out sentences, in their order, until so many scenes are kept. `check` exports
them, asks ASAM's checkers, which must be installed here, and hands the files to the readers that are given: esmini's
library, and the Pythons of environments that `played_elsewhere.py` and `commonroad_elsewhere.py` say how to make.
"""

from __future__ import annotations

import json
import logging
import subprocess
import sys
from collections import Counter
from importlib import import_module
from importlib.metadata import version
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import click

import chatscene
from chatscene.errors import ChatSceneError, RunError

HERE = Path(__file__).parent
TEXTS = Path(__file__).with_name("held-out.jsonl")


@click.group()
def main() -> None:
    """See the head of this file."""


@main.command()
@click.argument("folder", type=click.Path(path_type=Path))
@click.option("--kept", default=100, show_default=True)
@click.option("--scenes", default=10, show_default=True)
@click.option("--ego", default="idm", show_default=True)
def keep(folder: Path, kept: int, scenes: int, ego: str) -> None:
    """Make runs until so many scenes are kept; a folder per sentence, named by its number."""
    count: Counter[str] = Counter()
    for number, line in enumerate(TEXTS.read_text(encoding="utf-8").splitlines(), 1):
        if count["kept"] >= kept:
            break
        try:
            run = chatscene.run(json.loads(line)["text"], folder / f"{number:03}", scenes=scenes, ego=ego, seed=0)
        except ChatSceneError as error:
            count["refused"] += 1
            click.echo(f"{number:3} {type(error).__name__}")
            continue
        count["served"] += 1
        count["kept"] += len(run.kept)
        click.echo(f"{number:3} {len(run.kept)} kept")
    click.echo(", ".join(f"{what} {number}" for what, number in count.items()))


@main.command()
@click.argument("folder", type=click.Path(path_type=Path, exists=True))
@click.option("--esmini", type=click.Path(path_type=Path), help="Its library.")
@click.option("--gym", help="Python of an environment with scenario-gym.")
@click.option("--read", help="Python of an environment with commonroad-io.")
@click.option("--drive", help="Python of an environment with CommonRoad's drivability checker.")
def check(folder: Path, esmini: Path | None, gym: str | None, read: str | None, drive: str | None) -> None:
    """Export all kept scenes, and print what is found in them."""
    with TemporaryDirectory() as name:
        out = Path(name)
        for form in ("openscenario", "commonroad", "csv", "opendrive"):
            (out / form).mkdir()
            count = exported(folder, form, out / form)
            click.echo(f"{form}: {count['scenes']} scenes, {count['files']} files, {count['refused']} runs without any")
        click.echo(judged("qc_openscenario", "openscenarioxml", sorted((out / "openscenario").glob("*.xosc"))))
        click.echo(judged("qc_opendrive", "opendrive", sorted((out / "opendrive").glob("*.xodr"))))
        played = [sys.executable, str(HERE / "esmini_plays.py"), str(esmini), *_of(out, "openscenario"), "--near", "0"]
        asked = {
            "esmini": esmini and played,
            "scenario-gym": gym and [gym, str(HERE / "played_elsewhere.py"), *_of(out, "openscenario")],
            "commonroad-io": read and [read, str(HERE / "commonroad_elsewhere.py"), *_of(out, "commonroad")],
            "drivability": drive and [drive, str(HERE / "commonroad_elsewhere.py"), *_of(out, "commonroad"), "--drive"],
        }
        for reader, command in asked.items():
            if command:
                done = subprocess.run(command, capture_output=True, text=True, check=False)
                click.echo(f"{reader}: exit status {done.returncode}")
                click.echo(done.stdout + done.stderr[-2000:] * (done.returncode != 0))


def _of(out: Path, form: str) -> tuple[str, str]:
    return str(out / form), str(out / "csv")


def exported(folder: Path, form: str, out: Path) -> Counter[str]:
    """Every run of a folder in a format, all files in one folder."""
    count: Counter[str] = Counter(scenes=0, files=0, refused=0)
    for number, run in enumerate(sorted(path.parent for path in folder.glob("*/run.json"))):
        try:
            done = chatscene.export(run, to=form, out=out / str(number))
        except RunError:
            count["refused"] += 1
            continue
        count["scenes"] += len(done.files)
        for file in done.folder.iterdir():
            file.replace(out / file.name)
        done.folder.rmdir()
    count["files"] = sum(1 for _ in out.iterdir())
    return count


def judged(package: str, name: str, paths: list[Path]) -> str:
    """What one of ASAM's checkers finds in files, in words."""
    logging.disable(logging.WARNING)
    baselib: Any = import_module("qc_baselib")
    bundle, run = import_module(f"{package}.constants").BUNDLE_NAME, import_module(f"{package}.main").run_checks
    issues: Counter[str] = Counter()
    rules: Counter[str] = Counter()
    for path in paths:
        configuration, result = baselib.Configuration(), baselib.Result()
        configuration.set_config_param("InputFile", str(path))
        result.register_checker_bundle(name=bundle, description="", version="1", summary="")
        result.set_result_version("1")
        run(configuration, result)
        for checker in result.get_checker_bundle_result(bundle).checkers:
            rules[checker.status.value] += 1
            issues.update(issue.description for issue in checker.issues)
    found = "; ".join(f"{count} times: {what}" for what, count in issues.most_common(5)) or "nothing wrong"
    ran = ", ".join(f"{count} {status}" for status, count in rules.items())
    return f"asam-qc-{name} {version(f'asam-qc-{name}')}: {len(paths)} files, rules {ran}; {found}"


if __name__ == "__main__":
    main()
