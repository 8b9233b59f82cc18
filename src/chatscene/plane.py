"""Scenic without what it needs for bodies in space alone.

All programs run in two dimensions. For three, Scenic imports meshes (trimesh, and with it networkx and half of SciPy),
their collisions (fcl), and pictures and videos of cameras (Pillow with all its formats, cv2) as it is imported itself,
which takes as long as all the rest of it. Of SciPy's space it needs rotations alone. Here these stand in as modules
that are imported once something is asked of them.
"""

from __future__ import annotations

import importlib
import sys
from collections.abc import Sequence
from importlib.machinery import ModuleSpec, PathFinder
from pathlib import Path
from types import ModuleType
from typing import Any

LATER = ("scenic.core.scenarios", "scenic.core.pruning")  # Scenic's own that it imports in its first compilation
MESHES = ("trimesh", "trimesh.transformations", "trimesh.voxel", "fcl", "cv2")
ROTATIONS = ("scipy.spatial", "scipy.spatial.transform")
SPACE = (*MESHES, *ROTATIONS, "PIL", "PIL.Image")


class _Later(ModuleType):
    """A module that is imported once something is asked of it, but for what Scenic asks as it is imported."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        if sys.modules.get(self.__name__) is self:  # Scenic is being imported
            if self.__name__ == "trimesh.transformations":
                return _Function(self.__name__, name)
            if name in _AT_ONCE:
                return _AT_ONCE[name]
            if name == "Rotation":
                return importlib.import_module("scipy.spatial.transform._rotation").Rotation
            if (inner := sys.modules.get(f"{self.__name__}.{name}")) is not None:
                return inner
        found = _real(self.__name__)
        return getattr(found, name) if hasattr(found, name) else _real(f"{self.__name__}.{name}")


class _Function:
    """A function of a module that is imported once it is called."""

    def __init__(self, module: str, name: str) -> None:
        self._where = module, name

    def __call__(self, *given: Any, **named: Any) -> Any:
        module, name = self._where
        return getattr(_real(module), name)(*given, **named)


def _real(name: str) -> ModuleType:
    """The module itself, imported now if it was not."""
    if isinstance(sys.modules.get(name), _Later):
        _take_away()
    found = importlib.import_module(name)
    _mend()
    return found


class _Mesh:
    """A base class in place of trimesh's."""


class UnitBox:
    """The mesh of a box of unit length, width and height, as far as Scenic's default shape asks for it."""

    is_volume = is_convex = True
    extents = (1.0, 1.0, 1.0)
    vertices = 0.0

    def __init__(self) -> None:
        self.bounding_box = self
        self.center_mass = 0.0

    def copy(self) -> UnitBox:
        """Itself, since it never changes."""
        return self

    def apply_transform(self, matrix: Any) -> None:
        """Nothing: it is scaled to what it is."""


class _Creation:
    @staticmethod
    def box(size: Sequence[float]) -> UnitBox:  # noqa: ARG004 - of trimesh; Scenic asks for the unit box alone
        return UnitBox()


class _Formats(dict[str, Any]):
    """How Scenic writes what a sensor sees, by a file's ending; those of pictures are added once one is asked for.

    Args:
        own: Those that Scenic has without Pillow.
        picture: How it writes any picture.
    """

    def __init__(self, own: dict[str, Any], picture: Any) -> None:
        super().__init__(own)
        self._picture = picture

    def get(self, ending: str, *otherwise: Any) -> Any:
        """As a dictionary's."""
        if ending not in self:
            image = _real("PIL.Image")
            known = (e for e, name in image.registered_extensions().items() if name in image.SAVE)
            self.update({e[1:]: self._picture for e in known if e[1:] not in self})
        return super().get(ending, *otherwise)


def _no_formats() -> dict[str, str]:
    return {}


_AT_ONCE: dict[str, Any] = {"Trimesh": _Mesh, "creation": _Creation, "registered_extensions": _no_formats}


def _take_away() -> None:
    for name in SPACE:
        if isinstance(sys.modules.get(name), _Later):
            del sys.modules[name]


def _mend() -> None:
    """Put into Scenic what was made without trimesh: the one class that inherits from it."""
    regions: Any = sys.modules.get("scenic.core.regions")
    trimesh: Any = sys.modules.get("trimesh")
    if regions is not None and trimesh is not None and issubclass(regions.SurfaceCollisionTrimesh, _Mesh):
        own = {"is_convex": vars(regions.SurfaceCollisionTrimesh)["is_convex"], "__module__": regions.__name__}
        regions.SurfaceCollisionTrimesh = type("SurfaceCollisionTrimesh", (trimesh.Trimesh,), own)


def _mesh_of(shape: Any) -> Any:
    """The mesh of a shape; of the default shape, made now if it was not."""
    if isinstance(shape._mesh, UnitBox):
        _real("trimesh")
        shape._mesh = type(shape)()._mesh
    return shape._mesh


class _Loader:
    """Scenic's own loader, with stand-ins while it works."""

    def __init__(self, own: Any) -> None:
        self._own = own

    def __getattr__(self, name: str) -> Any:
        return getattr(self._own, name)

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        """As Scenic's own."""
        found: ModuleType | None = self._own.create_module(spec)
        return found

    def exec_module(self, module: ModuleType) -> None:
        """As Scenic's own, which imports most of it."""
        without_pictures = "PIL" not in sys.modules
        for name in SPACE:
            sys.modules.setdefault(name, _Later(name))
        for name in ROTATIONS:
            if isinstance(later := sys.modules[name], _Later):  # a package, whose modules can be imported alone
                later.__path__ = [str(Path(importlib.import_module("scipy").__path__[0], *name.split(".")[1:]))]
        try:
            self._own.exec_module(module)
            for name in LATER:
                importlib.import_module(name)
        finally:
            _take_away()
        shapes: Any = importlib.import_module("scenic.core.shapes")
        shapes.MeshShape.mesh = property(_mesh_of)
        sensors: Any = importlib.import_module("scenic.core.sensors")
        if without_pictures:
            sensors.valueExtHandlers = _Formats(sensors.valueExtHandlers, sensors.pilHandler)
        _mend()


class Flat:
    """Finds Scenic, and nothing else, for `sys.meta_path`."""

    @staticmethod
    def find_spec(name: str, path: Sequence[str] | None = None, target: ModuleType | None = None) -> ModuleSpec | None:
        """Scenic's own, with another loader."""
        if name != "scenic" or "trimesh" in sys.modules:
            return None
        spec = PathFinder.find_spec(name, path, target)
        if spec is not None and spec.loader is not None:
            loader: Any = _Loader(spec.loader)
            spec.loader = loader
        return spec


def use_flat() -> None:
    """Import Scenic so from now on, in this process."""
    if Flat not in sys.meta_path:
        sys.meta_path.insert(0, Flat)


def whole() -> None:
    """Import all that was left out, for a process that can import nothing later on."""
    for name in SPACE:
        _real(name)
