#: description = "The emergency vehicle standing at the kerb launches into the ego's lane and races off."
#: adversaries = ["emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "accelerate", "fast"]
#: position = "kerb"

param OPT_ADV_DISTANCE = Range(8, 22)  #: [m] how far the ego still has to go to it when it moves off
param OPT_ADV_SPEED = Range(13, 17)  #: [m/s] how fast it drives

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do ThrottleOnPath(ownLane(egoRoute), 1, 0, globalParameters.OPT_ADV_SPEED)
