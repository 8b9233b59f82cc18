#: description = "The oncoming car drives against the traffic in the ego's lane."
#: rephrasings = [
#:   "there's a guy coming straight at us in our own lane",
#:   "Vehicle 2 was travelling the wrong way in the lane of Vehicle 1.",
#:   "wrong-way driver, our lane, head-on",
#:   "The target approaches the VUT in the VUT's lane in the opposite direction at constant speed.",
#:   "A car is driving in the wrong direction on our side of the road.",
#:   "A cyclist rides the wrong way up our lane, towards us.",
#:   "The ghost driver keeps to the ego's side for far too long.",
#:   "A motorbike comes head on, on the side where it has no business.",
#:   "Some doddery old fella was coming straight at me on my side of the road, going the wrong way.",
#:   "A wrong-way driver was traveling toward Unit 1 in its lane, against the flow of traffic.",
#:   "Ghost driver, ego's lane, head-on, holds spd.",
#:   "The target travels in the VUT's lane in the opposite direction at constant speed.",
#:   "A car comes against me in my lane, he drives on false side.",
#:   "Contraflow actor in our lane, no evasive move, head-on all the way.",
#:   "He came on down her side of the road as though it were his own, and never gave an inch.",
#:   "Control, we've got a wrong-way driver in your lane, coming head-on towards you.",
#:   "theres a car coming STRAIGHT for us the wrong way up our lane help",
#:   "A confused pensioner drove into the face of the traffic in its own lane, police said.",
#:   "You were in her lane, going the contrary way, and you maintained your course toward her throughout?",
#:   "One car coming opposite direction in my own lane, wrong side totally, not stopping also.",
#:   "I'm on my side and so's he, and we're pointing at each other. Somebody's wrong and it ain't me.",
#:   "Sustained contraflow travel of opposing vehicle in ego lane.",
#:   "WRONG WAY DRIVER HEAD ON IN MY LANE",
#:   "The truck breasted the traffic in our lane.",
#:   "Bus on our side, pointed at us, and it keeps on coming",
#:   "Unit 6, vehicle in your lane proceeding contraflow towards you.",
#:   "Moped riding against the stream, straight up the AV's lane.",
#:   "Put an ambulance head-on in the ego's lane, holding a steady pace.",
#:   "Why is that van in our lane facing us?",
#:   "The pickup had no right to be where it was, on my half of the road, travelling steadily towards me against everybody who was going my way.",
#:   "The oncoming target occupies the lane of the vehicle under test, opposed to the prescribed direction, and closes in at a constant 40 km/h.",
#:   "I blinked my lights at the lorry, for it was driving up our lane from the other end, but the driver just carried on in the wrong direction.",
#:   "V2 was proceeding in a direction opposite to that permitted and was in the same lane as V1, approaching it front to front at moderate speed.",
#:   "A tourist car, I think from the left-driving country, was coming on my lane against me, not quick, not slow, he did not understand his mistake.",
#:   "some delivery rider cycling the wrong way up my lane, towards me, keeping a nice even pace like thats totally normal??",
#:   "At first we took the headlamps for somebody overtaking who would soon be back on his side. He wasn't overtaking anything; he was simply travelling up our lane in the wrong direction, mile after mile for all we know, and he came on without a waver.",
#:   "Listeners, you've heard the traffic announcer say there's a vehicle going the wrong way. Well, I met it. It was a beige saloon, it had my lane to itself until I turned up, and it kept driving towards me as if I were the one in error.",
#:   "The parameter set is simple: opposing agent, lateral position within our lane, heading reversed relative to the lane, speed constant. No lane departure back to its own side, no braking, no swaying; the AV has to solve the head-on conflict on its own.",
#:   "He'd come out of the filling station by the wrong exit, I suppose, that motorcyclist. At any rate he was in the lane that belonged to us, riding against us and against the arrows on the tarmac, as regular as a clock.",
#:   "Q. Which lane was the fire engine in? A. Mine. Q. And which way was it heading? A. Towards me, against the traffic, and it stayed in my lane the whole time I could see it, at the same speed.",
#:   "Pushbike, our lane, handlebars towards us, steady as you please.",
#:   "Ambulance facing the robotaxi in the robotaxi's own lane, holding its pace.",
#:   "why is the FRONT of a bus coming at me in MY lane",
#:   "The coach had got onto our half of the road somehow, and from there it proceeded towards us at an even speed in defiance of every arrow.",
#:   "An oncoming target, positioned in the VUT's lane and moving opposite to its permitted direction, sustains both lane position and speed throughout the approach.",
#:   "There was a moped in my lane as there often is, only that I saw its headlamp and not its number plate, and it came and came.",
#:   "Have a motorcyclist come the wrong way along the lane the ego is using, at an ordinary pace, and keep him in it.",
#:   "V2 was traveling eastbound in the westbound lane, in which V1 was proceeding westbound, and V2 continued to do so as the two closed on each other.",
#:   "My lane is one-way for me, I think; but this lorry, he thinks it is one-way for him, and with constant speed we approach us.",
#:   "You know those red signs with the white bar? I could see their backs, so the man in the saloon ought to have seen their fronts. He was motoring along my lane from the other end, not fast, not slow, facing me, and he looked as comfortable as if he had been in his own drive.",
#:   "I had pulled out nothing, I was overtaking no one, my lane was mine. And still there were two headlights in it, low down and dead ahead, and they didn't move to either side; they just drew apart from one another, evenly, as the thing came on up the wrong side of the road.",
#:   "The radio had been on about a ghost driver, and Mum said, how silly, who'd do that. Then we saw him. He was a police car, of all things, and he was coming to us in our own lane, against everyone else, and he didn't go quicker and he didn't go slower.",
#:   "The cyclist couldn't be persuaded that anything was amiss. He had been riding down the claimant's lane in the direction opposite to hers, the arrows under his wheels pointing at his own face, and he had kept it up at a regular pace till she was obliged to stop.",
#:   "In this test both vehicles are in one lane, and they're pointing at each other. The truck isn't drifting over from its own side and won't go back to it; it's simply on the wrong carriageway, at a uniform 40, and the gap closes at the sum of the speeds.",
#:   "I've tramped up and down this country with a lorry since '89 and I'd never had it happen. There's me on my side. There's a hatchback on my side too. I can see his tax disc, he can see mine, and he keeps driving at me against all the traffic, steady, like it's me that has to think again.",
#:   "Her first idea was that she herself had gone wrong. She looked for the line, and it was where it ought to be; so it was the fire engine that was misplaced, whose great chrome mouth was advancing down her lane from the far end, without haste and without a doubt.",
#:   "We do the drill in the classroom: lights, horn, stay calm. Here's the real thing for you. That van has got himself on our side of the road, he's travelling towards us in our lane, he isn't passing anybody, and he's showing no sign of slowing or of moving over.",
#:   "The rental agreement was found open at the page about driving on the right. Its signatory had presumably not got that far, for he'd brought the people carrier along the left for four miles, which is how we came to meet it, grille to grille, in our lane, bowling along at a constant fifty.",
#:   "Everything on the road ahead of us had the wrong colour. Where there should have been red lamps, going away, there was white, approaching: a motorbike, square in the robotaxi's lane, coming against the stream and never altering its speed.",
#:   "On highway they don't want to go up to the U-turn, it's two kilometres extra. So tractor, auto, everybody comes on the wrong side; this one Tempo was in my lane itself, facing me, forty speed, fully cool, as if government gave him that lane.",
#:   "My lane, my side, somebody else's headlights, steadily bigger.",
#:   "Grille where tail lamps should be: a coach, wrong way, our lane.",
#:   "Cyclist facing us, in our lane, pedalling on as if invited.",
#:   "We could see the driver's tie through his windscreen, which we'd no right to see, he being in our lane and on his way to where we had come from.",
#:   "Nothing but white lights in front, and they were in the lane that's ours, and they neither hurried nor slackened nor thought of getting out of it.",
#:   "Give the ego somebody to meet in its own lane: a fire engine with its front to us, moving at an even forty the opposite way to everyone else.",
#:   "All the arrows on the tarmac point away from you, and he's driving over them towards you; he's in the wrong, and he's keeping on at the same pace.",
#:   "At first contact V2 occupied V1's lane, its direction of travel being the reverse of that assigned; both lane and velocity were unchanged ten seconds later.",
#:   "On the Autobahn warns the radio, and on my country road comes one: nose against nose, he on my lane, me on my lane, and he drives and drives.",
#:   "It took me far too long to see what was amiss, because each thing by itself was all right. A car, good. In a lane, good. Going at fifty, same as me. It was its having a face. There was a face on it, headlamps and all, and it was the lane I was in, and it was getting no farther away but nearer.",
#:   "I should have thought the horn would do it. From beyond the bridge I was leaning on it, and this young fellow on a scooter came on up my half of the road, chin up, at the same steady lick, with everybody who was going my way pulling over one after another. Then there was only me left.",
#:   "The two roads are divided by a line of white stones. On our side of them one drives north. The van was on our side, and it was driving south, and had been for a mile, by what the shepherd says; it didn't speed, it didn't stray, and it met us where the stones end.",
#:   "It's the sign gantry that gives it away on the video. You read it forwards because it's for you. Beneath it comes an ambulance, no lamps, no siren, in the same lane that we're filming from, and its crew would have to be reading the gantry from the back. It keeps that up until we've stopped.",
#:   "You know the moving walkway at the airport, and there's always one child that's running up the down one? That, in a Saab. It came along our lane towards us while the rest of our stream were peeling off on both sides of it. No zigzags, no pause, no burst of speed; a man on his way to work on somebody else's road.",
#:   "Would an overtaking driver have moved back in? Of course, and the plaintiff waited for him to do so. But there was nobody for him to overtake. He was in her lane because he took it for his, he faced her because he took that for the direction, and he proceeded in this belief, evenly, till she was on the verge.",
#:   "We have three parameters for the head-on actor. Lateral offset from the centre of the ego's lane: nil. Heading with respect to the lane: 180 degrees. Speed: twelve metres per second, constant, from spawning to the end. Please don't add any weaving or braking, since those are other entries in the catalogue.",
#:   "From the high seat of a lorry I can see over things, so I saw it early, and for once I'd have been happier not to. Three cars up, the brake lights went outward, left, right, left, like a shoal splitting. Through the shoal swam the biker. He was in our lane, facing us, at a nice regular forty.",
#:   "My wife says, \"He'll see us.\" I say, \"He's looking right at us.\" That's how long we had. Some tourist in a hire car had our side of the coast road, cliff and all, and was motoring to meet us along it at the pace you'd take to look at the sea. And the other side stood empty.",
#:   "The moon was behind it, which made it worse; they saw a shape. A bicycle has no business being larger each time one blinks. Those in their own lane go away, or are caught up with, seen from the rear. This one bore down on them with its lamp and its two knees, up their lane, tranquil as a mill.",
#:   "One-way is only for the one who believes. From my front one school bus is coming, in my lane, children are waving to me from front glass. Both sides wall. I'm showing light, he's also showing light. I show him hand, what is this; he's showing me hand, namaste. And the same speed he was keeping, coming, coming.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: opposite direction; own code"
#: [slots]
#: actions = ["oncoming", "wrong-way"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 35.0
#: high = 90.0
#: unit = "m"
#: meaning = "distance to the ego at which it comes over into the ego's lane"
#: [[parameters]]
#: name = "OPT_ADV_OFFSET"
#: low = 0.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far toward its own side it keeps when it meets the ego"

param OPT_ADV_SPEED = Range(4, 9)
param OPT_ADV_DISTANCE = Range(35, 90)
param OPT_ADV_OFFSET = Range(0, 3)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < 36
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_ADV_OFFSET)
