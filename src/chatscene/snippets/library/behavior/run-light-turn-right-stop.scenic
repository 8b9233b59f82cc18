#: description = "The crossing car turns right on red into the ego's lane and stops there."
#: rephrasings = [
#:   "hangs a right on red and then pulls up right in front of us",
#:   "Vehicle 2 turned right on red and stopped in the travel lane.",
#:   "right on red, then halts in lane",
#:   "The target turns right against the red signal and comes to a standstill in the lane of the VUT.",
#:   "The bus turns right by red and after that it stays standing in front of the ego.",
#:   "A taxi swings right through the lights and stops dead to drop somebody off.",
#:   "The biker hooks right on red and comes to rest ahead.",
#:   "It ignores the signal, comes round to the right, and goes no further.",
#:   "Came round the corner to the right on a red, into my lane, and just parked it there.",
#:   "Vehicle 2 made an unlawful right turn on red into Unit 1's lane and stopped.",
#:   "R-turn on red into ego lane, halts there.",
#:   "The crossing target turns right at red into the VUT's lane and comes to rest in it.",
#:   "The truck turns right with red light, comes in my lane and stands there.",
#:   "Right-on-red actor ends in our lane at zero speed, blocks it after the turn.",
#:   "He slipped round to the right though the light forbade it, and having got into her lane he stood still there.",
#:   "He's taken a right on red into your lane and now he's stopped dead in it, brake.",
#:   "guy turned right on red right into our lane n then just stopped??",
#:   "A minibus rounded the corner to the right against the signal and halted in the lane it had joined.",
#:   "Despite the red you turned right into my client's lane, and once in it you stopped?",
#:   "He took right on red signal, came to my lane and put full stop there.",
#:   "Sneaks round to the right on the red, plants himself in my lane and goes no further.",
#:   "Red-signal right-hand entry to ego lane with immediate standstill.",
#:   "RIGHT ON RED INTO MY LANE AND HE STOPS",
#:   "The van rounded right on red and clogged our lane.",
#:   "comes round to the right on red joins our lane and stops",
#:   "Bus disregards red, bears right ahead of us, stands still.",
#:   "Crossing van: red light ignored, right into ego lane, halt.",
#:   "RIGHT THROUGH RED, then parks himself in front of me",
#:   "Have a lorry take a right against the lights and stop before us.",
#:   "A motorbike out of the side street didn't wait for green, peeled off to the right into the lane we were in and pulled up there.",
#:   "The crossing target turns right in violation of its red signal, enters the lane of the VUT, travels a short distance and brakes to standstill.",
#:   "His light was red as a tomato, still he rounded the corner to the right and into my lane, and having got there he stood.",
#:   "By red the car has made the turn to the right, it was then in my lane in front of me, and there it has stopped completely.",
#:   "The taxi now standing in our lane had got there by slipping round the right-hand corner against its signal, just to let somebody out.",
#:   "Is it correct that you took the right-hand turn while the signal showed red, and that you then halted in the lane upon which my client was driving?",
#:   "I was coming up to the lights, which were green for me. A delivery lorry from the side road ignored its red and came round to the right so it was in front of me in my lane. Then its brake lights came on and that was as far as it got.",
#:   "V2, facing a red signal on the cross street, failed to wait and executed a right turn, which placed it in V1's lane ahead of V1. After some ten metres the driver of V2 brought it to a stop in the lane, stating later that he had been lost.",
#:   "The adversary comes from the crossing road. It ought to hold at red but does not: it bends round to the right, merges into the lane of the robotaxi and, once it has straightened up there, brakes to zero. The robotaxi then has a stationary vehicle ahead.",
#:   "Here the coach has a red, he's round to the right anyway, bless him, so now he's in your lane and you think he'll get going. He doesn't, he has pulled up to let his people off. Brake and stay behind him, don't argue.",
#:   "It was the 38 bus, I take it every week, so I know it when I see it. It went right at the corner though its light was red, got in front of our car, and then it stopped in our lane and opened its doors.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "turn-right", "stop"]
#: control = "signal"
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it turns"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 1.2
#: high = 2.5
#: unit = "s"
#: meaning = "how long it goes on in the ego's lane before it stops"

param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_ADV_SPEED = Range(5, 8)
param OPT_STOP_TIME = Range(1.2, 2.5)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 6
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_STOP_TIME seconds
    do BrakeOnPath(egoRoute, 0.6)
