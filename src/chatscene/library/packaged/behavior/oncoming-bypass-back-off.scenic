#: description = "The oncoming car stops and backs off while the ego goes around the obstacle."
#: adversaries = ["car", "truck", "bus"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "stop", "reverse"]
#: position = "oncoming"
#: maneuver = "bypass"

param OPT_ADV_SPEED = Range(4, 8)  #: [m/s] how fast it drives
param OPT_ADV_DISTANCE = Range(22, 50)  #: [m] distance to the ego at which it stops
param OPT_ADV_BACK = Range(1.5, 4)  #: [m/s] how fast it backs up
param OPT_ADV_BACK_TIME = Range(2, 5)  #: [s] for how long it backs up

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 1.5 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, 0.7) until self.pose[3] < 0.05
    do Halt() for 0.4 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK) for globalParameters.OPT_ADV_BACK_TIME seconds
    do Halt()
