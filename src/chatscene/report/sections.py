"""The sections of the report that are plain HTML. Everything that comes from outside is escaped here."""

from __future__ import annotations

import math
import shlex
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict
from html import escape
from itertools import groupby
from typing import Any
from urllib.parse import quote

from chatscene.evaluate.score import wilson
from chatscene.report.highlight import highlight
from chatscene.report.ranges import plot_ranges
from chatscene.runs import RunRecord, Status
from chatscene.settings import Settings

Row = Mapping[str, Any]

PROGRAM = "program"  # the generator that runs a user's own
_COMPONENTS = {"behavior": "Adversary's behavior", "geometry": "Road geometry", "spawn": "Spawn position"}


def heading(record: RunRecord, explanation: Row) -> str:
    """The sentence, what was read in it, and how far the run came where it did not end well."""
    said = escape(title(record))
    first = f"<h1>{said}</h1>" if record.generator == PROGRAM else f"<h1><q>{said}</q></h1>"
    return f"{first}{_reading(explanation)}{_banner(record)}"


def title(record: RunRecord) -> str:
    """The sentence; of a program of the user's own, whose text is all of its code, its name."""
    return _program_name(record) if record.generator == PROGRAM else record.text.strip()


def _program_name(record: RunRecord) -> str:
    return record.text.partition("\n")[0].removeprefix("## program ").strip()


def _reading(explanation: Row) -> str:
    """The slots in words: what the scenes are held against, which need not be all that was said."""
    facts = "; ".join(f"{_words(name)}: {_slot(value)}" for name, value in facts_of(explanation))
    return f'<p class="reading"><b>Read as</b> {escape(facts)}.</p>' if facts else ""


def facts_of(explanation: Row) -> list[tuple[str, object]]:
    """What was read: each slot with its value."""
    return [fact for scenario in explanation.get("scenarios", []) for fact in scenario.get("slots", {}).items()]


def _words(name: str) -> str:
    return name.replace("_", " ")


def _banner(record: RunRecord) -> str:
    if record.status is Status.DONE:
        return ""
    words = {
        Status.RUNNING: "This run is not finished. What is shown is what was done so far.",
        Status.FAILED: "This run failed. What is shown is what was done before.",
        Status.REFUSED: "This run was refused. Nothing was searched.",
    }
    reason = f"<br>{escape(record.reason)}" if record.reason else ""
    return f'<p class="banner" role="status"><strong>{words[record.status]}</strong>{reason}</p>'


def verdict(scenes: Sequence[Row], ego: str, *, read: bool) -> str:
    """How many scenes there are, how many crashed, how many were kept and show what was read; and who drove.

    Args:
        scenes: Driven ones and rejected ones.
        ego: Who drove and what it sees, as `chatscene.report.egos.egos_in_words` says it.
        read: Whether anything was read that scenes are held against.
    """
    ran = [row for row in scenes if row["status"] == "ran"]
    if not ran:
        return '<p class="verdict">No scene was driven.</p>'
    hits, kept = sum(row["collision"] for row in ran), sum(row["selected"] for row in ran)
    fill_ins = sum(row["fill_in"] for row in ran)
    avoidable = sum(row["avoidable"] is True for row in ran)
    low, high = wilson(hits, len(ran))
    fastest = max((row["impact_speed"] or 0.0 for row in ran), default=0.0)
    tiles = [
        (f"{hits / len(ran):.0%}", "collision rate", f"95 % interval {low:.0%} to {high:.0%} (Wilson)"),
        (
            f"{fastest:.1f} m/s" if hits else "none",
            "hardest impact",
            "speed of approach at contact" if hits else "nothing collided",
        ),
        (
            f"{kept}",
            "scenes kept",
            f"{fill_ins} of them without a collision" if fill_ins else "all of them with a collision",
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
    cells = "".join(
        f'<div class="tile"><dt>{escape(label)}</dt><dd>{value}</dd><dd class="note">{escape(note)}</dd></div>'
        for value, label, note in tiles
    )
    return (
        f'<p class="verdict">{_scenes(len(ran))} driven, <strong>{hits} collided</strong>'
        f" ({hits / len(ran):.0%}, 95 % interval {low:.0%} to {high:.0%}), <strong>{kept} kept</strong>. "
        f"{_shown(ran) if read else 'Nothing was read that a scene would have to show.'}</p>"
        f'<p class="senses"><b>The ego:</b> {escape(ego)}.</p>'
        f'<dl class="tiles">{cells}</dl>'
    )


def _shown(ran: Sequence[Row]) -> str:
    """How many scenes show all that was read; the kept ones apart."""
    kept = [bool(row["meaning_ok"]) for row in ran if row["selected"]]
    every = [bool(row["meaning_ok"]) for row in ran]
    return (
        f"Of {_scenes(len(kept), 'kept scene')} {sum(kept)} show all that was read; of all {len(every)}, "
        f"{sum(every)}, each as far as its drive went."
    )


def _scenes(count: int, what: str = "scene") -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def scene_table(scenes: Sequence[Row], units: Mapping[str, str], replayable: Iterable[str]) -> str:
    """The driven scenes in the order given; those in `replayable` have a button."""
    parameters = [name for name in units if any(row.get(name) is not None for row in scenes)]
    shown = set(replayable)
    head = "".join(
        f'<th scope="col"{kind}>{name}</th>'
        for name, kind in (
            ("Scene", ""),
            ("Outcome", ""),
            ("Impact<small>m/s</small>", ' class="n"'),
            ("Avoidable", ""),
            ("Who hit", ""),
            ("Score", ' class="n"'),
            ("As read", ""),
            *((f"{escape(short(name))}<small>{escape(units[name])}</small>", ' class="n"') for name in parameters),
        )
    )
    body = "".join(_scene_line(row, parameters, row["scene_id"] in shown) for row in scenes)
    return (
        '<div class="scroll" tabindex="0" role="region" aria-label="Scenes"><table class="scenes">'
        f"<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>"
    )


def short(parameter: str) -> str:
    """A parameter's name for a heading."""
    return parameter.removeprefix("OPT_").replace("_", " ").lower()


def scene_label(scene_id: str) -> str:
    """A scene's name without its scenario: ``route 00 · scene 017``."""
    return " · ".join(part.replace("-", " ") for part in scene_id.split("/")[-2:])


def _scene_line(row: Row, parameters: Sequence[str], replayable: bool) -> str:
    label = escape(scene_label(row["scene_id"]))
    ident = escape(row["scene_id"], quote=True)
    name = (
        f'<button type="button" class="play-scene" data-scene="{ident}" title="Replay {ident}">'
        f'<span aria-hidden="true">▶</span> {label}</button>'
        if replayable
        else f'<span title="{ident}">{label}</span>'
    )
    badge = ' <span class="chip kept">kept</span>' if row["selected"] else ""
    badge += ' <span class="chip">fill-in</span>' if row["fill_in"] else ""
    outcome = "collision" if row["collision"] else row["ending"]
    avoidable = {True: "yes", False: "no", None: ""}[row["avoidable"]]
    fault = (row["fault"] or "").replace("-", " ")
    failures = row["meaning_failures"] or []
    said = "yes" if not failures else f'<span class="no" title="{escape("; ".join(failures), quote=True)}">no</span>'
    numbers = "".join(f'<td class="n">{_number(row.get(name))}</td>' for name in parameters)
    return (
        f'<tr data-scene="{ident}"><th scope="row">{name}{badge}</th>'
        f'<td><span class="chip {"hit" if row["collision"] else ""}">{escape(outcome)}</span></td>'
        f'<td class="n">{_number(row["impact_speed"], 1)}</td><td>{avoidable}</td><td>{escape(fault)}</td>'
        f'<td class="n">{_number(row["overall_score"], 3)}</td>'
        f"<td>{said}</td>{numbers}</tr>"
    )


def _number(value: float | None, digits: int = 2) -> str:
    return "" if value is None or math.isnan(value) else f"{value:.{digits}f}"


def understanding(explanation: Row) -> str:
    """What was read in the sentence, what was looked at, and why the rest was not taken."""
    scenarios = explanation.get("scenarios", [])
    if not scenarios:
        return '<p class="quiet">The run ended before the sentence was understood.</p>'
    return "".join(_scenario(scenario, alone=len(scenarios) == 1) for scenario in scenarios)


def _scenario(scenario: Row, *, alone: bool) -> str:
    title = "" if alone else f"<h3><q>{escape(scenario['text'])}</q></h3>"
    slots = "".join(
        f'<span class="chip slot"><i>{escape(_words(name))}</i> {escape(_slot(value))}</span>'
        for name, value in scenario.get("slots", {}).items()
    )
    notes = "".join(f"<li>{escape(note)}</li>" for note in scenario.get("notes", []))
    cards = "".join(_component(scenario, key, label) for key, label in _COMPONENTS.items())
    return (
        f'{title}{_confidence(scenario)}<p class="slots">{slots}</p>'
        f"{f'<ul class=notes>{notes}</ul>' if notes else ''}"
        f'<p class="quiet">The bars show how near each snippet is to what was said, from 0 to 1.</p>'
        f'<div class="cards">{cards}</div>{_ruled_out(scenario)}'
    )


def _slot(value: object) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return ", then ".join(map(str, value)) if isinstance(value, list) else str(value)


def _confidence(scenario: Row) -> str:
    confidence = scenario.get("confidence")
    if confidence is None:
        return ""
    base = f", base scenario <b>{escape(scenario['base'])}</b>" if scenario.get("base") else ""
    return f'<p class="confidence">{_meter("Confidence", confidence)}<span>confidence{base}</span></p>'


def _meter(label: str, value: float) -> str:
    share = min(max(value, 0.0), 1.0)
    return (
        f'<span class="meter" role="img" aria-label="{escape(label, quote=True)} {value:.2f}">'
        f'<span style="width:{share:.0%}"></span></span><b class="value">{value:.2f}</b>'
    )


def _component(scenario: Row, key: str, label: str) -> str:
    said = escape(scenario.get("parts", {}).get(key, ""))
    chosen = scenario.get("chosen", {}).get(key)
    found = scenario.get("candidates", {}).get(key, [])
    items = "".join(_candidate(match, match["snippet_id"] == chosen) for match in found)
    return f'<article class="card"><h3>{label}</h3><p class="said">{said}</p><ol>{items}</ol></article>'


def _candidate(match: Row, chosen: bool) -> str:
    name = escape(match["snippet_id"].partition("/")[2] or match["snippet_id"])
    conflicts = "".join(f'<small class="no">{escape(conflict)}</small>' for conflict in match.get("conflicts", []))
    return (
        f'<li class="{"chosen" if chosen else ""}"><code>{name}</code>'
        f"{' <span class=chip>chosen</span>' if chosen else ''}"
        f"<small>{escape(match['description'])}</small>{conflicts}"
        f'<div class="bar">{_meter("similarity", match["similarity"])}</div></li>'
    )


def _ruled_out(scenario: Row) -> str:
    """What scored better but cannot be joined, or was joined and did something else."""
    found = [([out["snippet_id"]], out["reason"]) for out in scenario.get("ruled_out", [])]
    found += [(one["snippet_ids"], one["reason"]) for one in scenario.get("tried", [])]
    if not found:
        return ""
    items = "".join(f"<li><code>{escape(' with '.join(ids))}</code> {escape(reason)}</li>" for ids, reason in found)
    return f"<h3>Ruled out</h3><ul class=notes>{items}</ul>"


def programs(sources: Mapping[str, str]) -> str:
    """The Scenic programs; the first is open."""
    blocks = [
        f"<details{' open' if i == 0 else ''}><summary><code>programs/{escape(name)}.scenic</code></summary>"
        f'<pre class="code" tabindex="0"><code>{highlight(source)}</code></pre></details>'
        for i, (name, source) in enumerate(sources.items())
    ]
    return "".join(blocks) or '<p class="quiet">No program was assembled.</p>'


def refinement(ranges: Sequence[Row], scenes: Sequence[Row]) -> str:
    """A plot per scenario, route and parameter; the first route is open."""
    key = ("scenario_id", "route_id")
    groups = groupby(sorted(ranges, key=lambda row: [row[k] for k in key]), key=lambda row: [row[k] for k in key])
    blocks: list[str] = []
    for (scenario, route), rows in groups:
        own = [s for s in scenes if s["status"] == "ran" and s["scenario_id"] == scenario and s["route_id"] == route]
        plots = _plots(list(rows), own)
        title = f"{escape(scenario)}, {escape(route.replace('-', ' '))}"
        blocks.append(
            f'<details{"" if blocks else " open"}><summary>{title}</summary><div class="plots">{plots}</div></details>'
        )
    return "".join(blocks) or '<p class="quiet">Nothing was searched.</p>'


def _plots(rows: Sequence[Row], scenes: Sequence[Row]) -> str:
    names = list(dict.fromkeys(row["parameter"] for row in rows))
    return "".join(
        f"<figure><figcaption><b>{escape(short(name))}</b> {escape(_meaning(rows, name))}</figcaption>"
        f"{plot_ranges(name, [row for row in rows if row['parameter'] == name], scenes)}</figure>"
        for name in names
    )


def _meaning(rows: Sequence[Row], name: str) -> str:
    row = next(row for row in rows if row["parameter"] == name)
    return f"{row['meaning']} [{row['unit']}]".strip()


def rejections(scenes: Sequence[Row]) -> str:
    """What could not be driven, and why."""
    rejected = [row for row in scenes if row["status"] == "rejected"]
    if not rejected:
        return '<p class="quiet">No draw was rejected.</p>'
    reasons = Counter(row["reason"] for row in rejected)
    lines = "".join(
        f'<tr><td class="n">{count}</td><td>{escape(reason)}</td></tr>'
        for reason, count in sorted(reasons.items(), key=lambda item: (-item[1], item[0]))
    )
    listed = "".join(f"<li><code>{escape(row['scene_id'])}</code> {escape(row['reason'])}</li>" for row in rejected)
    return (
        f"<p>{len(rejected)} of {len(scenes)} draws could not be placed and were drawn again.</p>"
        f"<table><tbody>{lines}</tbody></table>"
        f"<details><summary>Each of them</summary><ul class=notes>{listed}</ul></details>"
    )


def provenance(record: RunRecord) -> str:
    """What made this page, and the command that makes it again."""
    versions = ", ".join(f"{name} {number}" for name, number in record.versions.items())
    seconds = record.timings.get("total")
    facts = {
        "Versions": versions,
        "Seed": str(record.seed),
        "Map": record.map_name,
        "Ego": record.ego,
        "Time": "not recorded" if seconds is None else f"{seconds:.1f} s, until this page was written",
    }
    if left := _without_option(record):
        facts["Set from Python, as the command has no option for it"] = left
    items = "".join(f"<div><dt>{name}</dt><dd>{escape(value)}</dd></div>" for name, value in facts.items())
    again = f'<pre class="code wrap" tabindex="0"><code>{escape(command(record))}</code></pre>'
    return f'{again}<dl class="facts">{items}</dl>'


# The options of `chatscene run` that are settings; a test holds them to the command line.
OPTIONS = {
    ("search", "scenes"): "--scenes",
    ("search", "routes"): "--routes",
    ("search", "seed"): "--seed",
    ("search", "avoidable_only"): "--avoidable",
    ("search", "sampler"): "--sampler",
    ("retrieval", "library"): "--library",
    ("retrieval", "embedder"): "--embedder",
    ("retrieval", "language_model"): "--language-model",
}


def command(record: RunRecord) -> str:
    """The command line that repeats a run, where it was started; of a program of one's own, in the run folder."""
    if record.generator == PROGRAM:
        words = ["chatscene", "run", "--program", f"programs/{quote(_program_name(record), safe='')}.scenic"]
    elif record.generator == "chatscene":
        words = ["chatscene", "run", record.text]
    else:
        return f"# a scenario of: chatscene benchmark --generator {shlex.quote(record.generator)}"
    words += ["--map", record.map_name, "--ego", record.ego]
    for place, value in _changed(record).items():
        if place in OPTIONS:
            words += [OPTIONS[place]] if value is True else [OPTIONS[place], str(value)]
    return shlex.join(words)


def _without_option(record: RunRecord) -> str:
    changed = _changed(record)
    return ", ".join(f"{_words(place[1])} {value}" for place, value in changed.items() if place not in OPTIONS)


def _changed(record: RunRecord) -> dict[tuple[str, str], object]:
    """The settings that are not the default, by group and name."""
    default = asdict(Settings())
    return {
        (group, name): value
        for group, values in record.settings.items()
        for name, value in values.items()
        if value != default.get(group, {}).get(name)
    }
