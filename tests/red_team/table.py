"""What stopped each program, as recorded in ``outcomes.json`` and shown in ``docs/security.md``.

``python -m red_team.table``, in the folder ``tests``, runs every program behind the second wall alone and writes both.
"""

from __future__ import annotations

import json
import os
import tempfile
from pathlib import Path

from chatscene.maps.network import resolve_map
from chatscene.settings import SimulationSettings
from chatscene.simulate.confined.allow_list import check_foreign
from chatscene.simulate.confined.nursery import Nursery
from red_team.attempt import LIMITS, SECRET, Canaries, Listener, attempt
from red_team.corpus import ATTACKS, Attack

OUTCOMES = Path(__file__).with_name("outcomes.json")
PAGE = Path(__file__).parents[2] / "docs" / "lab" / "red-team.md"
BEGIN, END = "<!-- table begins -->", "<!-- table ends -->"


def recorded() -> dict[str, str]:
    """For each program that is run behind the second wall alone, what stops it there."""
    return dict(json.loads(OUTCOMES.read_text(encoding="utf-8")))


def table(outcomes: dict[str, str]) -> str:
    """The table as Markdown."""
    rows = ["| program | what it tries | the allow-list | without the allow-list |", "|---|---|---|---|"]
    rows += [f"| {a.name} | {a.tries} | {_first_wall(a)} | {outcomes.get(a.name, 'not run')} |" for a in ATTACKS]
    return "\n".join(rows)


def _first_wall(attack: Attack) -> str:
    refusals = check_foreign(attack.source)
    if not refusals:
        return "lets it pass"
    what = refusals[0].what.replace("|", "\\|").replace("`", "'")
    return f"`{what}`"


def _write() -> None:
    with tempfile.TemporaryDirectory() as name, Listener() as listener:
        canaries = Canaries(Path(name), listener.port, listener.callers)
        canaries.secret.write_text(SECRET)
        os.environ["CANARY"] = SECRET
        with Nursery(resolve_map("town"), SimulationSettings(), LIMITS) as nursery:
            outcomes = {
                attack.name: attempt(nursery, canaries.fill(attack.source)).stopped_by
                for attack in ATTACKS
                if attack.runs
            }
        assert canaries.untouched()
    OUTCOMES.write_text(json.dumps(outcomes, indent=1) + "\n", encoding="utf-8")
    before, _, rest = PAGE.read_text(encoding="utf-8").partition(BEGIN)
    after = rest.partition(END)[2]
    PAGE.write_text(f"{before}{BEGIN}\n{table(outcomes)}\n{END}{after}", encoding="utf-8")


if __name__ == "__main__":
    _write()
