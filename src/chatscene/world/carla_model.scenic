"""The world model for programs that are written for CARLA: its names, with a meaning here or a named refusal.

Sizes are those that Scenic records of CARLA's blueprints. What only a picture would show, weather, colours and lamps,
is taken and has no effect.
"""

from chatscene.world.driving import *
from chatscene.world.carla_behaviors import *
from chatscene.terms.actors import LIMITS as _LIMITS
from chatscene.world.carla_actions import *
from chatscene.world.lights import (freezeTrafficLights, getClosestTrafficLightStatus, getTrafficLightStatus,
    setAllIntersectionTrafficLightsStatus, setClosestTrafficLightStatus, setTrafficLightStatus, unfreezeTrafficLights,
    withinDistanceToRedYellowTrafficLight, withinDistanceToTrafficLight)
from chatscene.world.places import wheelbase_of as _wheelbase_of

from chatscene.world.blueprints import blueprintsInCategory as _blueprintsIn, sizeOf as _sizeOf

param weather = 'ClearNoon'
param carla_map = ''
param render = 0
param record = ''

class CarlaActor(DrivingObject):
    blueprint: None
    defaultLength: 1
    defaultWidth: 1
    defaultHeight: 1
    length: _sizeOf(self.blueprint, "length", self.defaultLength)
    width: _sizeOf(self.blueprint, "width", self.defaultWidth)
    height: _sizeOf(self.blueprint, "height", self.defaultHeight)
    rolename: None
    physics: True
    snapToGround: True

class Vehicle(CarlaActor, Car):
    @property
    def isCar(self):
        return False

class Car(Vehicle):
    blueprint: Uniform(*_blueprintsIn('car'))
    defaultLength: 4.5
    defaultWidth: 2
    defaultHeight: 1.5

    @property
    def isCar(self):
        return True

class NPCCar(Car):
    pass

class Bicycle(Vehicle):
    blueprint: Uniform(*_blueprintsIn('bicycle'))
    defaultLength: 2
    wheelbase: _wheelbase_of('Bicycle', self.length)
    wheelAngle: _LIMITS['Bicycle'].wheel_angle

class Motorcycle(Vehicle):
    blueprint: Uniform(*_blueprintsIn('motorcycle'))
    defaultLength: 2
    wheelbase: _wheelbase_of('Motorcycle', self.length)
    wheelAngle: _LIMITS['Motorcycle'].wheel_angle

class Truck(Vehicle):
    blueprint: Uniform(*_blueprintsIn('truck'))
    defaultLength: 7.5
    defaultWidth: 2.5
    defaultHeight: 3
    wheelbase: _wheelbase_of('Truck', self.length)
    wheelAngle: _LIMITS['Truck'].wheel_angle

class Van(Vehicle):
    blueprint: Uniform(*_blueprintsIn('van'))
    defaultLength: 5
    defaultWidth: 2
    defaultHeight: 2

class Bus(Vehicle):
    blueprint: Uniform(*_blueprintsIn('bus'))
    defaultLength: 10
    defaultWidth: 4
    defaultHeight: 4
    wheelbase: _wheelbase_of('Bus', self.length)
    wheelAngle: _LIMITS['Bus'].wheel_angle

class Pedestrian(CarlaActor, Pedestrian):
    blueprint: Uniform(*_blueprintsIn('walker'))
    defaultLength: 0.5
    defaultWidth: 0.5
    defaultHeight: 1.5

class Prop(CarlaActor, Prop):
    defaultLength: 0.5
    defaultWidth: 0.5
    defaultHeight: 0.5
    physics: False

class Trash(Prop):
    blueprint: Uniform(*_blueprintsIn('trash'))

class Cone(Prop):
    blueprint: Uniform(*_blueprintsIn('cone'))

class Debris(Prop):
    blueprint: Uniform(*_blueprintsIn('debris'))

class VendingMachine(Prop):
    blueprint: Uniform(*_blueprintsIn('vendingMachine'))

class Chair(Prop):
    blueprint: Uniform(*_blueprintsIn('chair'))

class BusStop(Prop):
    blueprint: Uniform(*_blueprintsIn('busStop'))

class Advertisement(Prop):
    blueprint: Uniform(*_blueprintsIn('advertisement'))

class Garbage(Prop):
    blueprint: Uniform(*_blueprintsIn('garbage'))

class Container(Prop):
    blueprint: Uniform(*_blueprintsIn('container'))

class Table(Prop):
    blueprint: Uniform(*_blueprintsIn('table'))

class Barrier(Prop):
    blueprint: Uniform(*_blueprintsIn('barrier'))

class PlantPot(Prop):
    blueprint: Uniform(*_blueprintsIn('plantpot'))

class Mailbox(Prop):
    blueprint: Uniform(*_blueprintsIn('mailbox'))

class Gnome(Prop):
    blueprint: Uniform(*_blueprintsIn('gnome'))

class CreasedBox(Prop):
    blueprint: Uniform(*_blueprintsIn('creasedbox'))

class Case(Prop):
    blueprint: Uniform(*_blueprintsIn('case'))

class Box(Prop):
    blueprint: Uniform(*_blueprintsIn('box'))

class Bench(Prop):
    blueprint: Uniform(*_blueprintsIn('bench'))

class Barrel(Prop):
    blueprint: Uniform(*_blueprintsIn('barrel'))

class ATM(Prop):
    blueprint: Uniform(*_blueprintsIn('atm'))

class Kiosk(Prop):
    blueprint: Uniform(*_blueprintsIn('kiosk'))

class IronPlate(Prop):
    blueprint: Uniform(*_blueprintsIn('ironplate'))

class TrafficWarning(Prop):
    blueprint: Uniform(*_blueprintsIn('trafficwarning'))
