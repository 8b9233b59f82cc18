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
    maximum, neighbourPath, offRamp, offsetFrom, oncomingPath, opposite, ownLane, ownWay, pointOn, progressOn, restsWithin, ringTraffic,
    secondsTo, shortOfJunction, speedOn, straightOn, timeTo, trafficFrom,
    unplaced as _unplaced, waitingTraffic, wayOf, wholeLane, wheelbase_of as _wheelbase_of)
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
        has=(), only=None):
    """The ego's route: number `globalParameters.route` of those the map has for this geometry, or number `only` alone.

    With `param egoStart = 'at-line'` it begins right before the junction, if it leads through one: `to_line` [m] before
    its entry, where the ego is longer than a car.
    """
    return _choose_route(_load_roads(globalParameters.map), globalParameters.map, int(globalParameters.route), maneuver=maneuver,
        place=place, control=control, lanes=lanes, opposite=opposite, beside=beside, crossed=crossed, site=site, lane=lane,
        approach=approach, begins=begins, ends=ends, most=most, setting=setting, divided=divided, has=has, only=only, at_line=globalParameters.egoStart == 'at-line',
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
    length: _LIMITS['Car'].length
    width: _LIMITS['Car'].width
    wheelbase: _wheelbase_of('Car', self.length)
    wheelAngle: _LIMITS['Car'].wheel_angle
    isWalker: False
    label: ''
    role: ''
    route: None
    orders: ()
    wantedSpeed: None
    keepsLimits: False
    backwards: False

class Truck(Car):
    length: _LIMITS['Truck'].length
    width: _LIMITS['Truck'].width
    wheelbase: _wheelbase_of('Truck', self.length)
    wheelAngle: _LIMITS['Truck'].wheel_angle

class Bus(Car):
    length: _LIMITS['Bus'].length
    width: _LIMITS['Bus'].width
    wheelbase: _wheelbase_of('Bus', self.length)
    wheelAngle: _LIMITS['Bus'].wheel_angle

class EmergencyVehicle(Car):
    length: _LIMITS['EmergencyVehicle'].length
    width: _LIMITS['EmergencyVehicle'].width
    wheelbase: _wheelbase_of('EmergencyVehicle', self.length)
    wheelAngle: _LIMITS['EmergencyVehicle'].wheel_angle

class Motorcycle(Car):
    length: _LIMITS['Motorcycle'].length
    width: _LIMITS['Motorcycle'].width
    wheelbase: _wheelbase_of('Motorcycle', self.length)
    wheelAngle: _LIMITS['Motorcycle'].wheel_angle

class Bicycle(Car):
    length: _LIMITS['Bicycle'].length
    width: _LIMITS['Bicycle'].width
    wheelbase: _wheelbase_of('Bicycle', self.length)
    wheelAngle: _LIMITS['Bicycle'].wheel_angle

class Pedestrian(Walking, Pedestrian):
    regionContainedIn: everywhere
    position: _unplaced()
    parentOrientation: 0
    length: _LIMITS['Pedestrian'].length
    width: _LIMITS['Pedestrian'].width
    isWalker: True
    label: ''
    role: ''

class EScooter(Car):
    length: _LIMITS['EScooter'].length
    width: _LIMITS['EScooter'].width
    wheelbase: _wheelbase_of('EScooter', self.length)
    wheelAngle: _LIMITS['EScooter'].wheel_angle

class Wheelchair(Pedestrian):
    length: _LIMITS['Wheelchair'].length
    width: _LIMITS['Wheelchair'].width

class Dog(Pedestrian):
    length: _LIMITS['Dog'].length
    width: _LIMITS['Dog'].width

class Deer(Pedestrian):
    length: _LIMITS['Deer'].length
    width: _LIMITS['Deer'].width

class Van(Car):
    length: _LIMITS['Van'].length
    width: _LIMITS['Van'].width
    wheelbase: _wheelbase_of('Van', self.length)
    wheelAngle: _LIMITS['Van'].wheel_angle

class Child(Pedestrian):
    length: _LIMITS['Child'].length
    width: _LIMITS['Child'].width

class Tractor(Car):
    length: _LIMITS['Tractor'].length
    width: _LIMITS['Tractor'].width
    wheelbase: _wheelbase_of('Tractor', self.length)
    wheelAngle: _LIMITS['Tractor'].wheel_angle

class Tram(Car):
    length: _LIMITS['Tram'].length
    width: _LIMITS['Tram'].width
    wheelbase: _wheelbase_of('Tram', self.length)
    wheelAngle: _LIMITS['Tram'].wheel_angle

class Box(Lying, DrivingObject):
    regionContainedIn: everywhere
    position: _unplaced()
    length: _LIMITS['Box'].length
    width: _LIMITS['Box'].width
    isWalker: False
    label: ''
    role: ''

class Cone(Box):
    length: _LIMITS['Cone'].length
    width: _LIMITS['Cone'].width

class Debris(Box):
    length: _LIMITS['Debris'].length
    width: _LIMITS['Debris'].width

## What somebody lets go

class Ball(Pedestrian):
    length: _LIMITS['Ball'].length
    width: _LIMITS['Ball'].width

class Door(Pedestrian):
    length: _LIMITS['Door'].length
    width: _LIMITS['Door'].width
    allowCollisions: True

class Load(Car):
    length: _LIMITS['Load'].length
    width: _LIMITS['Load'].width
    wheelbase: _wheelbase_of('Load', self.length)
    wheelAngle: _LIMITS['Load'].wheel_angle
    allowCollisions: True

## Things that stand in the way or in the line of sight

class Prop(Lying, DrivingObject):
    regionContainedIn: everywhere
    position: _unplaced()
    isWalker: False
    label: ''
    role: ''

class BusStop(Prop):
    length: _PROPS['BusStop'].length
    width: _PROPS['BusStop'].width

class VendingMachine(Prop):
    length: _PROPS['VendingMachine'].length
    width: _PROPS['VendingMachine'].width

class Kiosk(Prop):
    length: _PROPS['Kiosk'].length
    width: _PROPS['Kiosk'].width

class Container(Prop):
    length: _PROPS['Container'].length
    width: _PROPS['Container'].width

class Hedge(Prop):
    length: _PROPS['Hedge'].length
    width: _PROPS['Hedge'].width

class Billboard(Prop):
    length: _PROPS['Billboard'].length
    width: _PROPS['Billboard'].width

class WarningSign(Prop):
    length: _PROPS['WarningSign'].length
    width: _PROPS['WarningSign'].width
