"""A short plan of a map: its junctions, and the streets between them."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from chatscene.maps.writing.objects import Bay, Crosswalk, Driveway
from chatscene.maps.writing.reference_lines import Corner
from chatscene.terms.scenario import Control

LANE = 3.5  # [m]
SHOULDER = 1.5  # [m]
SIDEWALK = 2.5  # [m]
RIDDEN = 2.6  # [m] of a lane for bicycles that is one to drive on: no narrower one is
SETBACK = 20.0  # [m], from a junction's centre to where its arms end: corner sidewalks must not overlap


@dataclass(frozen=True, slots=True, kw_only=True)
class Node:
    """A junction.

    Attributes:
        id: From 1 up.
        x: Centre [m].
        y: Centre [m].
        control: How it is controlled.
        setback: From its centre to where its arms end [m].
        abreast: Whether one turns in as many lanes as both roads have, as in a roundabout; in one if not.
        marked: Whether a crosswalk leads across each of its arms.
        minor: The ids of the streets that alone have its signs; of none, all have them.
        gives_way: Whether its signs are to give way, and not to stop.
    """

    id: int
    x: float
    y: float
    control: Control
    setback: float = SETBACK
    abreast: bool = False
    marked: bool = False
    minor: tuple[int, ...] = ()
    gives_way: bool = False


class Surroundings(Enum):
    """OpenDRIVE's type of a road, and the speed allowed there [km/h]."""

    TOWN = ("town", 50)
    ZONE = ("town", 30)
    RURAL = ("rural", 100)
    COUNTRY = ("rural", 80)
    MOTORWAY = ("motorway", 120)
    SLOWER_MOTORWAY = ("motorway", 110)
    MOTORWAY_END = ("motorway", 80)
    RAMP = ("motorway", 60)
    LOT = ("town", 10)
    ANY = ("unknown", 50)  # of which no limit is usual


@dataclass(frozen=True, slots=True, kw_only=True)
class Street:
    """A street or a carriageway between two junctions, or a part of one.

    Attributes:
        id: Unique among streets, from 1 up.
        start: Junction at its start, or the id of the street that leads on into it; None where the map begins.
        end: Junction at its end, or the id of the street it leads on into; None where the map ends.
        lanes: Lanes in its direction.
        back: Lanes in the other direction: none of a carriageway; None stands for as many.
        via: Its corners.
        start_at: Where it starts [m], if not at its junction's setback.
        end_at: Where it ends [m], if not at its junction's setback.
        lane: Width of a lane [m].
        shoulder: Width of each shoulder [m], 0 for none.
        sidewalk: Width of each sidewalk [m], 0 for none.
        begins: From where to where [m] the outermost lanes come into being.
        ceases: From where to where [m] the outermost lanes taper out.
        inner: From where to where [m] the innermost lane of a carriageway tapers out into its median, if it does.
        one_sided: Whether only the outermost lane in its direction does either.
        nose: Over how many metres the shoulder widens from nothing at the start, and narrows to nothing at the end.
        median: Width of the grass on the left of a carriageway [m], 0 for none.
        surroundings: Which speed is allowed.
        bays: Along it.
        crosswalks: Across it.
        cycle: Whether its shoulders are lanes for bicycles.
        tram: Whether rails lie in the innermost lane of each direction.
        rails: Where rails lead across it [m along the street].
        bus_lane: Whether its outermost lane is for buses.
        ridden: Whether its outermost lane is for bicycles, and as narrow as they need it.
        kerbs: Whether a carriageway has a shoulder and a sidewalk on its left, too.
        driveways: That lead off it.
        allowed: The speed allowed [km/h], if not what its surroundings have.
    """

    id: int
    start: Node | int | None
    end: Node | int | None
    lanes: int
    back: int | None = None
    via: tuple[Corner, ...] = ()
    start_at: tuple[float, float] | None = None
    end_at: tuple[float, float] | None = None
    lane: float = LANE
    shoulder: float = SHOULDER
    sidewalk: float = SIDEWALK
    begins: tuple[float, float] | None = None
    ceases: tuple[float, float] | None = None
    inner: tuple[float, float] | None = None
    one_sided: bool = False
    nose: tuple[float, float] = (0.0, 0.0)
    median: float = 0.0
    surroundings: Surroundings = Surroundings.TOWN
    bays: tuple[Bay, ...] = ()
    crosswalks: tuple[Crosswalk, ...] = ()
    cycle: bool = False
    tram: bool = False
    rails: tuple[float, ...] = ()
    bus_lane: bool = False
    ridden: bool = False
    kerbs: bool = False
    driveways: tuple[Driveway, ...] = ()
    allowed: int | None = None

    @property
    def lanes_back(self) -> int:
        """Lanes in the other direction."""
        return self.lanes if self.back is None else self.back

    def width_of(self, number: int, *, right: bool) -> float:
        """How wide [m] a lane is, from 1 for the innermost."""
        return RIDDEN if self.ridden and right and number == self.lanes else self.lane

    def edge(self, *, right: bool) -> float:
        """How far [m] the lanes of a direction reach from the reference line."""
        lanes = self.lanes if right else self.lanes_back
        return sum(self.width_of(number, right=right) for number in range(1, lanes + 1))
