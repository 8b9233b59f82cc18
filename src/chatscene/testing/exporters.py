"""What every exporter owes; see `chatscene.exports.exporter.Exporter`."""

from __future__ import annotations

import copy
from collections.abc import Callable
from pathlib import Path

import numpy as np

from chatscene.errors import RunError
from chatscene.exports.exporter import Exporter, KeptScene, MapFile, load_exporter
from chatscene.library.load import load_library
from chatscene.maps.network import resolve_map
from chatscene.program.assemble import assemble
from chatscene.program.sample import scene_at
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator
from chatscene.terms.actors import BY_CLASS, AdversaryKind
from chatscene.terms.episode import Ending, Episode, Role, Track
from chatscene.terms.scenario import Scenario, Slots, SubDescriptions
from chatscene.terms.scene import Rejected
from chatscene.terms.surroundings import Light, Surface, Surroundings, Weather
from chatscene.testing.contract import maker, require

_MAP = MapFile(
    name="some map.xodr",
    content=b"""<OpenDRIVE><header revMajor="1" revMinor="4"/><road name="" length="400" id="1" junction="-1">
<planView><geometry s="0" x="99900" y="0" hdg="0" length="400"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none" level="false"/></center>
<right><lane id="-1" type="driving" level="false"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right>
</laneSection></lanes></road></OpenDRIVE>
""",
)
_PROGRAM = """# Somebody steps out.

model chatscene.world.model

param OPT_SPEED = Range(0.5, 4)
param OPT_GEO_Y = Range(-3, 50)  # [m] ahead
"""
_SURROUNDED = (
    Surroundings(),
    Surroundings(light=Light.NIGHT, weather=Weather.FOG, surface=Surface.ICE),
    Surroundings(light=Light.DUSK, weather=Weather.SNOW, surface=Surface.SNOW),
)


def check_exporter(exporter: str | Callable[[], Exporter]) -> None:
    """Hold an exporter to the contract of all.

    Args:
        exporter: Its name, ``package.module:factory``, or what makes one.

    Raises:
        ContractBroken: It breaks a rule; the message says which.
        SettingsError: There is none of that name.
        MissingExtra: Its package is missing.
    """
    make = maker(exporter, load_exporter)
    seen: dict[str, bytes] = {}
    for scene in (*awkward_scenes(), planned_scene()):
        before = copy.deepcopy(scene.episode.tracks)
        try:
            files = dict(make().files(scene))
        except RunError:
            continue  # it lacks what the format needs
        name = scene.episode.scene_id
        own = [file for file in files if file == scene.map.name or file.startswith(scene.stem)]
        require(bool(own), "a scene has a file that begins with its stem, or its map", (name, list(files)))
        for file, content in files.items():
            require(Path(file).name == file, "the name of a file has no folder in it", file)
            require(type(content) is bytes and content != b"", "a file has content, in bytes", file)
            same = seen.setdefault(file, content) == content
            require(same, "what several scenes need has one content, all else has names of its own", file)
        if scene.map.name in files:
            require(files[scene.map.name] == scene.map.content, "the map is copied as it is")
        require(files == make().files(scene), "the same scene gives the same bytes", name)
        untouched = all(map(_same, before, scene.episode.tracks))
        require(untouched, "an exporter leaves the scene as it is", name)
    require(bool(seen), "there is a scene of which it gives files")


def _same(one: Track, other: Track) -> bool:
    return all(np.array_equal(getattr(one, name), getattr(other, name)) for name in ("x", "y", "heading", "speed"))


def awkward_scenes() -> list[KeptScene]:
    """Everybody and everything there is, moving and standing, under names and words that some formats escape."""
    scenes: list[KeptScene] = []
    for index, surroundings in enumerate(_SURROUNDED):
        steps = (1, 2, 40)[index]
        kinds = ["Car", *BY_CLASS, "BusStop", "Hovercraft"]
        tracks = tuple(_track(number, kind, steps) for number, kind in enumerate(kinds))
        episode = Episode(
            scene_id=f"some-one/route-00/scene-{index:03d}",
            ego="idm",
            dt=0.1,
            tracks=tracks,
            events=(),
            signals=(),
            ending=Ending.TIMEOUT,
            route_completion=0.5,
            distance_to_route=np.zeros(steps),
            off_road=np.zeros(steps, np.bool_),
            surroundings=surroundings,
        )
        scenes.append(
            KeptScene(
                episode=episode,
                text='a "quoted" <car> & a straße\n',
                program=_PROGRAM,
                values={"OPT_SPEED": 1.25 + index, "OPT_GEO_Y": -3.0},
                route=index,
                map=_MAP,
            )
        )
    return scenes


def planned_scene() -> KeptScene:
    """The beginning of a scene of packaged snippets: somebody ahead in the next lane brakes, which a plan says."""
    library = load_library()
    names = ("behavior/lane-brake", "geometry/lane-change-left", "spawn/adjacent-lane-ahead")
    behavior, geometry, spawn = map(library.get, names)
    scenario = Scenario(
        id="planned",
        text="Somebody brakes.",
        base=None,
        parts=SubDescriptions(behavior="", geometry="", spawn=""),
        slots=Slots(),
    )
    program = assemble(scenario, (behavior, geometry, spawn), AdversaryKind.CAR)
    path = resolve_map("town")
    simulator = load_simulator(path, SimulationSettings())
    scene = scene_at(program, 0, 0.5, name="scene-000")
    session = simulator.open(program, scene)
    assert not isinstance(session, Rejected)
    episode = session.episode(scene.id, "idm")
    session.close()
    return KeptScene(
        episode=episode,
        text=scenario.text,
        program=program.source,
        values=scene.values,
        route=0,
        map=MapFile(name=path.name, content=path.read_bytes()),
        joined=lambda: program,
    )


def _track(number: int, kind: str, steps: int) -> Track:
    """Every third stands, every other one backs up while its heading goes round."""
    t = np.arange(steps) * 0.1
    speed = np.full(steps, 0.0 if number % 3 == 2 else (-1.5 if number % 2 else 7.0))
    turning = 0.0 if number % 3 == 2 else 1.0
    return Track(
        actor="ego" if number == 0 else f'actor "{number}" <é>',
        role=(Role.EGO, Role.ADVERSARY, Role.OCCLUDER, Role.BACKGROUND)[min(number, 3)],
        kind=kind,
        length=2.0,
        width=1.0,
        x=1e5 + 4.0 * number + speed * t,
        y=-1e-7 * number + 0.0 * t,
        heading=3.0 + turning * t,
        speed=speed,
    )
