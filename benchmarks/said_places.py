"""How many recorded readings of fresh texts get the road that they say, and what the road of the others lacks.

    python benchmarks/said_places.py [--each] [--file benchmarks/reading/fresh-seventh.jsonl ...]

Each line of a file has a `text` and the `replies` of a language model; no model is asked. The last reply is read and
built, as for a user's text. A built situation lacks something of its place where a fact of the road is left out, or
where the program says so (`… since no map has …`, `… where the map has no …`). Prints for each file how many are built
with all of it, built without some of it, and refused since no place was found; and which facts are lacking.
"""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

import click
from recorded_replies import Recorded, recorded

from chatscene.build.build import Built, build
from chatscene.errors import LanguageModelError, NotBuilt
from chatscene.models.language.checked import CheckedModel
from chatscene.models.language.scripted import Scripted
from chatscene.read.by_model import LIMITS, ModelReader

FOLDER = Path(__file__).parent / "reading"
FILES = tuple(FOLDER / f"fresh-{name}.jsonl" for name in ("third", "fourth", "seventh"))
LACKS = re.compile(r"since no (?:map|suitable road) has|where the map has no|the ego has a stop sign too")
NOWHERE = re.compile(r"no map has such a place|the longest road has|the road that it comes from is too short")


def built(one: Recorded) -> Built | str:
    """What the last reply to a text is built as; why not, in words."""
    script = Scripted([one.replies[-1]] * (1 + LIMITS.reasks))
    reader = ModelReader(CheckedModel(script, limits=LIMITS), lambda _: "")
    try:
        read = reader.read(one.text)
        return build(read.ranked[0].situation) if read.ranked else "no situation"
    except (LanguageModelError, NotBuilt) as error:
        return str(error)


def lacking(made: Built) -> list[str]:
    """What of its place a program lacks, in words."""
    left_out = [one for one in made.left_out if one.startswith("road.")]
    return left_out + [one for one in made.assumed if LACKS.search(one)]


def _kind(told: str) -> str:
    """The same without who it is about."""
    return re.sub(r"road\.has\.\d+", "road.has", re.sub(r"^\w+ (?=crosses|starts)", "somebody ", told))


@click.command()
@click.option("--file", "files", type=click.Path(path_type=Path), multiple=True, default=FILES)
@click.option("--each", is_flag=True, help="Print a line for each text.")
def main(files: tuple[Path, ...], each: bool) -> None:
    """Count the places that recorded readings get."""
    for file in files:
        counts, what, laid = Counter[str](), Counter[str](), 0
        for one in recorded(file, file):
            made = built(one)
            if isinstance(made, str):
                outcome, lacks = ("no place" if NOWHERE.search(made) else "no program for other reasons"), [made]
            else:
                lacks = lacking(made)
                outcome = "without some of it" if lacks else "with all of it"
                laid += made.map.startswith("road:")
                what.update(map(_kind, lacks))
            counts[outcome] += 1
            if each and outcome != "no program for other reasons":
                where = made.map if not isinstance(made, str) else "-"
                print(f"{one.id}\t{outcome}\t{where}\t{'; '.join(lacks)}", flush=True)
        print(f"{file.stem}: {', '.join(f'{many} {name}' for name, many in sorted(counts.items()))}; {laid} roads laid")
        for told, many in what.most_common():
            print(f"  {many:3d}  {told}", flush=True)


if __name__ == "__main__":
    main()
