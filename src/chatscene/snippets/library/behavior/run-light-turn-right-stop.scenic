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
#:   "Jumped his red rightward into our lane, then dropped anchor.",
#:   "Bus disobeys red, comes about right, rests in front of us.",
#:   "Scooter off the side street: red ignored, right-hander, standstill, our lane.",
#:   "The people carrier from the cross street skipped its red, tucked itself round to the right ahead of us and called it a day there.",
#:   "Target violates the red phase with a right turn, lines up in the ego lane, travels a few metres and is braked to a stationary end state.",
#:   "If you must nip round to the right on a red and into my lane, why, oh why, do you then pull up in it?",
#:   "The auto was having red, still he took right side turning into my lane, after ten metres he put brake and became parking there.",
#:   "Give me a lorry that won't wait at its red, rounds the bend to the right into the AV's lane and then halts for good.",
#:   "Having taken the right-hand corner from the side road in defiance of a red lamp, the cabman brought his vehicle to rest before ours.",
#:   "On the tape there is no one in our lane at 10:15:02. At 10:15:05 there is a yellow van in it, still with a bit of right lock on, come from the side street whose light is plainly red. At 10:15:08 its brake lights are burning and it is as still as a house.",
#:   "Look what's come to live in our lane. He was in the side road, he'd a red over his head, and it didn't bother him in the least: round the corner to the right and in front of us. And you'd think he'd get on with it, having been so keen. No, he's stopped dead.",
#:   "According to the independent witness the third party's motorcycle failed to remain at the signal, which was at red. It turned to its right into the lane along which the insured was travelling, straightened up, and proceeded for a very short distance only. It was then stopped by its rider, who proceeded to adjust his helmet.",
#:   "Green, I had, as green as a frog. From the crossing street a truck slid round its right-hand corner and made himself the first in my lane, though for him it was red. Good, I think, then drive at least! He does not drive. After two lengths he has braked and stood and looked for the house number.",
#:   "We stood behind it for five minutes, an empty school bus, and my sister wanted to know where it had come from. From round the corner, I said, with its light red. It had slipped in to the right, ahead of our car, gone a little way up our lane and then put its brakes on for ever.",
#:   "For the rule-breaking set: cross street, signal red. The crossing coupe doesn't honour it but turns right, so that it's now ahead of the robotaxi in the robotaxi's lane. For about two seconds it runs along as if to leave. It then brakes moderately down to zero and remains an obstacle.",
#:   "Cyclist's eye view. I'm at the front on green, and I see a Transit's bonnet come poking round from my right at the cross street, where it's on red. It swings to its right, into my lane, the one I'm in. Then its back doors come up to me at alarming speed because it has pulled up.",
#:   "The constable noted a queue on the northern arm, headed by a coach which had no business to be there. It had been seen to round the corner on a red signal, turning right out of Dock Street. Once in the northbound lane it had gone no farther than the newsagent's, and there it stood.",
#:   "He came out of the side street as a cat comes out of a larder. The lamp above him was red; he turned to the right beneath it with an air of having been sent for, and settled the long saloon in the lane before them. There the long saloon sank on its springs and was still.",
#:   "All traffic, obstruction just past the lights on Queen's Avenue. A taxi's turned right out of the cross street on a red into the avenue's nearside lane, in front of my caller, and has come to a stop in that lane a few yards along. He's let nobody out and he isn't shifting.",
#:   "I hit my shin on the fare box, that's what came of it. Our driver had to stamp because a small red car had popped out from the right on its red light. It bent round rightward to be in front of us, and no sooner was it in front than it braked and wouldn't go.",
#:   "Right round the corner on red, into our lane, finished.",
#:   "Crossing cab: red, right-hander, our lane, brakes, nothing further",
#:   "Somebody's minibus turned right on red and died in my lane",
#:   "The coach that heads our queue came to do so by slipping to the right out of Dock Street on red and then halting in our lane.",
#:   "My green was worth nothing, as a lorry had bent rightward into my lane on its red, gone twenty yards and pulled up for good.",
#:   "We got its left flank, its tail, its stop lamps, and then simply its parked back end, all while its own signal had been red.",
#:   "The van has red from the cross street, goes nevertheless right about the corner to my lane, drives little bit, and plants himself.",
#:   "Kindly note that the motorbike at right angles to us took his right turn upon the red, came before our bonnet and put down the stand there.",
#:   "Let the crossing bus treat its red as a right-turn arrow, take over the ego's lane, and within two seconds make it impassable by braking to rest.",
#:   "There's nobody in the lane before you at the lights, that's what being first means. I was first, on a green. Then I was second, since the side street's light was red and a fish van didn't care and came round to the right. It led me for about as long as it takes to say so, then it led me nowhere.",
#:   "What do you do when a door opens in a car that's been in your lane for three seconds? I didn't know either. It'd come from the street on the right, with a red to look at, curled rightward in front of us, and driven a few metres up our way before it was pulled up. The door was for a lady with a cello.",
#:   "On the approach to the junction the following was seen. Cross-street aspect red. A crossing truck, that should've been waiting at it, swings through a quarter circle to its right and is in the subject lane, ahead. Its brake lamps come on two seconds after and they don't go off. Subject vehicle at rest behind, distance 2.4 m.",
#:   "I keep a tin for fines from the children, and I had to put in a pound. It was the tail of a campervan that made me say it. There'd been no tail there. It had come round in front of us to its right, with its light as red as jam, and we'd all got used to the idea of following it, and it stopped.",
#:   "That corner's got a baker's on it, and I'd bet you my licence that the baker's is the reason. Watch the taxi there, on the right, he's got a red. See him not care? He's come round it to the right, he's in your lane, he's running on a few yards. And there's the reason, with its lights on, and he's stopped dead.",
#:   "Loose chippings flew off the inside of the bend, which is how you could tell he had taken it fast, the motorcyclist. Red light or no he'd come round to his right into our lane. The chippings were still rolling as he rolled to a stand. He sat with both his feet on the road and looked at his map, we behind him.",
#:   "The lamp that hung above the side street was red, but a hearse has no fear of lamps. It rounded the corner rightward, with all its flowers nodding, and became the head of our procession. We'd followed it for no more than a dozen paces when the flowers nodded the other way, and it had halted, and with it everyone.",
#:   "By the photographs, the bus stands in the northbound lane, eighteen metres past the crossing, doors shut. By the schedule it should've stood in Mill Road at a red light. The driver conceded that he'd gone round to the right regardless, found he was on the wrong route once in the lane, and stopped it there to telephone.",
#:   "First I lost the zebra, then the far traffic light, then the sky. It was a furniture wagon from my right, and it was coming round by the right into the lane I was about to use, and I know his signal was red since mine had been green for ages. Next I'd two brake lights as big as plates, and they stayed on.",
#:   "Well the AV was going straight on, on a green, as good as gold. I'm on the pavement. This scooter's waiting, no, not waiting at all, on the cross road; it's red for him but he hangs a right round the post, plop, into the lane in front of the AV. I think he's off home. He goes three car lengths and stops.",
#:   "Scenario 7c of the light-violation family. The violator is on the crossing road; its signal is red. It makes for the ego's lane by a turn to the right and runs in it as though about to depart. Departure does not take place: after OPT seconds it decelerates moderately until stationary. It neither reverses nor moves on thereafter.",
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

advTurn = ("straight", "right-turn")

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 6
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_STOP_TIME seconds
    do BrakeOnPath(egoRoute, 0.6)
