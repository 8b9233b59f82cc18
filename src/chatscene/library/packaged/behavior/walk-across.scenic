#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: origin = "base scenario straight-obstacle; own code"
#: [variants]
#: cross      = { actions = ["cross"], adv_speed = [1.5, 5], adv_distance = [18, 54] }
#: slow-cross = { actions = ["cross", "slow"], adv_speed = [0.8, 1.4], adv_distance = [22, 52], adversaries = ["pedestrian"] }
#: [descriptions]
#: cross      = "The pedestrian crosses the road without stopping."
#: slow-cross = "The pedestrian crosses very slowly."

param OPT_ADV_SPEED = Range$adv_speed  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] how far the ego still has to go when it starts to move

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 8)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
