#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [variants]
#: walker-plant-in-lane = { actions = ["cross", "stop", "block"], adv_speed = [1.1, 1.8], adv_distance = [30, 48], stop_distance = [0.2, 1.25], near = 3.5 }
#: rider-stall-in-lane  = { actions = ["pull-out", "slow", "stop"], adv_speed = [1.4, 2.6], adv_distance = [30, 50], stop_distance = [0, 1.1], near = 4, adversaries = ["bicycle", "motorcycle"] }
#: [descriptions]
#: walker-plant-in-lane = "The pedestrian walks into the ego's lane, plants itself there and refuses to move."
#: rider-stall-in-lane  = "The rider rolls slowly out of the roadside into the ego's lane, stalls and stands across it."

param OPT_ADV_SPEED = Range$adv_speed  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] how far the ego still has to go when it starts to move
param OPT_STOP_DISTANCE = Range$stop_distance  #: [m] how far from the ego's line it comes to rest

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < $near
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
