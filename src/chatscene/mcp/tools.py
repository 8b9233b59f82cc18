"""The table of tools. A new tool is a function and its row."""

from __future__ import annotations

from chatscene.mcp import driving, writing
from chatscene.mcp.tool import Tool

TOOLS: dict[str, Tool] = {
    tool.name: tool
    for tool in (
        Tool(name="vocabulary", does=writing.vocabulary),
        Tool(name="read", does=writing.read, writes=True),
        Tool(name="build", does=writing.build, writes=True),
        Tool(name="verify", does=driving.verify, writes=True),
        Tool(name="story", does=driving.story),
        Tool(name="edit", does=writing.edit, writes=True),
        Tool(name="run", does=driving.run, writes=True),
        Tool(name="why", does=driving.why),
        Tool(name="rate", does=driving.rate),
        Tool(name="coverage", does=driving.coverage),
        Tool(name="export", does=driving.export, writes=True),
        Tool(name="import", does=writing.import_, writes=True),
    )
}
"""By name, in the order in which agents need them."""
