#: description = "The oncoming car comes the wrong way in the ego's lane, stops, and backs away."
#: adversaries = ["car", "truck", "bus"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "stop", "reverse"]
#: position = "oncoming"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(5, 9)  #: [m/s] how fast it drives
param OPT_ADV_DISTANCE = Range(30, 48)  #: [m] distance to the ego at which it brakes
param OPT_ADV_BACK = Range(1.5, 4)  #: [m/s] how fast it backs up
param OPT_ADV_BACK_TIME = Range(2, 5)  #: [s] for how long it backs up

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < 75
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 0.8 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(against(egoRoute)) until self.pose[3] < 0.05
    do Halt() for 0.4 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK) for globalParameters.OPT_ADV_BACK_TIME seconds
    do Halt()
