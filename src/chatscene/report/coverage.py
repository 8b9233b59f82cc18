"""`coverage.html`: what of catalogues is served, as one page that needs nothing but a browser."""

from __future__ import annotations

import base64
from collections.abc import Mapping, Sequence
from typing import Any
from urllib.parse import quote

from chatscene.report.templates import asset, fill, policy
from chatscene.terms.coverage import SHOWN, Answer, Catalogue, Covered, Tally


def coverage_page(found: Sequence[tuple[Catalogue, Sequence[Covered]]]) -> str:
    """The page."""
    return fill(
        "coverage.html",
        title="Coverage",
        policy=policy(),
        style=asset("viewer.css") + asset("coverage.css"),
        catalogues=[
            {
                "name": catalogue.name,
                "title": catalogue.title,
                "tally": Tally.of(rows),
                "in_words": Tally.of(rows).in_words(),
                "cards": [{**_card(row), "id": f"{number}-{place}"} for place, row in enumerate(rows)],
            }
            for number, (catalogue, rows) in enumerate(found)
        ],
    )


def _card(row: Covered) -> Mapping[str, Any]:
    return {
        "name": row.entry.name,
        "sentence": row.entry.sentence,
        "answer": row.answer.value,
        "served": row.answer is Answer.SERVED,
        "beyond": row.answer is Answer.OUT_OF_REACH,
        "weak": row.shown < SHOWN * row.scenes,
        "reasons": row.reasons,
        "parts": [name.split("/", 1) for name in row.snippet_ids],
        "read": [(name.replace("_", " "), value) for name, value in row.slots.items()],
        "unused": row.unused,
        "share": row.shown / row.scenes if row.scenes else None,
        "shown": row.shown,
        "scenes": row.scenes,
        "fared": row.fared,
        "failures": row.failures,
        "missed": row.missed[:3],
        "picture": base64.b64encode(row.picture).decode(),
        "run": row.searched,
        "report": f"{quote(row.searched.folder)}/report.html" if row.searched else "",
    }
