"""What holds of an act by its traits: the sets of acts that it is in, each with what the set is.

    python -m making.traits slow-down
    python -m making.traits SLOWS BRAKES

Takes names of acts, or of traits (`Tempo`, `Heads`) to compare before one is chosen.
"""

from __future__ import annotations

import ast
import inspect
import itertools
import sys
from collections.abc import Iterator

from chatscene.terms import vocabulary
from chatscene.terms.vocabulary import Act, Heads, Tempo, acts_of


def sets() -> Iterator[tuple[str, frozenset[Act], str]]:
    """Each set of acts in `terms/vocabulary.py`, with the sentence below it."""
    body = ast.parse(inspect.getsource(vocabulary)).body
    for one, below in itertools.pairwise(body):
        match one, below:
            case ast.Assign(targets=[ast.Name(id=name)]), ast.Expr(value=ast.Constant(value=str(said))):
                found = getattr(vocabulary, name)
                if isinstance(found, frozenset) and all(isinstance(act, Act) for act in found):
                    yield name, found, " ".join(said.split())
            case _:
                pass


def named(name: str) -> frozenset[Act]:
    """An act, or all that have a trait of that name."""
    traits = [table[name] for table in (Tempo, Heads) if name in table.__members__]
    return acts_of(*traits) if traits else frozenset((Act(name),))


def main() -> None:
    """Print them."""
    for name in sys.argv[1:]:
        acts = named(name)
        print(f"{name}: as {', '.join(sorted(acts))}")
        for called, members, said in sets():
            if acts & members:
                print(f"  {called}: {said}")


if __name__ == "__main__":
    main()
