#: description = "The car blocks multiple lanes by driving extremely slowly through the intersection."
#: rephrasings = [
#:   "A vehicle creeps over the junction and obstructs several lanes.",
#:   "The adversary inches across the crossroads far too slowly.",
#:   "The crossing car takes forever to clear the ego's way.",
#:   "At walking pace the other driver rolls through and holds up everyone.",
#:   "A long lorry crawls through the intersection.",
#:   "this thing just inches over the crossing and nobody can move",
#:   "Vehicle 2 proceeded through the intersection at very low speed, obstructing traffic.",
#:   "The bus is passing the crossing so slowly that all must wait.",
#:   "A bus was inching over the crossroads at a snail's pace and nobody could get by in any lane.",
#:   "Vehicle 2 proceeded through the intersection at approximately three miles per hour, obstructing several lanes of traffic.",
#:   "Truck crawling thru X-ing, walking pace, several lanes plugged. Never stops.",
#:   "The target traverses the junction at a constant very low speed, obstructing more than one lane.",
#:   "The car drives in the crossing so slow like a turtle, nobody can pass.",
#:   "Slow-mover in the junction box: continuous 1-2 m/s, no stops, occupies multiple lanes.",
#:   "It oozed across the crossroads like treacle, and behind it and beside it everyone had to wait.",
#:   "He's taking all day to get over that junction and he's holding everyone up, just sit tight till he's dawdled across.",
#:   "bus going like 2mph thru the intersection n nobody can get round it",
#:   "A lorry took an age to creep over the crossroads, bottling up every lane.",
#:   "Would you agree that the lorry went over the junction at barely a walk, leaving no lane free?",
#:   "That bus so slow at the junction, like tortoise, all the lanes also stuck.",
#:   "Slower than a hearse over the crossroads, he was, and spread across the lot of us.",
#:   "Multi-lane obstruction by very-low-speed intersection transit.",
#:   "SLOWEST TRUCK EVER TAKES UP WHOLE INTERSECTION",
#:   "The truck oozed over the crossroads, corking every lane.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["slow"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -4.0
#: high = 26.0
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

param OPT_ADV_DISTANCE = Range(-4, 26)
param OPT_ADV_SPEED = Range(5, 9)
param OPT_SLOW_DISTANCE = Range(-2, 6)
param OPT_SLOW_SPEED = Range(0.6, 2.2)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SLOW_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED)
