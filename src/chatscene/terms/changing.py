"""An ego that changes lanes once another does something: by a deed of its own, on a way that keeps its lane."""

from __future__ import annotations

from chatscene.terms.situation import EGO, Deed, Ego
from chatscene.terms.vocabulary import CHANGES, Act


def waits_for_another(deed: Deed) -> bool:
    """Whether a deed begins once, or while, somebody else than the ego does something."""
    when = deed.when
    named = () if when is None else (when.after, when.during)
    return any(one is not None and not one.startswith(f"{EGO}.") for one in named)


def changes_later(ego: Ego) -> bool:
    """Whether an ego whose way is said to change lanes does so by a deed that waits for somebody else."""
    waits = any(deed.act is Act.LANE_CHANGE and waits_for_another(deed) for deed in ego.does)
    return ego.route in CHANGES and waits
