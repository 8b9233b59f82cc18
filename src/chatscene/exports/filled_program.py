"""A scene as the Scenic program that draws nothing: every range is replaced by the scene's value.

Whoever has `chatscene` installed compiles it with Scenic's own command; the map lies beside it. What the ego under test
did is not in it: a program says where everybody starts and what the others do.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from chatscene.errors import RunError
from chatscene.exports.exporter import KeptScene
from chatscene.terms.scene import OWN_MODEL

PLUGIN = {
    "name": "scenic",
    "makes": "FilledProgram",
    "what": "the program",
    "per scene": "`.scenic`, with the scene's values",
    "also": "the map, `.xodr`",
}

_DECLARED = re.compile(r"^param[ \t]+(OPT_\w+)[ \t]*=[^#\n]*?(?=[ \t]*(?:#|$))", re.MULTILINE)
_MODEL = re.compile(r"^model[ \t]+(\S+)[ \t]*$", re.MULTILINE)


class FilledProgram:
    """One ``.scenic`` per scene, and the map."""

    def files(self, scene: KeptScene) -> Mapping[str, bytes]:
        """The program of a scene, filled in, and the map.

        Raises:
            RunError: Scenic draws in the program itself, or the scene lacks a value of it.
        """
        scene_id = scene.episode.scene_id
        model = _MODEL.search(scene.program)
        if model is None or model[1] != OWN_MODEL:
            raise RunError(
                f"scene {scene_id!r} is of a program in which Scenic itself draws where things stand "
                f"(model {model[1] if model else 'unknown'}), so its values are not the whole scene; export what was "
                "driven: --to openscenario or --to csv"
            )

        def filled(declared: re.Match[str]) -> str:
            if (value := scene.values.get(declared[1])) is None:
                raise RunError(f"scene {scene_id!r} has no value of {declared[1]}, which its program declares")
            return f"param {declared[1]} = {value!r}"

        # The world model takes both, where they are set before it is loaded.
        place = f"param map = localPath({scene.map.name!r})\nparam route = {scene.route}\n"
        program = _MODEL.sub(lambda found: place + found[0], _DECLARED.sub(filled, scene.program), count=1)
        source = f"# scene {scene_id}\n{program}"
        return {f"{scene.stem}.scenic": source.encode(), scene.map.name: scene.map.content}
