#: description = "The crossing car runs the red light, stops, and backs up again."
#: rephrasings = [
#:   "he shoots over the red, realises it, bangs it in reverse and rolls back",
#:   "Vehicle 2 entered against a red signal, stopped, and backed toward the stop bar.",
#:   "overruns red, halts, reverses out",
#:   "The target passes the stop line on red, comes to a standstill and then moves rearwards.",
#:   "The truck passed the red, then it stops and goes with the back direction again to the line.",
#:   "A lorry noses out against the lights, thinks again, and backs away.",
#:   "Having jumped the signal, the bus pulls up and retreats.",
#:   "The van goes through on red, gets halfway, and withdraws backwards.",
#:   "He jumped the lights, stopped in the middle realising what he'd done, and shoved it in reverse.",
#:   "Unit 2 entered on red, stopped within the intersection and backed toward its point of entry.",
#:   "Thru red, halt mid-jct, reverses.",
#:   "The crossing target passes the red signal, comes to rest in the junction and moves rearward.",
#:   "The truck goes over red, then stands and drives back.",
#:   "Red-light violator with regrets: stops past the line, then backs out again.",
#:   "He was through the red before he saw it; he stopped, shamefaced, and crept backwards whence he'd come.",
#:   "He's gone over on red, he's stopped, and now his reversing lights are on, so let him back out.",
#:   "he ran the red, went oops, stopped n started backing up",
#:   "The driver overran the stop signal, halted in the junction and sheepishly retreated backwards.",
#:   "Past the red signal you went, there you stopped, and then you drove in reverse whence you came?",
#:   "He jumped signal, then stopped inside, then taking reverse back to the line.",
#:   "Through the red, penny drops, stops, and then it's beep beep beep all the way back.",
#:   "Red-signal violation with mid-intersection halt and rearward withdrawal.",
#:   "RUNS RED LIGHT, REGRETS IT, BACKS UP",
#:   "The crossing truck trespassed on red, halted and backpedalled.",
#:   "Van overran the red, came to a halt, and went back again.",
#:   "Cross traffic: through red, pulls up in the junction, retreats astern.",
#:   "Bus busts the signal, stands, then reverses out the way it came.",
#:   "Make a saloon jump the red, halt, and shuffle backwards.",
#:   "He ignored his red light, stopped, and hastily reversed again.",
#:   "By the time I passed, it had backed up to where it started, having entered on red and stopped in the crossing.",
#:   "The lorry from the left was over its line in spite of red, he saw the mistake, remained standing and then drove rearwards back.",
#:   "In phase two the vehicle crossing on red is halted within the junction; in phase three it withdraws in reverse gear.",
#:   "There goes a taxi through the red, now he's pulled up, and here he comes backing out again with a very red face.",
#:   "What is the robotaxi meant to do about a coach that crosses on red, pulls up in mid-junction and then backs off?",
#:   "My nan drove straight past the red light, stopped when everybody hooted, and had to go backwards with all those people watching.",
#:   "I had the green and was rolling up to it. A delivery truck from the cross street had missed his red completely; he came to a stand half over the junction, put up his hand, and backed away to where he belonged.",
#:   "V2 proceeded past a steady red indication into the intersection and came to rest short of V1's lane. Following a brief stop its reverse lamps illuminated and V2 moved rearward a distance of about eighteen feet.",
#:   "The tourist in the hired saloon had been admiring the cathedral. He swam in under a red light, woke to a chorus of horns, brought the car to rest, and with much crunching of gears withdrew the way he had come.",
#:   "Test idea: someone on the cross road doesn't obey the red. He's into the junction, realises, and stops completely; half a second later he begins to move the other way, tail first. Can the AV tell he's clearing the path for it?",
#:   "This bus driver is well known for it. Signal was red from his side, still he came inside, then policeman has whistled, so he stopped the bus there only and slowly he took it behind again.",
#:   "Red ignored, halt in the box, then backwards out of it.",
#:   "Jumps the light, stops dead, and backs off again. Some bus.",
#:   "In on red, standstill, white lamps, retreat to his side.",
#:   "The lorry from the cross street had come out under a red light; it stood, its reversing alarm started up, and it withdrew the way it came.",
#:   "If you enter on red, and you stop, and you then back out again, do you suppose that those of us with the green know what to do?",
#:   "He's coming over by red, the taxi, in the half he is stopping, and then in the reverse gear he's going home behind his line.",
#:   "Let a horsebox violate its signal, come to rest in the intersection, and roll rearward out of it while the subject vehicle has green.",
#:   "A hatchback was backing out of the junction as we got there, having gone into it on red from the side and come to a standstill.",
#:   "Two units reporting: van ran the red on Fifth, stopped in the intersection, now it's in reverse and heading back up Fifth, no contact made.",
#:   "That bonnet in our windscreen grew, stood still and then, of all things, shrank. You must know that it belonged to an estate from the side street, that we'd a green and the estate a red, and that it had come out notwithstanding. I suppose the lady had noticed. She shrank all the way to her stop line.",
#:   "The sound told the story. First our horn, as the coach came in from the left while the lamp on its side was red. Next its brakes, that long wet sneeze, until it was at rest. After that a bleeping, with a voice, \"attention, this vehicle is reversing\", growing fainter as the thing took itself off again.",
#:   "Owning up is a fine quality, I tell my learners, but not in a junction. That fellow there drove in on his red. All right, he's stopped, he has realised. What would be sensible? Anything but that. He's got his arm over the seat and he's backing out, with a motorbike behind him for all he knows. We wait.",
#:   "The signal controller logged phase red for the minor arm from 12:00:00 on. At 12:00:03 a pickup passes the loop, inward. At 12:00:05 its speed is zero. At 12:00:08 the very same loop is passed by the same pickup, outward, tail first. Our shuttle, with green, had by that time stopped and didn't know whether to go.",
#:   "My mate the bus driver had a bad morning. He'd missed that his light was red, he had rolled well in, and every one of us on the main road was hooting. So he stood. You could see him go the colour of the light. Then he found reverse, and the whole twelve metres went back where they'd been.",
#:   "In V1's dashcam recording a box truck enters from the right against a solid red. It comes to a complete halt short of V1's lane. Approximately one second later its backup lights illuminate and the truck moves rearward, re-crossing its stop bar. V1, which had braked hard, was rear-ended by V3.",
#:   "It came out a yard at a time, so far as I could make out from my saddle, and then it went in again like a tongue. I mean the removal van. Red for him, green for us cyclists. Out across our front, stop, a face at the window, and back, cab last this time, into the street it'd poked out of.",
#:   "What the test should reveal is whether the AV takes the stop for the end of the story. A saloon on the cross road drives past its red lamp and halts in the junction; the AV brakes. After half a second the saloon moves, only it's in reverse gear, clearing the way. When do we release the brake?",
#:   "\"Somebody has a guilty conscience,\" said my wife. I hadn't yet understood what I was seeing, that is, a big jeep which got smaller. But she had had her eye on his lamp. It was red when he drove out from the side, it was red as he sat there in the midst of things, and red yet when he crept backwards.",
#:   "At our chowk this is comedy. One tempo has come in when it's red for him. Whistle! He's put brake and stood in the centre, hands folded to the policeman. The policeman is showing with one finger, behind. So he has put reverse and with the helper shouting \"aane do\" he has gone behind only, till his line.",
#:   "daddy that lorry did a naughty. it was red and it came out and then it stopped and everybody beeped and it went beep beep beep too and went back in. can we go now its green",
#:   "On red he was in; on red, backwards, out again.",
#:   "Through the red, full stop, and tail-first home.",
#:   "Box van overshot its red, paused, and withdrew.",
#:   "He had shown us his bonnet, against his red, and let it stand there before us; now he was taking it away again, the way you draw back a hand.",
#:   "Of the saloon's two crossings of the stop line, both under red, the first was forwards, the second backwards, and in between it stood for a breath in the box.",
#:   "I'd like the cross-street lorry to defy its signal, to come to rest once it's well inside, and, after half a second, to roll out again stern first.",
#:   "Bus is coming by red, he stands in the middle with shame, then he's putting in the back gear and goes home where he came from.",
#:   "What I braked for, officer, was a car where there ought not to be one with its light at red; when I'd finished braking it was gone, rearwards.",
#:   "A horn from us, a stop by him, a bleep from his back end: that's how the truck that had ignored the lights was persuaded to give back our junction.",
#:   "You don't often get to see a blush on a lorry. It had come out of the side street as though its light weren't red; it was halfway to our lane before it hung its head and stood. And then the two white lamps, a wag of the trailer, and all of it went back up the side street, bumper last, until just its nose was at the line.",
#:   "We were told that he had withdrawn his car, and I took it for lawyers' talk. It's literal. The gentleman had ventured out on the crossroads, the signal being red on his arm. He'd come to a halt there in order to consider his position. He considered it untenable, engaged the lever, and withdrew, looking over his left shoulder.",
#:   "For its size the minibus made three different noises. A rush, when it came past its red without lifting. A gasp, as it stopped, so close to our way that the door could have let someone in for us. And finally a whine that went off, lower and lower, down the road from which it had come, windscreen toward us to the end.",
#:   "The system ought to wait for the second act. Act one is an offender: past the lamp, which is red, into the box, stationary. Most systems will now work out a path round the front of him. Act two is the offender's repentance, so there is no front to go round any more, it's on its way back behind the line at two metres a second.",
#:   "A whistle did it, I think. The constable on the corner had seen the cab go under the red, and he blew, and the cab stopped as if it had run out of road. The constable pointed. With his finger he pushed it, so to speak, all the way back across the zebra, its boot going first, and our queue applauded.",
#:   "It grew in my side window, it did nothing in my side window, it shrank in my side window. Those are the three stages. The lamp above it stayed the same through all of them, red as my face. I suppose the girl in the jeep hadn't looked up at it until the middle one.",
#:   "My pupil had the green and did the right thing, which was not to take it. That removal van was coming in from the left against his. See? He's out in the middle, he's stood still, he's twigged. What'll he do next? I'd have stayed put. He's a gentleman, he's giving us the room: there go his reversing lights, and away he backs.",
#:   "V2 failed to obey a steady red and came to rest with its front axle at the center of the intersection. A pedestrian struck the hood with an umbrella. V2 remained for an instant, following which it was placed in reverse and traveled rearward some 25 feet to a position behind its stop bar. V1 had by then been struck from the rear.",
#:   "I sell newspapers there, so I know who has red. This one had. He came with his delivery truck, smoking, thinking of his girl. Everyone hooted and he stood, in the place where the trams meet. He looked at us, we looked at him. Then he took himself away with his back in front, very small, very slowly, till he was again under his lamp.",
#:   "Something large and white had put its head out from under the red light, like a cow through a hedge. It saw them. It stopped chewing. For a moment the two parties regarded each other over the empty junction; and then the cow, that is to say the coach, drew in its head, foot by foot, to the sound of a small electric bell.",
#:   "pov ur the robotaxi. green. some guy in a pickup just comes out on red from the side. stops like a deer. u stop. everyone stops. then he does the lil hand wave and backs all the way up to his line. backs! up! into his own queue lol they had to back up too",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "stop", "reverse"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 22.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = -2.5
#: high = 2.5
#: unit = "m"
#: meaning = "how far beyond where their ways meet it comes to rest"
#: [[parameters]]
#: name = "OPT_ADV_BACK"
#: low = 1.5
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it backs up"
#: [[parameters]]
#: name = "OPT_ADV_BACK_TIME"
#: low = 1.5
#: high = 4.0
#: unit = "s"
#: meaning = "for how long it backs up"

param OPT_ADV_DISTANCE = Range(0, 22)
param OPT_ADV_SPEED = Range(5, 9)
param OPT_STOP_DISTANCE = Range(-2.5, 2.5)
param OPT_ADV_BACK = Range(1.5, 3.5)
param OPT_ADV_BACK_TIME = Range(1.5, 4)

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK) for globalParameters.OPT_ADV_BACK_TIME seconds
    do Halt()
