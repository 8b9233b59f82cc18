"""What each part of the reader brings on texts of others: how many are read with every fact right, nothing refused.

    python benchmarks/parts_of_reading.py kept kept-second narratives-kept --narratives FOLDER/dev.jsonl

A row for each part alone and for what is taken away from the whole; texts in scope of each set. The paper's way takes
the snippet nearest to the text for behavior, geometry and spawn, each on its own, and is judged by the facts of these.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import click
from labelled import labelled

from chatscene.interpret.decide import decided, likeliest_together, weigh
from chatscene.interpret.nearest import nearest
from chatscene.interpret.trust import account_is_right
from chatscene.library.load import load_library
from chatscene.models.encoders.embedding import load_embedder
from chatscene.read.decompose import hear
from chatscene.read.slot_classifier import PACKAGED, believed_by, load_classifier
from chatscene.settings import RetrievalSettings
from chatscene.studies.facts import differing
from chatscene.terms.conclusions import concluded
from chatscene.terms.frame import Frame
from chatscene.terms.scenario import Component, Slots

SETTINGS = RetrievalSettings()


def paper(frame: Frame) -> Slots:
    library, embedder = load_library(), load_embedder()
    facts: dict[str, object] = {}
    for component in Component:
        snippet = nearest(frame.text, component, library, embedder, count=1, lexical_weight=0.0)[0][0]
        facts |= {name: value for name, value in snippet.slots.said().items() if name not in facts}
        if component is Component.BEHAVIOR:
            facts["adversary"] = snippet.adversaries[0]
    return replace(Slots(), **facts)


def patterns(frame: Frame) -> Slots:
    return concluded(frame.outright)


def account(frame: Frame) -> Slots:
    return concluded(frame.account.slots) if frame.account else Slots()


def classifier(frame: Frame) -> Slots:
    """By the classifier alone, as if neither patterns nor account had found anything or said that there is nothing."""
    own = load_classifier(PACKAGED)
    alone = replace(own, trust={})
    bare = replace(frame, outright=Slots(), account=None, stated=())
    return likeliest_together(replace(bare, beliefs=believed_by(alone, alone.encoders(), bare)), SETTINGS)


def without_account(frame: Frame) -> Slots:
    bare = replace(frame, account=None)
    return likeliest_together(_believed(bare), SETTINGS)


def without_patterns(frame: Frame) -> Slots:
    """The account may stand, patterns count for nothing."""
    told = _believed(replace(frame, outright=Slots()))
    guess = likeliest_together(told, SETTINGS)
    return account(frame) if account_is_right(told, guess) >= 0.5 else guess


def guess(frame: Frame) -> Slots:
    return likeliest_together(_believed(frame), SETTINGS)


def whole(frame: Frame) -> Slots:
    return concluded(frame.outright) if frame.whole else decided(weigh(_believed(frame), SETTINGS)).slots


def _believed(frame: Frame) -> Frame:
    own = load_classifier(PACKAGED)
    return replace(frame, beliefs=believed_by(own, own.encoders(), frame))


WAYS: dict[str, Callable[[Frame], Slots]] = {
    "the paper's way: the nearest snippets": paper,
    "patterns alone": patterns,
    "account alone": account,
    "classifier alone": classifier,
    "all, the account never a reading of its own": guess,
    "all but the account": without_account,
    "all but the patterns": without_patterns,
    "all": whole,
}


@click.command()
@click.argument("sets", nargs=-1, required=True)
@click.option("--narratives", type=click.Path(exists=True, dir_okay=False, path_type=Path))
def main(sets: tuple[str, ...], narratives: Path | None) -> None:
    for name in sets:
        texts = [(hear(text), said) for _, text, in_scope, said in labelled(name, narratives) if in_scope]
        print(f"{name}, {len(texts)} in scope")
        for way, slots_of in WAYS.items():
            right = sum(not differing(said, slots_of(frame)) for frame, said in texts)
            print(f"  {way}: {right}", flush=True)


if __name__ == "__main__":
    main()
