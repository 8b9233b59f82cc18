"""What a model is asked for, and what becomes of it: data that our own code makes a snippet of, or reasons why not.

Nothing a model writes becomes a file name, a header or a line of a program as it stands: names are spelt anew, texts
are cleaned and quoted, and what a snippet promises about names and ranges is computed from the code.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from dataclasses import replace
from functools import lru_cache
from typing import Literal

from pydantic import BaseModel, ConfigDict, Field

from chatscene.errors import SnippetError
from chatscene.grow.lint import Finding, check_code, partner_names, refused_code, world_names
from chatscene.library.compatibility import HEADER_PROVIDES
from chatscene.library.load import Library, names_of
from chatscene.library.snippet_file import MARK, tuned_in
from chatscene.models.language.structured import printable
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.nouns import with_article
from chatscene.terms.scenario import Component, Control, Distance, Maneuver, Occluder, Place, Position, Side, Slots
from chatscene.terms.snippet import ParameterRange, Snippet

SHORTEST, LONGEST = 10, 200  # characters of a wording
REPHRASINGS = 5  # at least
LONGEST_NAME = 48
CORE: dict[Component, frozenset[str]] = {
    Component.BEHAVIOR: frozenset({"AdvBehavior"}),
    Component.GEOMETRY: frozenset({"egoRoute", "egoSpawnPt"}),
    Component.SPAWN: frozenset({"AdvAgent"}),
}
"""Names that every snippet of a component defines."""
CLAIMS: dict[Component, tuple[str, ...]] = {
    Component.BEHAVIOR: ("actions",),
    Component.GEOMETRY: ("maneuver", "place"),
    Component.SPAWN: ("position",),
}
"""Facts that every proposal of a component fills, so that its drives can be held against something."""


class DraftParameter(BaseModel):
    """A parameter that the code declares; its range is read from there."""

    model_config = ConfigDict(extra="forbid")

    name: str = Field(max_length=64)
    unit: Literal["m", "m/s", "s", "rad", "1"]
    meaning: str = Field(max_length=LONGEST)


class DraftSlots(BaseModel):
    """The facts that the drives will show; see `chatscene.terms.scenario.Slots`."""

    model_config = ConfigDict(extra="forbid")

    actions: list[Action] = Field(default=[], max_length=6)
    side: Side | None = None
    position: Position | None = None
    occluder: Occluder | None = None
    maneuver: Maneuver | None = None
    place: Place | None = None
    control: Control | None = None
    leader: bool | None = None
    blocker: bool | None = None
    distance: Distance | None = None
    group: bool | None = None
    lanes: int | None = Field(default=None, ge=1, le=3)
    two_way: bool | None = None


class Draft(BaseModel):
    """What a model is asked for."""

    model_config = ConfigDict(extra="forbid")

    name: str = Field(max_length=200, description="two to five words that say what is new about it")
    description: str = Field(max_length=2 * LONGEST, description="one sentence")
    rephrasings: list[str] = Field(min_length=REPHRASINGS, max_length=12, description="other ways to say it")
    adversaries: list[AdversaryKind] = Field(max_length=len(AdversaryKind))
    slots: DraftSlots
    parameters: list[DraftParameter] = Field(max_length=8)
    code: str = Field(max_length=8000, description="Scenic")


def slug(name: str, taken: Collection[str] = ()) -> str:
    """A file name made of a model's words: letters a to z, digits and hyphens; numbered where it is taken.

    Raises:
        SnippetError: No letter or digit is left.
    """
    plain = "-".join(re.findall(r"[a-z0-9]+", name.lower()))[:LONGEST_NAME].strip("-")
    if not plain:
        raise SnippetError("the name has no letter or digit")
    numbered = (f"{plain}-{n}" if n > 1 else plain for n in range(1, len(taken) + 2))
    return next(one for one in numbered if one not in taken)


def snippet_of(
    draft: Draft, snippet_id: str, component: Component, library: Library, *, origin: str
) -> Snippet | tuple[Finding, ...]:
    """Make a snippet of a draft; its code is read and not run.

    Returns:
        The snippet, or what is wrong with the draft.
    """
    lines = draft.code.replace("\r\n", "\n").strip("\n").split("\n")
    code = "\n".join(line.partition(MARK)[0].rstrip() for line in lines)  # what our marks say is for us to write
    blank = Snippet(
        id=snippet_id,
        component=component,
        description=printable(draft.description, LONGEST + 1),
        rephrasings=tuple(dict.fromkeys(printable(text, LONGEST + 1) for text in draft.rephrasings)),
        slots=Slots(**draft.slots.model_dump(exclude={"actions"}), actions=tuple(dict.fromkeys(draft.slots.actions))),
        adversaries=() if component is Component.GEOMETRY else tuple(dict.fromkeys(draft.adversaries)),
        origin=origin,
        source=code,
    )
    if faults := (*refused_code(blank, library), *_said_faults(blank, library)):
        return faults
    names = names_of(code, world_names())
    known = {p.name: p for p in draft.parameters}
    if unknown := sorted(names.parameters.keys() - known.keys()):
        return (Finding(snippet_id, "parameters", f"the list of parameters lacks {', '.join(unknown)}"),)
    if unmarked := sorted(names.parameters.keys() - tuned_in(code)):
        declared = f"param {unmarked[0]} = Range(low, high)"
        return (Finding(snippet_id, "parameters", f"{', '.join(unmarked)}: say {declared} on a line of its own"),)
    made = replace(
        blank,
        requires=names.requires,
        provides=names.provides,
        parameters=tuple(
            ParameterRange(
                name=name, low=low, high=high, unit=known[name].unit, meaning=printable(known[name].meaning, LONGEST)
            )
            for name, (low, high) in sorted(names.parameters.items())
        ),
    )
    return code_faults(made, library) or made


def code_faults(snippet: Snippet, library: Library) -> tuple[Finding, ...]:
    """What is wrong with a stranger's snippet before anything of it is run."""
    return refused_code(snippet, library) or (
        *_said_faults(snippet, library),
        *check_code(snippet),
        *_roles(snippet, library),
    )


def _roles(snippet: Snippet, library: Library) -> Iterator[Finding]:
    """Whether it defines what its component defines, and nothing of its partners'."""
    provides = set(snippet.provides)
    if missing := sorted(CORE[snippet.component] - provides):
        yield Finding(
            snippet.id, "names", f"{with_article(snippet.component)} defines {', '.join(missing)}; this one does not"
        )
    theirs = {*partner_names(snippet.component, library), *HEADER_PROVIDES} - {
        name for s in library.of(snippet.component) for name in s.provides
    }
    if taken := sorted(provides & theirs):
        yield Finding(snippet.id, "names", f"{', '.join(taken)} is for a partner to define")
    if snippet.component is not Component.SPAWN and re.search(r"\bnew\b", re.sub(r"#.*", "", snippet.source)):
        yield Finding(snippet.id, "names", f"{with_article(snippet.component)} places nothing; only a spawn does")


def _said_faults(snippet: Snippet, library: Library) -> Iterator[Finding]:
    """Whether its words are new and its facts such that somebody can check them."""
    for text in (snippet.description, *snippet.rephrasings):
        if fault := wording_fault(text):
            yield Finding(snippet.id, "text", fault)
    if len({_words(t) for t in (snippet.description, *snippet.rephrasings)}) < REPHRASINGS + 1:
        yield Finding(snippet.id, "text", f"needs at least {REPHRASINGS} rephrasings, each different")
    if said := _said_by(snippet.description, snippet, library):
        yield Finding(snippet.id, "text", f"the description is a wording of {said}")
    filled = snippet.slots.said().keys()
    if missing := [name for name in CLAIMS[snippet.component] if name not in filled]:
        yield Finding(snippet.id, "slots", f"{with_article(snippet.component)} says its {', '.join(missing)}")
    usual = {name for s in library.of(snippet.component) for name in s.slots.said()}
    if odd := sorted(filled - usual):
        yield Finding(snippet.id, "slots", f"{with_article(snippet.component)} does not fill {', '.join(odd)}")
    if not snippet.adversaries and snippet.component is not Component.GEOMETRY:
        yield Finding(snippet.id, "slots", "it names no kind of adversary")


def wording_fault(text: str) -> str | None:
    """Why a text is no wording; None if it is one."""
    if not SHORTEST <= len(text) <= LONGEST:
        return f"a wording has {SHORTEST} to {LONGEST} characters, not {len(text)}: {text[:40]!r}"
    if not text.isprintable() or len(_words(text)) < 2:
        return f"a wording is a few printable words, not {printable(text, 40)!r}"
    return None


@lru_cache(maxsize=1 << 16)  # the library's own wordings are asked for with every draft
def _words(text: str) -> tuple[str, ...]:
    return tuple(re.findall(r"[^\W_]+", text.casefold()))


def same_words(one: str, other: str) -> bool:
    """Whether two texts are the same but for capitals and punctuation."""
    return _words(one) == _words(other)


def _said_by(text: str, snippet: Snippet, library: Library) -> str | None:
    """The id of another snippet of the component that has this wording."""
    for other in library.of(snippet.component):
        if other.id != snippet.id and any(same_words(text, t) for t in (other.description, *other.rephrasings)):
            return other.id
    return None
