#: description = "The crossing car runs the red light and turns left at walking pace."
#: rephrasings = [
#:   "he's got red but he just crawls round to the left in front of us",
#:   "Vehicle 2 made a slow left turn against a red signal.",
#:   "left on red, crawling",
#:   "The target turns left on red at a speed below 14 km/h.",
#:   "A bike turns slowly to the left also when the traffic light shows red.",
#:   "A scooter trundles left through the red, unhurried.",
#:   "Against the lights a car eases itself round to its left, holding everybody up.",
#:   "The cyclist ignores the signal and bends left at a snail's pace.",
#:   "He went through on red and then sort of oozed round to the left at a snail's pace.",
#:   "Cross vehicle disregarded the signal and made a left turn at a very low rate of speed.",
#:   "Bike over red, L turn, crawling.",
#:   "The crossing vehicle passes the red signal and performs its left turn at approximately 5 km/h.",
#:   "The motorbike ignores red and turns left very very slow.",
#:   "Red runner turning left at creep speed, long occupancy of our path.",
#:   "The light was against the cyclist, but he crept out anyway and made his leisurely way round to the left.",
#:   "He's come out on a red, he's going left, and you'd think he had all the time in the world.",
#:   "went thru the red and turned left at like snail mode",
#:   "A motorist ignored the red signal and eased round to the left at little more than walking speed.",
#:   "You disregarded the red, and then turned left with such tardiness that no one could get by.",
#:   "Red light also he is not stopping, and turning left slow slow like morning walk.",
#:   "Jumps the red, right, so you'd think he's in a rush, but no, he crawls round to the left like a milk float.",
#:   "Red-signal violation with slow left turn of crossing vehicle and long exposure in conflict area",
#:   "RUNS THE RED... IN SLOW MOTION (left turn)",
#:   "The crossing cyclist slights the red and meanders left.",
#:   "Red for the scooter; it dribbles round to its left regardless.",
#:   "Simulate a cross-street car disregarding its red and easing left at footpace.",
#:   "Bike from the side, light's red, goes left anyhow, slow as syrup.",
#:   "El semáforo is red for him, but he turns left, tranquilo, like walking.",
#:   "he didn't stop for red and went left slower than my gran",
#:   "Unperturbed by a light that was plainly against him, the gentleman in the hatchback coming from the side went leftward through the junction at the gait of a stroller.",
#:   "The crossing target fails to stop at its red aspect and executes a left turn in the path of the VUT, speed during the turn ≤ 6 km/h.",
#:   "With our green just lit, a motorcyclist sidled past his red from the cross street and swung left with his boots practically brushing the ground all the way.",
#:   "Look, his lights are red and he's still coming, and now he's bearing left in front of us at such a dawdle that we'll have to wait.",
#:   "V2 entered from the cross street on a red indication; its subsequent turn to the left was so slow that V1 had to brake and remain waiting.",
#:   "It had almost completed its turn to the left, this little saloon that had a red light and no business moving, at the speed you'd push a trolley.",
#:   "I was in my lorry, on green, third in the queue, and nobody was going anywhere. Turned out a lady on a bicycle had come out of the side road on red, and was describing the widest, gentlest left turn you ever saw, bell tinkling, basket full of leeks, no quicker than if she'd been wheeling it.",
#:   "The insured's light had changed to green. A saloon then came from the intersecting road in defiance of its own red signal and began turning to its left, and it accomplished this so sluggishly, hardly above the pace of somebody out for a walk, that the insured was forced to make an emergency stop.",
#:   "For the violation suite: cross traffic has red, yet one car goes anyway. It isn't a fast offender; it turns to its left through our path at roughly the speed of a person on foot and stays that slow to the end of the turn. The ego has green and must not assume it'll clear in time.",
#:   "My tuk-tuk passenger was laughing. The light for that side was fully red, sir, and one scooter man came out as if red is only for decoration. He was taking left, so slowly, so slowly, in front of all of us, like he is searching for a dropped coin on the road.",
#:   "Caption this, lads. Guy in a beige estate, his light's been red for ages, rolls out from the side road anyway and starts hooking a left. Ten seconds later he is still hooking that left, at zimmer-frame pace, and the robotaxi in front of me is waiting like a saint.",
#:   "Moped on red, hooking left ahead of everybody, at a grandmother's shuffle.",
#:   "Saloon from the side: red ignored, left taken, speed of treacle.",
#:   "red light lady turning left in front of me slower than continental drift",
#:   "Let a bicycle from the side street treat its red as a suggestion and wheel round leftward before us in no more of a rush than a falling leaf.",
#:   "The biker's light had been red for a good while when he came trickling over the line and bent off to his left, boots trailing, before my bonnet.",
#:   "A hatchback out of the cross street, whose signal displayed red at the time, described its left-hand arc ahead of V1 at approximately three miles an hour.",
#:   "Why did we sit through half of our green? Because some dreamer from the side road, on red, was taking his left as slowly as paint dries.",
#:   "The test target enters against red and yaws to the left through the VUT's path, being driven throughout on tick-over alone, without use of the accelerator.",
#:   "He has red, this man on the bicycle, and yet he arrives from the side and makes his left with us all watching, slowly like a bishop.",
#:   "One tries not to judge, but the lights in this town are perfectly clear. They were green for our bus. They were, and I checked, red for the little grey car at our left. It rolled out regardless, indicator clicking, and was steered round to its own left in front of us so sleepily that our driver had time to pour his coffee.",
#:   "The photograph proves the red; the sequence of eleven photographs proves the speed. It usually takes three to see an offender out of the junction. In this instance the motor scooter, which came from Quay Street, is still not through its left turn in the eleventh, and in the ninth one can see a man on foot drawing level with it.",
#:   "My instructor's foot was quicker than mine. We had green, we were rolling. \"Side road,\" he said, \"she's on red and she's coming anyway.\" And round she came, to her left, this woman in an enormous car, so gradually that I could see her lips move as she sang. He said never to trust a green until you've looked.",
#:   "What sort of outlaw signals? I was behind the robotaxi on my bicycle, waiting for our green, and we got it. The outlaw had red. He was on a motorbike, he came out from the crossing street with his left winker on, and he toddled round in that direction right before us, both feet hovering, no faster than a procession.",
#:   "Defect 5127, false clearance. Cross traffic is on red, but one vehicle passes the line, and from its heading it's going left. Planner computes 2.4 s until our path is free, on the basis of an average turn. The vehicle in fact goes round at pedestrian speed and our path isn't free until 9 s have gone.",
#:   "I am from Chengdu and I know many kinds of red light. There is red that people don't see, and red that people are too fast for. This uncle on bicycle, coming out of the side, saw it and was not fast. He turned to left in front of our car with so much calm, I think he was the slowest law-breaker in whole city.",
#:   "My meter was running, so he cost somebody money. The signal for his street was red as a beetroot. Out comes a Nissan all the same, and it bears off to its left through the space I'd been given a green for, and I swear I had time to tell the fare about my knee, the operation and the nurse before it had got itself straight.",
#:   "Considering that it was against the light, you'd expect a little shame. Not from the old fellow in the Morris. He emerged from Abbey Street while his lamp glowed red upon his roof, he leaned into a left, and he pursued that left past a lorry, a coach and our own car, each of us on green, with the serenity of a rowing boat.",
#:   "Dispatch here, hold the ladder at the crossroads a moment. There's a scooter out in the junction in front of you. He's come off Elm on a red, I've got him on the camera, and he's taking a left at about the speed you'd walk a dog. Wait for him, he's got no idea you're there, and he's going to be a while.",
#:   "The inquiry heard that no one had been speeding. Indeed the car from the intersecting road was timed at six km/h, and at six km/h it completed its turn to the left, in the path of the tram replacement bus. What it had not been entitled to do was to begin, because its own lights were then, and for some time had been, red.",
#:   "Brakes, elbows, swearing, the usual. I'd a green and a full peloton on my wheel. From the right, where it was red, a girl on a Dutch bike had come floating out, and she was now going left through the lot of us, upright, phone in her hand, at the pace of a carousel. We came apart round her like water.",
#:   "Side street, red, taxi dribbles round to its left regardless.",
#:   "pushbike on the cross road ignored red n did the slowest left ever",
#:   "Saloon, crossing arm, red against him, going left at a crawl. Over.",
#:   "Our green was half used up by a motorbike whose rider, with red over his head in the side road, paddled himself round the corner to his left with both feet.",
#:   "What I object to isn't only that she came out from the side on red, but that she then took her left-hand turn as if she were pushing a pram.",
#:   "Two things were wrong with the hatchback in the junction: its lamp, on the cross street, was red, and its left turn was being performed at the speed of moss.",
#:   "Crossing target enters against a red signal and executes a left turn; speed from stop line to completion of the turn not above 1.5 m/s, no standstill, no acceleration.",
#:   "He's got a red, that fellow on the tricycle to our side, and he's turning left in spite of it, so slowly that you may as well pull on the handbrake.",
#:   "Please give the car at the side a driver who neither minds the red nor owns a second gear: over the line, leftward, round, in one long roll at shoe-leather pace.",
#:   "When the light lets me go I go, as a rule. It let me go. But a grey Rover, which the light over its own street hadn't let go, was in the way. It was in the way with its nose, then with its door, then with its boot, in that order and without hurry, going round to its left. I could have polished it in passing.",
#:   "The signal controller is beyond suspicion: arm B, from which the bicycle came, had been at red for eleven seconds. It's on the loop at B when the shuttle on arm A gets its green. It's half round its left turn when the shuttle is on top of it, braking. It has completed its left turn another seven seconds later. It had at no time exceeded six kilometres an hour.",
#:   "There's an old man in our street who says that red is for people in a hurry, and he has never been in a hurry. He comes down the side road in his Ambassador. We have green. He comes over his line as one comes into temple, and bends to the left, little, little, before my bus and forty others. When he's completed his bending, we have red.",
#:   "I'd not have minded a racer. A racer on red is out and round and gone, and you swear. This was a woman on a sit-up-and-beg, from the left-hand street, red as you like. She put her arm out for the left. She pedalled, oh, let's say once every house number. I had her hat in front of my radiator, all the way round, for the whole of my green.",
#:   "Which signal did your scooter have? Red, sir. You were on the street that crosses? Yes, sir. And you turned? Left, sir. My learned friend suggests you \"shot out\". I couldn't, sir, on account of the aquarium. I had it between my knees. I went over the line and I bore round at about the pace that I could have carried it. The fish are well, sir.",
#:   "Frame by frame there's nearly no difference, so we skip in tens. Ten: a motorbike from the right-hand arm is over its line, and the lamp above it's red. Twenty: its front wheel points to its left. Thirty, forty, fifty: it's coming round, and the pigeons by its wheels don't get up. Sixty: it has come round. Ours is the bonnet that has been rocking on its brakes since twenty-two.",
#:   "As the subject vehicle entered on green its front camera showed a long low limousine, athwart, at a bearing that altered by only a few degrees a second. The limousine belonged to the cross road. The cross road had red. Its wheels were on left lock and it remained in gentle motion, so that the subject vehicle watched it change by slow degrees from a flank to a pair of tail lights.",
#:   "There's jumping the lights and there's what Mr Pym did. You can't call it jumping. He leaked through them. They were red at his end, at the side, he'd his glasses on his forehead; and the little car seeped out past the post, and round to the left, and I'd the post van on its nose, and the parcels round my ears, before he was even looking the right way.",
#:   "When I tell it in Lyon they don't believe. The cyclist comes from the transverse street, his fire is red, he looks at it, he looks at me, he shrugs. He makes his turn on the left. With us one makes this quickly, one is ashamed. He makes it as a bishop makes the blessing. My tyres wept on the pavement; he wasn't at half yet.",
#:   "The map says they're four seconds clear of us, so we've no conflict; the map has assumed he'd stop on red, and that if he didn't he'd at least get on with it. He did neither. Look at the side camera: pickup, red aspect, rolling over the line. Look at the front one: same pickup, wheels round to its left, still rolling, same as before, like something on a slipway.",
#:   "Silent movie for you. Left of picture, cross street, a red light. Under it a Mini. The Mini oughtn't to move and it moves. You can go and make your tea. You come back and it's in the middle, half turned to its left, moving. Now it's got its back to you, it's in the other road, and at the bottom you see my wipers, which I'd hit in panic.",
#: ]
#: adversaries = ["car", "motorcycle", "bicycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "turn-left", "slow"]
#: control = "signal"
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 15.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.3
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it turns"

param OPT_ADV_DISTANCE = Range(0, 15)
param OPT_SLOW_SPEED = Range(2.3, 3.5)

advTurn = "left-turn"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED)
