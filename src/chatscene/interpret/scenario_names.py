"""What scenarios are called."""

from __future__ import annotations

import hashlib
import re

from chatscene.terms.situation import Situation

STATED = "situation"
"""What the scenario of a situation is called that was read in no text."""


def scenario_id(situation: Situation) -> str:
    """What the scenario of a situation is called: after the text that it was read in, or what it is."""
    return named(situation.about) if situation.evidence.quoted else STATED


def named(text: str) -> str:
    """What the scenario of a text is called: readable, and the same whenever it is read."""
    stem = "-".join(re.findall(r"[a-z0-9]+", text.lower())[:4]) or "scenario"
    return f"{stem[:40]}-{hashlib.blake2b(text.encode(), digest_size=3).hexdigest()}"
