"""What the site has beside the pages of this folder: the repository's own, and two that are made of what there is.

`mkdocs build` calls `on_files` before it reads anything, and what else begins with `on_` for each page.
"""

from __future__ import annotations

import json
import re
from html import escape, unescape
from pathlib import Path

import click
from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

from chatscene.commands.main import main
from chatscene.report.index_columns import ROWS, TABLES
from chatscene.terms import vocabulary
from chatscene.terms.act_amounts import amounts_of
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.acts import Action

ROOT = Path(__file__).parents[1]
OF_THE_REPOSITORY = {
    "README.md": "index.md",
    "CONTRIBUTING.md": "contributing.md",
    "CHANGELOG.md": "changelog.md",
    "SECURITY.md": "security-policy.md",
}
WORDS = {
    "The ego's route: `ego.route`": vocabulary.EgoRoute,
    "The road: `road.kind`": vocabulary.RoadKind,
    "The surroundings of the road: `road.setting`": vocabulary.Setting,
    "Right of way at the junction: `road.control`": vocabulary.RightOfWay,
    "The ego's light: `road.ego_light`": vocabulary.EgoLight,
    "What the road has: `road.has`": vocabulary.Feature,
    "Kinds: `others.*.kind`": vocabulary.UserKind,
    "Roles: `others.*.role`": vocabulary.Role,
    "Directions: `others.*.starts.facing`": vocabulary.Facing,
    "Manners: `others.*.does.*.manner`": vocabulary.Manner,
    "Broken rules: `others.*.does.*.breaks`": vocabulary.Breach,
    "Who strikes: `contact.striker`": vocabulary.Striker,
}
MADE = re.compile(r"^<!-- made: (\w+) -->$", re.MULTILINE)
BLOCK = re.compile(r'<div (class="(?:[^"]* )?highlight"[^>]*>)<pre>(.*?)</pre>', re.DOTALL)
TAG = re.compile(r"<[^>]*>")
STATUS = re.compile(r"^Status: (.*?), (\d{4}-\d\d-\d\d)(.*)$", re.MULTILINE)


def on_files(files: Files, *, config: MkDocsConfig) -> Files:
    """Add the pages that no file of this folder holds."""
    made = {place: moved((ROOT / name).read_text()) for name, place in OF_THE_REPOSITORY.items()}
    made["decisions/index.md"] = decisions()
    made["reference/commands.md"] = commands()
    made |= {
        f"tutorials/{path.stem}.md": notebook(path) for path in sorted((ROOT / "docs" / "tutorials").glob("*.ipynb"))
    }
    for place, text in made.items():
        files.append(File.generated(config, place, content=text))
    return files


def on_page_markdown(markdown: str, *, page: Page, **_: object) -> str:
    """Make the tables, lead to the page of a tutorial, not to its notebook; keep decisions and logs out of the search.

    What a page has in place of a table is `<!-- made: NAME -->`, with a name in `TABLES_OF`.
    """
    if page.file.src_uri.startswith(("decisions/", "lab/")):
        page.meta["search"] = {"exclude": True}
    markdown = MADE.sub(lambda found: TABLES_OF[found[1]](), markdown)
    return re.sub(r"(tutorials/[\w-]+)\.ipynb\)", r"\1.md)", markdown)


def on_page_content(html: str, **_: object) -> str:
    """Let the button of a block copy its commands without prompts: Material copies `data-copy` where there is one."""
    return BLOCK.sub(_copied, html)


def _copied(block: re.Match[str]) -> str:
    lines = unescape(TAG.sub("", block[2])).splitlines()
    said = "\n".join(line.removeprefix("$ ") for line in lines if line.startswith("$ "))
    return f'<div data-copy="{escape(said)}" {block[1]}<pre>{block[2]}</pre>' if said else block[0]


def notebook(path: Path) -> str:
    """A notebook as a page: its words, its code, and what it holds that its cells printed, which a test runs again."""
    parts: list[str] = []
    for cell in json.loads(path.read_text())["cells"]:
        text = "".join(cell["source"])
        parts.append(text if cell["cell_type"] == "markdown" else f"```python\n{text}\n```")
        parts += [f"```text\n{''.join(output['text'])}```" for output in cell.get("outputs", [])]
    return "\n\n".join(parts) + "\n"


def moved(text: str) -> str:
    """A page of the repository with its links as they are seen from this folder."""
    text = text.replace("](docs/decisions)", "](decisions/index.md)").replace("](docs/", "](")
    for name, place in OF_THE_REPOSITORY.items():
        text = text.replace(f"]({name})", f"]({place})")
    return text


def decisions() -> str:
    """A table of all decisions, newest first."""
    rows: list[str] = []
    for page in sorted(ROOT.glob("docs/decisions/*.md"), reverse=True):
        text = page.read_text()
        number, title = text.splitlines()[0].removeprefix("# ").split(" ", 1)
        found = STATUS.search(text)
        assert found, page
        rows.append(f"| {number} | [{title}]({page.name}) | {found[1]}{found[3]} | {found[2]} |")
    head = ("# Decisions", "", "What could have been done otherwise, and why it was done so.", "")
    return "\n".join([*head, "| | decision | status | date |", "|---|---|---|---|", *rows, ""])


def commands() -> str:
    """What each command says of itself."""
    parts = ["# Command line", "What each command prints with `--help`."]
    for name, command, depth in walk(main, "chatscene", 2):
        context = click.Context(command, info_name=name, max_content_width=100, terminal_width=100)
        parts += [f"{'#' * depth} {name}", f"```text\n{command.get_help(context)}\n```"]
    return "\n\n".join(parts)


def walk(command: click.Command, name: str, depth: int) -> list[tuple[str, click.Command, int]]:
    """A command and those below it, with their names as they are typed."""
    names = command.commands if isinstance(command, click.Group) else ()
    below = ((child, command.get_command(click.Context(command), child)) for child in names)
    found = (one for child, each in below if each for one in walk(each, f"{name} {child}", depth + 1))
    return [(name, command, depth), *found]


def words() -> str:
    """The words of a situation that need no more than their meaning."""
    parts = [f"### {title}\n\n{table(('word', 'meaning'), rows_of(some))}" for title, some in WORDS.items()]
    touching = ", ".join(f"`{part}`" for part in vocabulary.Part)
    return "\n\n".join([*parts, f"### Parts that touch: `contact.ego`, `contact.other`\n\n{touching}"])


def rows_of(some: type[vocabulary.Word]) -> list[tuple[str, ...]]:
    """A row per word."""
    return [(f"`{word}`", word.meaning) for word in some]


def places() -> str:
    """Where somebody can start, and on which side."""
    rows: list[tuple[str, ...]] = []
    for where in vocabulary.Where:
        sides = "left or right" if where.row.sided else " or ".join(where.row.sides)
        rows.append((f"`{where}`", where.meaning, sides))
    return table(("word", "meaning", "`side`"), rows)


def deeds() -> str:
    """Every act of a situation, with what may be said of it and who can do it."""
    rows: list[tuple[str, ...]] = []
    for act in vocabulary.Act:
        amounts = "; ".join(f"`{name}`: {says}" for name, says in amounts_of(act).items())
        named = act.row.whom or act in vocabulary.FOR_SOMEBODY
        also = ", ".join(f"`{name}`" for name in ("to",) * act.row.sided + ("whom",) * named)
        rows.append((f"`{act}`", act.meaning, amounts, also, ", ".join(who(act))))
    return table(("act", "meaning", "amounts", "also", "by"), rows)


def who(act: vocabulary.Act) -> list[str]:
    """Who can do an act, by how they move."""
    moves = {Moves.DRIVES: "motor vehicles", Moves.RIDES: "two-wheelers", Moves.WALKS: "pedestrians and animals"}
    by = [name for how, name in moves.items() if how in act.row.by]
    by = ["all road users"] if len(by) == len(moves) else by
    return by + ["things"] * (Moves.LIES in act.row.by) + ["the ego"] * act.row.ego


def acts() -> str:
    """Every act that a snippet can show."""
    return table(("act", "what is seen"), [(f"`{action}`", action.row.meaning) for action in Action])


def tables() -> str:
    """The tables of `chatscene sql`, column by column."""
    parts: list[str] = []
    for name, columns in TABLES.items():
        rows = [(f"`{one.name}`", one.in_sql, one.unit, one.meaning) for one in columns]
        said = f"{ROWS[name][0].upper()}{ROWS[name][1:]}."
        parts.append(f"## {name}\n\n{said}\n\n{table(('column', 'type', 'unit', 'meaning'), rows)}")
    return "\n\n".join(parts)


def table(head: tuple[str, ...], rows: list[tuple[str, ...]]) -> str:
    """A table as Markdown has it."""
    lines = [head, ("---",) * len(head), *rows]
    return "\n".join(f"| {' | '.join(cells)} |" for cells in lines)


TABLES_OF = {"words": words, "places": places, "deeds": deeds, "acts": acts, "tables": tables}
