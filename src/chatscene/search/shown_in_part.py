"""As much of a situation as drives show: lesser facts for which no drive shows what was said are left out.

A number may be one that can be built and still keeps two from meeting, or somebody from doing what it is there for.
Then it is left out, as `chatscene.build.in_part` leaves out what cannot be built, and told with what is not seen.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace

from chatscene.build.build import Built, build
from chatscene.build.in_part import Less, lesser_read, touches
from chatscene.errors import ChatSceneError
from chatscene.search.rehearsal import rehearsed_once, unseen_at_first
from chatscene.terms.situation import Situation

TRIES = 12
"""Situations at most that are driven a few times."""
_UNSEEN = re.compile(r"none of \d+ drives (?:by \S+ )?(?:shows ([\w.-]+)|(begins)): (.*)")
_BEGINS = "begins"


def shown_in_part(situation: Situation, built: Built) -> tuple[Situation, Built]:
    """As much of a situation as drives show, and its program before it is rehearsed; all of it if nothing less helps.

    Only facts that were read in a text are left out.

    Args:
        situation: What is to happen.
        built: Its program before it is rehearsed.
    """
    if not situation.evidence.quoted:
        return situation, built
    unseen, tries = _facts(rehearsed_once(built, situation).unseen), TRIES
    made, program, left_out = situation, built, list[str]()
    while unseen and tries:
        for less in _promising(made, unseen):
            tries -= 1
            if (found := _without(less, program, unseen)) is not None:
                told = "; ".join(f"{path}: {seen}" for path, seen in unseen.items() if path not in found[1])
                left_out.append(f"{less.told} (with it, no drive shows {told})")
                made, (program, unseen) = less.situation, found
                break
            if not tries:
                break
        else:
            break
    if unseen or made is situation:
        return situation, built
    return replace(made, evidence=replace(made.evidence, unbuilt=(*situation.evidence.unbuilt, *left_out))), program


def _facts(unseen: tuple[str, ...]) -> dict[str, str]:
    """The facts that no drive shows, by their paths, with what is seen."""
    found = filter(None, map(_UNSEEN.match, unseen))
    return {one[1] or _BEGINS: one[3] for one in found}


def _promising(situation: Situation, unseen: Mapping[str, str]) -> Iterator[Less]:
    """The situation without a fact: those first that are not seen themselves, then of the same road user, the ego's."""
    whose = {".".join(path.split(".")[:2]) for path in unseen} | {path.split(".")[0] for path in unseen}
    met = {f"others.{path.split('.')[1]}" for path in unseen if path.startswith("encounter.")}

    def rank(one: Less) -> int:
        if any(touches(one.path, path) for path in unseen):
            return 0
        theirs = ".".join(one.path.split(".")[:2])
        return 1 if theirs in whose | met else 2 if one.path.startswith("ego") else 3

    yield from sorted(lesser_read(situation), key=lambda one: (rank(one), one.missed))


def _without(less: Less, before: Built, unseen: Mapping[str, str]) -> tuple[Built, dict[str, str]] | None:
    """The program without a fact, and what none of its drives shows, if that is less; a few drives tell at first."""
    try:
        made = build(less.situation, name=before.program.scenario_id)
        if len(_facts(unseen_at_first(made, less.situation))) >= len(unseen):
            return None
        left = _facts(rehearsed_once(made, less.situation).unseen)
    except ChatSceneError:
        return None
    return (made, left) if len(left) < len(unseen) else None
