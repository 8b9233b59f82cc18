#: description = "The car makes a U-turn in the middle of the intersection."
#: rephrasings = [
#:   "he just swings right round in the junction and heads back where he came from",
#:   "Vehicle 2 executed a U-turn within the intersection in front of Vehicle 1.",
#:   "U-turn inside the crossing",
#:   "The target turns through 180 degrees within the junction across the path of the VUT.",
#:   "The car turns around in the crossing and returns in the direction from where it came.",
#:   "A taxi spins about on the crossroads to pick up a fare on the other side.",
#:   "The biker does a one-eighty in front of the ego.",
#:   "A police car whips round in the box and doubles back.",
#:   "Some wally spun right round in the middle of the crossroads and went back the way he'd come.",
#:   "Unit 2 made an illegal U-turn within the intersection.",
#:   "Moto flips 180 mid-jct.",
#:   "The target performs a 180-degree turn inside the intersection and departs in the opposite direction.",
#:   "The police car turns around complete in the crossing and goes back.",
#:   "Actor does a U-ey at the centre of the junction instead of any of the legal exits.",
#:   "He got as far as the middle, swung her all the way about and headed back where he came from.",
#:   "He's doubling back, that car, swinging right round in the junction, so don't assume he's going straight.",
#:   "mans did a full uey in the middle of the intersection",
#:   "A driver turned about in the heart of the crossroads, bringing cars to a standstill.",
#:   "You turned your vehicle about in the centre of the junction so as to return whence you had come?",
#:   "Middle of junction he took U-turn, as if it is his father's road.",
#:   "About-turn slap in the middle of the crossroads, this genius, wrong way home was it?",
#:   "Reversal of travel direction by turning inside intersection area.",
#:   "U-TURN IN THE MIDDLE OF A BUSY INTERSECTION",
#:   "The police car pirouetted at the centre of the crossroads.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["u-turn"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 5.0
#: high = 28.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 0.0
#: high = 5.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it turns"

param OPT_ADV_DISTANCE = Range(5, 28)
param OPT_ADV_SPEED = Range(4, 7)
param OPT_SWERVE_DISTANCE = Range(0, 5)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE
    do TurnOff(3, globalParameters.OPT_ADV_SPEED, 5)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
