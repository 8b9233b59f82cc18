"""Road users: the one table of their kinds. A new kind is a row here, and a class in `world/model.scenic`.

A row may be *like* another (`RoadUser.like`): then snippets that name the other serve it too, and whoever was trained
before there was such a kind hears it as the other. It differs in what it is: size, limits, words, drawing.

Lorries and buses hold 90 and 100 km/h, at which their limiters are set (Directive 92/6/EEC, articles 2 and 3).
Sizes are those of typical road users, accelerations mid-size production figures; the car is CARLA's Lincoln MKZ
2017. How long pedals and the yaw rate take is for the physics ``lagged`` alone, where the sources stand
(`chatscene.simulate.embedded.lagged`). Walkers: sprint starts reach about 4 m/s²; 8 m/s is a fast adult's sprint. The
nouns are written by us, after the way crash reports, test protocols, driving schools and people at the kitchen table
speak.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import lru_cache
from typing import Any
from weakref import WeakKeyDictionary

from chatscene.terms.nouns import with_article

THING_HEIGHT = 2.0  # [m], at the roadside
NEARLY = 0.95  # of a top speed: what somebody may be at
ABOUT = 1.01  # times the speed that a body holds is no other speed
EASILY = 1.05  # times the drag at a speed is what the engine of one gives that is built for it
AIR_DRAG = 0.0008  # [1/m] on top of `Limits.drag`: with both, a car coasts from 15 to 10 m/s in about 15 s


class Manner(StrEnum):
    """How a road user moves, as far as verbs are concerned."""

    WALKS = "walks"
    RIDES = "rides"
    DRIVES = "drives"
    LIES = "lies"  # a thing on the road, which does nothing but be there


@dataclass(frozen=True, slots=True, kw_only=True)
class Limits:
    """What a kind of body can do.

    Attributes:
        length: [m].
        width: [m].
        throttle: Acceleration at full throttle and standstill [m/s²].
        brake: Deceleration at full brake [m/s²].
        top_speed: [m/s]; throttle fades linearly towards it.
        wheelbase: [m]; 0 for walkers and things.
        wheel_angle: Largest wheel angle [rad].
        wheel_rate: Largest rate of the wheel angle [rad/s].
        lateral: Largest lateral acceleration [m/s²]; beyond it the turn widens.
        drag: Deceleration when coasting [m/s²] at standstill; grows with speed squared.
        drive_lag: Time constant of the drive's build-up [s].
        brake_lag: Time constant of the brake's build-up [s].
        yaw_lag: Time constant of the yaw rate [s] at 20 m/s; proportional to the speed.
        characteristic_speed: Speed [m/s] at which the same wheel angle gives half the curvature that it gives at
            walking pace; infinite where it does not depend on the speed.
        most: Of one that is stronger than others of its kind, the speed [m/s] that it is driven at at most; else 0.
    """

    length: float
    width: float
    throttle: float = 0.0
    brake: float = 0.0
    top_speed: float = 0.0
    wheelbase: float = 0.0
    wheel_angle: float = 0.0
    wheel_rate: float = 0.0
    lateral: float = 0.0
    drag: float = 0.2
    drive_lag: float = 0.3
    brake_lag: float = 0.3
    yaw_lag: float = 0.1
    characteristic_speed: float = 22.0
    most: float = 0.0

    @property
    def fastest(self) -> float:
        """The speed [m/s] that anybody may be at: nearly the top speed, which nobody quite reaches."""
        return self.most or NEARLY * self.top_speed

    @property
    def holds(self) -> float:
        """The speed [m/s] at which drag takes all that the engine gives; of who walks nearly the top speed."""
        if not self.wheelbase:
            return self.fastest
        fade = self.throttle / self.top_speed
        root = math.sqrt(fade * fade + 4.0 * AIR_DRAG * (self.throttle - self.drag))
        return (root - fade) / (2.0 * AIR_DRAG)


@dataclass(frozen=True, slots=True, kw_only=True)
class RoadUser:
    """What holds of all road users of a kind.

    Attributes:
        scenic: Class in `world/model.scenic`, and the kind of its tracks.
        blueprint: What it is in CARLA 0.9.
        mass: Of a common one with whoever is in or on it [kg].
        limits: What its body can do.
        manner: How it moves; those on foot or on two wheels are the vulnerable ones (Directive 2010/40/EU, article 4).
        height: [m]; nominal; by it bodies hide each other from the ego (`chatscene.terms.sight`).
        openscenario: Its category in OpenSCENARIO XML 1.2: of a vehicle, a pedestrian or a thing.
        nouns: What it is called, parted by `|` or lines, the usual word first.
        motorised: Whether it is meant where a text speaks of vehicles in general.
        wheel: Diameter of its wheels [m]; nominal; 0 where formats ask for none.
        osi: Its type in `VehicleClassification` of the Open Simulation Interface 3, without `TYPE_`; empty of what is
            no vehicle there.
        commonroad: Its type of dynamic obstacle in CommonRoad 2020a.
        role: What it is there for, in the words of both formats; empty of one for nothing in particular.
        like: The kind that it acts like, by name; empty where it acts like none but itself.
        told_apart: Whether facts with names of their own tell it from the kind that it is like; a situation does.
        slow: Speed [m/s] below which a watcher calls it slow.
        fast: Speed [m/s] from which a watcher calls it fast.
        driven: Speed [m/s] at which it is driven at most, however fast the road is: lorries and buses outside towns by
            StVO § 3 (3) 2 and § 18 (5), and in most of Europe; a tram among others on the road keeps to what holds for
            them; tractors are built for 40 km/h at most (Regulation (EU) 167/2013, class T1).
        tows: Whether it is two bodies that are coupled, which are built as one rigid body.
        most: Speed [m/s] that a strong one of the kind is driven at, if a common one does not hold as much; else 0.
    """

    scenic: str
    blueprint: str
    mass: float
    limits: Limits
    manner: Manner
    height: float
    openscenario: str
    nouns: str
    motorised: bool = True
    wheel: float = 0.0
    osi: str = ""
    commonroad: str = "unknown"
    role: str = ""
    like: str = ""
    told_apart: bool = True
    slow: float = 4.0
    fast: float = 11.0
    driven: float = math.inf
    tows: bool = False
    most: float = 0.0

    def __post_init__(self) -> None:
        """Hold a row to what every format asks of who moves so.

        Raises:
            ValueError: It lacks what its manner asks for; the message says what.
        """
        rolls = self.manner in (Manner.DRIVES, Manner.RIDES)
        row = f"{self.scenic} {self.manner}, so its row in terms/actors.py"
        if rolls and not self.wheel > 0.0:
            raise ValueError(f"{row} needs wheel, the diameter [m] that OpenSCENARIO asks for: nominal if it has none")
        if rolls and not self.osi:
            raise ValueError(f"{row} needs osi, its type of vehicle in OSI, such as OTHER")
        if self.wheel and not rolls:
            raise ValueError(f"{row} has no wheel: no format asks for one")

    def at(self, speed: float) -> RoadUser:
        """The row of one that is driven at a speed [m/s]: a stronger one, if a common one does not hold it."""
        return self if speed <= ABOUT * self.limits.holds or not self.most else _stronger(self, min(speed, self.most))

    @property
    def noun(self) -> str:
        """What one is called, without an article."""
        return self.nouns.replace("\n", "|").strip(" |").partition("|")[0].strip()


@lru_cache(maxsize=64)
def _stronger(row: RoadUser, speed: float) -> RoadUser:
    """The row of one whose throttle fades so slowly that it holds a speed [m/s] with some of it left."""
    limits = row.limits
    drag = EASILY * (limits.drag + AIR_DRAG * speed * speed) if limits.wheelbase else (1.0 - NEARLY) * limits.throttle
    top = float(f"{speed / (1.0 - drag / limits.throttle):.4g}")
    return replace(row, limits=replace(limits, top_speed=top, most=row.most))


def fading(holds: float, throttle: float, drag: float = 0.2) -> float:
    """The speed [m/s] towards which throttle fades of a body that holds a speed with its foot down.

    Args:
        holds: That speed [m/s].
        throttle: Its acceleration at full throttle and standstill [m/s²].
        drag: Its deceleration when coasting [m/s²] at standstill.
    """
    return holds / (1.0 - (drag + AIR_DRAG * holds * holds) / throttle)


def _like(one: tuple[str, RoadUser], name: str, limits: Mapping[str, float], **different: Any) -> tuple[str, RoadUser]:
    """A kind that only a situation tells from another: that one's row with what differs, of its body and else."""
    row = one[1]
    apart: dict[str, Any] = {"like": row.like or one[0], "told_apart": False, "limits": replace(row.limits, **limits)}
    return name, replace(row, **(apart | different))


class AdversaryKind(StrEnum):
    """What kind of road user the adversary is.

    Attributes:
        row: What holds of all of the kind.
    """

    _value_: str
    row: RoadUser

    def __new__(cls, value: str, row: RoadUser) -> AdversaryKind:
        """A member of a name, with its row."""
        kind = str.__new__(cls, value)
        kind._value_, kind.row = value, row
        return kind

    CAR = (
        "car",
        RoadUser(
            scenic="Car",
            most=250 / 3.6,
            blueprint="vehicle.lincoln.mkz_2017",
            mass=1700.0,
            limits=Limits(
                length=4.9,
                width=2.13,
                throttle=4.5,
                brake=8.0,
                top_speed=50.0,
                wheelbase=2.85,
                wheel_angle=1.22,
                wheel_rate=2.4,
                lateral=7.0,
            ),
            manner=Manner.DRIVES,
            height=1.5,
            wheel=0.65,
            openscenario="car",
            commonroad="car",
            osi="CAR",
            nouns="""
                car | sedan | SUV | taxi | hatchback | estate car | cab | convertible | sports car | station wagon
                vehicle | limousine | jeep | family car | small car | rental car
            """,
        ),
    )
    TRUCK = (
        "truck",
        RoadUser(
            scenic="Truck",
            most=120 / 3.6,
            driven=80 / 3.6,
            blueprint="vehicle.carlamotors.carlacola",
            mass=8000.0,
            limits=Limits(
                length=7.8,
                width=2.5,
                throttle=2.2,
                brake=6.0,
                top_speed=fading(90 / 3.6, 2.2),
                wheelbase=4.5,
                wheel_angle=0.8,
                wheel_rate=1.0,
                lateral=4.0,
                drive_lag=0.6,
                brake_lag=0.43,
                yaw_lag=0.2,
            ),
            manner=Manner.DRIVES,
            height=3.2,
            wheel=1.0,
            openscenario="truck",
            commonroad="truck",
            osi="HEAVY_TRUCK",
            nouns="""
                truck | lorry | HGV | delivery truck | dump truck | box truck
                tipper truck | garbage truck | refuse lorry | heavy goods vehicle
                flatbed truck | tanker truck | removal lorry
            """,
        ),
    )
    BUS = (
        "bus",
        RoadUser(
            scenic="Bus",
            most=130 / 3.6,
            driven=80 / 3.6,
            blueprint="vehicle.mitsubishi.fusorosa",
            mass=6500.0,
            limits=Limits(
                length=11.5,
                width=2.5,
                throttle=1.8,
                brake=5.5,
                top_speed=fading(100 / 3.6, 1.8),
                wheelbase=6.0,
                wheel_angle=0.8,
                wheel_rate=1.0,
                lateral=3.5,
                drive_lag=0.6,
                brake_lag=0.43,
                yaw_lag=0.2,
            ),
            manner=Manner.DRIVES,
            height=3.1,
            wheel=1.0,
            openscenario="bus",
            commonroad="bus",
            osi="BUS",
            nouns="""
                bus | city bus | coach | school bus | double-decker bus | tour bus | shuttle bus
                night bus | tourist coach | commuter bus
            """,
        ),
    )
    MOTORCYCLE = (
        "motorcycle",
        RoadUser(
            scenic="Motorcycle",
            most=250 / 3.6,
            blueprint="vehicle.yamaha.yzf",
            mass=300.0,
            limits=Limits(
                length=2.2,
                width=0.8,
                throttle=6.0,
                brake=8.0,
                top_speed=50.0,
                wheelbase=1.45,
                wheel_angle=0.8,
                wheel_rate=2.5,
                lateral=7.0,
                yaw_lag=0.2,
                characteristic_speed=math.inf,
            ),
            manner=Manner.RIDES,
            height=1.6,
            wheel=0.6,
            openscenario="motorbike",
            commonroad="motorcycle",
            osi="MOTORCYCLE",
            nouns="""
                motorcyclist | motorcycle | motorbike | biker | moped | scooter | scooter rider | motor scooter
                motorcycle courier | moped rider | rider on a motorbike | motorbike rider | man on a scooter
                woman on a motorcycle
            """,
        ),
    )
    BICYCLE = (
        "bicycle",
        RoadUser(
            scenic="Bicycle",
            most=70 / 3.6,
            blueprint="vehicle.bh.crossbike",
            mass=90.0,
            limits=Limits(
                length=1.8,
                width=0.6,
                throttle=1.8,
                brake=4.5,
                top_speed=12.0,
                wheelbase=1.05,
                wheel_angle=0.8,
                wheel_rate=2.5,
                lateral=4.0,
                yaw_lag=0.2,
                characteristic_speed=math.inf,
            ),
            manner=Manner.RIDES,
            height=1.7,
            wheel=0.65,
            openscenario="bicycle",
            commonroad="bicycle",
            osi="BICYCLE",
            nouns="""
                cyclist | bicycle | bicyclist | bike rider | e-bike rider | bike | boy on a bike
                woman on a bicycle | bike courier | cycle courier | man on a bicycle | racing cyclist
                young cyclist | child on a bike | e-bike | delivery cyclist
            """,
            fast=6.5,
            motorised=False,
        ),
    )
    PEDESTRIAN = (
        "pedestrian",
        RoadUser(
            scenic="Pedestrian",
            blueprint="walker.pedestrian.0001",
            mass=80.0,
            limits=Limits(length=0.6, width=0.6, throttle=4.0, brake=5.0, top_speed=8.0),
            manner=Manner.WALKS,
            height=1.7,
            openscenario="pedestrian",
            commonroad="pedestrian",
            nouns="""
                pedestrian | man | woman | jogger | runner | old man | elderly woman | young man | teenager
                student | walker | passer-by | person | tourist | old lady | man with a suitcase
                person on foot | dog walker
            """,
            slow=1.45,
            fast=3.0,
            motorised=False,
        ),
    )
    EMERGENCY_VEHICLE = (
        "emergency-vehicle",
        RoadUser(
            scenic="EmergencyVehicle",
            most=180 / 3.6,
            blueprint="vehicle.ford.ambulance",
            mass=3500.0,
            limits=Limits(
                length=5.9,
                width=2.1,
                throttle=3.5,
                brake=7.5,
                top_speed=40.0,
                wheelbase=3.7,
                wheel_angle=1.0,
                wheel_rate=2.0,
                lateral=6.0,
            ),
            manner=Manner.DRIVES,
            height=2.5,
            wheel=0.7,
            openscenario="van",
            commonroad="priorityVehicle",
            osi="VAN",
            role="ambulance",
            nouns="""
                ambulance | emergency vehicle | rescue vehicle | police van | ambulance on an emergency call
                emergency ambulance
            """,
        ),
    )

    # Those that act like another. Sizes and speeds: an e-scooter may be 2 m long and 0.7 m wide, must go no faster than
    # 20 km/h and brake with 3.5 m/s² (German eKFV, sections 1, 3 and 4; 25 km/h elsewhere); a wheelchair is up to 1.3 m
    # long and 0.7 m wide (ISO 7193) and, with a motor, up to 15 km/h fast (EN 12184), commonly 6 to 10; dogs run 24 to
    # 40 km/h, roe deer up to 60, figures as animal books give them. All at second hand. CARLA 0.9 has neither these nor
    # animals: what stands in for them there has another look, and the size of that.
    E_SCOOTER = (
        "e-scooter",
        RoadUser(
            scenic="EScooter",
            most=45 / 3.6,
            like="bicycle",
            blueprint="vehicle.bh.crossbike",
            mass=95.0,
            limits=Limits(
                length=1.2,
                width=0.6,
                throttle=1.5,
                brake=3.5,
                top_speed=7.0,
                wheelbase=0.9,
                wheel_angle=0.8,
                wheel_rate=2.5,
                lateral=3.0,
                yaw_lag=0.2,
                characteristic_speed=math.inf,
            ),
            manner=Manner.RIDES,
            height=1.8,
            wheel=0.25,
            openscenario="bicycle",
            commonroad="bicycle",
            osi="STANDUP_SCOOTER",
            nouns="""
                e-scooter | e-scooter rider | electric scooter | man on an e-scooter | woman on an e-scooter
                rental e-scooter
            """,
            motorised=False,
            slow=3.0,
            fast=5.0,
        ),
    )
    WHEELCHAIR = (
        "wheelchair",
        RoadUser(
            scenic="Wheelchair",
            most=15 / 3.6,
            like="pedestrian",
            blueprint="walker.pedestrian.0001",
            mass=140.0,
            limits=Limits(length=1.2, width=0.7, throttle=1.2, brake=2.0, top_speed=2.8),
            manner=Manner.WALKS,
            height=1.3,
            openscenario="wheelchair",
            commonroad="pedestrian",
            osi="WHEELCHAIR",
            nouns="""
                wheelchair user | wheelchair | person in a wheelchair | man in a wheelchair | woman in a wheelchair
                electric wheelchair
            """,
            motorised=False,
            slow=0.9,
            fast=2.0,
        ),
    )
    DOG = (
        "dog",
        RoadUser(
            scenic="Dog",
            like="pedestrian",
            blueprint="walker.pedestrian.0009",
            mass=30.0,
            limits=Limits(length=0.9, width=0.3, throttle=5.0, brake=6.0, top_speed=10.0),
            manner=Manner.WALKS,
            height=0.6,
            openscenario="animal",
            nouns="dog | puppy | stray dog | big dog | hound | small dog",
            motorised=False,
            slow=1.5,
            fast=5.0,
        ),
    )
    DEER = (
        "deer",
        RoadUser(
            scenic="Deer",
            like="pedestrian",
            blueprint="walker.pedestrian.0001",
            mass=25.0,
            limits=Limits(length=1.2, width=0.35, throttle=6.0, brake=6.0, top_speed=15.0),
            manner=Manner.WALKS,
            height=0.9,
            openscenario="animal",
            nouns="deer | roe deer | stag | fawn | young deer | frightened deer",
            motorised=False,
            slow=1.5,
            fast=6.0,
        ),
    )

    # Bodies that only a situation tells from what they are like: sentences are labelled without them. A van is as large
    # as a long Mercedes-Benz Sprinter 907 (5.9 m by 2.0 m, wheelbase 3.67 m; class N1 up to 3.5 t), and a good 160 km/h
    # fast. A child is as high as Euro NCAP's target EPTc (1.154 m, of a seven-year-old, which walks at 5 km/h; AEB VRU
    # protocol), and as much smaller than a pedestrian in the other directions. A tractor is a farm's of about 100 kW,
    # which may go 40 to 50 km/h; it brakes with 5 m/s² at least (Regulation (EU) 2015/68). A tram is the one rigid car
    # of a Tatra T3 (14.0 m by 2.5 m, bogies 6.4 m apart, 65 km/h), and brakes in danger as BOStrab asks, with 2.7 m/s²
    # and a little more; the maps have no rails, so that it turns as a bus does. All at second hand.
    VAN = (
        "van",
        RoadUser(
            scenic="Van",
            most=180 / 3.6,
            like="car",
            told_apart=False,
            blueprint="vehicle.mercedes.sprinter",
            mass=2800.0,
            limits=Limits(
                length=5.9,
                width=2.0,
                throttle=3.2,
                brake=7.5,
                top_speed=45.0,
                wheelbase=3.67,
                wheel_angle=1.0,
                wheel_rate=2.0,
                lateral=6.0,
            ),
            manner=Manner.DRIVES,
            height=2.6,
            wheel=0.68,
            openscenario="van",
            commonroad="car",
            osi="VAN",
            nouns="van | delivery van | minivan | panel van | transporter | camper van | parcel van",
        ),
    )
    CHILD = (
        "child",
        RoadUser(
            scenic="Child",
            like="pedestrian",
            told_apart=False,
            blueprint="walker.pedestrian.0012",
            mass=25.0,
            limits=Limits(length=0.4, width=0.4, throttle=4.0, brake=5.0, top_speed=6.0),
            manner=Manner.WALKS,
            height=1.154,
            openscenario="pedestrian",
            commonroad="pedestrian",
            nouns="""
                child | kid | boy | girl | schoolchild | little girl | schoolboy | toddler | little boy | schoolgirl
            """,
            slow=1.3,
            fast=2.5,
            motorised=False,
        ),
    )
    TRACTOR = (
        "tractor",
        RoadUser(
            scenic="Tractor",
            most=65 / 3.6,
            driven=30 / 3.6,
            like="truck",
            told_apart=False,
            blueprint="vehicle.carlamotors.carlacola",
            mass=6500.0,
            limits=Limits(
                length=4.7,
                width=2.4,
                throttle=1.3,
                brake=5.0,
                top_speed=13.0,
                wheelbase=2.7,
                wheel_angle=0.9,
                wheel_rate=1.2,
                lateral=4.0,
                drive_lag=0.6,
                brake_lag=0.43,
                yaw_lag=0.2,
            ),
            manner=Manner.DRIVES,
            height=3.0,
            wheel=1.6,
            openscenario="truck",
            commonroad="truck",
            osi="HEAVY_TRUCK",
            nouns="tractor | farm tractor | farmer's tractor | old tractor",
            fast=9.0,
        ),
    )
    TRAM = (
        "tram",
        RoadUser(
            scenic="Tram",
            most=80 / 3.6,
            driven=50 / 3.6,
            like="bus",
            told_apart=False,
            blueprint="vehicle.mitsubishi.fusorosa",
            mass=20000.0,
            limits=Limits(
                length=14.0,
                width=2.5,
                throttle=1.5,
                brake=3.0,
                top_speed=18.0,
                wheelbase=6.4,
                wheel_angle=0.8,
                wheel_rate=1.0,
                lateral=3.0,
                drive_lag=0.6,
                brake_lag=0.43,
                yaw_lag=0.2,
            ),
            manner=Manner.DRIVES,
            height=3.1,
            wheel=0.7,
            openscenario="tram",
            commonroad="train",
            osi="TRAM",
            nouns="tram | streetcar | tramcar | city tram | light-rail vehicle | light-rail tram",
        ),
    )

    # Those whose body alone differs from that of one above: sizes, masses and speeds of common ones, at second hand. A
    # pickup: Ford F-150 SuperCrew; a minibus: Ford Transit of 17 seats; an auto-rickshaw: Bajaj RE; a cargo bike: Urban
    # Arrow, as wide as a Christiania; a fire engine: DIN 14530, LF 20; a quad: class L7e; a combine harvester without
    # its header, as it goes on roads; a cart with the ox or horse that draws it. A moose as heavy as VTI's dummy; other
    # animals as animal books give them. Carts and riders go as fast as their animals trot or gallop.
    PICKUP = _like(
        CAR,
        "pickup",
        {"length": 5.9, "width": 2.03, "wheelbase": 3.69, "throttle": 4.0, "brake": 7.5, "lateral": 6.0},
        scenic="Pickup",
        most=200 / 3.6,
        blueprint="vehicle.tesla.cybertruck",
        mass=2400.0,
        height=1.96,
        wheel=0.8,
        openscenario="van",
        nouns="pickup | pickup truck | pick-up | ute | bakkie | tow truck | flatbed pickup",
    )
    MINIBUS = _like(
        VAN,
        "minibus",
        {"length": 6.7, "width": 2.06, "wheelbase": 3.75, "throttle": 2.8, "brake": 7.0, "lateral": 5.0},
        scenic="Minibus",
        most=160 / 3.6,
        blueprint="vehicle.volkswagen.t2",
        mass=3900.0,
        height=2.78,
        nouns="minibus | microbus | matatu | dolmus | jeepney | marshrutka | dala dala | shuttle van",
    )
    AUTO_RICKSHAW = _like(
        CAR,
        "auto-rickshaw",
        {"length": 2.64, "width": 1.3, "wheelbase": 2.0, "wheel_angle": 0.8, "throttle": 1.8, "brake": 5.0}
        | {"top_speed": fading(65 / 3.6, 1.8), "lateral": 4.0},
        scenic="AutoRickshaw",
        most=80 / 3.6,
        driven=50 / 3.6,
        blueprint="vehicle.micro.microlino",
        mass=600.0,
        height=1.71,
        wheel=0.4,
        commonroad="motorcycle",
        nouns="auto-rickshaw | autorickshaw | rickshaw | tuk-tuk | tuktuk | bajaj | motor tricycle | tricycle",
    )
    QUAD = _like(
        MOTORCYCLE,
        "quad",
        {"length": 2.1, "width": 1.2, "wheelbase": 1.3, "throttle": 4.0, "brake": 6.0, "lateral": 4.5}
        | {"top_speed": fading(90 / 3.6, 4.0)},
        scenic="Quad",
        most=120 / 3.6,
        mass=430.0,
        height=1.7,
        nouns="quad bike | quad | ATV | four-wheeler | all-terrain vehicle",
    )
    CARGO_BIKE = _like(
        BICYCLE,
        "cargo-bike",
        {"length": 2.6, "width": 0.85, "wheelbase": 1.8, "throttle": 1.2, "brake": 4.0, "top_speed": 10.0}
        | {"lateral": 3.0},
        scenic="CargoBike",
        most=50 / 3.6,
        mass=200.0,
        nouns="cargo bike | cargo bicycle | cycle rickshaw | pedicab | delivery trike | box bike",
        fast=5.5,
    )
    POLICE_CAR = _like(
        CAR,
        "police-car",
        {},
        like="emergency-vehicle",
        scenic="PoliceCar",
        blueprint="vehicle.dodge.charger_police",
        mass=1900.0,
        commonroad="priorityVehicle",
        role="police",
        nouns="police car | patrol car | squad car | police cruiser | police car with its siren on",
    )
    FIRE_ENGINE = _like(
        TRUCK,
        "fire-engine",
        {"length": 8.6, "wheelbase": 4.4, "top_speed": fading(100 / 3.6, 2.2)},
        like="emergency-vehicle",
        scenic="FireEngine",
        most=130 / 3.6,
        driven=math.inf,
        blueprint="vehicle.carlamotors.firetruck",
        mass=14000.0,
        height=3.3,
        commonroad="priorityVehicle",
        role="fire",
        nouns="fire engine | fire truck | fire appliance | ladder truck | fire engine with flashing lights",
    )
    HARVESTER = _like(
        TRACTOR,
        "harvester",
        {"length": 8.9, "width": 3.5, "wheelbase": 3.9, "throttle": 1.0, "top_speed": fading(30 / 3.6, 1.0)},
        scenic="Harvester",
        most=40 / 3.6,
        driven=25 / 3.6,
        mass=17000.0,
        height=4.0,
        nouns="combine harvester | harvester | combine | forage harvester | beet harvester",
        fast=6.5,
    )
    CART = _like(
        TRACTOR,
        "cart",
        {"length": 5.5, "width": 1.9, "wheelbase": 2.6, "throttle": 0.8, "brake": 2.0, "top_speed": 6.0},
        scenic="Cart",
        most=30 / 3.6,
        driven=10 / 3.6,
        mass=1200.0,
        height=2.0,
        wheel=1.2,
        osi="TRAILER",
        commonroad="unknown",
        nouns="ox cart | bullock cart | horse-drawn carriage | horse cart | carriage | donkey cart",
        motorised=False,
        slow=1.4,
        fast=3.5,
    )

    # Those that tow are one rigid body here, as long as the two. Lengths as Directive 96/53/EC allows them, and as
    # common for caravans and farm trailers; speeds of cars that tow by StVO § 18 (5). They turn about as tight as such
    # a pair.
    SEMI_TRAILER = _like(
        TRUCK,
        "semi-trailer",
        {"length": 16.5, "width": 2.55, "wheelbase": 7.0, "wheel_angle": 0.95, "throttle": 1.4, "brake": 5.5}
        | {"top_speed": fading(90 / 3.6, 1.4), "lateral": 3.5},
        scenic="SemiTrailer",
        blueprint="vehicle.carlamotors.european_hgv",
        mass=30000.0,
        height=4.0,
        tows=True,
        nouns="""
            articulated lorry | semi-trailer truck | semi-trailer | semi | tractor-trailer | articulated truck | artic
            lorry with a trailer | truck with a trailer | road train | big rig | eighteen-wheeler | juggernaut
        """,
    )
    ARTICULATED_BUS = _like(
        BUS,
        "articulated-bus",
        {"length": 18.0, "width": 2.55, "wheelbase": 7.0, "wheel_angle": 0.95, "throttle": 1.4, "brake": 5.0},
        scenic="ArticulatedBus",
        mass=19000.0,
        tows=True,
        nouns="articulated bus | bendy bus | accordion bus",
    )
    CAR_AND_TRAILER = _like(
        CAR,
        "car-and-trailer",
        {"length": 11.5, "width": 2.3, "wheelbase": 5.0, "throttle": 2.8, "brake": 6.5, "lateral": 4.0}
        | {"top_speed": fading(110 / 3.6, 2.8)},
        scenic="CarAndTrailer",
        most=140 / 3.6,
        driven=80 / 3.6,
        mass=3000.0,
        height=2.6,
        tows=True,
        nouns="""
            car with a trailer | car with a caravan | caravan | car and caravan | car towing a boat | boat trailer
            pickup with a trailer | horse trailer | horse box | cattle trailer rig
        """,
    )
    TRACTOR_AND_TRAILER = _like(
        TRACTOR,
        "tractor-and-trailer",
        {"length": 12.2, "width": 2.55, "wheelbase": 5.0, "throttle": 1.0, "brake": 4.0},
        scenic="TractorAndTrailer",
        mass=14000.0,
        tows=True,
        nouns="tractor with a trailer | tractor and trailer | tractor with a slurry tanker | tractor with a hay wagon",
    )
    PRAM = _like(
        PEDESTRIAN,
        "pram",
        {"length": 1.7, "throttle": 2.0, "brake": 3.0, "top_speed": 4.0},
        scenic="Pram",
        mass=100.0,
        nouns="pram | pushchair | stroller | baby carriage | buggy | shopping trolley | trolley | handcart",
        fast=2.2,
    )
    HORSE_RIDER = _like(
        DEER,
        "horse-rider",
        {"length": 2.4, "width": 0.7, "throttle": 3.0, "brake": 3.0, "top_speed": 12.0},
        scenic="HorseRider",
        mass=580.0,
        height=2.4,
        nouns="horse rider | rider on a horse | horse and rider | horsewoman | horseman",
    )
    HORSE = _like(
        DEER,
        "horse",
        {"length": 2.4, "width": 0.65, "throttle": 4.0, "brake": 4.0},
        scenic="Horse",
        mass=500.0,
        height=1.6,
        nouns="horse | pony | loose horse | donkey | mule",
    )
    COW = _like(
        DEER,
        "cow",
        {"length": 2.4, "width": 0.75, "throttle": 3.0, "brake": 3.0, "top_speed": 7.0},
        scenic="Cow",
        mass=600.0,
        height=1.45,
        nouns="cow | bull | calf | ox | cattle | buffalo | heifer",
        fast=4.0,
    )
    MOOSE = _like(
        DEER,
        "moose",
        {"length": 2.7, "width": 0.8, "throttle": 4.0, "brake": 4.0},
        scenic="Moose",
        mass=360.0,
        height=2.0,
        nouns="moose | elk | reindeer | camel | bear",
    )
    SHEEP = _like(
        DEER,
        "sheep",
        {"length": 1.2, "width": 0.45, "throttle": 4.0, "brake": 5.0, "top_speed": 8.0},
        scenic="Sheep",
        mass=70.0,
        height=0.8,
        nouns="sheep | goat | lamb | ewe",
        fast=4.0,
    )
    BOAR = _like(
        DEER,
        "boar",
        {"length": 1.4, "width": 0.4, "throttle": 5.0, "top_speed": 11.0},
        scenic="Boar",
        mass=90.0,
        height=0.8,
        nouns="wild boar | boar | pig | sow | warthog",
        fast=5.0,
    )
    KANGAROO = _like(
        DEER,
        "kangaroo",
        {"length": 1.3, "width": 0.45},
        scenic="Kangaroo",
        mass=65.0,
        height=1.5,
        nouns="kangaroo | roo | wallaby | ostrich | emu",
    )
    SMALL_ANIMAL = _like(
        DOG,
        "small-animal",
        {"length": 0.5, "width": 0.2},
        scenic="SmallAnimal",
        mass=5.0,
        height=0.3,
        nouns="small animal | cat | fox | hare | rabbit | hedgehog | squirrel | goose | duck | badger",
    )

    # Things on the road: they only stand, and what they do is composed. They are read where every word of a text is:
    # elsewhere a box is a junction's, and a cone stands for what is around.
    BOX = (
        "box",
        RoadUser(
            scenic="Box",
            blueprint="static.prop.box01",
            mass=15.0,
            limits=Limits(length=0.65, width=0.65),
            manner=Manner.LIES,
            height=0.65,
            openscenario="obstacle",
            nouns="box | crate | cardboard box | carton | wooden crate | parcel",
            motorised=False,
        ),
    )
    CONE = (
        "cone",
        RoadUser(
            scenic="Cone",
            like="box",
            blueprint="static.prop.trafficcone02",
            mass=5.0,
            limits=Limits(length=0.45, width=0.4),
            manner=Manner.LIES,
            height=0.75,
            openscenario="obstacle",
            nouns="cone | traffic cone | pylon | road cone | warning cone | construction cone",
            motorised=False,
        ),
    )
    DEBRIS = (
        "debris",
        RoadUser(
            scenic="Debris",
            like="box",
            blueprint="static.prop.creasedbox02",
            mass=60.0,
            limits=Limits(length=1.6, width=0.7),
            manner=Manner.LIES,
            height=0.5,
            openscenario="obstacle",
            nouns="debris | fallen load | lost cargo | rubble | lost load | wreckage",
            motorised=False,
        ),
    )

    @property
    def acts_as(self) -> AdversaryKind:
        """The kind whose snippets serve it: itself, or that which it is like."""
        return AdversaryKind(self.row.like) if self.row.like else self

    @property
    def heard_as(self) -> AdversaryKind:
        """The kind that a fact with a name of its own has for it: itself, or that which it is like."""
        return self if self.row.told_apart else self.acts_as

    @property
    def is_vulnerable(self) -> bool:
        """Whether it is on foot or on two wheels."""
        return self.row.manner in (Manner.WALKS, Manner.RIDES)

    @property
    def lies(self) -> bool:
        """Whether it is a thing, which never moves."""
        return self.row.manner is Manner.LIES


BY_CLASS: dict[str, AdversaryKind] = {kind.row.scenic: kind for kind in AdversaryKind}
REVERSE_SPEED = 6.0  # [m/s], the most that a body with wheels drives backwards

PROPS: dict[str, Limits] = {
    "BusStop": Limits(length=3.6, width=1.4),
    "VendingMachine": Limits(length=1.2, width=0.9),
    "Kiosk": Limits(length=2.4, width=2.0),
    "Container": Limits(length=3.0, width=1.8),
    "Hedge": Limits(length=5.0, width=0.8),
    "Billboard": Limits(length=2.0, width=0.6),
    "WarningSign": Limits(length=0.1, width=0.9),
}
"""Things that stand beside the road, by their class; nobody meets them."""
LOOSE: dict[str, Limits] = {
    "Ball": Limits(length=0.22, width=0.22, throttle=8.0, brake=1.0, top_speed=10.0),
    "Door": Limits(length=1.1, width=0.1, throttle=5.0, brake=6.0, top_speed=3.0),
    "Load": Limits(
        length=1.2,
        width=1.0,
        throttle=6.0,
        brake=5.0,
        top_speed=60.0,
        wheelbase=0.8,
        wheel_angle=0.6,
        wheel_rate=2.0,
        lateral=5.0,
        characteristic_speed=math.inf,
    ),
}
"""What somebody lets go, by its class: a ball that rolls, the door of a car, a load, which slides with half of g."""
LIMITS: dict[str, Limits] = {name: kind.row.limits for name, kind in BY_CLASS.items()} | LOOSE


def manner_of(kind: str) -> Manner | None:
    """How what a track is of moves, by its class; None for a thing."""
    return BY_CLASS[kind].row.manner if kind in BY_CLASS else None


def noun_of(kind: str) -> str:
    """What a track is of in words, by its class: ``Pedestrian`` a pedestrian, ``BusStop`` a bus stop."""
    return BY_CLASS[kind].row.noun if kind in BY_CLASS else re.sub(r"(?<=[a-z])(?=[A-Z])", " ", kind).lower()


def one_of_class(kind: str) -> str:
    """One of what a track is of, by its class: ``Pedestrian`` *a pedestrian*, ``EScooter`` *an e-scooter*."""
    return with_article(noun_of(kind))


_ID = re.compile(r"[A-Za-z]\d*(?:-\d+)?")
"""What somebody of a situation is called, which says nothing in a sentence; other names are roles."""


_PART = re.compile(rf"({_ID.pattern})-[a-z]+")
"""What somebody of a situation lets go of: a door, a load."""
_NUMBERED = re.compile(r"(.+?)-(\d+)")


def named(actor: str, kind: str, kinds: Mapping[str, str]) -> str:
    """What an actor is called in a sentence: *the car*, *car B* of several, *the leader (van)*, *parked car 2*.

    Args:
        actor: Its name in the episode.
        kind: Its class.
        kinds: The class of everybody in the episode but the ego, by name.
    """
    noun = noun_of(kind)
    alone = sum(noun_of(its) == noun for its in kinds.values()) < 2
    if _ID.fullmatch(actor):
        return f"the {noun}" if alone else f"{noun} {actor}"
    if part := _PART.fullmatch(actor):
        return f"the {noun}" if alone else f"the {noun} of {part[1]}"
    if numbered := _NUMBERED.fullmatch(actor):
        role = numbered[1].replace("-", " ")
        role = role if noun in role.lower() else f"{role} {noun}"
        return f"the {role}" if alone else f"{role} {int(numbered[2]) + 1}"
    return f"the {actor}" if noun in actor.lower().replace("-", " ") else f"the {actor} ({noun})"


def has_lamps(kind: str) -> bool:
    """Whether what a track is of is seen by its own lamps at night, which the law asks of vehicles and cycles."""
    return manner_of(kind) not in (None, Manner.WALKS, Manner.LIES)


def height_of_kind(kind: str) -> float:
    """The nominal height [m] of what a track is of; things at the roadside are as high as what hides somebody."""
    return BY_CLASS[kind].row.height if kind in BY_CLASS else THING_HEIGHT


def kind_of(thing: object) -> str:
    """The kind of road user that a thing is: the nearest of its classes in `LIMITS`; else its own class."""
    kind = type(thing)
    if (known := _kinds.get(kind)) is None:
        names = [cls.__name__ for cls in kind.__mro__]
        known = _kinds[kind] = next((name for name in names if name in LIMITS), names[0])
    return known


_kinds: WeakKeyDictionary[type, str] = WeakKeyDictionary()
"""Of classes that are still there: each program brings its own, and a class holds all of the program."""
