"""The list of commands, by what one wants to do, a line each."""

from __future__ import annotations

from collections.abc import Mapping

import click

SECTIONS: dict[str, dict[str, str]] = {
    "Make scenes": {
        "run": "Search a sentence, situation or program for crash scenes.",
        "explain": "Show how a text is understood; run nothing.",
        "edit": "Change a situation in words, and run it again.",
        "chat": "Describe, change and run situations line by line.",
        "describe": "Make up sentences.",
        "import": "Turn OpenSCENARIO XML into a Scenic program.",
        "resume": "Continue interrupted work.",
        "schema": "Print the JSON schema of situations.",
    },
    "Look at results": {
        "open": "Open a report in the browser.",
        "story": "Describe in words what happened in a drive.",
        "view": "Browse all runs, and make new ones, in the browser.",
        "why": "Explain why a scene crashed, and what avoids it.",
        "replay": "Simulate a stored scene again and compare it.",
        "runs": "List all runs.",
        "sql": "Query all runs.",
        "check": "Find damaged, missing and added files.",
    },
    "Measure": {
        "verify": "Check whether a scene shows what was said.",
        "evaluate": "Compare egos on kept scenes.",
        "rate": "Estimate how often a situation ends in a crash.",
        "coverage": "Show which situations of a catalogue can be made.",
        "drive": "Drive ordinary routes without an adversary.",
    },
    "Learn": {
        "train": "Train an ego on ordinary drives.",
        "finetune": "Train an ego on kept scenes.",
    },
    "Other tools": {
        "export": "Write scenes for other tools.",
        "mcp": "Serve agents by the Model Context Protocol.",
        "skill": "Install a skill into an agent's folder.",
        "serve-carla": "Serve CARLA's protocol without CARLA.",
        "map": "Show, check and import maps.",
        "library": "Search, check and extend the library of snippets.",
        "doctor": "Check this installation, or a simulator.",
    },
    "The paper": {
        "benchmark": "Search all base scenarios and measure egos.",
        "reproduce": "Make the paper's tables.",
    },
}


def write_sections(commands: Mapping[str, click.Command], formatter: click.HelpFormatter) -> None:
    """Write the list of commands; what has no line here comes last, with the first sentence of its help."""
    rows = {
        title: [(name, line) for name, line in lines.items() if name in commands] for title, lines in SECTIONS.items()
    }
    listed = {name for section in rows.values() for name, _ in section}
    rows["Other"] = [(name, one.get_short_help_str(limit=200)) for name, one in commands.items() if name not in listed]
    widest = max(len(name) for name in commands)
    for title, section in rows.items():
        if section:
            with formatter.section(title):
                formatter.write_dl([(name.ljust(widest), line) for name, line in section])
