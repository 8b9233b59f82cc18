"""What the sections of the report say; `sections.html` says it in HTML."""

from __future__ import annotations

import math
import re
import shlex
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict
from itertools import groupby
from typing import TYPE_CHECKING, Any, cast
from urllib.parse import quote

from chatscene.measure.score import wilson
from chatscene.measure.severity import KMH, in_kmh
from chatscene.report.accounting import parts_of, told_first
from chatscene.report.how_fast import hardness
from chatscene.report.measures import scene_label
from chatscene.report.plots import Plot, plot_outcomes, plot_ranges
from chatscene.report.summary import outcomes_in_words
from chatscene.report.templates import fill_section
from chatscene.report.what_happened import kept_in_words, outcome_in_words
from chatscene.runs import RunRecord, Status, settings_of
from chatscene.runs.beside import Beside
from chatscene.search.generators.own_program import options_of
from chatscene.settings import SIMULATOR, Settings, SimulationSettings

if TYPE_CHECKING:
    from markupsafe import Markup

Row = Mapping[str, Any]

_BANNERS = {
    Status.RUNNING: "This run is not finished. What is shown is what was done so far.",
    Status.FAILED: "This run failed. What is shown is what was done before.",
    Status.REFUSED: "This run was refused. Nothing was searched.",
}
_COMPONENTS = {"behavior": "Adversary's behavior", "geometry": "Road geometry", "spawn": "Spawn position"}


def heading(record: RunRecord, explanation: Row, around: str) -> Markup:
    """The sentence, what was read in it, and how far the run came where it did not end well."""
    facts = "; ".join(f"{_words(name)}: {_slot(value)}" for name, value in facts_of(explanation))
    told = " ".join(scenario.get("told", "") for scenario in explanation.get("scenarios", []))
    own = record.program is not None
    return fill_section(
        "heading",
        record.title,
        own,
        told_first(explanation, record),
        told.removesuffix(".") or facts,
        around,
        _BANNERS.get(record.status),
        record.reason,
    )


def facts_of(explanation: Row) -> list[tuple[str, object]]:
    """What was read, slot by slot: what the scenes are held against, which need not be all that was said."""
    return [fact for scenario in explanation.get("scenarios", []) for fact in scenario.get("slots", {}).items()]


def _words(name: str) -> str:
    return name.replace("_", " ")


def verdict(scenes: Sequence[Row], counts: Mapping[str, int], *, read: bool) -> Markup:
    """How many scenes there are, how many crashed, how many were kept and show what was read."""
    ran = [row for row in scenes if row["status"] == "ran"]
    if not ran:
        return fill_section("undriven")
    return fill_section(
        "verdict",
        _scenes(len(ran)),
        outcomes_in_words(counts),
        counts["selected"],
        kept_in_words(ran),
        _shown(ran) if read else "No fact was read, so scenes are not checked.",
    )


def tiles(scenes: Sequence[Row]) -> Markup:
    """The numbers of all scenes, driven ones and rejected ones, with what each is."""
    ran = [row for row in scenes if row["status"] == "ran"]
    if not ran:
        return fill_section("quiet", "No scene was driven.")
    hits, kept = sum(row["collision"] for row in ran), sum(row["selected"] for row in ran)
    avoidable = sum(row["avoidable"] is True for row in ran)
    low, high = wilson(hits, len(ran))
    fastest = max(map(hardness, ran), default=0.0)
    shown = [
        (f"{hits / len(ran):.0%}", "collision rate", f"95 % interval {low:.0%} to {high:.0%} (Wilson)"),
        (
            in_kmh(fastest) if hits else "none",
            "hardest impact",
            "closing speed along the line of contact" if hits else "nothing collided",
        ),
        (
            f"{kept}",
            "scenes kept",
            kept_in_words(ran) or f"{sum(row['fill_in'] for row in ran)} of them without a collision",
        ),
        (
            f"{avoidable / hits:.0%}" if hits else "none",
            "of the crashes avoidable",
            "by the careful driver of UN R157" if hits else "nothing collided",
        ),
        (
            f"{len(scenes) - len(ran)}",
            "draws rejected",
            f"of {len(scenes)}" + "; the reasons are below" * (len(ran) < len(scenes)),
        ),
    ]
    return fill_section("tiles", shown)


def beside(beside: Beside, kept: Sequence[Row]) -> Markup:
    """What became of the kept scenes with another ego, or why nobody drove them again."""
    if beside.why_not:
        return fill_section("quiet", f"The kept scenes were not driven again for this page: {beside.why_not}.")
    if not beside.drives:
        return fill_section("quiet", "No kept scene was driven again for this page.")
    mine = sum(bool(row["collision"]) for row in kept if row["scene_id"] in beside.drives)
    theirs = sum(drive.collision is not None for drive in beside.drives.values())
    return fill_section("beside", beside.ego, _scenes(len(beside.drives), "kept scene"), mine, theirs)


def outcomes(ranges: Sequence[Row], scenes: Sequence[Row]) -> Markup:
    """A plot per scenario and parameter of what came of its values, over all routes."""
    names = dict.fromkeys((row["scenario_id"], row["parameter"]) for row in ranges)
    plots: list[tuple[str, str, Plot]] = []
    for scenario, name in names:
        rows = [row for row in ranges if (row["scenario_id"], row["parameter"]) == (scenario, name)]
        own = [row for row in scenes if row["scenario_id"] == scenario]
        plots.append((short(name), _meaning(rows, name), plot_outcomes(name, rows, own)))
    return fill_section("outcomes", plots) if plots and scenes else fill_section("quiet", "Nothing was searched.")


def _shown(ran: Sequence[Row]) -> str:
    """How many scenes show all that was read; the kept ones apart."""
    kept = [bool(row["meaning_ok"]) for row in ran if row["selected"]]
    every = [bool(row["meaning_ok"]) for row in ran]
    return (
        f"{sum(kept)} of {_scenes(len(kept), 'kept scene')} and {sum(every)} of all {len(every)} that were driven show "
        "all that was read. Drives that ended early are judged up to that point."
    )


def _scenes(count: int, what: str = "scene") -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def scene_table(scenes: Sequence[Row], units: Mapping[str, str], replayable: Iterable[str]) -> Markup:
    """The driven scenes in the order given; those in `replayable` have a button."""
    parameters = [name for name in units if any(row.get(name) is not None for row in scenes)]
    shown = set(replayable)
    columns = [
        ("Scene", None, False),
        ("Outcome", None, False),
        ("Ego", "km/h before", True),
        ("Other", "km/h at most", True),
        ("Impact", "km/h", True),
        ("A careful driver avoids it", None, False),
        ("Who hit", None, False),
        ("Score", "lower is worse", True),
        ("As read", None, False),
        *((short(name), units[name], True) for name in parameters),
    ]
    return fill_section(
        "scene_table", columns, [_scene_line(row, parameters, row["scene_id"] in shown) for row in scenes]
    )


def short(parameter: str) -> str:
    """A parameter's name for a heading."""
    return parameter.removeprefix("OPT_").replace("_", " ").lower()


def _scene_line(row: Row, parameters: Sequence[str], replayable: bool) -> Row:
    return {
        "id": row["scene_id"],
        "label": scene_label(row["scene_id"]),
        "replayable": replayable,
        "kept": row["selected"],
        "fill_in": row["fill_in"],
        "collision": row["collision"],
        "outcome": outcome_in_words(row),
        "speeds": [_kmh(row.get(name)) for name in ("ego_speed_before", "other_speed_most", "impact_speed")],
        "avoidable": {True: "yes", False: "no", None: ""}[row["avoidable"]],
        "fault": (row["fault"] or "").replace("-", " "),
        "score": _number(row["overall_score"], 3),
        "failures": "; ".join(row["meaning_failures"] or []),
        "parameters": [_number(row.get(name)) for name in parameters],
    }


def _kmh(speed: float | None) -> str:
    return "" if speed is None else f"{KMH * speed:.0f}"


def _number(value: float | None, digits: int = 2) -> str:
    return "" if value is None or math.isnan(value) else f"{value:.{digits}f}"


def understanding(explanation: Row) -> Markup:
    """What was read in the sentence, what was looked at, and why the rest was not taken."""
    scenarios = explanation.get("scenarios", [])
    if not scenarios:
        return fill_section("quiet", "The run ended before the sentence was understood.")
    return fill_section("understanding", [_scenario(scenario) for scenario in scenarios])


def _scenario(scenario: Row) -> Row:
    facts = scenario.get("slots", {}) | scenario.get("surroundings", {})
    return {
        "text": scenario.get("said", scenario["text"]),
        "told": scenario.get("told", ""),
        "parts": parts_of(scenario.get("said", scenario["text"]), scenario["words"]) if scenario.get("words") else [],
        "confidence": scenario.get("confidence"),
        "base": scenario.get("base"),
        "slots": [(_words(name), _slot(value)) for name, value in facts.items()],
        "readings": scenario.get("readings", []),
        "notes": scenario.get("notes", []),
        "components": [_component(scenario, key, label) for key, label in _COMPONENTS.items()],
        "ruled_out": _ruled_out(scenario),
    }


def _slot(value: object) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, dict):  # another road user
        facts = cast("dict[str, object]", value)
        return "; ".join(f"{_words(name)} {_slot(fact)}" for name, fact in facts.items())
    return ", then ".join(map(_slot, cast("list[object]", value))) if isinstance(value, list) else str(value)


def _component(scenario: Row, key: str, label: str) -> Row:
    chosen = scenario.get("chosen", {}).get(key)
    found = scenario.get("candidates", {}).get(key, [])
    return {
        "label": label,
        "said": scenario.get("parts", {}).get(key, ""),
        "matches": [_candidate(match, match["snippet_id"] == chosen) for match in found],
    }


def _candidate(match: Row, chosen: bool) -> Row:
    return {
        "name": match["snippet_id"].partition("/")[2] or match["snippet_id"],
        "chosen": chosen,
        "description": match["description"],
        "conflicts": match.get("conflicts", []),
        "similarity": match["similarity"],
    }


def _ruled_out(scenario: Row) -> list[tuple[str, str]]:
    """What scored better but cannot be joined, or was joined and did something else; and why."""
    found = [(out["snippet_id"], out["reason"]) for out in scenario.get("ruled_out", [])]
    return found + [(" with ".join(one["snippet_ids"]), one["reason"]) for one in scenario.get("tried", [])]


def programs(sources: Mapping[str, str]) -> Markup:
    """The Scenic programs; the first is open."""
    if not sources:
        return fill_section("quiet", "No program was assembled.")
    return fill_section("programs", [(name, highlight(source)) for name, source in sources.items()])


def refinement(ranges: Sequence[Row], scenes: Sequence[Row]) -> Markup:
    """A plot per scenario, route and parameter; the first route is open."""
    key = ("scenario_id", "route_id")
    groups = groupby(sorted(ranges, key=lambda row: [row[k] for k in key]), key=lambda row: [row[k] for k in key])
    blocks: list[tuple[str, list[tuple[str, str, Plot]]]] = []
    for (scenario, route), rows in groups:
        own = [s for s in scenes if s["status"] == "ran" and s["scenario_id"] == scenario and s["route_id"] == route]
        blocks.append((f"{scenario}, {route.replace('-', ' ')}", _plots(list(rows), own)))
    return fill_section("refinement", blocks) if blocks else fill_section("quiet", "Nothing was searched.")


def _plots(rows: Sequence[Row], scenes: Sequence[Row]) -> list[tuple[str, str, Plot]]:
    """Of each parameter its name, its meaning and its plot."""
    names = list(dict.fromkeys(row["parameter"] for row in rows))
    return [
        (short(name), _meaning(rows, name), plot_ranges(name, [r for r in rows if r["parameter"] == name], scenes))
        for name in names
    ]


def _meaning(rows: Sequence[Row], name: str) -> str:
    row = next(row for row in rows if row["parameter"] == name)
    return f"{row['meaning']} [{row['unit']}]".strip()


def rejections(scenes: Sequence[Row]) -> Markup:
    """What could not be driven, and why."""
    rejected = [row for row in scenes if row["status"] == "rejected"]
    if not rejected:
        return fill_section("quiet", "No draw was rejected.")
    reasons = Counter(row["reason"] for row in rejected)
    ordered = sorted(reasons.items(), key=lambda item: (-item[1], item[0]))
    return fill_section("rejections", len(scenes), ordered, [(row["scene_id"], row["reason"]) for row in rejected])


def provenance(record: RunRecord) -> Markup:
    """What made this page, and the command that makes it again."""
    versions = ", ".join(f"{name} {number}" for name, number in record.versions.items())
    seconds = record.timings.get("total")
    facts = {
        "Versions": versions,
        "Seed": str(record.settings["search"]["seed"]),
        "Map": record.map_name,
        "Ego": record.ego,
        "Time": "not recorded" if seconds is None else f"{seconds:.1f} s, until this page was written",
    }
    if record.report is not None:
        told = record.report
        facts["Report"] = f"{told.name}, conflict {told.number} of {told.of}"
        facts["Left out of the report"] = " … ".join(told.left_out) or "nothing"
    if record.situation is not None and record.situation.read_by:
        facts["Read by"] = record.situation.read_by
    if left := _without_option(record):
        facts["Set from Python, as the command has no option for it"] = left
    return fill_section("provenance", command(record), list(facts.items()))


# The options of `chatscene run` that are settings; a test holds them to the command line.
OPTIONS = {
    ("search", "scenes"): "--scenes",
    ("search", "routes"): "--routes",
    ("search", "seed"): "--seed",
    ("search", "avoidable_only"): "--avoidable",
    ("search", "sampler"): "--sampler",
    ("simulation", "simulator"): "--simulator",
    ("simulation", "physics"): "--physics",
    ("simulation", "occlusion"): "--occlusion",
    ("retrieval", "library"): "--library",
    ("retrieval", "embedder"): "--embedder",
    ("retrieval", "language_model"): "--language-model",
    ("retrieval", "reader"): "--reader",
    ("retrieval", "reading"): "--reading",
    ("retrieval", "stated"): "--set",
}


def command(record: RunRecord) -> str:
    """The command line that repeats a run, where it was started; of what lies in the run folder, there."""
    if record.program is not None:
        words = ["chatscene", "run", "--program", f"programs/{quote(record.program.name, safe='')}.scenic"]
        words += options_of(record.generator)
    elif record.situation is not None:
        words = ["chatscene", "run", "situation.yaml"]
    elif record.generator == "chatscene":
        words = ["chatscene", "run", record.text, *(word for one in record.edits for word in ("--edit", one))]
    else:
        return f"# a scenario of: chatscene benchmark --generator {shlex.quote(record.generator)}"
    words += ["--map", record.map_name, "--ego", record.ego]
    for place, value in _changed(record).items():
        if place[0] == "retrieval" and record.situation is not None:
            continue  # a situation is not read again
        if place == ("retrieval", "stated"):
            words += [word for fact in str(value).split() for word in (OPTIONS[place], fact)]
        elif place in OPTIONS:
            words += _written(OPTIONS[place], value)
    return shlex.join(words)


def _written(option: str, value: object) -> list[str]:
    """An option and its value, as typed; a flag that is off where it is usually on has *no* before its name."""
    if isinstance(value, bool):
        return [option if value else option.replace("--", "--no-", 1)]
    return [option, str(value)]


def _without_option(record: RunRecord) -> str:
    changed = _changed(record)
    return ", ".join(f"{_words(place[1])} {value}" for place, value in changed.items() if place not in OPTIONS)


def _changed(record: RunRecord) -> dict[tuple[str, str], object]:
    """The settings that are not the default of the command, by group and name."""
    default = asdict(Settings(simulation=SimulationSettings(simulator=SIMULATOR)))
    return {
        (group, name): value
        for group, values in asdict(settings_of(record)).items()
        for name, value in values.items()
        if value != default.get(group, {}).get(name)
    }


# What the parts of a Scenic program are, to be coloured


_KEYWORDS = (
    "model|param|behavior|monitor|do|until|for|while|if|elif|else|try|interrupt|when|with|at|facing|on|in|new|"
    "require|terminate|after|take|wait|return|def|class|import|from|as|and|or|not|is|None|True|False|record|"
    "setup|compose|scenario|abort|break|continue|pass|lambda|ahead|behind|left|right|of|by|seconds|steps|offset"
)

_TOKEN = re.compile(
    r"(?P<comment>#[^\n]*)"
    r'|(?P<string>"""[\s\S]*?"""|\'\'\'[\s\S]*?\'\'\'|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\')'
    r"|(?P<tuned>\bOPT_\w+)"
    rf"|(?P<keyword>\b(?:{_KEYWORDS})\b)"
    r"|(?P<number>\b\d+(?:\.\d+)?\b)"
    r"|(?P<actor>\b(?:ego|AdvAgent|AdvBehavior|AdvClass|egoRoute|egoSpawnPt|advTrajectory)\b)"
)


def highlight(source: str) -> list[tuple[str, str]]:
    """The program in pieces, each with its kind: ``comment``, ``string``, ``tuned`` and so on, or none."""
    pieces: list[tuple[str, str]] = []
    end = 0
    for token in _TOKEN.finditer(source):
        pieces += [("", source[end : token.start()]), (token.lastgroup or "", token.group())]
        end = token.end()
    return [*pieces, ("", source[end:])]
