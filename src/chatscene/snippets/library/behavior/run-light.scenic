#: description = "The crossing vehicle runs the red light at a steady speed."
#: rephrasings = [
#:   "A car ignores the signal and drives straight across.",
#:   "The adversary passes the stop line on red without slowing.",
#:   "Cross traffic disregards the lights and goes through.",
#:   "The other driver fails to stop at the red signal.",
#:   "A motorcyclist sails through on red in front of the ego.",
#:   "he just sails straight through the red",
#:   "Vehicle 2 disregarded the traffic signal and proceeded through the intersection.",
#:   "The car didn't respect the red light and passed.",
#:   "some bloke sailed through a red in front of me, didn't even slow, didn't speed up either",
#:   "V2 entered the intersection against a red signal at a constant speed.",
#:   "Truck from side: thru red, steady v.",
#:   "The crossing target disregards the red signal and passes the junction at constant speed.",
#:   "The bus has red light but he drives over, same speed as before.",
#:   "Signal violator: NPC ignores its red, constant velocity profile, straight over.",
#:   "The light stood red against him, and the cyclist pedalled by beneath it as calmly as you please.",
#:   "He's shot the lights, that van. Never touched his brakes, never touched his throttle, just carried on as if it was green.",
#:   "he just went thru the red like it was optional, didnt even slow down or speed up",
#:   "A coach ignored the stop signal and crossed at an unvarying pace, CCTV showed",
#:   "The signal stood against you, and yet you neither slowed nor quickened but went over?",
#:   "Red light also he is coming same speed only, no fear of police",
#:   "Colour blind, this fella, over he goes on red, cool as you like",
#:   "Signal violation by crossing traffic at constant speed",
#:   "Cyclist rolls right through a RED like it's nothing",
#:   "The truck waltzed over on red.",
#:   "Cross traffic: estate ignores its red, no change of pace.",
#:   "Red for him, yet over he rides, neither quicker nor slower.",
#:   "The bus drives by red through, always the same velocity.",
#:   "Let a crossing scooter pass on red, speed constant throughout.",
#:   "Stop light showing, lorry from the side rolls on over regardless.",
#:   "A taxi coming from the side street took no notice of the red lamp facing it and went over the junction at the very speed it had come with.",
#:   "Although their signal had been at stop for several seconds, the people in the minivan crossed in front of the robotaxi as evenly as a train.",
#:   "I want the cyclist from the cross street to ride over in spite of a red light, with no burst of speed and no braking.",
#:   "According to the red-light camera the motorcycle was doing 31 when it passed the stop line against the signal and 31 when it left the junction.",
#:   "You've got green, they've got red, and still you look, because here comes a coach from the left that isn't stopping, just trundling across as if alone.",
#:   "The crossing target vehicle maintains its initial velocity past a signal showing red and through the conflict area, without any longitudinal reaction.",
#:   "We had the green and I had just said how well the lights were set on this road. From the right came a woman on a bicycle. Her light was red, I could see it from where I sat, and she went on turning the pedals, click, click, across and away.",
#:   "It is the claimant's case that the signal controlling the defendant's approach was red. The defendant's van neither stopped at the line nor altered its speed in either direction; it simply proceeded over the crossroads, at about twenty-five miles an hour, into the claimant's path.",
#:   "Four of us in the car and we all saw it. Big tipper from the side road, light's as red as a tomato, and he doesn't even look as though he's thinking about it. No racing, no slowing, he just drives over, steady as you like.",
#:   "Down the avenue the lights had changed; the cross street's turned red. A motorcyclist came along it who seemed to be listening to music no one else heard, and at the same easy pace he passed beneath the lamp, over the crossing, and out of their lives.",
#:   "Bug: AEB late on red-light runner. Actor comes from the crossing arm, its own lamp is red, it is to disregard that. Keep it at the set speed from spawn to despawn, we've other tickets for the ones that brake, turn or speed up.",
#:   "Their signal's red; that coach rolls through, speed unchanged.",
#:   "Crossing cyclist ignores red, same tempo before, during, after.",
#:   "Red means nothing to the van from the side: over, constant pace.",
#:   "The minibus from the cross street went over the junction against its light, and its speed never changed by as much as a mile an hour.",
#:   "Guy on a Harley comes from the side with a solid red and just cruises through at 30, not slowing, not gunning it, nothing",
#:   "With its signal at red the intersecting target continues along its path at the set speed through the entire junction.",
#:   "You see his light's against him, and you see he isn't lifting or hurrying either; that lorry's coming straight over, so let him.",
#:   "His signal was red, mine green, and the tempo fellow from left side crossed in same speed as on the highway, no brake, no race.",
#:   "I'd like a motorcycle from the cross road that takes no heed of a red lamp and passes over at an even speed from start to finish.",
#:   "The tram man and I saw it both. Our lamp was green, theirs wasn't, and the hatchback that had theirs to obey was humming along the side street at what I'd call a fair speed. We waited for the hum to drop, and it didn't drop; it didn't rise either; it went by under our noses on the one note.",
#:   "There's a graph in exhibit 9. The horizontal line is the velocity of the defendant's lorry on the intersecting road, the vertical one is the moment at which it passed a stop line with the signal at red. You will notice, ladies and gentlemen, that the horizontal line isn't bent at all.",
#:   "I've no idea what the cyclist was thinking of, perhaps of supper. She arrived from our right, her light had been at stop since before I'd put my foot to the floor, and she came across between the kerbs like a clockwork duck. I had to stand on my brakes; the duck didn't so much as turn its head.",
#:   "Q: And what signal did the coach have? A: Red, I was sitting under it with my newspaper. Q: Did you hear it brake, or rev? A: Neither, it passed over that crossing from the side street as if it had been the open road, at whatever it had been doing up to then.",
#:   "V2 approached on the intersecting roadway, for which the signal had displayed red for 5.3 seconds. No deceleration prior to the stop bar and no subsequent acceleration were recorded. V2 crossed the intersection at 34 mph and continued out of view; V1 took evasive action.",
#:   "What woke me was the jolt of our own brakes. I sat up in the back, and there was a motorcyclist passing in front of us at a right angle, upright, unflustered, no faster than any commuter. Behind him, getting smaller, hung the red light that he'd come by, and his back went off down the far arm at the same rate.",
#:   "Twenty-six tonnes and he's got red, you'd hope he'd be on the anchors. I listened for them. From where I was waiting at the crossroads you could only hear tyres, swish, same swish as he'd made all down the side road, over the line and out the other side, and a little Fiat on green had to stop for him.",
#:   "The traffic light of the side has red colour, this I can swear. The taxi comes out from there and he holds his fifty, exactly his fifty, over the line, over the crossing, over everything. Not one time I have seen his brake lamp, and the motor was not louder.",
#:   "People imagine red-light runners as racers. Most are like the one our fleet met on Monday, a saloon in the crossing street whose driver never noticed the lamp and therefore changed nothing, no pedal up, no pedal down. It glided through the intersection, against red, at the forty-eight it had been keeping since the last bend.",
#:   "I was eight so I knew my colours. Red was on for the street that goes sideways, and on that street was a bus with a picture of cheese. It didn't stop for the red and it didn't go whoosh, it went on driving in its normal driving way, over the crossing, and our car had to stop for the cheese.",
#:   "He crossed them as the moon crosses a window. The light which governed the side street burned red, she saw it burning on his wet helmet, and he neither bent to hurry nor reached for his brake, but was carried by, on his quiet motorcycle, at the pace he had brought with him, and taken out of sight by the wall.",
#:   "Their lamp's red; the crossing van simply carries on carrying on.",
#:   "Cyclist over on red, unhurried, unslowed, like clockwork.",
#:   "Red, and yet not one mile an hour more or less.",
#:   "The stop line and the red above it made as much impression on the coach in the cross street as last year's snow; it held its thirty and went over.",
#:   "Crossing actor: trigger when its own signal shows red; constant set speed from trigger to despawn; path straight over; no reaction whatever to the lamp.",
#:   "green for me. red for him, like PROPER red. this dude on a moped keeps the same 25 he had all along and rides thru like its a parade",
#:   "Red was on his side, I am telling you on oath, and that bullock of a lorry crossed with the same same speed, no brake lamp, no extra smoke.",
#:   "We'd a green and had to stop on it, because the saloon in the side street kept up its even pace past its red and on across our bows.",
#:   "Was the motorcyclist early, late, hurried, startled? None of these; he had a red light and he proceeded over the junction as though he'd had no light at all.",
#:   "I set my watch by the bin lorry, it comes along the cross street at a jog and it has stopped for the red at our corner since before I retired. On Tuesday it jogged up to the red, it jogged under the red, it jogged out by the other side, and a lady on her green had to stand her Fiat on its nose.",
#:   "There's no drama in the footage until you look at the lamp. A scooter enters from the right at a reasonable speed, passes through the middle of the picture at that speed and departs at that speed. And all the while, over the rider's half of the crossroads, hangs a red light; it's been lit for six seconds, and what brakes is our robotaxi.",
#:   "My patient says that she doesn't recall a noise, and this is consistent. A bus that brakes for its signal makes one, and so does a bus that hurries to beat it. This one was governed by a red in the intersecting street and did neither. It came on over the junction with its needle where it'd been, and my patient, who'd a green, met the dashboard.",
#:   "Suppose that the signal for the side street had been out of order, and green; nothing in what the van did would need explaining. It rolled up to the line at forty, it was doing forty on the line and forty in the box. The signal was in order, however, and it was red, and so we've had to explain to a passenger why her laptop flew.",
#:   "Every day I hear people say they \"shot\" a light. I sell flowers at this crossroads and few shoot. That girl on the bicycle, with her own lamp as red as my carnations, she didn't shoot, she didn't dither. She rolled out from the side at just the pace she'd had by the bank, and over, and a taxi with every right on its side burned off half its tyres.",
#:   "The light had gone against him a good long while ago. I was waiting next to him in that side street on my bike. I heard the estate coming up from behind at a steady hum and I thought, now the hum will drop. It hummed past my elbow, over the line, between the cars that had green, and on down the hill, all on one note.",
#:   "There's no trick to it, I told him afterwards. You've a green, there's a pickup on the crossing road who's got a red, and what's his speed doing? Not going down, so he isn't stopping; not going up, so he isn't racing. He's coming through it exactly as he is, in a dead straight line, and you're going to let him have it.",
#:   "Telemetry of unit 2, for the record: 11.2 m/s at forty metres ahead of its stop line, 11.2 on the line, 11.1 in mid-junction, 11.2 at the far side. Signal phase for unit 2 at all those times: red. Driver of unit 2, when interviewed: \"What signal?\" Driver of unit 1, which had green and is now a good deal shorter: no comment.",
#:   "I want tell about respect. In my city the red lamp has no friends. A taxi is coming from cross street, his lamp is red, he sees it, he has eyes; his foot doesn't become lighter and doesn't become heavier. So he passes the crossing in front of us, with the arm out of the window, as if somebody pulls him by a rope, and we smell our brake.",
#:   "I was driving and Dad was supervising. \"She's got red,\" he said of a hatchback over in the cross street, \"she'll stop.\" She was bowling along as one does between lights. \"She'll stop,\" said Dad. She bowled up to it and by it and over, under our very bumper, neither the faster nor the slower for us, and Dad put his hat on.",
#:   "What is a colour to a man who's asleep with his eyes open? The lorry kept the pace at which the plain had rocked him; the cross street ran into theirs, and over it burned the red that should have woken him. It did not. The great wheels turned no more slowly upon the line, no faster in the crossing; it went through before their faces like an old thought.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: actions = ["run-light"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 13.0
#: unit = "m/s"
#: meaning = "how fast it crosses"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(6, 13)

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
