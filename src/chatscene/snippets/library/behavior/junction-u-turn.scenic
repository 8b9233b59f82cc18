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
#:   "Police bike loops right round mid-crossroads, off up its own street.",
#:   "Enters junction, exits by its own arm: taxi, one tight loop.",
#:   "saw a Civic do a donut-lite at the lights and go home",
#:   "Instead of leaving by one of the three other arms, the ambulance wheeled about at the centre and returned along the one that had brought it.",
#:   "The heading of the target increases continuously by 180 degrees while its position stays within the bounds of the intersection, after which it leaves at constant speed.",
#:   "He wants to go back, clearly, so round he comes in the middle of the junction, as tight as she'll turn, and there he goes away from us.",
#:   "A man on a moped drove to the middle, and there he has turned himself around like a dog before sleeping, and back to home.",
#:   "Could the side-road actor be made to bring itself about in the intersection's centre, facing home again, and drive away in that direction?",
#:   "Vehicle 2 entered from the east leg and, following a continuous turning movement inside the intersection proper, was observed leaving by the east leg.",
#:   "I had him down for straight on. His wheels went over, so I thought, no, he's turning; and they stayed over, and stayed over, till the same side of the car that had been facing me was facing away, and off he drove up the road he'd only just come out of.",
#:   "It was number 40 they needed and they had driven past it. That's how there came to be a fire officer's car, lamps on, swinging its whole length about between the four corners, and going back down Albert Street with the rest of us standing like skittles.",
#:   "Nobody has ever painted an arrow for what that Nissan did. It arrived at the crossing from the left, described a neat half circle round the manhole in the centre, and the next thing I could read was its rear number plate, going home.",
#:   "The report says the tyre marks form an arc. They begin and end on the same approach, one on the inbound side and one on the outbound, and the loop between them lies wholly within the intersection, where V2 was brought about in front of V1.",
#:   "My grandson counted it as a win for me in the I-spy game, something beginning with U. The lady had sailed out of her side street as far as the very middle, then she spun her wheel like a ship's captain and came back past the same postbox.",
#:   "In the planner's log we had it as a crossing vehicle, then as a left-turner, then as nothing we had a label for. It kept its steering at the limit in the centre of the box until it was headed up the arm it had come from, and it went.",
#:   "Rain was coming down hard and the junction shone. Into it came a single headlamp, which swept over the shop fronts like a lighthouse, the chemist, the bank, the pub, all the way round, and went out as the motorcycle showed us its tail and rode off whence it came.",
#:   "Sir, I can only say what I saw out of my cab. The minicab came into the crossroads at fair speed, he didn't take any of the exits, he screwed it round on the spot practically, and he went away in the direction he'd arrived from.",
#:   "People here take a U-turn anywhere, even in centre of four-road crossing. This one auto came from side road, he reached up to the middle, he turned full, opposite direction, and he went back to same road, and all of us only watching.",
#:   "The two of us reached the place at about the same time, I on the main road, she on the minor. There was room enough for her to cross; what there wasn't room for was that pirouette of hers in the middle, at the end of which she was pointing back up the minor road.",
#:   "Teaching point for today. That car in the junction has had its wheels on full lock for far too long to be making any ordinary turn, and look, it's come about completely, it's going back where it came from, all within the crossroads.",
#:   "Same arm in, same arm out, full lock in between.",
#:   "The moped drew a horseshoe round the centre manhole and rode home.",
#:   "Look, he's bringing her about in the crossroads, he's off back!",
#:   "Of the four ways out of that junction the police bike chose the one it had just come in by, with a tight loop in the middle.",
#:   "I had the taxi's headlights in my eyes, then its doors, then its boot, all in the middle of the crossing, and then it was gone up its own street.",
#:   "Let the other car get as far as the heart of the intersection and be wheeled about there until it faces the road it came by, and send it off along it.",
#:   "The heading log of the crossing agent runs from 90 to 270 degrees within the box, and the exit link has the same number as the entry link.",
#:   "It wasn't a left turn, though it set out like one; her wheels simply stayed hard over, inside the junction, till she could go back past her own front gate.",
#:   "V2's driver stated that she had missed the school and therefore, upon reaching the middle of the intersection, put the vehicle about and made for the direction she had come from.",
#:   "There's a statue in the centre of our crossroads and a saying that it has seen all but its own back. On market day it saw all of a Land Rover. Out of the brewery lane it came, round by the statue's toes in one hard sweep, and the brewery lane got it back again, while we sat there.",
#:   "What had us fooled was that it looked so much like somebody turning off. We waited for it to straighten up and take the road by the bank. It wouldn't straighten. The bank went past its bonnet, then we did, and only when its nose was pointing at the street behind it did the steering come back and the thing drive away.",
#:   "The scrape on our wing was made by his rear bumper and not his front one, sir. I had reckoned with a car going over the junction. But in the middle of it he'd begun to spin her round to go home, and the back end swings wide when you do that, whichever way the front's looking.",
#:   "Ambulance 12 has been stood down at the junction, so he isn't carrying on to you. I can see him on the camera: blinker on, round he comes in the dead centre, full circle near enough, no, half, and he's heading back down Victoria to the station. All units give him room there.",
#:   "It's a motorcycle, so it hardly needs any space. Even so I'd have liked a hint. He rode out of the side street up to the white lozenge in the middle, dropped a foot, let the back wheel skate about beneath him, and I was treated to his other profile and the number plate on his way out by the same side street.",
#:   "Count the exits, I say to the pupils, then count on none of them. You had that Volvo going straight, and you, Jamie, had it turning left. It's done neither. It has swung through the whole of the compass, or half, there between the corners, and it's now on its way back up the road that it was coming down.",
#:   "The chap in the shop sold me a paper and told me all about it. She'd forgotten the oven. You could see the very moment, he says, because she was halfway over the crossing; up went her hand to her mouth, over went the wheel as far as it would go, and round and home she went with the tyres squeaking.",
#:   "How many metres of road does a car need to face the other way? The one on our log took eleven. They're all of them within the intersection, so it needn't be looked for on any of the arms, barring the one which it both came from and left by. Our planner expected it on each of the remaining three.",
#:   "I drive the 68 and I'd had the green for a while. A cab on the side road hears a whistle from behind him, from where he'd come, I mean. What does he do? Right there, on the yellow boxes, nose to tail about, one go, no shunting, and away to his whistle. My standing passengers weren't.",
#:   "From the window of the dentist's the junction looks like a dartboard. A red hatchback flew at the bull from the left, so to speak, and at the bull it curled up on itself as a leaf does in a fire. When it had uncurled, it was travelling to the left, down the road it had flown in from.",
#:   "That day I was going to temple with mummy. From the left road one Alto came in the chowk, and it was raining, and in dead centre this Alto started to go round, and round, mummy said he is doing parikrama! Half he did, then face was to the left road again, and there only he went.",
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

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE
    do TurnOff(3, globalParameters.OPT_ADV_SPEED, 5)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
