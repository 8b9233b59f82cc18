"""The library as something that grows: checked as a whole, and the reader trained on it again."""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from chatscene.ego.policy import load_ego
from chatscene.grow.course import MEMBERS, Course, fold_of, left_out, of_others, of_ours
from chatscene.grow.directions import Joint, joints
from chatscene.grow.fit import Told, trust_of, unseen
from chatscene.grow.lint import Finding, alike, sifted, sound_part, trials, try_joint, try_triple, unpartnered
from chatscene.library.load import library_with, load_library
from chatscene.maps.network import resolve_map
from chatscene.read.slot_classifier import NAME, PACKAGED, SlotClassifier, save_classifier
from chatscene.runs.executor import ONE, Workers
from chatscene.runs.parallel import spread
from chatscene.runs.progress import Progress
from chatscene.search.climb import simulator_of
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings, Settings
from chatscene.studies.reading import Sentence, load_sentences
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.scenario import Component

FITTING = "fitting"  # the packaged sentences that the reader may learn from
KEPT_BACK = 8  # … but for those of one behavior in so many, on which the patterns are weighed against it
_Trial = tuple[tuple[str, str, str], AdversaryKind] | Joint | None  # None: who is alike


@dataclass(frozen=True, slots=True)
class _Setup:
    own: str
    scenes: int
    only: frozenset[str] | None


class _Checker:
    """Tries one program after another."""

    def __init__(self, setup: _Setup) -> None:
        self._setup = setup
        self._library, _ = sound_part(library_with(setup.own), setup.only)
        settings = Settings(retrieval=RetrievalSettings(library=setup.own))
        self._simulator = simulator_of(Retrieved(), resolve_map("town"), settings)
        self._ego = load_ego("rule-based")

    def __call__(self, trial: _Trial) -> set[Finding]:
        if trial is None:
            return alike(self._library, self._simulator, self._ego, self._setup.only)
        if isinstance(trial, Joint):
            return set(try_joint(trial, self._library, self._simulator, self._ego))
        (b, g, s), kind = trial
        triple = (self._library.get(b), self._library.get(g), self._library.get(s))
        return set(try_triple(triple, kind, self._simulator, self._ego, self._setup.scenes))


def lint_library(
    own: str = "", *, scenes: int, workers: Workers = ONE, progress: Progress
) -> tuple[Counter[Component], tuple[Finding, ...]]:
    """Check the packaged library, or somebody's own beside it.

    Args:
        own: Folder of one's own snippets; only these are checked then, as a stranger's: they are held against the
            allow-list and run behind the walls. Empty: the packaged ones are checked.
        scenes: Of each program.
        workers: Who tries; any number gives the same findings.
        progress: Told what is done.

    Returns:
        How many snippets of each component were checked, and the findings, sorted.
    """
    library = library_with(own)
    only = frozenset(s.id for s in load_library(Path(own))) if own else None
    sound, found = sound_part(library, only)
    tasks: list[_Trial] = [None]
    tried: set[str] = set()
    for triple, kind in trials(sound, only):
        ids = (triple[0].id, triple[1].id, triple[2].id)
        tried |= set(ids)
        tasks.append((ids, kind))
    tasks += joints(sound, only)
    for done, findings in enumerate(spread(_Checker, _Setup(own, scenes, only), tasks, workers=workers), 1):
        found |= findings
        progress("programs", done, len(tasks))
    if only is not None:
        tried |= {snippet.id for snippet in sound if snippet.id not in only}
    checked = Counter(s.component for s in library if only is None or s.id in only)
    return checked, sifted(found | unpartnered(sound, tried), only)


def course_of(own: str, *, anew: bool = False, count: int = 4000, epochs: int = 4, seed: int = 0, told: Told) -> Course:
    """How the classifier is trained on a library as it is now.

    Args:
        own: Folder of one's own snippets beside the packaged ones; empty for none.
        anew: Whether to begin with the encoder as it came, else with the packaged classifier.
        count: How many sentences to compose.
        epochs: How often each sentence is seen.
        seed: Of their composition and of the training.
        told: Of the steps done.
    """
    by_hand = [one for one in load_sentences(FITTING) if not kept_back(one)]
    library = library_with(own)
    return Course(library=library, by_hand=by_hand, anew=anew, count=count, epochs=epochs, seed=seed, told=told)


def fit_classifier(own: str, texts: Sequence[Path], course: Course, left: Path | None = None) -> Path:
    """Train the classifier.

    How much patterns and account count beside it is fitted on sentences of ours that it does not learn from, and on
    texts of others by members that leave out their source.

    Args:
        own: Folder of one's own snippets, into which it goes; empty for the packaged one.
        texts: Files of texts that others wrote, with their facts; each is a source.
        course: How it is trained.
        left: Folder for the classifiers that left out sources, by which it can be told how far a reading is right.

    Raises:
        MissingExtra: torch or onnx is missing.
        SettingsError: A file of texts cannot be read.
    """
    sources = [of_others(path, course.library) for path in texts]
    others = [text for source in sources for text in source]
    members = tuple(member for i in range(MEMBERS) for member in course.member(others, i).members)
    whole = SlotClassifier(members, course.classes(), {})
    rows = unseen(whole, [of_ours(one) for one in load_sentences(FITTING) if kept_back(one)])
    folds = list(left_out(sources, course)) if sources else []
    for i, source in enumerate(sources):
        rows += unseen(folds[fold_of(i)], source)
    trust = trust_of(whole.classes, rows)
    path = Path(own) / NAME if own else PACKAGED
    save_classifier(replace(whole, trust=trust), path)
    if left:
        for fold, classifier in enumerate(folds):
            save_classifier(replace(classifier, trust=trust), left / f"{fold}.npz")
    return path


def kept_back(sentence: Sentence) -> bool:
    """Whether the classifier does not learn from a sentence: one behavior in `KEPT_BACK` is new to it."""
    name = sentence.behavior
    return name is not None and hashlib.blake2b(name.encode()).digest()[0] % KEPT_BACK == 0
