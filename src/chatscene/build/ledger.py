"""What was said and what became of it: each fact is built, or told as left out, or refused by its path."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace

from chatscene.errors import NotBuilt
from chatscene.situations.facts import said_in, within
from chatscene.terms.lateral import LATERAL_OF_STARTS
from chatscene.terms.situation import Situation

LEFT_OUT = re.compile(
    r"^(?:road\.(?:has\.\d+|setting|speed_limit|arms|side_road|diameter)"
    r"|contact\.(?:ego|other|happens|striker)|.*\.manner)$"
)
"""Facts that a scene may lack and still show the conflict: they are told as left out, not refused."""


_ACROSS = re.compile(r"^others\.[\w-]+\.starts\.lateral\.")
_PLACE = re.compile(r"(others\.([\w-]+)\.starts\.where: )([\w-]+)")


def as_written(refusal: str, situation: Situation) -> str:
    """A refusal that names the place of somebody as it was written, where it was built as another word has it.

    Args:
        refusal: Why it is not built.
        situation: As it was written.
    """
    written = {one.id: one.starts.where for one in situation.others}
    return _PLACE.sub(lambda found: found[1] + written.get(found[2], found[3]), refusal)


@dataclass(slots=True)
class Ledger:
    """What was said of a situation, and what became of it while it is built.

    Attributes:
        situation: What was said, as it is built.
        told: The same as it was said, where that is told otherwise.
        built: The paths of facts that the program has.
        assumed: What was not said and had to be something, in words.
        lacking: Of that, what the place lacks.
        slow: Whether a slower ego is asked for than could be built.
    """

    situation: Situation
    built: set[str] = field(default_factory=set[str])
    assumed: list[str] = field(default_factory=list[str])
    lacking: list[str] = field(default_factory=list[str])
    told: Situation | None = None
    slow: bool = False

    def anew(self, situation: Situation) -> Ledger:
        """The same for a situation as it is built, to be added to on its own."""
        assumed, lacking = list(self.assumed), list(self.lacking)
        return replace(self, situation=situation, built=set(self.built), assumed=assumed, lacking=lacking)

    def take(self, *paths: str) -> None:
        """Facts that the program has: of each path, all in it."""
        self.built.update(paths)

    def assume(self, said: str) -> None:
        """Something that had to be chosen."""
        if said not in self.assumed:
            self.assumed.append(said)

    def lack(self, said: str) -> None:
        """Something that the place lacks, which is told as what was chosen is."""
        self.assume(said)
        self.lacking.append(said)

    def close(self) -> tuple[str, ...]:
        """What is left out, as ``path: value``.

        Raises:
            NotBuilt: There is a fact without which the scene would be another.
        """
        facts = ((path, value) for path, value in said_in(self.told or self.situation) if not self._is_built(path))
        left = {path: f"{path}: {str(value).lower() if isinstance(value, bool) else value}" for path, value in facts}
        if refused := [told for path, told in left.items() if not LEFT_OUT.match(path)]:
            raise NotBuilt("cannot be built yet: " + "; ".join(refused) + self._instead(refused))
        return tuple(left.values())

    def _instead(self, refused: list[str]) -> str:
        """Where it is built what was said of somebody's place across the road; empty where nothing was said of that."""
        across = {told.split(".")[1] for told in refused if _ACROSS.match(told)}
        hides = sorted(across & {one.hidden_by for one in self.situation.others if one.hidden_by is not None})
        unless = f"; not for {', '.join(hides)}, which hides a road user" if hides else ""
        return f"; {LATERAL_OF_STARTS}{unless}" if across else ""

    def _is_built(self, path: str) -> bool:
        return within(path, self.built)
