"""The library as something that grows: checked as a whole."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from pathlib import Path

from chatscene.ego.policy import load_ego
from chatscene.grow.directions import Joint, joints
from chatscene.grow.lint import Finding, alike, sifted, sound_part, trials, try_joint, try_triple, unpartnered
from chatscene.library.load import library_with, load_library
from chatscene.maps.network import resolve_map
from chatscene.runs.executor import ONE, Workers
from chatscene.runs.parallel import spread
from chatscene.runs.progress import Progress
from chatscene.search.climb import simulator_of
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings, Settings
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.scenario import Component

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
