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
