#: description = "The oncoming pedestrian suddenly runs into the lane toward the ego."
#: adversaries = ["pedestrian"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "accelerate"]
#: position = "oncoming"
#: blocker = false

param OPT_ADV_SPEED = Range(0.8, 2)  #: [m/s] how fast it goes at first
param OPT_ADV_SPRINT = Range(4, 7)  #: [m/s] how fast it runs
param OPT_ADV_DISTANCE = Range(10, 28)  #: [m] distance to the ego at which it runs
param OPT_ADV_ANGLE = Range(0.3, 0.9)  #: [rad] how sharply it turns into the lane

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do Halt() until gap(self, ego) < 2 * globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    side = 1 if offsetFrom(egoRoute, self) > 0 else -1
    do MoveAhead(globalParameters.OPT_ADV_SPRINT, side * globalParameters.OPT_ADV_ANGLE) until side * offsetFrom(egoRoute, self) < -1
    do Halt()
