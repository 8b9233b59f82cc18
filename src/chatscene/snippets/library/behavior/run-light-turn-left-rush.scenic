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
#:   "Standing at red, then tearing off left without waiting for green.",
#:   "Ambulance waits, light stays red, throttle slams, left it goes.",
#:   "Make the stopped biker launch left on red, flat out.",
#:   "The fire engine had been held at the side road's line; still on red, it pulled out with a howl and swept round to its left ahead of us.",
#:   "Target at rest behind the line, its signal red: full drive torque is applied and a left turn through the VUT's path is carried out.",
#:   "Signal is not changed, he is having red only, but that fellow standing first has twisted full accelerator and gone left across my bonnet.",
#:   "From a standstill at the red lamp V2 surged into the intersection, bearing left, its tires spinning and its speed still rising as it left the scene.",
#:   "While the light of him stayed red, the Peugeot which was waiting there parted like a rocket, and this towards its left, through my road.",
#:   "Sat there good as gold, didn't she, and then she's put her foot through the floor, red and all, and gone haring off to the left!",
#:   "We were looking at it, that's the mad part. It was the only other car out, a blue Golf at the line on the cross street with a red light shining on its roof. The roof was red when its nose came up, it was red when the tyres began to smoke, and it was still red when the Golf went by us, leftward, gathering speed.",
#:   "The nurse in the passenger seat was strapped in, luckily. The ambulance crew had waited some seconds at the red on the hospital road. Then the call was upgraded and the driver didn't wait any more: hard on the accelerator, out on red, round to the left, over the lane in which Vehicle 1 was approaching on green.",
#:   "\"That one's not going anywhere,\" my uncle said, pointing with his pipe at the motorcycle that was stopped at the crossroads for a red light. He ought not to have said so. It reared up, came out under that red light, laid itself over to its left and was doing fifty by the time it had crossed our bows.",
#:   "Behavioural note. A stationary vehicle behind a red signal has until now been regarded as no conflict. Subject 9 shows why that's unwise: wheels at rest for five seconds, signal red throughout, then maximum acceleration at once, with a left turn through our lane and a speed at its end of 13 m/s.",
#:   "I sell papers at that junction. You get to know the ones who can't sit still. This cabbie was creeping and dipping his clutch behind the line, lights against him. Before they'd changed he dropped it, and off he went with a squeal, round to the left, foot right down, and the driverless car stopped on its nose.",
#:   "The claim form has a sketch on it. Arrow A, ours, goes straight on through green. Arrow B begins at a small rectangle marked \"waiting at red\" and bends left over arrow A; beside it the insured has written \"signal still red!\" and \"engine screaming\" and, where the bend ends, \"even faster here.\"",
#:   "No, no, don't creep forward, you've got a green but he hasn't the look of a man who's stopping there. See? Light on his side's red as red, and he's launched it. He's coming round on his left hand right across us, and he's not lifting either, he's going faster the further round he gets.",
#:   "Title: cop forgets how traffic lights work. The cruiser's standing on the side street at a red, no siren, no lights. Ten seconds of nothing. Then it squats on its back axle and blasts out, light's red, you can zoom in, hangs a left in front of my hood and keeps on accelerating out of the picture.",
#:   "Please build the impatient one. He arrives on the crossing road ahead of time and stops properly for his red. When our robotaxi nears the junction he has had enough: he floors the pedal with the light unchanged, steers into a left turn that takes him through our path, and doesn't let go of the gas.",
#:   "It wasn't the lad's first time on a fast motorbike but it was his first in front of girls. They stood on the corner by the lamp, which was red, and he stood below it, revving. When he went it was all at once, the lamp not having changed, away and over to his left, the engine climbing and climbing, and our old Fiesta in between.",
#:   "All units, the subject's stationary at red on Mill Street, first in the queue, I'm two behind. Wait. He's off, he's gone on the red, he has gone left, left, left into the High Street, wheels spinning, and he's cut across a grey saloon that had the green. Speed's building, forty, fifty.",
#:   "Held at red, bored of red, blasts off left through it.",
#:   "Wheelspin under a red lamp, and the police car's gone left.",
#:   "Make the halted biker storm off leftwards, red be damned.",
#:   "He'd stopped for that red like a saint, so I sinned in trusting him, for he floored it under the same red and came slewing left over my lane.",
#:   "Never turn your back on a revving motorbike at a stop line: red or no red, this one was let loose, to his left, right through our way, engine screaming.",
#:   "The signal for V2 had not changed when its drive wheels broke traction at the stop line and it entered on a left-hand curve, speed increasing all the way round.",
#:   "From rest behind its line, and against a red aspect, the target applies full drive torque and follows the left-turn path over that of the VUT.",
#:   "For as long as we were far he stood at his red, and when we were near he gave everything to the motor and went to his left.",
#:   "Ambulance on the side road sits, sits, sits at the red, then it's bum down, nose up, round to the left in front of the 27, faster and faster.",
#:   "Because it was at a stand, with its hazard of a driver drumming on the wheel, I'd ticked it off my list. The lamp over it was red and remained red; you can see its glow slide back over the bonnet, the roof, the boot. Then all I saw was boot, going off round the corner to its left, over my lane, with smoke under it.",
#:   "We've two counts here. The first is the red, at which your client had properly halted and under which he improperly set out. The second's the manner of it. There's rubber on the line, there is rubber round the whole of the bend to the left, and a tachometer at the end of it, m'lud, that wants explaining.",
#:   "A standing start is quick, you know, quicker than a car that's rolling up. My pupil had the green and had looked. What she'd seen on the cross street was a stationary scooter with a red lamp. By the time she was at the line it wasn't there. It was in front of us, laid over to its left, with the rider tucked down and still winding it on.",
#:   "Nothing about the fire engine suggested hurry. One man was eating a banana. They were on the road that comes in from the harbour, at their red, and had been for half a minute. Then the bell went in the cab, I suppose. The lamp was as it had been; the engine wasn't. It roared out, round left, over our side, picking up pace.",
#:   "Phase diagram, cross street: red from second 0 to second 40. Trajectory of vehicle K, cross street: distance to line 1.0 m, constant, from second 9 to second 31. At second 31 it departs with an initial acceleration of 4, which it sustains on a left-hand arc through the conflict area. We were to arrive at 33, on green.",
#:   "\"What's he waiting for?\" asked little Ann, who can't see the lights from her seat. For green, I said, as he should. And the silver car heard me and was ashamed of it, for it gave a shriek and sprang out. It went by in front of us, to its left, getting louder. \"Was that green?\" asked Ann. It was not.",
#:   "You get a feel, on nights. There was a Golf stopped at the lights on Union Street, on red, and I was coming along the main on green, and its front kept dipping. He's on the clutch, I thought. Up came the front and out he flew. He hung it left, the way I'd come from, so I got him full across me, tyres going, pedal on the boards.",
#:   "Video's only nine seconds, so use the pause key. Pause one: motorcycle, cross street, both boots on the ground, red light. Pause two: motorcycle, one boot on the ground, front wheel off it, red light. Pause three: motorcycle, leaning left over my half of the junction. The red's in the background. Nobody's lifted any throttle.",
#:   "In a town where nothing moves before ten, the mayor's limousine had been standing by itself at the only signal. It was a long red. There wasn't a soul, unless you count us, and it seems we weren't counted. The great car squatted and flung itself out from under that red, to the left, across our nose, gathering way like a liner.",
#:   "He was waiting, therefore our AV had him in the drawer \"harmless.\" The signal for his arm was red, therefore in the drawer it stayed. I'd like a run in which the drawer springs open: from standstill, on that red, at full power, and around to his left through our lane, so that each metre of the arc is quicker than the last.",
#:   "Madame, I have seen everything, I sell the chestnuts there. The taxi was arrived and stopped at his red fire, correct. You came on the boulevard with your green one. He looks at his watch. He looks at his red. And pfff, he throws the horses, with the wheels which cry, towards his left hand, before you, and in the turn he pushes yet.",
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
