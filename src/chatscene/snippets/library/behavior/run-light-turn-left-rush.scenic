#: description = "The waiting car runs the red light and turns left with the throttle down."
#: rephrasings = [
#:   "still red for him, he guns it and whips round to the left",
#:   "Vehicle 2 accelerated from the stop bar on red into a left turn.",
#:   "from standstill, red, left, full gas",
#:   "The target, stationary at the stop line, accelerates on red and turns left across the VUT's path.",
#:   "The ambulance was waiting on the red but then it accelerates and turns left quickly.",
#:   "A fire engine pulls away against the lights and hurries round to its left.",
#:   "A biker cannot wait for green, twists the grip and tears off left.",
#:   "It launches off the line on red, bearing left and picking up speed.",
#:   "the bike waiting at the red didn't wait, he nailed it and whipped round to the left with his back wheel spinning",
#:   "While stopped at a red signal, the driver accelerated heavily and made a left turn against the light.",
#:   "Car at red: floors it, L turn, light still red.",
#:   "The stationary target departs against the red signal and turns left under full acceleration.",
#:   "The car stands at red, but then he gives full gas and goes to the left, still red.",
#:   "Waiting NPC jumps its red with max throttle into a left turn over the SUT's route; starts from v=0.",
#:   "The cruiser had stood waiting at the light; then it leapt forward on red and went howling round to the left.",
#:   "He's had enough of waiting, he's gone on red, foot to the boards, slewing round to the left.",
#:   "he was waiting at the red and then just floored it left before it changed",
#:   "A motorcyclist tired of the red signal tore off round to the left before it had turned",
#:   "You were stationary at the signal, it was yet red, and you nevertheless accelerated away to the left?",
#:   "He was waiting at red properly, then no patience, full speed take left turn",
#:   "Sat at the red drumming his fingers, then sod it, boots it round to the left",
#:   "Left turn on red from standstill under hard acceleration",
#:   "Police car waiting at red suddenly GUNS IT left",
#:   "The hatchback scorched off left against the red.",
#:   "Police car sat at red, then rockets away leftwards on it.",
#:   "Impatient biker drops the clutch at red, screaming off round to the left.",
#:   "Left, on red, from a standing start, pedal to the metal.",
#:   "Have the waiting ambulance bolt leftward while its signal is still red.",
#:   "he waited the light didnt change off he blasted to his left lol",
#:   "The taxi stood at its stop line for a good ten seconds before it tore away under a red lamp and, wheels spinning, bent round to the left over our route.",
#:   "From rest at the line, with its signal red, the target vehicle is accelerated at full drive torque along a left-turn path conflicting with that of the VUT.",
#:   "According to the pedestrian, V2 had been stopped for the light and, without awaiting green, surged into a left turn in which it was continuously gaining speed.",
#:   "I need a fire engine which is held at the red of the crossing road, then pulls out hard against that red and heads left with its engine roaring.",
#:   "Signal was red only, scooter was standing nicely, and then all of sudden he twisted full throttle and took left turn like in cinema, in front of me.",
#:   "He's been revving at that light since we came in sight, it's red, it's red, and he's gone for it, left, foot flat down, let him have the road.",
#:   "I was on the main road with a green light, doing twenty-eight. A grey coupé was standing on the cross street as it ought to. I looked away for one second, and when I looked again it was leaping out under its red light and slewing left before me, engine howling.",
#:   "Insured reports that the third party had been at a standstill at the red signal to her side. Apparently out of impatience he set his car in motion with maximum acceleration, swinging to his left through the junction while that signal was undeniably still red.",
#:   "Compare the two clips. In the other one the car never stopped and simply rolled round. In this one it is standing at the line on red; you can see the suspension squat, it launches on that same red and curves to the left picking up pace until it's out of view.",
#:   "The patrol car had stood there so meekly, its indicator ticking in time with the red lamp's reflection on the bonnet, that nobody expected it to spring. Yet spring it did, with the lamp as red as ever, and went storming round on its left hand across the avenue.",
#:   "Ticket: conflict predictor treats a vehicle halted at red as harmless. In the log a motorbike waits behind its line, jumps the light while it shows red and does its left turn at full throttle through our lane. Time from first movement to conflict point was under two seconds.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "turn-left", "accelerate"]
#: control = "signal"
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 52.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it accelerates"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.45
#: high = 0.8
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(18, 52)
param OPT_THROTTLE = Range(0.45, 0.8)

advTurn = "left-turn"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 9)
