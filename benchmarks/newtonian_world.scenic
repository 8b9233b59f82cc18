"""The opponent's world: Scenic's own Newtonian simulator, with the names that benchmark programs use."""

from scenic.simulators.newtonian.driving_model import *

from chatscene.world.ego_route import choose_route as _choose_route
from chatscene.world.places import directionOn, pointOn

param route = 0

def selectRoute(maneuver):
    return _choose_route(network, globalParameters.map, int(globalParameters.route), maneuver=maneuver)

def startOf(route):
    return new OrientedPoint at pointOn(route, 0), facing directionOn(route, 0)
