#: description = "The car cuts across in front of the ego at the last moment and leaves the road to the right."
#: rephrasings = [
#:   "He remembers his exit too late and slices right across us to make it.",
#:   "Vehicle 2 crossed the lane of vehicle 1 from left to right in order to leave the roadway.",
#:   "Late exit: crosses our lane and off to the right.",
#:   "The target cuts through the path of the VUT and turns out of the carriageway on the right-hand side.",
#:   "He wanted to go out right but he is too left, so he crosses us quickly.",
#:   "A van shoots over our bow into the petrol station.",
#:   "The bus nearly misses its turning and carves across our lane for it.",
#:   "A motorcyclist dives from the fast lane over ours and off the road.",
#:   "Silly sod in the next lane left it till the last second for his turning and dived across my nose to get off on the right.",
#:   "Unit 2 made an abrupt right exit from the left lane, crossing directly ahead of Unit 1.",
#:   "Truck alongside misses turn-off nearly, slices over ego's bow, off to R.",
#:   "The adjacent target crosses the VUT's path at minimal TTC in order to take the right-hand exit.",
#:   "He was in other lane, very late he sees his exit and passes before my nose to go out right.",
#:   "Neighbour-lane actor takes a last-moment right exit through our lane, doesn't stay in it; short TTC, then clears.",
#:   "He had nearly missed the slip road, and so he swept over right under her bonnet and disappeared down it.",
#:   "Watch the van next to you, he's just spotted his exit on the right and he's going to chop straight across us to make it.",
#:   "omg she nearly missed her exit n just yeeted across me to the right",
#:   "A van driver who almost overshot his turn-off sliced past the nose of a family car to make the ramp on the right.",
#:   "You realised you were about to miss your exit to the right, and you drove across the front of the plaintiff to reach it, correct?",
#:   "Aiyo, last minute then he want to exit right, cut my front and go off like that.",
#:   "Remembers his turning at the death, don't he, and comes straight over my front wheels for the right-hand slip.",
#:   "Eleventh-hour departure to the right across ego's front by vehicle from adjacent lane.",
#:   "TRUCK ALMOST MISSES EXIT, CROSSES MY NOSE TO MAKE IT",
#:   "The car alongside lunged for the right-hand exit under our nose.",
#:   "HGV on my left whips across my bonnet for the right-hand off-ramp",
#:   "Simulate a neighbour who sweeps through our lane into a right-hand side road.",
#:   "Fire engine, lane 2, crosses ahead of us late, gone right.",
#:   "Mummy, that lorry zoomed past our front to go down the little road on the right!",
#:   "Right-hand exit nearly overshot, bike carves over in front of Vehicle 1.",
#:   "The tipper was keeping level with me in the outside lane; then, with the turning all but gone, it barged over ahead of me and vanished down it to the right.",
#:   "Because the cab driver woke up to his junction far too late, he had to traverse the ego's lane inches from its bumper before peeling off the road on the right-hand side.",
#:   "Manoeuvre under test: vehicle in the left adjacent lane cuts laterally through the corridor ahead of the ego at short range and departs the carriageway on the right.",
#:   "The car on my left, she passes in front of me at the very last second, tac, and takes the small street at right.",
#:   "It was gone off to the right before I'd even found the horn, that motorbike, having come over from the lane beside me and missed my headlamp by a hair.",
#:   "Please make the ambulance run next to us until the hospital entrance is almost behind it, then have it veer over our bows and dive in there on the right.",
#:   "I represent the owner of the blue Astra. She tells us that a van which had been driving alongside, on her left, abruptly came over through her lane just yards in front, and without remaining there went straight off into a retail park on the right. She braked and spilt her coffee.",
#:   "You know when you can see somebody reading the signs and doing the sums? Woman in a people carrier, one lane over, looks up, sees it's her turn-off on the right, and bang, she's gone over my nose and off the main road altogether. No indicator, naturally.",
#:   "At 08:42 the subject vehicle was in the right lane at 50 km/h with a delivery truck slightly ahead in the neighbouring left lane. At the final moment the truck crossed the subject's lane at minimal clearance and quit the road by the driveway on the right.",
#:   "Dispatcher, I've had a near miss at the garden centre. Fellow in a pickup beside me left it till he was practically past the gate, then swung over through my lane right off my front wing and shot in there, to the right. I've got a partial plate.",
#:   "Here in India we are used to it, but still I got one shock. The lorry was going side by side with me, nicely, then at the last possible moment he came slanting over before my bumper and went off the highway towards right, into the petrol bunk.",
#:   "Lane-two cab, last instant, over our bow and out right.",
#:   "Missed-exit panic: coupé alongside slashes across us, off to the right.",
#:   "Truck beside you going right, NOW, in front of you, it's off.",
#:   "Wouldn't most people go on to the next exit? The minicab next to us didn't, he came over my wings at the final chevron and left on the right.",
#:   "Record the following: target in the left-hand adjacent lane; at minimum distance to the exit it traverses ahead of the subject vehicle and departs from the road rightwards.",
#:   "He indicated once, as a formality, and the next thing his whole lorry was passing sideways before my windscreen on its way into the rest area on the right.",
#:   "Let the motorbike ride abreast of the robotaxi till the turning is nearly gone, then let it slice by the front bumper and vanish down that turning, right-hand side.",
#:   "Near miss, exit 14: an ambulance, running level with the claimant on her left, quit the highway on the right by way of the tarmac directly in front of her.",
#:   "On a late impulse the driver of the neighbouring van gave up his lane, shot over mine, and was swallowed by the farm track that goes off right.",
#:   "I could see the sign for the hospital, and I could see the woman in the Skoda see it too, about a second after she ought to have. She was on my left. One jerk of the wheel, my bonnet went dark with Skoda, and then there she was going down the ramp on the other side.",
#:   "The van had been a fixture at my left elbow since the toll. When I next looked my left was empty, my brakes were on, and the van was rattling away down the slip road to the right. I worked out what must have come between only when I saw its paint on my number plate.",
#:   "V2 occupied the lane to the left of V1. Its operator told the trooper that he had \"almost blown past\" his exit. Skid evidence shows V2 passing from the left lane over V1's lane at a flat angle, roughly a car length in front of V1, and into the deceleration lane of the right-hand exit.",
#:   "Now that's a thing you'll never do in my car. If you've left it too late for the turning, you go round again. What you don't do is what this gentleman on our left has just done, which is swoop past our headlights and out at the right with about a yard to spare.",
#:   "When I was a little girl people had manners. On Thursday a young man on a motorcycle was riding at my left hand, nice as you please, and at the very end of the railings he leaned over, went by my front like a swallow, and was away up the vicarage lane on the right.",
#:   "In India exits are suggestions only. So I was in the slow lane, one tanker was parallel to me on the left side. Exit gore came, finished almost, and tanker decided. I am standing on my brake and he is going broadside before me, into the weighbridge road at right. Horn was also not given.",
#:   "Three things have to be right in this clip or the test is worthless. The vehicle begins next to us, on the left. It waits until hardly any room is left before the exit. And it ends off the carriageway, on the right-hand side, having sliced through the space we were about to drive into; it does not stay in our lane.",
#:   "To the ferry people he'd probably have been in time anyway. As it was, the driver of the camper decided with his wheels already on the hatching that this was his junction. He'd been two metres from my left door. He swept over the road in front of me in one go and I saw him disappear right, towards the docks.",
#:   "From the top deck you get a grandstand view. Our bus was in the inside lane, and a white saloon was drawing level on the driver's side. Suddenly I'm looking down on its roof, at an angle, right under our front window, and then it's gone up the exit to the right and the whole bus has lurched forward.",
#:   "The officer asked how I could be certain it meant to leave rather than just change lanes. Because it left, I told him. A police car, of all things, sat alongside me on my left till the exit sign was over our heads, then crossed me, nose to nose with the crash barrier, and peeled away down the right-hand ramp.",
#:   "Dear Auntie, we almost had bump. The big lorry at left side is sleeping, I think, because exit is already passing. Then he wakes, he makes a diagonal before our little car, so near that I see the nuts of his wheel, and he goes out at the right where is the factory. Uncle said many words.",
#:   "Off-ramp nearly gone; van beside us slants over our nose, down it.",
#:   "blink and she's across my bumper and up the ramp, from the OTHER lane",
#:   "Police bike, next lane: over your bows late, off right-hand side.",
#:   "There was a van at my left shoulder, then a van filling my windscreen side-on, then a van's rear doors dropping down the slip road to the right.",
#:   "What should have been the lorry's exit two hundred yards ago became its exit now, by way of my bonnet, and out it went on the right-hand side.",
#:   "Our neighbour on the left suddenly wanted the services on the right, and the only way there at that stage was through the few metres before our bumper.",
#:   "The adjacent target shall initiate its departure no earlier than the last 20 m, traverse the subject vehicle's lane diagonally at short headway, and exit by the right-hand road edge.",
#:   "I stood on my brakes for a fire engine that was mine for half a second, between being my neighbour's problem and being the industrial estate's, off to the right.",
#:   "He wasn't changing lanes, officer; he went from his, over mine under my very nose, to no lane whatever: out at the right, down to the quarry.",
#:   "Two sets of tyre marks tell it. Mine are straight and short. The taxi's start in the lane on my left, run slantwise through mine a couple of yards beyond where mine stop, and end in the gravel at the mouth of the right-hand ramp. The fare in the back had shouted that they were missing the turn.",
#:   "I'd been using that tipper as a windbreak, me on the scooter, him one lane to my left and a bit forward. With the sign for the tip already over our heads the windbreak went. Its tail passed left to right in front of my knees, gravel flew, and it was thundering off down the side road before I'd got my foot back up.",
#:   "Clip from the robotaxi, hazard class late leaver. Nothing in our lane. One delivery van in the next, slightly up on us. At 4.2 seconds its flank enters the picture from the left; at 5.0 it's dead centre and very large; at 5.9 it's out of the picture on the right, where the only thing is an exit it had practically gone by.",
#:   "You were counting exits for Grandad, and you got to seven and stopped. That's because a motorbike had leaned over so hard that its footrest sparked, come from the lane next door past our number plate, and gone out at number seven on the right, which nobody sensible would still have tried for. Grandad said it for you. He said seven.",
#:   "It was my own fault for sitting in his blind spot, I dare say. The artic to my left had its indicator going for the longest while, and I reckoned he'd given up, since the ramp was all but behind us. He hadn't. I had a wall of blue curtain in front of me at an angle, I had my horn, and I had a view of his trailer going away right.",
#:   "In our country one learns geometry so. On the left of me is the wedding car with flowers. At the right is coming the hall. The driver has forgotten the hall, everybody is shouting, he remembers. The shortest line between two points is through my lane, one hand before my lamp, and off the road to the right. I have flowers on my wiper.",
#:   "The learned judge asked for the length of time the pickup had been in the plaintiff's lane. \"No longer than it takes to cross it,\" said the witness. It had been level with her, on the left, up to the last post of the exit; it had then shown her its side, very near; and next it had been seen going from her down the right-hand slip.",
#:   "For the exit test I need a neighbour with poor planning. Start it in the left-hand lane, nose a little forward of ours. Wait until the ramp mouth is as good as gone. Then a hard diagonal, one car length before our bumper, and it carries on out to the right until the main road is rid of it. If it ends up in our lane, that's a fail.",
#:   "The paper said I swerved. I did, into the verge, and here's the reason. A lady in a camper in the other lane had seen the word Campsite at about the moment it went by her. Where I was going to be in one second, her camper was now, broadside. By the time I'd come to rest it was bouncing off among the trees on the right.",
#:   "What do you do when the ambulance at your left gets a radio call and the hospital turning is thirty feet off on your right? You brake, is what, and hard, because he'll not go round again. I had his rear step go through my headlight beam, left to right, and the next I knew he was halfway up the hospital road.",
#:   "She closed her eyes, which she later thought a pity. When she had shut them the lorry was beside them, humming, on the left. When she opened them Henry had both feet on the brake, the air in front stank of hot rubber, and the same lorry was swaying away down the right-hand fork, where it had every business to be but no business getting to it like that.",
#: ]
#: adversaries = ["car", "motorcycle", "truck", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute", "leftLane"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cut-in", "turn-right"]
#: side = "left"
#: leader = false
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 4.0
#: high = 11.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stays"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 6.5
#: unit = "m/s"
#: meaning = "how fast it turns off"

param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_ADV_AHEAD = Range(4, 11)
param OPT_ADV_SPEED = Range(5, 6.5)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(leftLane, ego, self) > 2
    do TurnOff(-0.9, globalParameters.OPT_ADV_SPEED, 9)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 3 seconds
    do Halt()
