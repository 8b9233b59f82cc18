#: description = "The rider turns left and cuts the corner, riding over the wrong side of the road it leaves."
#: rephrasings = [
#:   "A scooter takes the left-hander on the inside, all the way over on the wrong side.",
#:   "The motorcyclist cut the corner while turning left across the path of Vehicle 1.",
#:   "moto cuts corner on left turn",
#:   "The powered two-wheeler takes a left turn with its trajectory shifted to the inside.",
#:   "The bike makes a left turn too narrow and comes on the false side.",
#:   "A courier shaves the inside of the bend as he swings left.",
#:   "The moped takes a shortcut over the centre line to go left.",
#:   "She leans in early and clips the apex of her left turn in front of us.",
#:   "The cyclist sliced the corner turning left and came right over the wrong side of the side road.",
#:   "The bicyclist made a short left turn, traversing the opposing lane of the street he was leaving.",
#:   "MC turns L, clips the corner, on wrong half of road.",
#:   "The two-wheeler turns left on a shortened trajectory leading over the opposing lane of its road of origin.",
#:   "The motorbike turns left too short and drives on the wrong side at the corner.",
#:   "Rider's left turn skips the apex, path runs through the oncoming half of the arm it exits.",
#:   "He could not be bothered to go round properly; he took the short way over the wrong half of the lane and was gone.",
#:   "See that moped, he's cutting the corner on his left, he's on the wrong side where you'd be waiting.",
#:   "biker turned left and totally shaved the corner on the wrong side",
#:   "The rider took the left-hand bend so tightly that he strayed into the lane meant for those coming the other way.",
#:   "In turning left he abridged the corner, and rode where opposing traffic had every right to be.",
#:   "That scooter took short cut in the left turn, coming full wrong side.",
#:   "Left turn by the short route, over the wrong half, as if corners cost money.",
#:   "Shortened left-turn line of two-wheeler with use of opposing lane",
#:   "BIKER SKIPS THE CORNER - wrong side!",
#:   "The motorcyclist shears off the corner leftward over the wrong lane.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["acrossMeeting", "advMeeting", "advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["turn-left", "follow"]
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -2.0
#: high = 24.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 7.5
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.0
#: high = 2.2
#: unit = "m"
#: meaning = "how far it cuts to the inside"

param OPT_ADV_DISTANCE = Range(-2, 24)
param OPT_ADV_SPEED = Range(4, 7.5)
param OPT_SWERVE = Range(1, 2.2)

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, acrossMeeting) < globalParameters.OPT_ADV_DISTANCE + 7.5 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE)
