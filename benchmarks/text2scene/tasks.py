"""The tasks of the benchmark, and their texts.

    python benchmarks/text2scene/tasks.py > texts.jsonl
    python benchmarks/text2scene/tasks.py --clones FOLDER > texts.jsonl

    python benchmarks/text2scene/tasks.py --each FOLDER

prints the id and the text of each task, for the system that is to be measured, or writes a file of each. A text
lies in a file of this repository, or in a public repository at a commit: these are read from clones in FOLDER, named
as on GitHub without the owner. Texts whose clone is missing are left out, and how many is told.
"""

from __future__ import annotations

import hashlib
import json
import subprocess
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import click

from chatscene.situations.form import from_plain
from chatscene.terms.situation import Situation

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
TASKS = HERE / "tasks.jsonl"
HASHED = 16  # digits of the hash of a text that are kept


@dataclass(frozen=True, slots=True, kw_only=True)
class Task:
    """A text of somebody else, and what a scene of it must show.

    Attributes:
        id: Also the name of an answer's file, without its ending.
        split: The source.
        voice: In whose voice it is written, as the source says.
        by: Who wrote the text: ``person`` or ``language model``.
        licence: Of the text, as SPDX names it.
        readers: How many readers, of whom none saw what another said, agree on its facts.
        at: Where the text is: ``file`` and ``row`` here, or ``repository``, ``commit``, ``path`` and ``chars`` there.
        sha256: The first digits of the hash of the text.
        situation: Its facts.
    """

    id: str
    split: str
    voice: str
    by: str
    licence: str
    readers: int
    at: Mapping[str, Any]
    sha256: str
    situation: Mapping[str, Any]

    @property
    def facts(self) -> Situation:
        """What a scene must show."""
        return from_plain(self.situation)


class NoTextError(Exception):
    """The text of a task cannot be read; the message says why."""


def tasks(path: Path = TASKS) -> tuple[Task, ...]:
    """All tasks of a file."""
    return tuple(Task(**json.loads(line)) for line in path.read_text(encoding="utf-8").splitlines())


def text_of(task: Task, clones: Path | None) -> str:
    """The text of a task.

    Raises:
        NoTextError: Its clone is missing, or what stands there is not the text of which the facts were noted.
    """
    at = task.at
    if "file" in at:
        text = str(json.loads(_lines(ROOT / at["file"])[at["row"]])["text"])
    else:
        begin, end = at["chars"]
        text = plain(_shown(clones, at["repository"], at["commit"], at["path"])[begin:end])
    if hashed(text) != task.sha256:
        raise NoTextError(f"{task.id}: the text at {dict(at)} is another one than that of which the facts were noted")
    return text


def plain(found: str) -> str:
    """A passage of a file as one line, without what marks a list or a comment at the head of a line."""
    return " ".join(found.replace("\n#", "\n").replace("**", "").split())


def hashed(text: str) -> str:
    """The digits by which a text is known again."""
    return hashlib.sha256(text.encode()).hexdigest()[:HASHED]


@cache
def _lines(path: Path) -> list[str]:
    return path.read_text(encoding="utf-8").splitlines()


@cache
def _shown(clones: Path | None, repository: str, commit: str, path: str) -> str:
    """A file of a clone at a commit.

    Raises:
        NoTextError: There is no such clone, or no such commit or file in it.
    """
    name = repository.rpartition("/")[2]
    if clones is None or not (clones / name).exists():
        raise NoTextError(f"in a clone of https://github.com/{repository}; give --clones, a folder with it")
    asked = ["git", "-C", str(clones / name), "show", f"{commit}:{path}"]
    made = subprocess.run(asked, capture_output=True, text=True, encoding="utf-8", check=False)
    if made.returncode != 0:
        raise NoTextError(f"{path} of {repository} cannot be read: {made.stderr.strip()}")
    return made.stdout


def texts(clones: Path | None, missing: Counter[str]) -> Iterator[tuple[Task, str]]:
    """Each task whose text can be read; counts the others by why not."""
    for task in tasks():
        try:
            yield task, text_of(task, clones)
        except NoTextError as error:
            missing[str(error)] += 1


@click.command()
@click.option("--clones", type=click.Path(exists=True, file_okay=False, path_type=Path))
@click.option("--split", "splits", multiple=True, help="Only those of this source; may be given several times.")
@click.option("--each", type=click.Path(file_okay=False, path_type=Path), help="A folder for a file of each task.")
def main(clones: Path | None, splits: tuple[str, ...], each: Path | None) -> None:
    """Print the id and the text of each task."""
    missing = Counter[str]()
    if each is not None:
        each.mkdir(parents=True, exist_ok=True)
    for task, text in texts(clones, missing):
        if splits and task.split not in splits:
            continue
        line = json.dumps({"id": task.id, "split": task.split, "text": text}, ensure_ascii=False)
        if each is None:
            click.echo(line)
        else:
            (each / f"{task.id}.json").write_text(f"{line}\n", encoding="utf-8")
    for why, number in missing.items():
        click.echo(f"{number} left out: {why}", err=True)


if __name__ == "__main__":
    main()
