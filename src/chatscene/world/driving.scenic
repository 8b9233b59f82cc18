"""The world model for programs of Scenic's driving domain: its names, its places and its behaviors, our bodies.

Unlike `chatscene.world.model`, it leaves to Scenic what Scenic draws: positions, directions, colours. Programs for the
Newtonian simulator and for MetaDrive are read with it too.
"""

from chatscene.maps.network import install_network_memo as _install_network_memo
_install_network_memo()  # the map of the run, parsed once

from scenic.domains.driving.model import *

from chatscene.terms.actors import LIMITS as _LIMITS
from chatscene.world.actors import Driven, Placed, Walking
from chatscene.world.places import wheelbase_of as _wheelbase_of
from chatscene.world.stock import stock_simulator as _stock_simulator

from chatscene.world.searched import parameter as chatscene_parameter
from chatscene.world.series import TimeSeries

VerifaiRange, VerifaiDiscreteRange, VerifaiOptions = Range, DiscreteRange, Options  # whose package is not needed

param signals = 'clock'
param time_step = 0.1
param timestep = 0.1
if not (abs(globalParameters.time_step - 0.1) < 1e-9 and abs(globalParameters.timestep - 0.1) < 1e-9):
    raise ValueError('a drive has steps of 0.1 s; leave `param timestep` and `param time_step` away')

if 'simulator' not in globalParameters:
    from chatscene.settings import SimulationSettings as _SimulationSettings
    param simulator = _SimulationSettings().simulator
simulator _stock_simulator(globalParameters.simulator, globalParameters.map)

class Car(Driven, Car):
    wheelbase: _wheelbase_of('Car', self.length)
    wheelAngle: _LIMITS['Car'].wheel_angle
    isWalker: False
    label: ''
    route: None

class NPCCar(Car):
    pass

class Pedestrian(Walking, Pedestrian):
    isWalker: True
    label: ''

    @property
    def isPedestrian(self):
        return True

class Prop(Placed, DrivingObject):
    regionContainedIn: road
    position: new Point on road
    parentOrientation: Range(0, 360) deg
    isWalker: False
    label: ''

class Debris(Prop):
    pass
