"""What a classifier learns from, and members that leave some of it out.

Sentences of ours say what the library has, in every style of ours; texts of others say it as people do. A source is
one writer's texts: whether a reading is right can only be told on sources that its classifier has not seen.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from chatscene.grow.compose_texts import Labelled, compose, wordings
from chatscene.grow.fit import Classes, Told, fit, heads_of
from chatscene.library.load import Library
from chatscene.read.slot_classifier import PACKAGED, TRUSTED, SlotClassifier, load_classifier
from chatscene.studies.reading import Sentence, essential, load_sentences
from chatscene.terms.scenario import Component
from chatscene.terms.slots import SLOTS

MEMBERS = 1  # of the classifier
OFTENER = 2  # times a sentence written by hand is seen for one composed
FOLDS = 3  # of the sources
FEWEST = 2000  # sentences of ours that a member is trained on with
_UNSAID = frozenset(name for name, slot in SLOTS.items() if not slot.labelled)
_UNTAUGHT = frozenset(name for name, slot in SLOTS.items() if not slot.taught)


@dataclass(frozen=True, slots=True, kw_only=True)
class Course:
    """How members are trained.

    Attributes:
        library: Whose wordings and behaviors are learned.
        by_hand: Sentences of ours to learn from.
        anew: Whether to begin with the encoder as it came, else with the packaged classifier.
        count: How many sentences to compose.
        epochs: How often each sentence is seen.
        seed: Of their composition and of the training.
        told: Of the steps done.
    """

    library: Library
    by_hand: Sequence[Sentence]
    anew: bool
    count: int
    epochs: int
    seed: int
    told: Told

    def classes(self) -> Classes:
        """Of each head."""
        return heads_of(self.library)

    def member(self, others: Sequence[Labelled], number: int) -> SlotClassifier:
        """A classifier of one member, without trust in anything beside it.

        Args:
            others: Texts of others to learn from.
            number: Of the member; each is another.
        """
        seed, classes = self.seed + number, self.classes()
        hand = [of_ours(one) for one in self.by_hand]
        worded = [replace(one, open=one.open | _UNTAUGHT) for one in wordings(self.library)]
        composed = compose(self.library, self.count, seed)
        if self.anew:
            learned, onward = [*worded, *composed, *hand * OFTENER, *list(others) * OFTENER], None
        else:
            packaged = load_classifier(PACKAGED)
            onward = packaged.members[number % len(packaged.members)], packaged.classes
            learned = [*others, *_sample(worded, composed, hand, max(len(others), FEWEST), random.Random(seed))]
            learned += [one for one in worded if not set(one.behaviors) <= set(packaged.classes["behavior"])]
        found = fit(learned, classes, epochs=self.epochs, seed=seed, told=self.told, onward=onward)
        return SlotClassifier((found,), classes, {})


def left_out(sources: Sequence[Sequence[Labelled]], course: Course) -> Iterator[SlotClassifier]:
    """A classifier for each fold, which did not learn from the sources of that fold (`fold_of`)."""
    for fold in range(FOLDS):
        learned = (source for i, source in enumerate(sources) if fold_of(i) != fold)
        yield course.member([text for source in learned for text in source], fold)


def fold_of(source: int) -> int:
    """In which fold a source is, by its number."""
    return source % FOLDS


def of_ours(sentence: Sentence) -> Labelled:
    """A sentence of ours, as it is learned from."""
    one = _labelled(sentence)
    return replace(one, open=one.open | _UNTAUGHT)


def _labelled(sentence: Sentence) -> Labelled:
    if not sentence.in_scope:
        return Labelled(sentence.text, sentence.slots, open=frozenset(TRUSTED), in_scope=False)
    # Its behavior is left open: there are such sentences for two behaviors in three, and the others would lose.
    return Labelled(sentence.text, sentence.slots)


def of_others(path: Path, library: Library) -> list[Labelled]:
    """Texts that somebody else wrote, as they are learned from: each means some behavior that does just what it says.

    Raises:
        SettingsError: The file cannot be read.
    """
    does = [(snippet.id, essential(snippet.slots)) for snippet in library.of(Component.BEHAVIOR)]
    found: list[Labelled] = []
    for one in map(_labelled, load_sentences(path)):
        acts = essential(one.slots)
        unsaid = _UNSAID | ({"maneuver"} if one.slots.maneuver is None else set[str]())  # straight on, or not said
        same = tuple(name for name, acts_of_it in does if acts_of_it == acts)
        found.append(replace(one, behaviors=same, open=one.open | unsaid) if one.in_scope else one)
    return found


def _sample(
    worded: Sequence[Labelled], composed: Sequence[Labelled], hand: Sequence[Labelled], count: int, rng: random.Random
) -> list[Labelled]:
    """So many sentences of ours: half written by hand, the rest wordings and composed ones alike."""
    parts = ((hand, count // 2), (worded, count // 4), (composed, count // 4))
    return [one for part, many in parts for one in rng.sample(part, min(many, len(part)))]
