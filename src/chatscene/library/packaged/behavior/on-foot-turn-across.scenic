#: description = "The oncoming pedestrian walks along the edge of the road and suddenly turns off across the ego's lane."
#: adversaries = ["pedestrian", "bicycle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "swerve", "cross"]
#: position = "oncoming"
#: place = "road"
#: blocker = false

param OPT_ADV_SPEED = Range(2.4, 4.2)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(4, 20)  #: [m] distance to the ego at which it turns across

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 1 seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1.57)
