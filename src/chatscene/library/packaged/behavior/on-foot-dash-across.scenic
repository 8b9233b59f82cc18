#: description = "The oncoming pedestrian breaks into a sprint and dashes straight across the ego's lane."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "cross", "fast"]
#: position = "oncoming"
#: place = "road"
#: blocker = false

param OPT_ADV_SPEED = Range(0.9, 1.8)  #: [m/s] how fast it walks at first
param OPT_ADV_SPRINT = Range(4, 6.5)  #: [m/s] how fast it sprints
param OPT_ADV_DISTANCE = Range(5, 17)  #: [m] distance to the ego at which it sprints across

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 1 seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE + 1.5 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPRINT, 1.57)
