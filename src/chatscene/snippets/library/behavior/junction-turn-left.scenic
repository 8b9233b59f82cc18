#: description = "The car turns left across the ego's way without yielding."
#: rephrasings = [
#:   "A vehicle swings left through the junction in front of the ego.",
#:   "The adversary makes a left turn and takes the ego's priority.",
#:   "The other driver turns to the left, cutting the ego's path.",
#:   "A left-turning car crosses before the ego.",
#:   "The motorcyclist sweeps left over the crossroads ahead of the ego.",
#:   "he hangs a left right across us",
#:   "Vehicle 2 turned left and failed to yield the right of way.",
#:   "The target turns left across the path of the VUT at constant speed.",
#:   "He hung a left right across my bows without so much as a by-your-leave.",
#:   "Unit 2 failed to yield while making a left turn and crossed the path of Unit 1.",
#:   "Truck left turn at x-ing, no give way, cuts us off.",
#:   "The target vehicle executes a left turn across the path of the test vehicle, disregarding priority.",
#:   "The bus goes to the left before me, but I have priority.",
#:   "LTAP: actor ignores our right of way and turns left at normal speed.",
#:   "She had the right of way, but the cyclist simply leaned to the left and took it from her.",
#:   "He's going left, he hasn't looked, he's not going to give way to you, brake.",
#:   "she turned left right in front of me like i didnt exist, my turn btw",
#:   "A bus turned left through the path of a motorist who had the right to go first.",
#:   "You were bound to let my client pass; instead you took your left turn before him.",
#:   "He has taken the left turn across me, giving way is not in his dictionary.",
#:   "Lefty there reckons he owns the crossing, round he goes over my front, manners of a goat.",
#:   "Priority violation by left-turning vehicle across own path",
#:   "DIDN'T YIELD! Left turner cuts right across",
#:   "The cyclist turns left and snatches our priority.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["acrossMeeting", "advMeeting", "advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["turn-left"]
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -4.0
#: high = 26.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it turns"

param OPT_ADV_DISTANCE = Range(-4, 26)
param OPT_ADV_SPEED = Range(4, 10)

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, acrossMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
