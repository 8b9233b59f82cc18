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
