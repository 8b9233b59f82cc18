#: description = "The pedestrian suddenly sprints out onto the road in front of the ego and stops."
#: rephrasings = [
#:   "Somebody dashes into the lane and freezes directly in the path of the ego.",
#:   "The pedestrian bolts into the roadway, then stands still before the ego.",
#:   "A child runs out in front of the vehicle and halts there.",
#:   "The person rushes onto the street at full speed and comes to a dead stop.",
#:   "The runner darts out abruptly and blocks the lane by standing in it.",
#:   "A lad comes haring out and then stands stock-still in front of us.",
#:   "The pedestrian ran into the roadway and stopped in the path of Vehicle 1.",
#:   "ped runs out, freezes in lane",
#:   "Some kid legged it out in front of me and then froze like a deer in the headlights.",
#:   "The juvenile ran into the roadway ahead of Unit 1 and came to a sudden standstill.",
#:   "Ped bolts out, freezes in front of ego.",
#:   "The pedestrian target accelerates to running speed into the VUT's path and comes to rest there.",
#:   "A child runs suddenly on the street before me and stays standing.",
#:   "Dart-out then freeze: ped reaches our path running, halts in it, doesn't finish crossing.",
#:   "He burst out at a run, saw her coming, and stood rooted to the spot.",
#:   "Kid's run out, and he's stopped right there staring at you, brake!",
#:   "this girl sprinted out in front of us and then just FROZE",
#:   "A youth tore into the road and pulled up short before a car, as though turned to stone.",
#:   "He ran into the carriageway, and directly before the vehicle he ceased to move?",
#:   "Small boy suddenly ran in front of my car and then stood there like statue.",
#:   "Shoots out in front of me, sees the grille, and that's him stuck, won't go on, won't go back.",
#:   "Sudden running entry of pedestrian with standstill in ego path.",
#:   "GIRL SPRINTS OUT THEN FREEZES IN FRONT OF CAR",
#:   "A boy streaked out and petrified before us.",
#:   "Runner in the road, now stock-still, right before your bonnet!",
#:   "Jogger flings himself out ahead of us and turns into a lamp post.",
#:   "I need a person who rushes into our lane and stays rooted there.",
#:   "Le petit, he runs out very fast and pouf, he is like frozen.",
#:   "Ped at full tilt off pavement; halts dead in VUT lane; remains.",
#:   "She was standing like a bollard in the middle of my lane, the girl who one second earlier had come galloping off the pavement.",
#:   "It's the ones who run out and then lose their nerve you have to fear: this chap's belted into your lane and now he can't move a muscle.",
#:   "A pedestrian hurtled unexpectedly from the pavement into the path of the robotaxi and, rather than go on, remained motionless in front of it with arms outstretched.",
#:   "Upon trigger the adult dummy is accelerated to 3.5 m/s, driven into the VUT's lane and stopped abruptly at the lane centre, where it stays.",
#:   "What made you run into the street with such suddenness, and what, having got before the car, made you stand there and go no further?",
#:   "My little brother bombed out onto the road to get to Grandma, and when he saw the van he just went all stiff in front of it.",
#:   "From the saddle I saw it all. A man with a rucksack took off from the bus stop like a sprinter and was in the lane in two bounds. He'd have made it to the other side, but he caught sight of the car, and there he stuck, right in its way, knees bent, mouth open.",
#:   "I had hardly passed the school when a tall boy burst from the gate at full speed into the road. I braked, of course. He didn't run on and he didn't run back; he pulled himself up in the very middle of my half and stood gazing at me while I came to rest.",
#:   "The pedestrian was observed beside a mailbox. As Vehicle 1 came near she set off at a run, without warning, and reached its lane within about a second. There her run ended. She stood facing the grille and was still standing on the same spot when the driver got out.",
#:   "In this scenario the AV has to cope with a dash that isn't completed. Someone tears out from the edge, reaches the strip of road we're about to use, and there they plant both feet and won't budge. A planner that counts on them carrying on to the other side will hit them.",
#:   "Eighteen years on the buses and you still get a shock. Some lass came charging out after her boyfriend, handbag flying, straight into where I was going. And then what does she do? Sees the front of a double-decker and locks up solid. I had to stand there hooting till her fella fetched her.",
#:   "Student sprints out, goes rigid in our lane, remains there.",
#:   "sec one hes running out sec two hes a statue before us",
#:   "Woman legs it off the kerb, jams to a halt before the bus. Standing.",
#:   "At the sound of the horn the lad, who had bolted from the pavement like a startled deer, turned likewise to stone in the middle of our lane.",
#:   "Pedestrian onset of motion is abrupt, peak speed is reached within a metre, and the motion ends as abruptly in front of the AV, in its lane.",
#:   "Anyone who runs like that into the road ought at least to run off it again; this jogger ran as far as our bumper and there took root.",
#:   "Imagine it: out from the doorway at a gallop comes a man, arrives before your wheels, and, instead of clearing off, plants himself there and stares you down.",
#:   "The subject ran suddenly from the shoulder, stopped running when directly in line with V1's center, and was in the same place when V1 came to rest.",
#:   "Suddenly there is a girl which runs very fast into the way of our car, and there she stays like somebody has switched her off.",
#:   "I'd put it down to the headlights. She came off the verge so suddenly and with such a turn of speed that I expected her to be in the ditch on the other side before I could do a thing. Only the lights got hold of her, if you see what I mean. She stopped in them, dead centre, hands up, and didn't budge.",
#:   "They've a dare at the comprehensive, it's called Bollard. The rule is that you run out when the car's good and close, properly run, and then you've got to stand bang in its way and not flinch. My nephew was the bollard on Tuesday. The driver of the bread van got out and cried, and my nephew was still standing there.",
#:   "Bus stop, left side, eight people. Seven of them stayed put. The eighth took off without warning, covered the three metres to our lane in under a second, and shut down. There's no better word for it, he shut down like a toy when you pull out the battery, with the front of the robotaxi filling up behind him on the camera picture.",
#:   "There is a moment on the recording which the jury may wish to see twice. The pedestrian has come out at a sprint. Two more strides would take him past the lorry's wing, and he has the speed for them. He doesn't take them. He brings his feet together in the very lane the lorry is using, and from that spot he does not stir.",
#:   "We've plenty of runs that go through, and I'd like one that doesn't. Set a person by the kerb with no sign of any intention. When we're close, they explode into the road. When they're in line with our number plate all that energy's gone: zero speed, facing us, and zero it stays to the end of the file.",
#:   "My God, the children here. I was bringing our little bus down the hill from the chapel. One small fellow in the yellow shirt came flying off the step into the road, so quick that I only saw yellow. Then he saw me also. And yellow was not moving any more, yellow was just there before my glass, waiting for me to do something.",
#:   "He ran as one runs out of a burning house, with no thought but to be elsewhere, and the road received him. What he met on it was our radiator. It is curious how quickly such a man can be emptied of purpose: between two heartbeats he had ceased to run, and he stood before us as a post stands, till somebody led him away.",
#:   "The cyclist next to me shouted, and that's what did it, I think. A girl had shot off the pavement after her hat, going flat out. She could've got over easily. But she heard the shout, and both her shoes slapped down together right ahead of the Volvo and she stood with her eyes shut, and she'd have gone on standing till doomsday.",
#:   "Don't swerve, because you don't know which way they'll go. Sometimes they don't go any way. Last month a lad burst out on us from behind a skip, and he was moving, believe me. My learner braked in a straight line, thank heaven, and good that she did, for by the time we'd stopped the lad had become a fixture of our lane.",
#:   "Emergency braking demonstration, item 4: the sprinting and freezing adult. Spectators will see a dummy thrown out from the parked cars at up to fourteen km/h. It'll be brought to nil within its own width, right on the path of the car, and it won't be withdrawn. The car has to stop for it; there's nothing else to be done.",
#:   "At six in the morning there's only me and the milk. And that fellow. Came out of the allotments like a cork, right into the road, no reason that I could see, with a marrow under each arm. Then, smack in front of my float, he stopped as if he'd hit a pane of glass. There he stood. \"Morning, Alf,\" he said.",
#:   "Boy: pavement, blur, then a statue before our bumper.",
#:   "shot out in front of us then just. stood there. like deer",
#:   "Jogger flat out into your lane, and planted in it. Not moving. Over.",
#:   "Had she carried on at that rate she'd have been over long before we came, but the girl who'd burst from between the stalls was rooted to the spot on our white arrow.",
#:   "First his speed made me brake and then his lack of it made me brake harder, the man in the apron who tore out to the middle of my lane and pulled up dead.",
#:   "I've two pictures of him a second apart, one that's all legs and smear between the kerb and our lane, and one that's sharp, arms by his sides, facing our radiator.",
#:   "The VRU leaves the kerb without warning at sprinting speed, perpendicular to the lane, and comes to rest on the lane's centre line, where it remains upright.",
#:   "Make a schoolboy explode off the footpath as though he'd be over in two seconds, and then have him go no further than right in front of us.",
#:   "Look at her now, dear, standing in front of the car with her eyes like saucers; you'd never think that a second ago she came off that kerb like a rocket.",
#:   "The strange thing on the video's that he had made it, nearly. He'd gone from nothing to a full run at the kerb; there were two steps left to be past my bumper. Nobody called, nobody was coming the other way. His trainers squeaked, you hear them above my brakes, and there he was bolt upright in my lane with his palms towards me. I stopped against his palms.",
#:   "I'd picked my line behind him. You do on a bike in a bunch: he's going left to right at a gallop, so you go left. So had the blue car, you could see it edging. He'd hurtled out from the crowd like one that's seen his bus, and then stood in front of that blue car as if he'd never seen anything.",
#:   "Requirement: the system must not assume that a running pedestrian goes on running. Stimulus: the dummy's at the roadside, hidden by a van; it's launched at five metres a second towards the ego's path; in the middle of this path its speed is zero. It stays there, on its feet. A pass is a stop short of it. A swerve behind it has a second dummy waiting.",
#:   "Why I'd the handbrake on in the middle of the High Street? Because of the lady in it, constable. She came off your side like something out of a cannon, bag and all, and I said to Jean she'll be in the Boots opposite before we've blinked. Well, we blinked. She'd got no further than my number plate and she wasn't for going further. She was looking for her other glove.",
#:   "In the first half of the second the thermal camera shows a runner: warm thighs, arms in motion, on a course over our lane. In the second half it shows a standing figure, the same person, with the same warm thighs, in our lane. Between these there is one long step with the heel down. The autonomous van came to a halt two metres from the heel.",
#:   "Such a chicken my cousin is. We must go to other side for cricket, he says I go first. No looking! Full speed from the footpath like Bolt, till the centre of the near lane. There he sees one truck. He should run on, no? He should run back, no? He's standing. Truck is making all kinds of noises, and he's standing in front with bat in hand, like it's the wicket.",
#:   "The pupil was crying. What had she done wrong? Nothing. There was a pavement with a boy on it, then a boy going hell for leather to our front, and she'd braked for the place he was going from, so as to let him by. But he'd run out of courage just there, with our bumper to his left. She had to find the rest of the pedal, and did.",
#:   "\"There was a wind,\" she used to say, \"and it was he.\" He had been among the idlers on the steps. He was all at once a rushing thing, coat and hair, on its way over the road, and the coachman had lifted his foot to let it pass. It did not pass. It stood, and was a man, a foot from the lamps, hat in hand, looking at us.",
#:   "Claim: damage to roof load. I'd a piano on. When that kid broke from the queue and came pelting at the road, I touched the brake, no more, since at his rate he'd be clear of me. It's the second touch that shifted the piano. He wasn't clear. He'd stopped running bang in front of me, both feet together, mouth open, and he stuck there as though somebody'd cut his strings.",
#:   "On the skid pad we had a volunteer in a foam suit, a former hurdler. His brief: from a crouch at the edge, no signal to the driver, all-out to the taped cross in the middle of the car's lane. On the cross: freeze. He could go from eight metres a second to none in a single stride. What no driver had expected was that he'd still be there.",
#:   "The goalkeeper came to his line, as it were. He rushed out for the ball like a mad thing, between the parked cars, into the road, and the ball wasn't there; what was there was the taxi. Keepers go one way or the other. He didn't, he made himself tall, in the taxi's lane, and he held that. The taxi was the one to go down.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "accelerate", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it runs"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 6.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to run"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 1.0
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_SPEED = Range(4, 7)
param OPT_ADV_DISTANCE = Range(6, 18)
param OPT_STOP_DISTANCE = Range(0, 1)

behavior AdvBehavior():
    # Earlier where it has farther to go, or on a wide road it would pass behind the ego.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
