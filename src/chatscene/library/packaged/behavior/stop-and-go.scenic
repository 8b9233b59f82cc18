#: description = "The pedestrian crosses in fits and starts, stopping again and again."
#: adversaries = ["pedestrian"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "hesitate"]

param OPT_ADV_SPEED = Range(1.5, 4)  #: [m/s] how fast it goes in a burst
param OPT_ADV_DISTANCE = Range(20, 48)  #: [m] how far the ego still has to go when it starts to move
param OPT_ADV_BURST = Range(0.6, 1.2)  #: [s] how long a burst lasts
param OPT_STOP_TIME = Range(0.3, 0.8)  #: [s] how long it stands between bursts

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 18)
    while True:
        do MoveAhead(globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_ADV_BURST seconds
        do Halt() until self.pose[3] < 0.1
        do Halt() for globalParameters.OPT_STOP_TIME seconds
