"""Count the words of the texts that the reader learned from, and how often each told a fact.

    python -m making.reader.words --told FILE... --other FILE... --out src/chatscene/read/learned/words.gz

Files of `--told` have situations with the words of each fact; of `--other`, lines with a text or an edit, only the
words are taken. No seed; the same files give the same bytes.
"""

from __future__ import annotations

import gzip
import json
from collections import Counter
from pathlib import Path

import click

from chatscene.read.learned.words import PACKAGED, stems_in
from chatscene.read.quotes import says_nothing, spans_of
from making.reader.texts import told_in


def counted(told: tuple[Path, ...], others: tuple[Path, ...]) -> tuple[Counter[str], Counter[str]]:
    """How often each stem was seen in texts with quotes, or 0 if only in others, and how often it told a fact."""
    seen, tells = Counter[str](), Counter[str]()
    for path in told:
        for text, _, situation in told_in(path):
            quotes = situation.evidence.quoted.values() if situation is not None else ()
            spans = [span for words in quotes for span in spans_of(words, text)]
            at = 0
            for word in text.split():
                at = text.index(word, at)
                stems = [] if says_nothing(word) else stems_in(word)
                seen.update(stems)
                tells.update(stems if any(low <= at < high for low, high in spans) else ())
                at += len(word)
    for path in others:
        for line in path.read_text(encoding="utf-8").splitlines():
            row = json.loads(line)
            words = " ".join(str(row.get(name, "")) for name in ("text", "edit"))
            seen.update(dict.fromkeys(stems_in(words), 0))
    return seen, tells


@click.command()
@click.option("--told", multiple=True, type=click.Path(path_type=Path, exists=True), required=True)
@click.option("--other", multiple=True, type=click.Path(path_type=Path, exists=True))
@click.option("--out", type=click.Path(path_type=Path), default=PACKAGED)
def main(told: tuple[Path, ...], other: tuple[Path, ...], out: Path) -> None:
    """Write the counts."""
    seen, tells = counted(told, other)
    lines = "\n".join(f"{stem} {seen[stem]} {tells[stem]}" for stem in sorted(seen))
    out.write_bytes(gzip.compress(lines.encode("utf-8"), 9, mtime=0))
    click.echo(f"{len(seen)} stems, {sum(tells.values()) / sum(seen.values()):.2f} of all words tell a fact")


if __name__ == "__main__":
    main()
