#: description = "The car noses half into the ego's lane and stops there, straddling the line."
#: rephrasings = [
#:   "Somebody pokes his nose halfway into our lane and then stops, hogging both.",
#:   "Vehicle 2 straddled the lane line and came to rest partly in the path of vehicle 1.",
#:   "Partial cut-in, stops on the marking.",
#:   "The target performs an incomplete lane change and comes to standstill overlapping the VUT's path.",
#:   "The car is half in our lane, half in his, and it stands.",
#:   "A taxi wants over, chickens out midway and halts astride the dashes.",
#:   "The ambulance leaves its rear in the next lane and its front in ours, at rest.",
#:   "A van edges over the marking, sees no room and freezes there.",
#:   "the taxi next to me poked his snout over the line and just parked it there, half in his lane and half in mine",
#:   "V2 in the adjacent lane encroached partway into V1's lane and came to rest straddling the lane line.",
#:   "Car alongside: edges over, halts astride marking, blocks half our lane.",
#:   "Adjacent target makes a partial lane change of 50 % overlap and remains stationary on the lane marking.",
#:   "The police car from other lane comes only half to my lane and then stays standing on the line.",
#:   "Neighbouring actor aborts lane change midway and parks on the divider stripe, half of our width taken.",
#:   "The saloon leaned over into her lane, got as far as its door mirrors, and there it froze with two wheels on either side of the paint.",
#:   "He wants your lane but he's only gone half the job: nose in, tail out, and now he's sat there across the dashes.",
#:   "dude started coming into our lane then just gave up halfway and parked there wtf",
#:   "Queues formed after a saloon abandoned its manoeuvre with half its bodywork poking into the neighbouring stream",
#:   "And there he remained, half in one lane and half in the other, the nose obstructing my client?",
#:   "Cab beside us come in half body only then stop, neither here nor there, very irritating leh",
#:   "He sticks his bonnet in my lane and leaves it there like a foot in the door, won't come in, won't go out",
#:   "Incomplete lateral intrusion from adjacent lane with stationary overhang",
#:   "Police car gets STUCK between two lanes right beside me",
#:   "The estate car wedged its snout into our lane and froze.",
#:   "Astride the lane divider, front wheels on our side: that's where the saloon quit.",
#:   "He got one wheel over, then two, then nothing: stationary on the paint.",
#:   "Van next lane: 50% encroachment, v=0, stays.",
#:   "Half a fire engine in my lane, and it isn't going anywhere.",
#:   "Let the SUV angle partway over our marking and halt right there.",
#:   "The rapid response car slanted its bumper across the dashes towards me and pulled up like that, with its back half still where it came from.",
#:   "In statement the lady said the white hatchback came over only by its bonnet, then it was standing, one half with her, one half there.",
#:   "Target vehicle shall drift laterally from the neighbouring lane until its front overlaps the VUT lane by half its width, then brake to rest without completing the change.",
#:   "Why has the cab stuck its front corner into the robotaxi's strip and come to a dead halt instead of carrying on over?",
#:   "The car next us want come in, only put the head inside, then it don't move anymore, body is on two lanes.",
#:   "Unit 2 was found at rest across the broken white line, its forward portion obstructing Unit 1's lane, having steered partly over from the lane adjacent.",
#:   "Picture the scene: three lanes, everyone rolling, and a lad in a Fiesta to our left starts easing over. He gets as far as his headlights and front wing in our lane, loses his bottle, brakes, and sits there on the line with his tail sticking out behind.",
#:   "I am eighty-one and I do not see as well as I did, but I saw that ambulance. It tipped its nose into my part of the road, just the front half of it, mind, and then it stood quite still upon the white line.",
#:   "Bug 4417: planner believes the neighbour will finish its merge. It doesn't. The sedan yaws towards us, its front axle crosses the marker, it brakes to zero and holds at an angle, so about half our corridor is gone while the other half stays drivable.",
#:   "She'd been watching the estate in the corner of her eye. It turned its wheels towards her, pushed its long snout over the boundary, and then, as though someone had cut a string, it stopped where it was, neither in her lane nor out of it.",
#:   "we were coming up to the services and this merc on the right tries to squeeze in front of some lorry in our lane, gets his front end across the line, runs out of road and brakes. so now hes parked diagonal over both lanes",
#:   "Neighbouring taxi comes to rest half across our line.",
#:   "Police car beside us: half a lane change, then nothing more.",
#:   "One headlamp in our lane, one in his, parked.",
#:   "It had meant to come over from the next lane, but with its front wing across the paint the estate ran out of courage and sat.",
#:   "Have the SUV next to the ego start a lane change towards it, give up at the midpoint, and stay immobile on the stripe.",
#:   "Control, we are held up on the ring road: a minicab from lane two has poked halfway into ours and is now stationary on the dashes.",
#:   "El coche de al lado, sorry, the car at my side, it put the half of the body in my line and there it remained, without moving.",
#:   "The ambulance never finished coming over; its cab took up the left of our lane, its tail the right of its own, and its wheels had ceased turning.",
#:   "Is she planning to live there, that lady in the Micra, with two tyres over on our side of the markings and the handbrake on?",
#:   "The insured was travelling in the middle lane with a hatchback on her offside. She noticed its front wheels turn towards her and its wing creep past the lane line. She expected it either to carry on across or to drop back, yet it did neither: it braked and remained astride the line until she struck it.",
#:   "I've drawn you a sketch, officer. This is the broken line, this is me, and this rectangle sitting at an angle on the line is the people carrier. He had been level with the car in front, then he leaned over into my lane as far as the passenger seat, and that is where he chose to stop.",
#:   "Honestly the gap was never there and I think he worked that out too late lol. bonnet over the line, brake lights, and then he's just this diagonal wedge, half my lane gone, half his lane gone, and a whole motorway behind the pair of us leaning on the horn",
#:   "The rule of thumb which our planner had learned is that a car that crosses the marking will be wholly in the lane two seconds later. Here, after two seconds, its rear axle was still on the neighbouring side, its speed was nil, and so it remained, with about fifty per cent of our width shut off.",
#:   "From the top deck of the 73 you see everything. A fire engine in the next lane wanted to come across to us, only there was a bollard or some such, so it got its great red nose over the paint and pulled up. We looked straight down on its roof, half on our side and half not.",
#:   "What was left of our lane would have done for a motorbike. The rest was filled by the slanting front end of a Volvo whose driver, moving over from alongside, had looked in his mirror for the first time when he was already halfway in, and had braked to a standstill out of sheer fright.",
#:   "The partial encroachment scenario requires that the target, initially in the adjacent lane and slightly forward of the VUT, yaws towards the VUT's lane, achieves an overlap of approximately half its own width and there decelerates to zero, its longitudinal axis oblique to the lane boundary. It shall not complete the manoeuvre nor withdraw.",
#:   "Now, Priya, why have I got my foot over the dual brake? Look left. See how that white van's got its front wheel on our side, and its back wheel not? It was heading in, and now it isn't heading anywhere. Halfway and halted, that's the worst place he could have picked.",
#:   "She would later describe the police car as a door left ajar. It had swung its snout out of the neighbouring lane and into hers, not fast, and had then been left there, motionless, so that she could neither go through nor be certain it would not open the rest of the way.",
#:   "My car have automatic driving, I only watch. In the right lane one black sedan want to change to us, wheel already on the white line, head already inside, then he maybe see my car is near, he step brake and not move. So tail is in his lane and head is in mine.",
#:   "The robotaxi's log says \"obstacle, static, 48 percent lane overlap\". Four seconds earlier that obstacle had been an ordinary estate car doing thirty in the lane alongside. In between lie a turn of its wheel towards us, a front corner over the boundary, and a brake application which left it stranded with its boot still next door.",
#:   "Front wheels ours, back wheels theirs, engine ticking over.",
#:   "He got halfway across to us and the cab simply stayed put.",
#:   "Adjacent ambulance: partial intrusion, zero speed, tail still next door.",
#:   "The dashes ran under the middle of that police car, which had tilted over from the next lane and was going no farther.",
#:   "You can't call it a lane change, it was half a one, and the minicab sat there with the other half undone.",
#:   "Program the estate car in the neighbouring lane to slant over until roughly half its width is inside ours, and leave it standing at that spot.",
#:   "Our side sensors reported a bumper over the marking, then a door mirror, and then nothing more, since the sedan had pulled up right where it was.",
#:   "Lane two's blocked and so's half of lane three: fire tender leaned over from two, didn't finish, and it's stood across the line.",
#:   "She waited for the rest of the Skoda to arrive in her lane, and it never did; it had come to rest with its backside in its own.",
#:   "Attached is a photograph of the position in which both vehicles were found. Mine is straight, between its lines. The other is crooked, its front corner two feet from my bonnet and its boot in the lane it had been driving in beside me. I'm told I ought to have let it in. It was never coming in; it had stopped.",
#:   "A door handle, madam, is what I looked at for four minutes. The driver's window of his Mercedes was level with the paint, his headlights were in my lane, his number plate in the next. He had leant across from alongside, I suppose he saw me, and there he anchored himself, too far in and not in enough.",
#:   "The rear indicator was still winking in the lane he'd been in, and the front one was winking in mine. That, my love, is how your grandad saw it: the van from next door had tipped itself over the white line, run out of pluck, and parked. We had a strip the width of a pram left to get by.",
#:   "Nobody on the bus could understand it. The police car was running along beside us, rolled its nose over our line, so the driver eased off to leave it space, and into that space it didn't go. It just sat down, if you see what I mean, with the stripe dividing it fore and aft, and we had to wait.",
#:   "Ticket 882: AV brakes for side intrusion, correct, but then starts creeping as it assumes the intruder will clear. It won't. Ground truth has the hatchback's heading 14 degrees towards us, centre of mass exactly on the boundary, velocity 0.0 for the remainder of the log. Fix the completion assumption.",
#:   "I am truck driver from Łódź, forty ton. Small car at my right, I see him good in the mirror. He turn wheel to me, come with the lamp and the wing, and then I don't see him move. My bumper to his door one metre. He is not in my lane and he is not in his lane, he is monument.",
#:   "Picture of a man who has begun a sentence and forgotten how it ends: so stood that taxi. It had been abreast of us. It put out its snout into our strip of road as though about to say something, and then every wheel of it was still, the snout on this side, the luggage rack on that.",
#:   "The test is passed if the subject vehicle neither strikes the object nor leaves its lane on the far side. The object is a saloon which approaches the boundary from the adjacent lane, yaws through it until half of its bodywork protrudes, and is there brought to a standstill for good. It neither enters completely nor pulls its bodywork out again.",
#:   "what i had left was the gutter half of my own lane, a minute before id had all of it with an SUV keeping station on my other side. I heard a squeal, looked round, and there was its wheel arch slanting in over the markings with the tyre already locked. I cycle, so I got through. The van behind me couldn't.",
#:   "An exasperated coroner asked whether the ambulance had been in lane one or lane two. \"Yes,\" said the constable. It had commenced to shift from the latter into the former, in which the cars were; it had ceased to shift when it was astride of the line; and it had not turned a wheel from that moment.",
#:   "Drivers faced a squeeze past the Arndale last night after the driver of a people carrier bottled it mid-manoeuvre. Motorists in the next lane found its front half poking across the broken white line and its rear half where it belonged. \"We all thought he'd shove on in or back out,\" one said. He had switched off.",
#: ]
#: adversaries = ["car", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "stop"]
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 12.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stays"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.25
#: high = 1.7
#: unit = "m"
#: meaning = "how far it noses over"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 0.8
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(0, 30)
param OPT_ADV_AHEAD = Range(12, 18)
param OPT_SWERVE = Range(1.25, 1.7)
param OPT_BRAKE = Range(0.4, 0.8)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 8
    do SwerveOnPath(advLane, 6, -globalParameters.OPT_SWERVE if offsetFrom(egoRoute, self) > 0 else globalParameters.OPT_SWERVE) for 0.8 seconds
    do BrakeOnPath(advLane, globalParameters.OPT_BRAKE, -globalParameters.OPT_SWERVE if offsetFrom(egoRoute, self) > 0 else globalParameters.OPT_SWERVE)
