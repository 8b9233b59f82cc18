#: description = "The emergency vehicle races past the ego in the next lane on its call."
#: rephrasings = [
#:   "An ambulance with lights and siren rushes past us.",
#:   "The fire apparatus, responding to an emergency, passed vehicle 1 at high speed.",
#:   "EMS vehicle code 3, overtakes fast.",
#:   "The emergency vehicle overtakes the VUT at high relative speed in the adjacent lane.",
#:   "A police car with the blue light goes very quick beside us.",
#:   "A wailing fire engine storms by in the other lane.",
#:   "The paramedics hurtle up from the rear and are past.",
#:   "Siren in the mirror, whoosh, blue flashes ahead.",
#:   "An ambulance came belting past in the next lane, blues and twos going.",
#:   "A marked patrol unit responding Code 3 passed Unit 1 in the adjacent lane at high speed.",
#:   "Fire engine on shout, adj lane, flies by ego. Straight line.",
#:   "The emergency vehicle target, with warning devices active, passes the VUT in the adjacent lane at substantially higher speed.",
#:   "Police car with siren goes very fast by me on the other lane.",
#:   "EV on call blasts by one lane over, no lane change, no weaving; check siren handling.",
#:   "The siren rose behind her and then it was there beside her window and gone, hurtling on to somebody else's trouble.",
#:   "Ambulance coming through on your side, running hot, hold your lane and let it fly by.",
#:   "ambulance went past me sooo fast in the other lane, siren n everything",
#:   "A fire appliance answering a 999 call hurtled past traffic in the neighbouring lane.",
#:   "The police vehicle, its siren sounding, went by my client in the lane alongside at considerable speed, yes?",
#:   "Ambulance with siren went zooming in the next lane, all the way past me.",
#:   "Bluelights in the next lane, nee-naw, nee-naw, whoosh, gone before I could pull over.",
#:   "High-speed passing by responding emergency vehicle in adjacent lane.",
#:   "FIRE TRUCK FLIES PAST ON A CALL",
#:   "A police car streaked by in the lane alongside, siren wailing.",
#:   "Paramedics tore by on the neighbouring lane, siren howling.",
#:   "patrol car on a shout blazes past us one lane across wow",
#:   "Send a fire engine flying past the ego in the adjacent lane.",
#:   "NEE-NAW NEE-NAW it went zooming past daddy's car in its own lane!",
#:   "EV overtook subject at speed, parallel lane, warning equipment on.",
#:   "With its horns going, the rescue truck came up along the lane beside the robotaxi and left it standing, bound for some fire or other.",
#:   "You heard it before you saw it: a police car in the lane to your side, doing twice your speed, up alongside and away ahead of you.",
#:   "The vehicle under test is to be passed in the parallel lane by an ambulance on duty whose speed exceeds the VUT's by at least 40 km/h.",
#:   "In my country also we make place for the doctor's car, but here it came so rapid on the next track that already it was in front.",
#:   "Unit 4 responding, I'm level with a civilian saloon, now clear of him, staying in the outside lane and making good speed to the incident.",
#:   "An ambulance on its way to a casualty swept by at a tremendous lick, keeping to the lane alongside mine the whole time, and was soon a dot.",
#:   "I am eighty-one and my hearing is poor, so what I noticed were the blue reflections on my dashboard. Then something big and red thundered by in the lane next to me, off to a fire I imagine, and my small car rocked in its wind.",
#:   "Repro steps: ego cruises, fire apparatus with active siren approaches from the rear in the adjacent lane and passes at very high closing speed. It never enters our lane and does not deviate. Expected: no panic braking by the stack, just yield space and let it pass.",
#:   "The patrol car was answering a call for assistance and therefore driving with lights and siren. It drew level with Vehicle 1 in the lane beside it, went by at about 130 km/h, and had vanished round the bend before the driver of Vehicle 1 could react.",
#:   "We lorry drivers see them coming in the big mirror, little blue sparks growing. This one was an ambulance in the lane next to ours, absolutely motoring; it passed the cab like a bullet train, and off it went to whoever was waiting for it.",
#:   "There was a moment's confusion in the mirrors, then order: the engine kept to the lane alongside ours, its crew buckling helmets in the windows as they shot by on the way to the blaze. We were doing fifty and might as well have been parked.",
#:   "Blues in the next lane, a howl, and it's a mile ahead.",
#:   "Dash cam: fire engine goes by one lane over like I'm parked",
#:   "Let a siren-wailing ambulance blast past the AV, lane alongside.",
#:   "On its way to a stabbing, a patrol car ate up the lane to our side and left us behind as though our wheels had been clamped.",
#:   "An active-siren fire appliance shall close from the rear in the lane adjoining that of the VUT and pass it with a speed surplus of not less than 15 m/s.",
#:   "Hold your line, don't dodge; he's coming up beside you on a shout, he'll go straight through in his own lane, and there, he's gone already.",
#:   "Ambulance gaadi with siren on took the side lane and went ahead of us in one second only, so much speed, patient must be serious.",
#:   "The appellant's car was being passed, in the lane next to it, by a police vehicle answering an emergency, and passed with very great speed at that.",
#:   "What was that? That was the doctors, darling; somebody's poorly, so they zipped along the lane next to us, nee-naw, and now they're right up there by the bridge.",
#:   "I keep the radio low since I've had the hearing aid. There came a wail from behind, and I looked for it in the mirror, but it had already reached my shoulder: a big yellow ambulance in the other lane, going like the clappers. By the time I'd thought of pulling in, there were only its lights to be seen, far up.",
#:   "V1 was proceeding in the right lane when an engine company responding to a structure fire passed in the left lane. Witnesses put its speed at roughly twice that of traffic. It at no time left the left lane, and V1's driver reported only the buffeting of air and a startled infant.",
#:   "The mirrors went blue first. Then the inside of the van went blue, then the bonnet, then the road up in front, all within the time it takes to say it. They'd an armed robbery to get to, I read later, and the lane beside mine was clear for them the whole way.",
#:   "As a biker I feel it in the shoulders. An emergency doctor's estate came down the outside lane on a call while I was sitting behind a robotaxi in the middle one. It must have been doing ninety; the robotaxi twitched in the draught, and we both stared at a pair of tail lamps getting small.",
#:   "Regression: emergency vehicle, adjacent lane, no interaction. At the trigger the police car, which was hanging back abeam, goes to full throttle with lights and siren, draws away past us in its own lane, and becomes a dot. The stack should hold its lane and must not issue a hard stop.",
#:   "My instructor says half of all pupils swerve when the siren gets loud. I gripped the wheel and kept straight, and the fire engine tore up the lane alongside and was beyond us before I had breathed out. \"They'd a fire, you'd a lane,\" he said. \"Nobody needed anything from anybody.\"",
#:   "We were three abreast at sixty when the wail reached us. Nobody moved, because the lane to our right happened to be empty, and that was the one the ambulance used. Its speed was such that the driver of our coach only got as far as \"Here comes an—\" and it was there, and past, bound for the pile-up.",
#:   "Dispatcher's tape: unit is making to the hospital with the burns case, he's in lane three and clearing everybody. Saloon in lane two reports he went by so quick it rocked her. No contact, no change of lanes, he's just got his foot down and the horns going.",
#:   "I do not complain, Mr Officer, I only say how it was. I drive ninety, as permitted. On the track at my side comes the Polizei with the blue lamp and the tatü-tata; I believe two hundred he drove, and he went along me and away, before I could even take the foot from the gas.",
#:   "The night was broken into three pieces: before the siren, the siren, and after. In the middle piece something white and screaming drove through the lane at Nora's side, threw red on her hands, and flung itself on ahead toward whoever had dialled. Her own car, by comparison, seemed to be standing in a field.",
#:   "Mate, this is why you check the lane before you pull over. Cop car on a shout, sirens, the lot, doing warp speed in the lane next to me. If I'd moved into it to be nice he'd have been in my boot. I stayed put, he screamed through and was gone. Easy.",
#:   "A howl astern, a streak alongside, gone: paramedics on a shout.",
#:   "Fire engine on blues in the adjoining lane, storming by.",
#:   "our windows rattled, police car next lane flat out, gone",
#:   "The ambulance came up out of the mirror in the lane to our side and was a speck ahead before the boy had his hands over his ears.",
#:   "Let an engine with its beacons on come from behind in the lane that runs next to the AV's and leave the AV standing, straight as a die.",
#:   "Was that a patient in there? It went through the lane beside us with the siren going, at a rate that made our sixty feel like parking.",
#:   "With active warning devices the target shall close from the rear in the neighbouring lane and, at full throttle, clear the front of the VUT without any lateral deviation.",
#:   "I did nothing, since nothing was wanted of me: the blue lamps had a lane of their own, next to mine, and needed about one second to be done with us.",
#:   "Code three heading east, all yours, you've a test car in the lane beside, it's holding steady, blow right on by.",
#:   "First the ceiling of the car pulsed blue, faintly, then strongly, and I couldn't find the cause in my inside mirror as my lane behind was empty. Then my door window was full of red and chrome and noise. By the time I'd turned my head it was the windscreen's turn, and the thing in it was already small.",
#:   "The pitch gives you the speed, if you care to do the sum. Coming up it was a scream, at my elbow it fell by nearly a third, and going away down the lane next door it was a moan. I make that some thirty metres per second for a doctor's car on its call, against my fifteen.",
#:   "My parrot imitates it to this day. He was on the seat beside me when the brigade was called to the mill. He heard it begin behind us, he heard it go by outside his window, not slackening for a second, he heard it die away in front; and I felt the car sway from the wind of it, as it had only the lane next to us.",
#:   "In the log the robotaxi does nothing at all, which is the correct answer. Siren direction: rear, then abeam, then front, all within 3.1 s. Beacon track: never inside our lane boundaries. Relative speed: plus sixteen. We held our lane and our pace and let the police car have the one it was using.",
#:   "Nurse's evidence: we had a cardiac arrest on board and I shouted to Mick to give it all it had. I recall a grey car in the lane to one side of ours, in front at first. It went past my side window as though someone had pulled it backwards on a rope, and I never saw it again.",
#:   "You'll hear it, Chloe, ages before you see it, and everything in you wants to dive for the gutter. Don't. Look, blue lamps in the door mirror, so it's got the next lane clear. Hold still. There, that was all it was, a bang of air and a pair of tail lamps half a mile on. Somebody's house is burning.",
#:   "What went by was four tonnes of ambulance, and what was left of it after a breath was a wet stripe on the lane alongside and the smell of hot brakes from some earlier corner. My own bus hadn't had the time to wobble. The siren had started on our rear seats and finished beyond the bridge.",
#:   "Lorry drivers' forum, re: blue lights. I was plodding in lane one, limited, 56. Heard the two-tone, checked the glass, lane two behind me lit up like a disco. Before I could say \"here he comes\" to the dog he'd been. Never as much as brushed our lane; he'd have been doing a ton, poor sod's on a call.",
#:   "A pure speed-difference case: in the one lane the ego, calm; in the lane adjoining, starting a little behind, a fire appliance that has just been told of an explosion. It puts everything down. The ego's job is to see it appear at the flank, see it draw away in front, and not be startled into some steering of its own.",
#:   "In France, when the SAMU comes, all the world throws itself to the border. Me, I had not the time. It was already at my height, on the other file, with the pin-pon; I have turned the head, and it was not there any more; I have turned it to the front, and it was very little and very far.",
#:   "LOUD WARNING, headphone users. 0:07 nothing, 0:09 distant wailing, 0:10 white blur fills the neighbouring lane, 0:11 cammer's hat rotates, 0:13 you can just make out AMBULANCE on the back doors, miles up the road. For those asking: no, it did not come into his lane and no, it didn't slow. Why would it?",
#: ]
#: adversaries = ["emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "fast"]
#: position = "behind-beside"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 36.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 13.0
#: high = 17.0
#: unit = "m/s"
#: meaning = "how fast it overtakes"

param OPT_ADV_DISTANCE = Range(10, 36)
param OPT_ADV_SPEED = Range(13, 17)

behavior AdvBehavior():
    do KeepStation(advLane, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advLane, 1, 0, globalParameters.OPT_ADV_SPEED)
