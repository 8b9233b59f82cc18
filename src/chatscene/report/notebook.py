"""What a notebook shows: pages in frames of their own, so that neither their style nor their script touches it."""

from __future__ import annotations

import base64
from collections.abc import Mapping
from html import escape
from typing import Any

from chatscene.report import sections
from chatscene.report.templates import asset, fill
from chatscene.terms.scenario import Scenario, grouped


def framed(page: str, *, height: int = 720) -> str:
    """A page in a frame: its script may run there, and reach nothing outside."""
    return (
        f'<iframe sandbox="allow-scripts" srcdoc="{escape(page)}" '
        f'style="width: 100%; height: {height}px; border: 0"></iframe>'
    )


def understanding_frame(scenario: Scenario, explanation: Mapping[str, Any]) -> str:
    """How a sentence was understood, as the report shows it."""
    page = fill(
        "understanding.html",
        style=asset("viewer.css"),
        text=scenario.text if scenario.situation is None else scenario.situation.about or scenario.id,
        understanding=sections.understanding(explanation),
        unused=list(grouped(scenario.unused).values()),
        programs=sections.programs({scenario.id: explanation["program"]}),
    )
    return framed(page, height=560)


def picture(content: bytes, *, said: str) -> str:
    """A GIF as part of the page."""
    return f'<img src="data:image/gif;base64,{base64.b64encode(content).decode()}" alt="{escape(said)}">'
