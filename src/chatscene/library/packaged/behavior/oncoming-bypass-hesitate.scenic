#: description = "The oncoming car stops, hesitates, and then comes on while the ego goes around the obstacle."
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "hesitate"]
#: position = "oncoming"
#: maneuver = "bypass"

param OPT_ADV_SPEED = Range(3, 7)  #: [m/s] how fast it drives
param OPT_ADV_DISTANCE = Range(25, 55)  #: [m] distance to the ego at which it pauses
param OPT_STOP_TIME = Range(0.5, 2)  #: [s] how long it pauses

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 1.5 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, 0.7) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
