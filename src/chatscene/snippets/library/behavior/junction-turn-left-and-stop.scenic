#: description = "The car turns left across the ego's way and stops in the intersection."
#: rephrasings = [
#:   "A vehicle swings left through the junction and comes to a halt before the ego.",
#:   "The adversary makes a left turn and then stands still, causing a near collision.",
#:   "The other driver turns to the left in front of the ego and freezes.",
#:   "Turning left, the car stalls in the middle of the crossroads.",
#:   "The left-turning vehicle stops short and blocks the ego.",
#:   "he swings left in front of us and then just stops there",
#:   "Vehicle 2 turned left and came to rest in the path of Vehicle 1.",
#:   "left turn, then standstill across our lane",
#:   "he hung a left right across my bows and then stopped slap in the middle of the crossroads",
#:   "V2 made a left turn across V1's path and stopped within the intersection, blocking it.",
#:   "Truck L turn over our path, halts in mid-jct.",
#:   "The target turns left across the VUT's trajectory and comes to rest before completing the turn.",
#:   "The car wants to go left, crosses my way, and then does not go on, it stays in the crossing.",
#:   "Left-turner stops halfway through its turn, in the SUT's way; should remain there till the end.",
#:   "The coach had begun to swing left before them and then, turn half done, it stopped and barred the way.",
#:   "He's going left over you, and, oh dear, he's not clearing, he's pulled up halfway round in your path.",
#:   "guy turned left across us then froze halfway thru the turn",
#:   "A removal lorry embarked on a left turn before oncoming shoppers and got no further than the middle",
#:   "You commenced a left turn before my client's car and then abandoned it in mid-junction, did you not?",
#:   "He take left turn in front of us then stop halfway, whole junction choke",
#:   "Cuts left over my front and gives up halfway round, sat there like a lemon",
#:   "Left-turn conflict with standstill of the turning vehicle inside the intersection",
#:   "Bus turns left ACROSS me... and never finishes the turn",
#:   "The motorcycle peeled left over our path and then petrified mid-turn.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["acrossMeeting", "advMeeting", "advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["turn-left", "stop"]
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 4.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it turns"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 4.0
#: high = 7.5
#: unit = "m"
#: meaning = "how far beyond where their ways meet it comes to rest"

param OPT_ADV_DISTANCE = Range(4, 30)
param OPT_ADV_SPEED = Range(4, 9)
param OPT_STOP_DISTANCE = Range(4, 7.5)

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, acrossMeeting) < globalParameters.OPT_ADV_DISTANCE + 8 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory)
