"""Scenic is imported without what it needs in space alone, and has that once it is asked for."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

HEAD = "import sys\nimport chatscene\n"
IN_SPACE = """
import scenic
scene, _ = scenic.scenarioFromString("ego = new Object at (0, 0, 0), with width 2").generate()
assert "trimesh" in sys.modules
import trimesh
from scenic.core import regions
space = scene.egoObject.occupiedSpace
assert isinstance(space.mesh, trimesh.Trimesh)
assert abs(space.mesh.volume - 2.0) < 1e-9
assert space.containsPoint((0.9, 0.0, 0.0)) and not space.containsPoint((1.1, 0.0, 0.0))
assert space.getSurfaceRegion().intersects(regions.BoxRegion(position=(1, 0, 0)))
assert issubclass(regions.SurfaceCollisionTrimesh, trimesh.Trimesh)
assert not regions.SurfaceCollisionTrimesh(space.mesh.vertices, space.mesh.faces).is_convex
"""
IN_THE_PLANE = """
from chatscene.maps.network import resolve_map
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator
from chatscene.terms.scene import Scene, ScenicProgram
source = '''model chatscene.world.model
egoRoute = selectRoute(maneuver="straight")
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
other = new Truck at pointOn(egoRoute, 30)
'''
program = ScenicProgram(scenario_id="plane", source=source, parameters=(), snippet_ids=())
scene = Scene(id="plane/0", scenario_id="plane", route=0, block=0, seed=0, values={})
session = load_simulator(resolve_map("town"), SimulationSettings()).open(program, scene)
for _ in range(5):
    session.step((0.5, 0.0))
session.episode("plane/0", "nobody")
left = {"trimesh", "networkx", "cv2", "fcl", "scipy.ndimage", "scipy.spatial", "PIL"} & set(sys.modules)
assert not left, left
"""
ROTATED = """
from scenic.core import vectors
import scipy.spatial
from scipy.spatial import transform
assert transform.Rotation is vectors.Rotation
assert scipy.spatial.KDTree([(0.0, 0.0), (1.0, 1.0)]).query((0.9, 0.9))[1] == 1
"""
PICTURED = """
import numpy as np
from scenic.core import sensors
assert "PIL" not in sys.modules
assert sensors.valueExtHandlers.get("npy") is sensors.npyHandler and "PIL" not in sys.modules
assert sensors.valueExtHandlers.get("no-such-format") is None
sensors.valueExtHandlers.get("png")(sys.argv[1], np.full((2, 3, 3), 255, np.uint8), {})
from PIL import Image
assert Image.open(sys.argv[1]).size == (3, 2)
"""
WHOLE = """
import scenic
from chatscene.plane import whole
whole()
assert {"trimesh", "fcl", "scipy.spatial"} <= set(sys.modules)
"""
FIRST = """
import trimesh
import scenic.core.regions as regions
assert issubclass(regions.SurfaceCollisionTrimesh, trimesh.Trimesh)
"""


def _runs(program: str, *given: str) -> None:
    done = subprocess.run([sys.executable, "-c", HEAD + program, *given], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_a_program_in_the_plane_loads_nothing_that_is_for_space() -> None:
    _runs(IN_THE_PLANE)


def test_bodies_in_space_are_as_scenic_has_them() -> None:
    _runs(IN_SPACE)


def test_rotations_are_scipys_own() -> None:
    _runs(ROTATED)


def test_pictures_of_sensors_are_written_once_somebody_asks_for_them(tmp_path: Path) -> None:
    _runs(PICTURED, str(tmp_path / "seen.png"))


def test_who_has_loaded_meshes_before_keeps_them() -> None:
    _runs(FIRST)


def test_a_process_that_can_load_nothing_later_has_all_at_once() -> None:
    _runs(WHOLE)
