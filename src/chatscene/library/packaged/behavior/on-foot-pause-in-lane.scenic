#: description = "The oncoming pedestrian steps into the ego's lane, pauses there in doubt and then goes on across."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "cross", "hesitate"]
#: position = "oncoming"
#: maneuver = "straight"
#: place = "road"

param OPT_ADV_SPEED = Range(3, 4.6)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(22, 36)  #: [m] distance to the ego at which it steps in
param OPT_STOP_DISTANCE = Range(0.2, 1.6)  #: [m] how far from the ego's line it pauses
param OPT_STOP_TIME = Range(0.4, 1.4)  #: [s] how long it pauses

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do Halt() until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 1 seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1.4) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
