"""Step 2 of 9: a sentence to a frame, in which everything stands that was read and how sure it is.

Paper: section 3.3, step ii. The reference asks a language model; here patterns and a classifier read. Where the user
has a language model, that fills a situation (`chatscene.read.by_model`).
"""

from __future__ import annotations

from dataclasses import replace

from chatscene.read.decompose import hear
from chatscene.read.slot_classifier import believe
from chatscene.settings import RetrievalSettings
from chatscene.terms.frame import Frame, certain


def read(text: str, settings: RetrievalSettings | None = None) -> Frame:
    """Read a sentence without a language model.

    Raises:
        SettingsError: The text is empty or too long.
    """
    settings = settings or RetrievalSettings()
    heard = hear(text)
    believed = believe(heard, settings.library)
    return replace(heard, beliefs=certain(heard.outright, believed) if heard.whole else believed)
