#: description = "The car blocks multiple lanes by driving extremely slowly through the intersection."
#: rephrasings = [
#:   "A vehicle creeps over the junction and obstructs several lanes.",
#:   "The adversary inches across the crossroads far too slowly.",
#:   "The crossing car takes forever to clear the ego's way.",
#:   "At walking pace the other driver rolls through and holds up everyone.",
#:   "A long lorry crawls through the intersection.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["slow"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_SLOW_DISTANCE"
#: low = -2.0
#: high = 6.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it slows down"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 0.6
#: high = 2.2
#: unit = "m/s"
#: meaning = "how fast it crosses then"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(5, 9)
param OPT_SLOW_DISTANCE = Range(-2, 6)
param OPT_SLOW_SPEED = Range(0.6, 2.2)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SLOW_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED)
