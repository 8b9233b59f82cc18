"""Streets of OpenStreetMap as OpenDRIVE, by SUMO's ``netconvert``, which runs behind the walls of the kernel.

Its options are described at sumo.dlr.de/docs/netconvert.html.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from xml.etree import ElementTree as Xml

from chatscene.errors import MapError, MissingExtra
from chatscene.maps.openstreetmap import Extract
from chatscene.simulate.confined.confinement import Limits
from chatscene.simulate.confined.executable import GIVEN, Executable, run_confined

LIMITS = Limits(processor=120, wall=300.0, memory=2048, message=64 * 2**20)
SMALLER = "import a smaller area"

OPTIONS = (
    ("--osm-files", GIVEN),
    ("--opendrive-output", "stdout"),
    ("--xml-validation", "never"),
    ("--precision", "4"),
    # Metres around the middle of the streets, north up: what `geoReference` then says is all there is to it.
    ("--offset.disable-normalization",),
    ("--flatten",),
    ("--default.lanewidth", "3.5"),
    ("--keep-edges.by-vclass", "passenger"),
    # Nodes that only bend or tag a street do not cut it; nodes that are one junction in the street become one.
    ("--geometry.remove",),
    ("--junctions.join",),
    ("--no-turnarounds",),
    ("--roundabouts.guess",),
    ("--ramps.guess",),
    # Lights before a junction hold for it; those of crosswalks alone, which would cut the street, are left out.
    ("--tls.guess-signals",),
    ("--tls.discard-simple",),
    ("--tls.join",),
    ("--osm.sidewalks",),
    ("--osm.turn-lanes",),
)
"""What netconvert is told, besides the projection."""

PACKAGE = "eclipse-sumo"


@dataclass(frozen=True, slots=True, kw_only=True)
class Conversion:
    """A street as OpenDRIVE.

    Attributes:
        xodr: The file; of one extract always the same bytes.
    """

    xodr: bytes
    warnings: tuple[str, ...]


def installed_netconvert() -> Executable:
    """SUMO's netconvert as the extra ``osm`` brings it.

    Raises:
        MissingExtra: It is not installed.
    """
    found = find_spec("sumo")
    folder = None if found is None or found.origin is None else Path(found.origin).resolve().parent
    if folder is None or not (folder / "bin" / "netconvert").is_file():
        raise MissingExtra(f"a map is made of an extract by netconvert of the package {PACKAGE}", extra="osm")
    geodesy = str(folder / "data" / "proj")
    return Executable(
        command=(str(folder / "bin" / "netconvert"),),
        readable=(str(folder), str(folder.with_name("eclipse_sumo.libs"))),
        environment={
            "LC_ALL": "C.UTF-8",
            "SUMO_HOME": str(folder),
            "PROJ_DATA": geodesy,
            "PROJ_LIB": geodesy,
            "OPENBLAS_NUM_THREADS": "1",  # it may make no thread, and would fail to
        },
    )


def convert(path: Path, extract: Extract, limits: Limits = LIMITS) -> Conversion:
    """Make OpenDRIVE of the streets of an extract.

    Raises:
        MissingExtra: netconvert is not installed.
        MapError: It failed, crashed, or used up its time or memory; or it found no road.
        SandboxError: It cannot be confined here.
    """
    netconvert = installed_netconvert()
    projection = f"+proj=tmerc +lat_0={extract.latitude} +lon_0={extract.longitude} +k=1 +x_0=0 +y_0=0 +datum=WGS84"
    arguments = (*(word for option in OPTIONS for word in option), "--proj", f"{projection} +units=m")
    ended = run_confined(netconvert, arguments, path, limits)
    warnings = tuple(line.removeprefix("Warning: ") for line in ended.said if line.startswith("Warning: "))
    if ended.fault:
        errors = [line.removeprefix("Error: ") for line in ended.said if line.startswith("Error: ")]
        raise MapError(
            f"netconvert made no map of {path}: {ended.fault}"
            f"{': ' if errors else ''}{'; '.join(errors[:3])}; {SMALLER}, or look at the place it names in an editor"
        )
    text, closing, _ = ended.output.partition(b"</OpenDRIVE>")  # behind it stands that it was a success
    try:
        root = Xml.fromstring(text + closing)
    except Xml.ParseError as error:
        raise MapError(
            f"netconvert made no map of {path}, but something that is not XML: {error}; {SMALLER}"
        ) from error
    if root.find("road") is None:
        raise MapError(
            f"netconvert found no road in {path}, of {extract.streets} streets: "
            f"{'; '.join(warnings[:3]) or 'it does not say why'}; if all are closed to cars, import another area"
        )
    return Conversion(xodr=_tidied(root), warnings=warnings)


def _tidied(root: Xml.Element) -> bytes:
    """OpenDRIVE without a date, so that it is always the same, and with lengths that readers take.

    The length that netconvert gives a curve may be a billionth of a metre more than the curve has: Scenic then looks
    for a point beyond its end, and fails.
    """
    for header in root.iter("header"):
        header.attrib.pop("date", None)
    for geometry in root.iter("geometry"):
        curve = geometry.find("paramPoly3")
        if curve is not None:
            longest = _arc_length(curve) - 2e-9
            geometry.set("length", f"{min(float(geometry.get('length', '0')), longest):.9f}")
    notice = f"Streets from OpenStreetMap (c) OpenStreetMap contributors, ODbL 1.0, by netconvert {version(PACKAGE)}"
    return f'<?xml version="1.0" encoding="UTF-8"?>\n<!-- {notice} -->\n'.encode() + Xml.tostring(root) + b"\n"


def _arc_length(curve: Xml.Element) -> float:
    """The length [m] of a ``paramPoly3`` whose parameter runs from 0 to 1."""
    from scipy.integrate import quad

    k = {name: float(curve.get(name, "0")) for name in ("bU", "cU", "dU", "bV", "cV", "dV")}

    def speed(p: float) -> float:
        return math.hypot(*(k[f"b{axis}"] + 2 * k[f"c{axis}"] * p + 3 * k[f"d{axis}"] * p * p for axis in "UV"))

    return float(quad(speed, 0.0, 1.0)[0])
