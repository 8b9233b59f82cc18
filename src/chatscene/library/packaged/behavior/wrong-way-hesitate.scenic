#: description = "The oncoming car comes the wrong way in the ego's lane, stops for a moment, and comes on."
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "hesitate"]
#: position = "oncoming"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(4, 8)  #: [m/s] how fast it drives
param OPT_ADV_DISTANCE = Range(25, 50)  #: [m] distance to the ego at which it pauses
param OPT_STOP_TIME = Range(0.5, 1.5)  #: [s] how long it pauses
param OPT_ADV_OFFSET = Range(0, 3)  #: [m] how far toward its own side it keeps when it meets the ego

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < 75
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(against(egoRoute)) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < 24
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_ADV_OFFSET)
