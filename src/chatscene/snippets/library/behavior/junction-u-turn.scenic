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
#:   "Taxi did a complete loop-round at the crossroads and went home again",
#:   "Police bike swings about-face bang in the centre of the intersection.",
#:   "Let the saloon hook all the way round inside the junction.",
#:   "In the crossing he makes the full turn-around and drives back.",
#:   "Ambulance entered junction stop turned through half circle stop departed whence it came",
#:   "The woman in the SUV drove into the crossroads, hauled the wheel to its stop and came all the way round until she faced her own road again.",
#:   "Simulate a scooter that rides as far as the middle of the intersection and there turns round completely, leaving by the arm it entered from.",
#:   "According to the bystander, the minicab neither went straight on nor took a side street; it wheeled about in the middle of the junction and went back.",
#:   "Fire crew got a new address mid-call, so they're bringing the truck right round inside the crossroads and heading back up their street.",
#:   "What do you do with an actor that comes into the intersection, describes a tight half-circle there, and exits with its heading inverted?",
#:   "I saw how that car arrived in the middle of the crossing and rotated itself completly, then took again the same street as before",
#:   "Missed your road? Then go round the block like everybody else. The driver of this Golf didn't care to, so he spun his car about in the middle of the crossroads while everyone sat there staring, and off he went the way he'd come.",
#:   "V2 entered the intersection from the minor road. Instead of continuing, its driver applied full lock and turned the vehicle through approximately 180 degrees within the intersection, so that at the end it was facing the direction from which it had approached.",
#:   "My son asked from the back seat whether that was allowed. The motorcycle had come out to the centre of the junction, leaned right over, and swept round in a tight curve until it was pointing at the street it had just left.",
#:   "This one is mean to the intent predictor: no blinker, normal entry speed, and then the vehicle keeps turning and turning at the centre of the intersection until it has reversed its direction of travel and leaves by its own approach road.",
#:   "I am eighty-one and I have never done such a thing. The gentleman had evidently forgotten something at home, for he turned his car completely about right where the two roads meet, and drove off again with a cheerful wave.",
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
