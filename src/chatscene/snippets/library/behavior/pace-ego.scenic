#: description = "The car drives parallel to the ego and blocks its path."
#: rephrasings = [
#:   "A vehicle stays level with the ego, leaving no gap to move over.",
#:   "The adversary matches the ego's speed beside it.",
#:   "The neighbouring car keeps abreast and shuts the ego out of the lane.",
#:   "Side by side with the ego, the driver refuses to let it in.",
#:   "The car shadows the ego door to door.",
#:   "He sticks to our flank and won't let us over.",
#:   "Vehicle 2 travelled abreast of vehicle 1 at an equal speed.",
#:   "The target keeps lateral station alongside the VUT, zero relative velocity.",
#:   "this coach sat alongside me matching me mile for mile, so I couldn't get over",
#:   "V2 traveled abreast of V1 at the same speed, preventing V1 from moving over.",
#:   "Truck parallel, same v, lane shut for us.",
#:   "The target remains level with the VUT in the adjacent lane at identical speed, denying the lane change.",
#:   "The car goes always next to me, not faster, not slower, and I can not change the lane.",
#:   "Parallel runner keeps the SUT boxed: copies its velocity, stays abeam for the entire run.",
#:   "Whatever speed they chose the motorcycle chose too, and so it kept them walled in.",
#:   "He won't go forward and he won't drop back, he's just sat at your shoulder shutting the door on you.",
#:   "this car is right next to us and wont let us over, speeds up when we do slows when we do",
#:   "A driver was hemmed in by a bus that kept station at her side mile after mile",
#:   "You remained level with my client's doors, so that she was denied the lane?",
#:   "I go fast he go fast, I go slow he go slow, side by side, don't want to let me change lane",
#:   "Want to get over, can't, this fella's stuck to my ribs and he ain't shifting",
#:   "Parallel travel of adjacent vehicle at equal speed; blocked lane change, no braking",
#:   "Truck REFUSES to let me change lanes, matches my speed",
#:   "The motorbike mirrored our speed at our elbow.",
#:   "biker glued level with our door no way acros for us",
#:   "Hatchback rides abreast at equal speed and keeps our lane change shut.",
#:   "Keep a motorbike dead level with the ego the whole way.",
#:   "Adjacent saloon, zero drift, abeam throughout, lane change not possible.",
#:   "That car stays next to us and won't let daddy over.",
#:   "I braked a little, so did the cab; I sped up a little, so did the cab; it just remained at my side and kept the lane closed.",
#:   "The neighbouring target maintains longitudinal overlap with the vehicle under test at identical speed for the duration of the run and thus prevents it from changing lanes.",
#:   "You want to be over there by the next exit, but there's an SUV sitting off your right shoulder like a bodyguard, going precisely as fast as you.",
#:   "The motor bicycle was always exactly in parallel to me, so I could not go into the other lane, although I have waited very long.",
#:   "Is there anything more maddening than a car that neither passes you nor falls in behind, but just occupies the very spot you need beside you?",
#:   "For the entire length of the recording the pickup is level with the robotaxi in the lane it is trying to reach, and copies its pace.",
#:   "We had the neighbour's company for six kilometres. A silver estate, its driver staring ahead, kept its wheels in line with ours as if there were a rod between us. I needed that lane to get off at Fulda, and I never got it, because he never left my side.",
#:   "The Claimant indicated in good time. The motorcycle in the next lane did not yield and did not go ahead either; it adopted the Claimant's speed and held that position at her flank, so that there was no gap to enter. Having no choice, she missed her turn.",
#:   "Merge abort not triggered. NPC in the target lane locks on to our longitudinal position with no more than a metre of error and follows any change of speed we make. It does not enter our lane at any time. Requested: planner should abandon the merge after some seconds rather than insist.",
#:   "He had noticed the black car because it did not behave like traffic. Traffic comes and goes. This stayed. When he hurried it was beside him, when he idled it was beside him, a dark wall moving with his window, and the lane that he wanted lay on its other side.",
#:   "I ride a moped for the pizza place, so I was watching from behind. The two of them were like a pair of skates: the red coupé next to the test car, same speed, no gap front or back, mile upon mile, and the test car's blinker going the entire time for nothing.",
#:   "Moped glued abeam of us, same speed always, no way over.",
#:   "Keep a saloon flush beside the ego, shutting the lane it needs.",
#:   "I speed up he speeds up, I slow he slows, cant get over",
#:   "With its wheels exactly in line with ours, an SUV kept us penned in our lane the entire way, whatever I did with the pedals.",
#:   "A target in the adjoining lane mirrors the subject vehicle's speed profile with constant overlap, so that at no time is there a gap for the lane change.",
#:   "The gentleman on the motorbike went always at my side, when I made quicker he made quicker also, and so the other lane was for me closed.",
#:   "There's no use indicating; that hatchback has been at your side since the bridge, neither advancing nor falling away, and he is sitting on the space you want.",
#:   "Did he pass? He didn't. Did he drop behind? He didn't. The pickup merely travelled along at my client's shoulder and so kept him from his exit.",
#:   "Boss, this one cab is running parallel only, same to same speed, he's not leaving side for me to go over, like we are tied with rope.",
#:   "I've nothing against company but the white van overdid it. From the brewery to the ring road it was there, window to window with mine; I could've passed the driver a sandwich. I had to be in its lane for the hospital. I went faster, I went slower, and there was still van where the hospital ought to have been.",
#:   "V1 activated its turn signal and attempted to move to the right lane. V2, a passenger car, was in that lane directly beside V1. V1 varied its speed between 48 and 62 mph; V2 did the same. At no point did V2 leave its lane. V1 was thus unable to exit and continued to the next interchange.",
#:   "For the stubborn neighbour, choose a motorbike. It takes up a position by the ego's flank, in the lane we'd like to have, and stays put relative to us: no passing, no dropping back, no coming over. If the ego's planner slows, so does the bike. Run it to the end of the route and see if ego gives up politely.",
#:   "In thirty years of driving instruction I've had one pupil cry on a dual carriageway, and it was due to a grey Audi. It did nothing at all, that was the cruelty of it. It hung beside us at whatever speed she chose, blocking the way over, and she ran out of road, and of tissues.",
#:   "The mirrors showed nothing, since the thing wasn't behind; the windscreen showed nothing, since it wasn't in front. It was in the side window, and it filled it, mile after mile: the red flank of a sports car. The lane it was occupying was the one by which they'd planned to go home.",
#:   "Cam title: \"human wall\". Cammer wants right. There's a taxi on his right. Cammer gives it some beans; the taxi's door handle doesn't move one centimetre in the frame. Cammer lifts off; handle's still there. This goes on for the full two minutes and he never gets in.",
#:   "It was on a coach road in Andalusia, very wide. One car, blue, Portuguese, remained at the height of my door from the first toll until the second. He did nothing to me, he only copied. Each time I thought now I can go to the other lane, I looked, and it was occupied by him.",
#:   "You'll say I could have braked and gone in behind him. I tried. When the needle came down his came down, and there he was, my ear to his ear; the rider looked across as though we were on the same merry-go-round. I couldn't have got a bicycle into that lane, let alone the bakery truck.",
#:   "As a cyclist on the parallel path I can keep up with traffic there. The robotaxi had its indicator going. A people carrier was on that side of it and stuck by it like a barge roped to another barge: together they crawled past the allotments, together they picked up past the school. It never got an opening.",
#:   "Ticket closed as \"works as designed\", and I disagree. The NPC sets its target speed from ours every frame and so stays abreast for ever, in its own lane. No gap opens. Our lane change request remains pending for 74 s, then we miss the exit. A human would've given up or asked by dropping back a lot.",
#:   "Long after, what she could describe best was the other man's elbow. It rested on the sill of his estate car an arm's length from her, and it stayed an arm's length from her over the bridge and down the far side, at forty, at fifty, at forty again. She never did reach the lane that the elbow was in.",
#:   "Cab abreast of us, same speed, door shut on our lane.",
#:   "that biker is my shadow, i cant get over, ever",
#:   "Wheel to wheel all along, so no lane change for us.",
#:   "Whenever the robotaxi looked for room to move over, the same hatchback's door handle was in it, not an inch ahead nor behind where it had been.",
#:   "Have a saloon in the adjacent lane copy the ego's speed to the last decimal so that it can't go where it wants to.",
#:   "Our indicator blinked for a full two minutes, to the profit of nobody, as the motorcycle next to us was neither gone nor behind but, always, there.",
#:   "I missed my exit on account of a pickup that would not pass me, would not let me pass, and remained as it were bolted on to my flank.",
#:   "Relative longitudinal speed of the adjacent target: zero, tolerance 0.2 m/s, for the whole of the run; the gap required for the VUT's lane change shall not arise.",
#:   "Don't speed up, don't slow down, he'll only do the same, this young fella on the bike; he's your other half today and you'll be staying in your lane.",
#:   "The wipers of both cars were going, and what I remember is that I had leisure to notice that hers were out of step with mine. They stayed out of step by the same amount for the entire ring road, at the same distance from my nose. We wanted her lane, we'd wanted it from the tunnel on, and we ended in the next town.",
#:   "Most drivers can be shaken off. One goes a little under the limit, they float by, and there's one's gap. That was what I attempted. This taxi floated down to the little-under with me. I put it up again, it was up. In the end I gave the fare her money back, because the hospital had been on that side.",
#:   "There's one row in the table that never changes, and it's the row I'd draw your attention to. Ego speed: fifty, forty-two, sixty, fifty. Neighbour speed: fifty, forty-two, sixty, fifty. Offset between the noses: 0.4 m in all four. The lane change was requested on line one and it's still pending on the last.",
#:   "Officer, she didn't touch me. She did nothing at all, that is the complaint. Her estate was next to me as the bypass began, and I signalled. She was next to me at the garden centre, at the golf course and at the sewage works. My own lane ended there. I took to the hatching, while she looked ahead like a sphinx.",
#:   "Imagine that a wall is travelling. It isn't threatening you, it won't come any closer and it's got no plans to leave. On account of that wall, which in the present case is a black saloon with its front just ahead of your front, the turn that you'd like to prepare for can't be prepared. How soon do you give up? That's the measure.",
#:   "I believe that he didn't see me until much later. He had a song on, both his windows were down, we heard all of it. A silver coupé, in the lane which was ours by rights, or by signal at least. When we did forty he was doing forty with his elbow out, at our elbow. It was a long song.",
#:   "Two lamps stood in the wet road beside ours, and they kept the pace as one's own reflection would. Anna slowed. They slowed. She was on the wrong side for the bridge, and the bridge was coming, and there was nowhere for her to put the car but where those lamps were, so she went on, unwillingly, to the coast.",
#:   "V1 was traveling in lane 1 and intended to enter lane 2. Lane 2 was occupied by V2, a motorcycle, whose front axle was aligned with V1's hood. Over the following 900 yards V1 varied its speed by ten mph in either direction. V2's alignment did not vary. V1 didn't change lanes, and its route was recalculated.",
#:   "My sat-nav lady lost patience before I did. \"Keep in the other lane,\" she goes. I'd love to, darling. There's a Polo in it. \"Keep in the other lane.\" He's been in it level with my driver's door since you first said so, he hasn't sped up and he hasn't eased. \"Make a U-turn.\" Right you are.",
#:   "I was on the train, which for a while has the motorway under its window, and saw a small thing. A white car blinked. A red one was at its side. The white one was faster, the red one was; the white one dawdled, the red one did. It blinked for as long as the train could see it, and was never let across.",
#:   "The German colleague calls it Elefantenrennen, but with elephants one at least wins. Here nobody is winning. The motorcyclist is in the lane near to me, I am in mine, and the speedometers say the same. I have a truck before me soon, I would like to go out. And he sits at exactly the place for it, like a cork in the bottle.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advLane"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["pace"]
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = -7.0
#: high = 7.5
#: unit = "m"
#: meaning = "how far ahead of the ego it stays"

param OPT_ADV_AHEAD = Range(-7, 7.5)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD)
