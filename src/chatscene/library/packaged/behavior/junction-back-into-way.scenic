#: description = "The car passes the intersection, brakes to a stop, and backs into the ego's way."
#: adversaries = ["car", "truck", "bus"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "stop", "reverse"]

param OPT_ADV_DISTANCE = Range(36, 58)  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_ADV_SPEED = Range(6, 9)  #: [m/s] how fast it drives
param OPT_STOP_DISTANCE = Range(4, 7)  #: [m] how far beyond where their ways meet it stops first
param OPT_ADV_BACK = Range(1.5, 3.5)  #: [m/s] how fast it backs up
param OPT_ADV_REACH = Range(-1, 2)  #: [m] how far beyond where their ways meet it stays in the end

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK) until distanceLeft(advTrajectory, self, advMeeting) > -globalParameters.OPT_ADV_REACH - brakingDistance(self)
    do Halt()
