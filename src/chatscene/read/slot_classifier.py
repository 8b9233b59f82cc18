"""What a sentence says, by an encoder trained on sentences of ours and on texts of others.

The patterns of `chatscene.read` are right where they match and silent where they do not; a classifier is never silent
and seldom sure. Here is the classifier: MiniLM with its upper layers trained further, and on its states one head per
slot, one for the actions, one over the behaviors of the library and one for whether it is a driving scenario at all,
each with its own attention over the words. Several, trained apart, are averaged. How much the patterns and the
account count beside them was fitted on texts that members had not seen (decisions 0017 and 0073).
`chatscene.grow.course` says what it learns from, `chatscene.grow.fit` trains it.
"""

from __future__ import annotations

import zipfile
import zlib
from collections.abc import Mapping, Sequence
from dataclasses import astuple, dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.errors import SnippetError
from chatscene.files.bounded import check_archive
from chatscene.models.encoders.embedding import MiniLM
from chatscene.read.lexicon import KINDS
from chatscene.terms.acts import Action
from chatscene.terms.frame import Beliefs, Frame
from chatscene.terms.scenario import Slots
from chatscene.terms.slots import SLOTS

NAME = "slot_classifier.npz"
PACKAGED = Path(__file__).parent / NAME
BEHAVIOR = "behavior"  # the head over the behaviors' ids
SCOPE = "scope"  # the head that tells what a library of driving scenarios can serve at all
NOT_SAID = ""  # the class of a slot that the sentence leaves open

VALUES = {name: tuple(map(str, slot.values)) for name, slot in SLOTS.items()}  # as names of classes
HEADS = (*VALUES, "actions", BEHAVIOR, SCOPE)
TRUSTED = (*VALUES, "actions")  # of which the patterns know something

Floats = NDArray[np.float32]


@dataclass(frozen=True, slots=True)
class Trust:
    """How a slot is decided from the classifier's log-odds, the patterns and the account: their log-odds are added.

    Attributes:
        odds: Factor of the classifier's log-odds.
        found: Added to what the patterns found.
        silent: Added to what they did not find: to "not said" where they found no value, to an action they missed.
        told: Added to what the account says.
        untold: Added to what it does not say, as `silent` is.
    """

    odds: float = 1.0
    found: float = 0.0
    silent: float = 0.0
    told: float = 0.0
    untold: float = 0.0

    def joined(self, odds: Floats, marks: Floats, account: Floats) -> Floats:
        """Log-odds from the classifier's, and the marks of patterns and account: 1 found, -1 not found, 0 neither."""
        joined = self.odds * odds + np.where(marks > 0, self.found, 0.0) + np.where(marks < 0, self.silent, 0.0)
        return joined + np.where(account > 0, self.told, 0.0) + np.where(account < 0, self.untold, 0.0)


@dataclass(frozen=True, slots=True, eq=False)
class Member:
    """One trained encoder and its heads.

    Attributes:
        changes: What was trained of the encoder: what to add to the bytes of its file, by where they stand.
        queries: (heads, D), what each head attends to.
        weights: (D, columns), a column per class of each head in order.
        bias: (columns,).
    """

    changes: Mapping[int, bytes]
    queries: Floats
    weights: Floats
    bias: Floats

    def log_odds(self, states: Floats) -> Floats:
        """(heads, columns) log-odds of each class as each head sees it, from the encoder's states, (tokens, D).

        Not with ``@``: how linear algebra sums depends on how many threads it has, which whoever imports NumPy before
        us decides (decision 0027); `einsum` has one.
        """
        told = states.astype(np.float64)
        heed = np.einsum("td,hd->th", told, self.queries)
        share = np.exp(heed - heed.max(axis=0))
        pooled = np.einsum("th,td->hd", share / share.sum(axis=0), told)
        return (np.einsum("hd,dc->hc", pooled, self.weights) + self.bias).astype(np.float32)


@dataclass(frozen=True, slots=True, eq=False)
class SlotClassifier:
    """Members that were trained apart, whose log-odds are averaged: where they err, they seldom err alike.

    Attributes:
        members: At least one.
        classes: Of each of `HEADS`.
        trust: Per slot, and for actions, how much the members count beside the patterns.
    """

    members: tuple[Member, ...]
    classes: Mapping[str, tuple[str, ...]]
    trust: Mapping[str, Trust]

    def encoders(self) -> tuple[MiniLM, ...]:
        """The encoder of each member."""
        return tuple(MiniLM(member.changes) for member in self.members)

    def log_odds(self, states: Sequence[Floats]) -> dict[str, Floats]:
        """(classes,) log-odds of each head from the states of a sentence, (tokens, D), of each member's encoder."""
        told = [member.log_odds(each) for member, each in zip(self.members, states, strict=True)]
        odds = np.mean(told, axis=0)
        found: dict[str, Floats] = {}
        first = 0
        for row, (name, classes) in zip(odds, self.classes.items(), strict=True):
            found[name] = row[first : first + len(classes)]
            first += len(classes)
        return found

    def classify(self, states: Sequence[Floats], rules: Slots, account: Slots | None = None) -> Beliefs:
        """How likely each value of each slot, each action and each behavior is.

        Args:
            states: The states of the sentence, (tokens, D), of each member's encoder.
            rules: What the patterns found in it.
            account: What was made out of it clause by clause; None where nothing was.
        """
        slots: dict[str, dict[str, float]] = {}
        for name, odds in self.log_odds(states).items():
            classes = self.classes[name]
            joined = odds
            if name in self.trust:
                marks = rule_marks(name, classes, rules), rule_marks(name, classes, account)
                joined = self.trust[name].joined(odds, *marks)
            likely = 1 / (1 + np.exp(-joined)) if name == "actions" else _softmax(joined)
            slots[name] = dict(zip(classes, likely.tolist(), strict=True))
        return Beliefs(
            slots={name: {as_value(name, v): p for v, p in slots[name].items()} for name in VALUES if name in slots},
            actions={Action(name): p for name, p in slots["actions"].items()},
            behaviors=slots[BEHAVIOR],
            in_scope=slots[SCOPE]["True"],
        )


def _softmax(x: Floats) -> Floats:
    e = np.exp(x - x.max())
    return e / e.sum()


def rule_marks(head: str, classes: Sequence[str], rules: Slots | None) -> Floats:
    """(classes,) 1 for what rules found; -1 for "not said" where they found nothing, and no action found; 0 without."""
    if rules is None:
        return np.zeros(len(classes), np.float32)
    if head == "actions":
        return np.array([1.0 if name in rules.actions else -1.0 for name in classes], np.float32)
    found = as_class(getattr(rules, head))
    return np.array([(1.0 if name else -1.0) if name == found else 0.0 for name in classes], np.float32)


def as_class(value: object) -> str:
    """A slot's value as the name of its class."""
    return NOT_SAID if value is None else str(value)


def as_value(slot: str, name: str) -> Any:
    """The value of a slot from the name of its class."""
    if name == NOT_SAID:
        return None
    return next(value for value in SLOTS[slot].values if str(value) == name)


def classes_of(head: str, behaviors: Sequence[str]) -> tuple[str, ...]:
    """The classes of a head."""
    if head == "actions":
        return tuple(Action)
    if head == SCOPE:
        return ("False", "True")
    return tuple(behaviors) if head == BEHAVIOR else (NOT_SAID, *VALUES[head])


# Files


def save_classifier(classifier: SlotClassifier, path: Path) -> None:
    """Write a classifier: arrays only, a row per member. The same places of the encoder's file change in each."""
    members = classifier.members
    changes = b"".join(b"".join(member.changes.values()) for member in members)
    packer = zlib.compressobj(strategy=zlib.Z_HUFFMAN_ONLY)  # small numbers without repeats (decision 0042)
    np.savez_compressed(
        path,
        at=np.array(list(members[0].changes), np.int64),
        lengths=np.array([len(new) for new in members[0].changes.values()], np.int64),
        changes=np.frombuffer(packer.compress(changes) + packer.flush(), np.uint8),
        classes=np.array("\n".join(f"{head}\t" + "\t".join(names) for head, names in classifier.classes.items())),
        queries=np.stack([member.queries for member in members]),
        weights=np.stack([member.weights for member in members]).astype(np.float16),
        bias=np.stack([member.bias for member in members]),
        trust=np.array([astuple(t) for t in classifier.trust.values()]),
    )


@lru_cache(maxsize=2)
def load_classifier(path: Path = PACKAGED) -> SlotClassifier:
    """Read a classifier.

    Raises:
        SnippetError: The file is missing or damaged.
    """
    try:
        check_archive(path)
        with np.load(path, allow_pickle=False) as arrays:
            ends = np.cumsum(arrays["lengths"]).tolist()
            places = list(zip(arrays["at"].tolist(), [0, *ends[:-1]], ends, strict=True))
            _check_places(path, [(at, b - a) for at, a, b in places])
            queries = arrays["queries"]
            unpacked = zlib.decompressobj().decompress(arrays["changes"].tobytes(), len(queries) * ends[-1])
            changes = np.frombuffer(unpacked, np.uint8).reshape(len(queries), ends[-1])
            rows = zip(changes, queries, arrays["weights"].astype(np.float32), arrays["bias"], strict=True)
            named = [line.split("\t") for line in str(arrays["classes"]).split("\n")]
            trust = [Trust(*row) for row in arrays["trust"].tolist()]
            classes = {head: tuple(names) for head, *names in named}
            return SlotClassifier(
                members=tuple(
                    Member({at: changes[a:b].tobytes() for at, a, b in places}, queries, weights, bias)
                    for changes, queries, weights, bias in rows
                ),
                classes=classes,
                trust=dict(zip([head for head in classes if head in TRUSTED], trust, strict=True)),
            )
    except (OSError, ValueError, KeyError, TypeError, MemoryError, zipfile.BadZipFile, zlib.error) as error:
        raise SnippetError(
            f"the slot classifier {path} cannot be read ({error}); train it again with: chatscene library fit"
        ) from error


def _check_places(path: Path, places: list[tuple[int, int]]) -> None:
    """Refuse to change the encoder's file elsewhere than the packaged classifier does, where only weights lie.

    Raises:
        ValueError: It would.
    """
    if path == PACKAGED:
        return
    trained = load_classifier(PACKAGED).members[0].changes
    if places != [(at, len(new)) for at, new in trained.items()]:
        raise ValueError("it would change the encoder elsewhere than training does")


@lru_cache(maxsize=2)
def _trained(path: Path) -> tuple[SlotClassifier, tuple[MiniLM, ...]]:
    classifier = load_classifier(path)
    return classifier, classifier.encoders()


def believe(frame: Frame, own: str = "") -> Beliefs:
    """How likely each fact is in a sentence.

    Args:
        frame: The sentence, and what its words say outright.
        own: Folder of one's own snippets; the classifier trained on them is used if it lies there, else the packaged.
    """
    at = Path(own) / NAME
    classifier, encoders = _trained(at if own and at.exists() else PACKAGED)
    return believed_by(classifier, encoders, frame)


def believed_by(classifier: SlotClassifier, encoders: Sequence[MiniLM], frame: Frame) -> Beliefs:
    """How likely a classifier finds each fact in a sentence.

    A kind of road user that it was not trained on is heard as what it is like; a slot without a head is absent.

    Args:
        classifier: Who is asked.
        encoders: Of its members.
        frame: The sentence, and what its words say outright.
    """
    kind, account = frame.outright.adversary, frame.account.slots if frame.account else None
    if kind is None or kind.lies or kind.acts_as is kind or str(kind) in classifier.classes["adversary"]:
        return classifier.classify([encoder.states(frame.told) for encoder in encoders], frame.outright, account)
    text, known = KINDS[kind].sub(kind.acts_as.noun, frame.told), replace(frame.outright, adversary=kind.acts_as)
    if account and account.adversary is kind:
        account = replace(account, adversary=kind.acts_as)
    beliefs = classifier.classify([encoder.states(text) for encoder in encoders], known, account)
    who = {kind if value is kind.acts_as else value: p for value, p in beliefs.slots["adversary"].items()}
    return replace(beliefs, slots={**beliefs.slots, "adversary": who})
