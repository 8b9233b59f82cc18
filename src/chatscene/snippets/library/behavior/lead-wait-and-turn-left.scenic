#: description = "The car ahead stops in the lane, waits and then turns left off the road."
#: rephrasings = [
#:   "The car in front of us stops in the middle to wait and then swings left across the road.",
#:   "Vehicle 2 was stopped in the lane waiting to make a left turn into a drive and then turned.",
#:   "Lead stops, waits, left turn off road.",
#:   "The target stands ahead of the VUT, dwells and then leaves the road to the left.",
#:   "It stays before us to let the others go and then is turning to left in a parking.",
#:   "The truck we follow halts to let somebody by, then lumbers left into a yard.",
#:   "The bus ahead pulls up mid-lane, pauses and heaves itself left off the street.",
#:   "A biker ahead holds up everybody until he can cut left to the café.",
#:   "the car ahead stopped in the lane, hung about waiting for his moment and then peeled off left off the road",
#:   "V2, directly ahead, stopped in the travel lane, waited, and then completed a left turn off the roadway.",
#:   "Truck ahead halts in lane, waits, then L off rd.",
#:   "The lead vehicle stops in lane, remains stationary for a waiting period and then departs the road by a left turn.",
#:   "The bus in front stands some seconds in the lane, and after this it goes left, away from the street.",
#:   "Lead stop with dwell time, then left exit off the carriageway; the SUT has to queue behind it.",
#:   "It had pulled up before them and bided its time, and when it judged the moment right it swung left and was gone from the road.",
#:   "He's holding you up because he's wanting to go left off the road there. Patience... he's waiting... and off he goes.",
#:   "car in front stopped in the road forever then finally turned left",
#:   "Traffic was held up while a lorry stood in the road biding its time before leaving it to the left",
#:   "You remained stationary in the lane for some while and eventually departed to the left?",
#:   "Bus in front stop there wait wait wait, then only go left side",
#:   "He sits there in the middle of the lane having a think, and when he's good and ready off he goes left",
#:   "Standing lead vehicle awaiting left turn off the road; delayed clearance",
#:   "Car ahead waits FOREVER in the lane before turning left",
#:   "The van ahead lingered, then sidled off leftward.",
#:   "Bus in front halts, bides its time, hangs a left off the road.",
#:   "Leader stationary in lane a while, then away left into a driveway.",
#:   "Up front the van's at a stand; by and by it's off the road, leftwards.",
#:   "Have the cab up front stop, hold, and exit left.",
#:   "Biker we follow waits at a standstill before veering left off the road.",
#:   "The tractor unit ahead came to rest in our lane, sat there with its indicator going, and eventually rolled off left into the depot.",
#:   "When the police car in front had stopped and kept all of us waiting some seconds, he left the road to the left hand.",
#:   "V1's lane was occupied by a stopped hatchback, which after a delay of several seconds departed leftward into a shopping-centre entrance.",
#:   "She's pulled up in front, so you stop behind her; she's in no rush, and now she's off the road to the left, carry on.",
#:   "How long must we sit behind this pickup, which has simply halted in the lane, before it makes its blessed left into the farm?",
#:   "With the preceding target at standstill for the defined stop time, a subsequent left turn shall take it off the carriageway.",
#:   "The ambulance ahead of us drew to a stop with its crew peering about for the right house. After a good long look they found it, and the thing rolled away leftward up a gravel path, and we could go on.",
#:   "I had stopped behind the coach because it had stopped too, in the running lane, no explanation. We sat. Then the driver must have seen his opening, as he swung it ponderously left and disappeared into the hotel car park.",
#:   "Scene request: one motorcycle rides in front of the AV and comes to a halt. It stands there for as long as a person needs to make up his mind, after which it goes off left, out of the roadway.",
#:   "Papa, the car in front is not moving! It was just standing there and we were just standing too, and then it went round to the side where the sweet shop is, on the left, and off the street.",
#:   "The learner who led our little procession stalled her courage rather than her engine. She stopped, she considered the gateway at her left for what seemed a whole afternoon, and at last she steered in and set the rest of us free.",
#:   "Front car halts in lane, bides there, then leaves leftwards.",
#:   "Up ahead a moped stood awhile, then ducked left off the road.",
#:   "Stationary for ages in front of us, then off left, gone.",
#:   "Behind the bus we all came to a stand because it had; some time later it lumbered off to the left into the depot yard.",
#:   "In front of the AV, let a delivery van come to rest in the running lane, linger, and at last swing left into a farm gate.",
#:   "When at long last the milk lorry before me had gone off the road on its left hand, I could start again, after half a minute of standing.",
#:   "He has stopped in my nose, he has made a pause like for a cigarette, then he has quitted the road by the left.",
#:   "Why must that ambulance pull up dead before us, do nothing for a good while, and only then roll off leftward into the clinic drive?",
#:   "The lead police motorcycle is to be halted in the lane, held there for the dwell time, and then steered out of the carriageway to the left.",
#:   "I've got the time stamps if you want them. 08:14:02, horsebox in front of us stationary, our lane, brake lights steady. 08:14:11, same picture, somebody's hooting. 08:14:13, its wheels go over to the left and it noses out of the road into the show ground, very slowly, with a pony looking back at us.",
#:   "We spent the best part of the weather forecast looking at the back doors of a florist's van. It had stopped ahead of us, just like that, on the open street. And as the lady on the radio came to Scotland it stirred, put itself to the left, and trundled down a track between two greenhouses.",
#:   "It isn't broken down, and no, you don't go round it. Think! It's stopped in your lane, it's been there a while, its front wheels are pointing left. There's a drive on that side. Now, you see? Over it goes and off the road, and had you been beside it you'd be in its passenger door.",
#:   "My complaint to the coach firm is about the wait. Your number 40 came to a halt directly before my taxi, in the lane, not at any stop. There we both stood. My passenger missed her train by the very amount of time it took your man to make up his mind and steer left, off the street, to the filling station.",
#:   "The fire engine that led the carnival had stopped for a word with somebody, or so it seemed to us, who were next in line. The band played a whole chorus. At the end of it the big red thing gave a shudder and wheeled away to its left, out of the road, to its shed, and our robot car was first.",
#:   "In this clip the planner's patience is tested. Leader decelerates to nought; the lane is blocked; a naive system swings out to pass on the left after three seconds. At five the leader makes a left-hander off the road, which is where the naive system would be by then. Ours stayed behind. Well done, ours.",
#:   "For my driving I have one rule from my father: who stands, he wants something. The rickshaw in front was standing, so I was standing also. One minute nearly. What did he want? He wanted the temple side. He turned his handle to left and went out of the road through the arch, and I said thank you father.",
#:   "The operator of V1 stated that he had come to a stop behind V2, which had itself stopped in the through lane for reasons unknown. After several seconds without movement V2 made a left turn toward a private driveway and exited the roadway, at which time V1, already moving up, clipped its trailing corner.",
#:   "\"Is it dead?\" said the boy, for the big saloon that they had been behind since the toll house hadn't so much as twitched in all the time that he took to peel an orange. It wasn't. It hummed, it leaned, it took itself off the highway by a white gate upon the left, and the road lay open.",
#:   "On two wheels you get in front of things, but behind this motor scooter there was no passing. He'd stopped in the middle of the lane with his arm out left, and there he perched, waiting. I'd put my foot down by then. In the end he zipped across and off the road to the left, down to the allotments.",
#:   "cctv of the garage shows it well: pickup in front of the shuttle stops, in lane, shuttle stops too, both just sit there. people on the shuttle start looking at phones. then pickup goes left right over onto our forecourt & shuttle toddles on. nobody's fault imo",
#:   "Halted ahead of us, dithered, then off leftward into a yard.",
#:   "Bus in front: stood, waited, trundled off the road, left.",
#:   "First a cork in our lane, eventually a left exit.",
#:   "For as long as the cement mixer in front was making up its mind, none of us moved; when it had, it lumbered off the street by its left hand.",
#:   "My tea had gone cold by the time the van ahead, at rest in the middle of everything, found its courage and peeled away leftward down the farm track.",
#:   "Keep the lead ambulance stationary in our lane for a few seconds after it has pulled up, and only then send it leftward off the carriageway.",
#:   "The police rider going before us came to a stand, remained so with one boot down, and in due course disappeared to the left between two gateposts.",
#:   "Where did he go in the end? Left, madam, off the road, to the garden centre; but before that he'd stood ahead of me till the lights behind had changed twice.",
#:   "He stops before my bus, he sits and thinks about his life, and then finally he's steering out from the road on the left side.",
#:   "We were asked how the gate came to be open. It was opened for the lorry we were stuck behind, and that's what it had stopped for, plumb in the lane, with nobody able to pass. A man in a vest walked the bolt back. Only then did it growl, put its cab to the left, and draw its whole length off the road through it.",
#:   "I learnt a lot about that saloon. It had a dent, a dog guard, and a ticket for the regatta. One gets to know the back of a car when it has come to a halt ahead and one sits there with it, engine on, for the time it takes oncoming traffic to go by. Its left flank was the last thing I learnt, as it slipped away up a drive.",
#:   "Ten seconds isn't long, unless you're an impatient planner. At second zero the hearse leading us came to rest in lane. At second four the planner had drawn a path around its left side. At second eight it was about to take it. At second ten the hearse put itself exactly there, for it was going left, off the road, to the crematorium.",
#:   "On the radio they said there was a breakdown by the quarry. I was there, it wasn't one. The coach at the head of us was as healthy as I am: it stopped; it stood, because its driver had never been to the quarry and was reading the boards; and having read them it went off to its left and up the ramp, and that was your breakdown.",
#:   "The indicator went tick for so long that I fell into step with it, drumming. A moped had drawn up in front of my car, in the road, not beside it. Its rider sat with his arms folded. Whatever he wanted to see come or go must have come or gone, for the ticking moved off, across, leftwards, and in at the bowls club.",
#:   "Behind a stopped vehicle one shouldn't honk, one should look where its driver looks. The driver of the pickup that held me up looked to the left the whole time. I saw there a hotel. So I waited, since he waited. When he was ready he steered there, out of the street, and only the taxi behind me had been honking.",
#:   "V1 came to a stop behind V2, which was halted in the only lane and displaying a left signal. V2 did not move for approximately seven seconds. It then turned from the roadway into a filling station on its left side. V1's automation had by this time twice begun, and twice aborted, a passing maneuver to the left.",
#:   "How did it feel, being trapped behind the fire engine? Restful, actually. It simply ceased to go. There wasn't a blue light on, there was a fireman eating a banana. My fellow passenger timed the banana at forty seconds. The skin went into a bag, and the whole thing heaved round to the left off the road, home into its shed.",
#:   "It was hot, and the driver ahead, whom he hated by now, had let his big grey car die of thirst in the road; so at least it seemed. Minutes went by, or one minute. Then, as an ox gets up, the car got up, and went to the left, off the white road, beneath the olives. There was a well there. He hadn't noticed.",
#:   "You're doing the right thing, which is nothing. That tractor-and-trailer outfit, sorry, that truck, has pulled up in your path because he can't get to where he wants yet. Give him his time. Look at the far verge, there's a gap in the hedge on his left. He'll be through it the moment that he fancies his chance. What did I say?",
#:   "van in front just STOPS in the road. im like puncture? 10 sec. hazard? no. 20 sec, guy behind me is leaning on the horn. then it just casually rolls off left into the car wash. bro had all of us queueing for his car wash",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["stop", "hesitate", "turn-left"]
#: place = "road"
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 5.0
#: high = 28.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.2
#: high = 0.6
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 1.0
#: high = 2.5
#: unit = "s"
#: meaning = "how long it stands"

param OPT_ADV_DISTANCE = Range(5, 28)
param OPT_BRAKE = Range(0.2, 0.6)
param OPT_STOP_TIME = Range(1, 2.5)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do TurnOff(1.4, 3)
    do MoveAhead(3) for 4 seconds
    do Halt()
