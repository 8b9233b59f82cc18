#: description = "The car blocks multiple lanes by driving extremely slowly through the intersection."
#: rephrasings = [
#:   "A vehicle creeps over the junction and obstructs several lanes.",
#:   "The adversary inches across the crossroads far too slowly.",
#:   "The crossing car takes forever to clear the ego's way.",
#:   "At walking pace the other driver rolls through and holds up everyone.",
#:   "A long lorry crawls through the intersection.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory", "ego"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["slow"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 25.0
#: high = 55.0
#: unit = "m"
#: meaning = "distance to the ego at which it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.0
#: high = 3.2
#: unit = "m/s"
#: meaning = "how fast it crosses"

param OPT_ADV_DISTANCE = Range(25, 55)
param OPT_ADV_SPEED = Range(1, 3.2)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
