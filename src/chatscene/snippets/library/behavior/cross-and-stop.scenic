#: description = "The pedestrian suddenly crosses the road and stops in front of the ego."
#: rephrasings = [
#:   "Someone walks out onto the carriageway and comes to a standstill right before the oncoming ego.",
#:   "The pedestrian steps into the lane and halts in the ego's path.",
#:   "A person on foot begins to cross and then freezes in the middle of the lane.",
#:   "The cyclist rides across and stands still in the way of the ego.",
#:   "The adversary moves over the street from the side and stays there, blocking the lane.",
#:   "The motorcyclist crosses abruptly and comes to a halt in the centre of the intersection.",
#:   "Some bloke on foot marches out and then just parks himself in our lane.",
#:   "The non-motorist entered the roadway and came to rest in the lane of Vehicle 1.",
#:   "A woman dashed out and then just planted herself bang in front of me.",
#:   "Pedestrian entered the roadway without warning and came to a standstill in the path of Unit 1.",
#:   "Ped runs out, halts dead ahead, doesn't move.",
#:   "The cyclist target enters the lane from the side without notice and comes to rest in the path of the test vehicle.",
#:   "Man comes fast on the street and then he stands before my car.",
#:   "VRU pops out crosswise then freezes like a deer on our centreline; does not clear.",
#:   "The boy sprang off the pavement and then his feet stuck to the asphalt; he stood there staring at her headlights.",
#:   "Careful, that kid on the moped's come straight out and parked himself across your front.",
#:   "some girl ran out and then just stood there like an npc",
#:   "A man bolted into the street and came to rest squarely before an approaching car.",
#:   "The deceased, I put it to you, entered the carriageway all at once and there remained upright in the defendant's path.",
#:   "The aunty suddenly come out and then never move already, stand there block me.",
#:   "Comes charging off the pavement and then turns into a statue, what am I meant to do, go over him?",
#:   "Sudden pedestrian incursion with subsequent stationary occupation of the lane",
#:   "CYCLIST RIDES OUT AND JUST STOPS IN MY WAY",
#:   "The walker bursts out and roots himself before us.",
#:   "Out of nowhere an old man crosses, then stands still before us.",
#:   "Jogger crosses without warning, halts dead in front of the ego.",
#:   "Scooter crosses our road on a whim and pulls up right there.",
#:   "La dame traverses very sudden and she stops just before my bonnet.",
#:   "Make a pedestrian abruptly cross and come to a stop before the AV.",
#:   "Without so much as a glance a cyclist set off over the road and applied his brakes squarely ahead of us, where he remained.",
#:   "What I saw was a lady with a pram set off over the carriageway from one second to the next and pull up in front of that car.",
#:   "The moped target traverses the lane from the nearside at an unannounced moment and is brought to rest on the VUT's centreline.",
#:   "Kid on a bike shot over from the pavement side, then he just stopped with his wheel pointing at the other kerb and me bearing down on him.",
#:   "Granddad was on the footpath one moment; the next he had started across our street, and halfway, before the taxi's grille, he would not go one step more.",
#:   "She stood motionless in the headlights of the tram-yellow taxi, having a heartbeat earlier quit the pavement to get over the street.",
#:   "I was doing no more than twenty past the chemist's. A woman who had been chatting on the pavement turned on her heel and made to cross, and when she was right in front of my car she stopped, and there she stayed, looking at me.",
#:   "V1 was proceeding straight. A non-motorist moved from the roadside on a perpendicular path without any prior indication, reached the lane of V1 and ceased moving. Witnesses agree that he was standing upright when V1 arrived and had not gone any farther.",
#:   "For the robustness set we need a sudden crosser which doesn't clear. It waits at the side until the ego is near, cuts across at right angles, then velocity zero inside the ego lane and it holds there until the run has ended.",
#:   "You ask what the motorcyclist did. He came over from the left all of a sudden, as if to reach the petrol station opposite, and then he brought his machine to a stop exactly in our way, both feet down, and looked the other way.",
#:   "There was this boy, sir, he was standing near the tea stall only. Suddenly he started crossing, no looking, nothing, and when he came in front of my car he stopped there itself, like somebody switched him off.",
#:   "Sudden cut across the road, then a full stop before us.",
#:   "kid on a scooter just crosses outta nowhere, then parks infront of us",
#:   "Over he goes all at once, and halts squarely ahead.",
#:   "With no warning whatever the rambler set out to get to the far side, and once in front of the oncoming car he stood still.",
#:   "The pedestrian target commences a perpendicular crossing on short notice and is immobilised at the centre of the VUT's track, where it stays.",
#:   "He was looking in the shop window, sir, and next moment he is crossing, and exactly before my rickshaw he has stopped like a pole.",
#:   "Could the cyclist abruptly ride out across our way and then pull up in the middle of it, feet on the ground, until the run ends?",
#:   "Unit 4 here, female on foot has gone straight across the lane without looking and now she's standing in front of a silver cab, not moving.",
#:   "You're fine, you're fine, oh, she's crossing, brake, and now she's stopped in front of us with the pram, so we wait for her.",
#:   "It had been raining and I had the wipers on full. Between one sweep and the next a woman under a red umbrella had left the pavement to get across, and at the sweep after that the umbrella was dead ahead and it didn't get any closer to the other side. I stopped with the bonnet almost under it.",
#:   "Claimant's vehicle was proceeding at 25 mph when a moped emerged from the forecourt at right angles to it, all of a sudden. The moped came to rest in claimant's lane. Its rider remained astride it, facing the opposite kerb, and claimant's vehicle struck the front wheel at low speed.",
#:   "I've asked the boy since why he did it and he says he doesn't know. He had been waiting with his friends at the side, quite sensibly. Then it took him and he was off over the road, and when he'd got to where our car was going to be, all the go went out of him and there he was.",
#:   "The detector had her down as crossing, which was right, as she had launched herself from the kerb at ninety degrees to us a moment before. The predictor had her clear of the lane in 1.4 seconds, which was wrong. She'd no more steps in her; she stood on our centre line until the end of the log.",
#:   "A bag of oranges did for him. He'd hurried out from between the stalls to get to the other side, with no thought for traffic, and when the bag split he pulled up in the road right where our van was heading. He never bent for them, he just stood and looked at me.",
#:   "Picture a chessboard and a piece that leaves its edge square at a run of the hand, straight across, and is set down plumb in your column. That was the jogger. Nobody had expected him to go, and nobody expected him to stay there, jaw hanging, with the bus bearing down on him.",
#:   "V1 was eastbound at 31 mph. A bicyclist departed the north sidewalk abruptly and traversed the westbound lane on a southerly heading. Upon reaching the eastbound lane the bicyclist ceased forward motion, and the bicycle was stationary, upright and broadside to V1 when V1's driver applied the brakes.",
#:   "Je vous explique. I roll tranquilly, there is an old monsieur with his baguette on the border, he regards nothing, he traverses all at once. And in place of finishing, he arrests himself just before my car and there he rests planted, like a tree.",
#:   "I'm eighty-one and I know one oughtn't. I saw my bus across the way and started over without thinking, and then I heard the lorry. My legs wouldn't have it any more, neither on nor back, so I stood where I was, right before that great radiator, and waited for whatever was coming.",
#:   "lol the AI handled this better than me. motorbike guy sitting at the side, zero sign he's going anywhere, then out he comes straight over the lane. and you think he'll clear it so don't brake too hard, except he put the anchors on slap in front of the camera and just chilled there",
#:   "The tyre marks in front of number 14 are mine, all nine metres of them. They end a yard short of the place where a young lady with headphones was standing. She'd only just stepped off, quick as you like, to get to the tram on the other side, and then for some reason got no further.",
#:   "Off the kerb to get over, then planted before our bumper.",
#:   "Scooter darts over our road and dies in front of us.",
#:   "Sudden crosser, and then a crosser no more, dead ahead.",
#:   "With no look round, the postman made for the other pavement and got exactly as far as my number plate, where he stood with his letters.",
#:   "The lane was free, then there was a cyclist crossing it, then there was a cyclist standing across it, facing the far kerb, and I was out of road.",
#:   "could the walker please set off across at short notice and have his velocity set to zero on the ego's centreline, for good",
#:   "We'd have missed her if she had kept going, but the old girl who had so suddenly started over the road chose to stop right before our radiator.",
#:   "Person from left is coming on the road like arrow is shot, for going other side, and in front of my auto itself he became like a statue.",
#:   "DASHCAM: moped pulls straight across w no warning then just sits there side-on infront of me, feet down, both of us staring",
#:   "The ambulance drew up with its bumper touching the man's carrier bag. Nobody had knocked him down; he was merely there, upright, his face towards the chemist's on the far side, to which he'd headed off from the bus stop without a glance at us. It hadn't occurred to him to go the rest of the way.",
#:   "Half a crossing is worse than a whole one. I'd reckoned with the whole one, when this jogger veered off his pavement at a right angle to get over to the park, and I'd have passed behind him nicely. But the feet that had brought him into our lane stayed in our lane, both together, and I had to find somewhere else to put a bus.",
#:   "What the thermal camera gives us is a warm upright blob at the kerb which, at 22 m, sets off sideways through the picture. It arrives at the middle. By rights it ought to leave on the right of the frame; instead it grows and grows in the middle, since it's standing there and we aren't yet.",
#:   "It was the umbrella, officer, I thought it was only an umbrella blowing over. There was a gentleman under it. He'd left the doorway in one go, over he was coming, and by the time I'd understood that there was a gentleman he had pulled up, umbrella and all, plumb in line with my badge.",
#:   "So here's the thing I can't get my head round on this job. You're crossing, you've not looked, fine, we've all done it, so cross! Don't get to the middle of a bin lorry's lane and then hold up your hand like the Pope. That's what he did, and he was still there when I'd climbed down.",
#:   "A traffic island would have been no harder to avoid. It had come into being in under two seconds, when a girl on a bicycle at the edge took it into her head to ride over to the kiosk. In the robotaxi's lane she clamped both brakes; and there were now a front wheel, a frame and a back wheel set across our way.",
#:   "The defence says that the deceased ought to have been seen; seen doing what? At one moment she was at the roadside, waiting like the rest. At the next she was on her way to the other side, unannounced. And at the third, my lord, she was on her way to nowhere, for she had halted in the direct line of the van.",
#:   "I am old and my sentence in English is short. The child stood by the tree. Then the child came over the street, very sudden, I was near. I thought, he goes through. He did not go through; he stood before my car, I could see only the hair, and he did not go away.",
#:   "Test debrief, dummy run 6. Start signal received late, so the traverse from the nearside began when the vehicle was already within 20 m. Cable drive was cut with the dummy on the vehicle's axis. It remained there, and our braking left a margin of eleven centimetres to its hip.",
#:   "Between the hardware shop and the tea house runs the road, and he'd crossed it every day of his life. That day too he went at it quite abruptly, as one goes at cold water. But in the middle, with the grey bonnet coming at him, something he'd forgotten came back to him, and he stood still to remember it.",
#:   "My daughter's bike has a squeak, so I heard the whole thing from the garage. Squeak-squeak-squeak, that's her going over the road without a by-your-leave. Then no squeak, which I didn't like, as she couldn't have been across so soon; then brakes, a car's. She was stood in the road straddling her bike, and there was a bumper this far from her knee.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.4
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 40.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary starts to move"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 1.0
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_SPEED = Range(1.4, 5)
param OPT_ADV_DISTANCE = Range(10, 40)
param OPT_STOP_DISTANCE = Range(0, 1)

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 8)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
