"""The world model: every name a snippet may use. A program says `model chatscene.world.model`, and no more.

Nothing here names a simulator: the parameter `simulator` does, and settings have its default. The only random values
in a program are its `OPT_` parameters: classes fix what Scenic's driving domain would draw (colours, positions), so
that a scene is exactly its parameter values.
"""

if 'map' not in globalParameters:
    from chatscene.maps.network import resolve_map as _resolve_map
    param map = str(_resolve_map('town'))

from chatscene.maps.network import install_network_memo as _install_network_memo
_install_network_memo(light=True)  # no parsed copy of the map beside the map itself, and none in memory

from scenic.domains.driving.model import *

from chatscene.maps.loading import load_roads as _load_roads
from chatscene.world.actions import DriveAction, WalkAction
from chatscene.world.actors import Driven, Lying, Walking
from chatscene.world.behaviors import *
from chatscene.world.stories import PlayStory, TakePart
from chatscene.world.ego_route import choose_route as _choose_route, route_along as _route_along
from chatscene.world.places import (adjacentPath, against, asideOf, backFrom, besideRoad, brakingDistance,
    crossingDirection, directionOn, distanceLeft, extended, gap, headway, lanesBeside, lastLane, leftAt, levelOn, lineThrough, onward,
    maximum, neighbourPath, offRamp, offsetFrom, oncomingPath, opposite, outOfDriveway, ownLane, ownWay, pointOn, progressOn, restsWithin, ringTraffic,
    secondsTo, shortOfJunction, speedOn, straightOn, timeTo, trafficFrom,
    unplaced as _unplaced, waitingTraffic, wayOf, wayOff, wholeLane, wheelbase_of as _wheelbase_of)
from chatscene.terms.actors import LIMITS as _LIMITS
from chatscene.terms.actors import PROPS as _PROPS
from chatscene.terms.order import Order
from scenic.core.vectors import globalOrientation as _NORTH

if 'route' not in globalParameters:
    param route = 0
if 'signals' not in globalParameters:
    param signals = 'clock'
if 'egoStart' not in globalParameters:
    param egoStart = 'approach'
if 'drivesUntil' not in globalParameters:
    param drivesUntil = 'arrival'
if 'light' not in globalParameters:
    param light = 'day'
if 'weather' not in globalParameters:
    param weather = 'clear'
if 'surface' not in globalParameters:
    param surface = None  # what follows from the weather

if 'simulator' not in globalParameters:
    from chatscene.settings import SimulationSettings as _SimulationSettings
    param simulator = _SimulationSettings().simulator
from chatscene.world.stock import stock_simulator as _stock_simulator
simulator _stock_simulator(globalParameters.simulator, globalParameters.map)

def selectRoute(maneuver, place=None, control=None, lanes=1, opposite=None, beside=None, crossed=(), site=None,
        lane=None, approach=None, begins=None, ends=None, most=None, to_line=None, setting=None, divided=False,
        shape=None, arms=None, across=None, by_exit=None, has=(), only=None):
    """The ego's route: number `globalParameters.route` of those the map has for this geometry, or number `only` alone.

    With `param egoStart = 'at-line'` it begins right before the junction, if it leads through one: `to_line` [m] before
    its entry, where the ego is longer than a car.
    """
    return _choose_route(_load_roads(globalParameters.map), globalParameters.map, int(globalParameters.route), maneuver=maneuver,
        place=place, control=control, lanes=lanes, opposite=opposite, beside=beside, crossed=crossed, site=site, lane=lane,
        approach=approach, begins=begins, ends=ends, most=most, setting=setting, divided=divided, shape=shape, arms=arms, across=across, by_exit=by_exit, has=has, only=only, at_line=globalParameters.egoStart == 'at-line',
        **({} if to_line is None else {'to_line': to_line}))

def routeThrough(*points):
    """The ego's route along points [m], map frame, in driving order."""
    return _route_along(_load_roads(globalParameters.map), globalParameters.map, points)

def startOf(route):
    """The ego's start pose."""
    return new OrientedPoint at pointOn(route, 0), facing directionOn(route, 0)

## Road users

class Car(Driven, Car):
    regionContainedIn: everywhere
    position: _unplaced()
    parentOrientation: _NORTH
    yaw: (roadDirection at self.position).yaw + self.roadDeviation if self.parentOrientation is _NORTH else 0
    color: (0.75, 0.75, 0.78)
    kind: 'Car'
    length: _LIMITS[self.kind].length
    width: _LIMITS[self.kind].width
    wheelbase: _wheelbase_of(self.kind, self.length)
    wheelAngle: _LIMITS[self.kind].wheel_angle
    topSpeed: _LIMITS[self.kind].top_speed
    isWalker: False
    label: ''
    role: ''
    route: None
    orders: ()
    wantedSpeed: None
    keepsLimits: False
    backwards: False

class Truck(Car):
    kind: 'Truck'

class Bus(Car):
    kind: 'Bus'

class EmergencyVehicle(Car):
    kind: 'EmergencyVehicle'

class Motorcycle(Car):
    kind: 'Motorcycle'

class Bicycle(Car):
    kind: 'Bicycle'

class Pedestrian(Walking, Pedestrian):
    regionContainedIn: everywhere
    position: _unplaced()
    parentOrientation: 0
    kind: 'Pedestrian'
    length: _LIMITS[self.kind].length
    width: _LIMITS[self.kind].width
    topSpeed: _LIMITS[self.kind].top_speed
    isWalker: True
    label: ''
    role: ''

class EScooter(Car):
    kind: 'EScooter'

class Wheelchair(Pedestrian):
    kind: 'Wheelchair'

class Dog(Pedestrian):
    kind: 'Dog'

class Deer(Pedestrian):
    kind: 'Deer'

class Van(Car):
    kind: 'Van'

class Child(Pedestrian):
    kind: 'Child'

class Tractor(Car):
    kind: 'Tractor'

class Tram(Car):
    kind: 'Tram'

class Pickup(Car):
    kind: 'Pickup'

class Minibus(Car):
    kind: 'Minibus'

class AutoRickshaw(Car):
    kind: 'AutoRickshaw'

class Quad(Car):
    kind: 'Quad'

class CargoBike(Car):
    kind: 'CargoBike'

class PoliceCar(Car):
    kind: 'PoliceCar'

class FireEngine(Car):
    kind: 'FireEngine'

class Harvester(Car):
    kind: 'Harvester'

class Cart(Car):
    kind: 'Cart'

class SemiTrailer(Car):
    kind: 'SemiTrailer'

class ArticulatedBus(Car):
    kind: 'ArticulatedBus'

class CarAndTrailer(Car):
    kind: 'CarAndTrailer'

class TractorAndTrailer(Car):
    kind: 'TractorAndTrailer'

class Pram(Pedestrian):
    kind: 'Pram'

class HorseRider(Pedestrian):
    kind: 'HorseRider'

class Horse(Pedestrian):
    kind: 'Horse'

class Cow(Pedestrian):
    kind: 'Cow'

class Moose(Pedestrian):
    kind: 'Moose'

class Sheep(Pedestrian):
    kind: 'Sheep'

class Boar(Pedestrian):
    kind: 'Boar'

class Kangaroo(Pedestrian):
    kind: 'Kangaroo'

class SmallAnimal(Pedestrian):
    kind: 'SmallAnimal'

class Box(Lying, DrivingObject):
    regionContainedIn: everywhere
    position: _unplaced()
    kind: 'Box'
    length: _LIMITS[self.kind].length
    width: _LIMITS[self.kind].width
    isWalker: False
    label: ''
    role: ''

class Cone(Box):
    kind: 'Cone'

class Debris(Box):
    kind: 'Debris'

## What somebody lets go

class Ball(Pedestrian):
    kind: 'Ball'

class Door(Pedestrian):
    kind: 'Door'
    allowCollisions: True

class Load(Car):
    kind: 'Load'
    allowCollisions: True

## Things that stand in the way or in the line of sight

class Prop(Lying, DrivingObject):
    regionContainedIn: everywhere
    position: _unplaced()
    length: _PROPS[self.kind].length
    width: _PROPS[self.kind].width
    isWalker: False
    label: ''
    role: ''

class BusStop(Prop):
    kind: 'BusStop'

class VendingMachine(Prop):
    kind: 'VendingMachine'

class Kiosk(Prop):
    kind: 'Kiosk'

class Container(Prop):
    kind: 'Container'

class Hedge(Prop):
    kind: 'Hedge'

class Billboard(Prop):
    kind: 'Billboard'

class WarningSign(Prop):
    kind: 'WarningSign'
