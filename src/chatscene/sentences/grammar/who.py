"""How people name road users.

Written by us, after the way crash reports, test protocols, driving schools and people at the kitchen table speak.
"""

from __future__ import annotations

from chatscene.situations.inflection import listed
from chatscene.terms.actors import AdversaryKind

NOUNS: dict[AdversaryKind, tuple[str, ...]] = {kind: listed(kind.row.nouns) for kind in AdversaryKind}
UNNAMED = listed("road user | traffic participant | other party in traffic")
COLOURS = listed("white | black | silver | blue | dark | grey | yellow | green")
GROUPS = listed(
    """two {many} | two {many} | a group of {many} | several {many} | a couple of {many} | three {many}
    a pair of {many} | a handful of {many} | a number of {many} | some {many}"""
)
