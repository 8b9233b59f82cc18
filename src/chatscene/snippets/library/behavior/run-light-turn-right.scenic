#: description = "The vehicle runs the red light and makes an abrupt right turn."
#: rephrasings = [
#:   "A car ignores the signal and hooks sharply to the right inside the junction.",
#:   "Jumping the lights, the adversary swings right in front of the ego.",
#:   "The other driver crosses on red and suddenly turns right.",
#:   "Against the red a vehicle enters and yanks the wheel rightward.",
#:   "The motorcyclist disregards the lights and cuts round to the right.",
#:   "he runs the red and chucks it to the right",
#:   "Vehicle 2 entered against the signal and turned sharply to the right.",
#:   "runs red, late hard right",
#:   "The van didn't bother with the red, he just whipped it round to the right in front of me.",
#:   "Unit 2 failed to stop for the red signal and made a sharp right turn.",
#:   "MC ignores red, snap R turn.",
#:   "The target vehicle passes the red signal and performs a right turn with high yaw rate.",
#:   "The bus has red but goes fast around to the right.",
#:   "Red runner with a sudden right turn into our exit, quick steering, no stop at the line.",
#:   "She had green; he had red, and still he threw the wheel over and barrelled round to the right.",
#:   "Truck's not stopping for that light, he's yanked it right, he's coming into your road.",
#:   "he didnt even stop for the red just whipped a right",
#:   "A car took a sudden right-hand turn against the red signal.",
#:   "The signal being against you, you nonetheless turned to the right, and sharply.",
#:   "Red signal was there but he cut the right turn just like that, full sudden.",
#:   "Red's only a suggestion for him, hard right and gone.",
#:   "Abrupt right turn of vehicle in violation of red signal",
#:   "NO STOP ON RED, snaps right in my face",
#:   "The truck flouts the red and lunges right.",
#:   "Crossing biker blows the red and dives off to the right.",
#:   "Side-street van on red, doesn't halt, violent right-hander, over.",
#:   "Let the cross-traffic bus ignore red and veer round right sharply.",
#:   "The red lamp he didn't see, and fast he turned right.",
#:   "saloon jumps its lights then a handbrake style right lol",
#:   "Its signal was at stop, yet the lorry from the intersecting street entered and, all in one jerk, made a turn to the right in front of us.",
#:   "The crossing target does not comply with its red signal; within the junction it initiates a right turn with a steep rise in steering angle.",
#:   "You've got the green, so you think he's waiting. Nope, he's through the red, and there he goes, wrenching that hatchback round to his right.",
#:   "Monsieur in the cross street burned the red fire, and when I thought he will go straight he has brutally taken the right.",
#:   "I saw the motorcycle pass its red light and thought it meant to go over; instead it was suddenly laid over into a right turn.",
#:   "How did the pickup end up on the road to its right? By passing a red light without pause and hauling the wheel round at the last second.",
#:   "I was in the middle of my driving lesson, would you believe. The cab on the other road had red, clear as day. He came out, and before my instructor could get a word in he'd thrown it to the right, tyres squealing, with the passenger's face squashed on the window.",
#:   "The operator of Vehicle 2 disregarded a steady red indication on the cross street and entered the intersection. He then changed direction abruptly to the right. There was no signal and no lowering of speed beforehand, and the marks on the asphalt show how tight and how late the turn was begun.",
#:   "Ticket: red-light runner, right variant. The NPC arrives on the crossing arm against red and goes on in. We predict it straight across; a few metres before the conflict point its heading swings by ninety degrees to its right in under two seconds. Please keep the straight and the left one separate.",
#:   "Nobody at the bus stop could believe it. The coach had a red, the people were already lifting their feet to cross, and it came through as if the lamp had been put up for decoration. Then its whole length heeled over and it was gone round the corner to the right, luggage doors rattling.",
#:   "In the fourth video the culprit is a milk tanker. It's on the road that crosses ours, its light has been red for an age, and it doesn't so much as lift. Having come in, it takes a savage right, and you can see the far wheels go light. The cammer just says \"wow\".",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: actions = ["run-light", "turn-right"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 42.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 0.0
#: high = 8.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it turns"

param OPT_ADV_DISTANCE = Range(18, 42)
param OPT_ADV_SPEED = Range(5, 10)
param OPT_SWERVE_DISTANCE = Range(0, 8)

advTurn = "straight"

behavior AdvBehavior():
    # Where no way goes straight on, it leaves its way before that bends.
    start = self.pose[2]
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE or abs(self.pose[2] - start) > 0.15
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -1.5708)
