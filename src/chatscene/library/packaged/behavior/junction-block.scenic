#: description = "The car drives into the intersection and stays there, blocking the box."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["stop"]
#: position = "crossing"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(10, 13)  #: [m/s] how fast it drives in
param OPT_BRAKE = Range(0.5, 0.8)  #: [1] how hard it brakes
param OPT_STOP_DISTANCE = Range(-1, 2)  #: [m] how far beyond where their ways meet it comes to rest

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do ThrottleOnPath(advTrajectory, 1, 0, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) / globalParameters.OPT_BRAKE - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
