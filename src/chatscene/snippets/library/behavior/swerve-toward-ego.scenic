#: description = "The car swerves toward the ego's lane and straightens up again."
#: rephrasings = [
#:   "A vehicle beside lurches across the marking and recovers.",
#:   "The adversary veers at the ego for a moment.",
#:   "The neighbouring car jerks sideways into the ego's space, then back.",
#:   "The driver yanks the wheel over and corrects late.",
#:   "The lorry drifts abruptly out of its lane and returns.",
#:   "He nearly sideswipes us and then jerks back.",
#:   "Vehicle 2 drifted abruptly across the lane line and corrected.",
#:   "It pulls the wheel to our side and again back to its own.",
#:   "The car beside me twitched over at me and then straightened itself out.",
#:   "Vehicle 2 veered toward Unit 1's lane and then regained its course.",
#:   "Veh lunges at ego lane, corrects, stays own lane.",
#:   "The target deviates laterally in the direction of the VUT's lane and then resumes its heading.",
#:   "The bus comes a bit in direction of my lane and then goes straight again.",
#:   "Lateral feint: neighbour jerks at us but doesn't change lane, recovers heading.",
#:   "He gave a sudden lurch in her direction, so that she flinched, and then he was steady again.",
#:   "He's had a wobble towards you, that lorry, but he's caught it, he's back in line.",
#:   "car jerked at us for a sec then went back straight, prob on his phone",
#:   "A lorry keeled momentarily in the direction of a passing car before holding its course again.",
#:   "You came toward my client's lane, though not to stay, and at once righted your course?",
#:   "Side lane bus suddenly leaned towards me, then became straight again, thank God.",
#:   "Has a nibble at my lane, then behaves himself again. Awake now, are we?",
#:   "Momentary lateral excursion of vehicle toward ego lane with self-correction.",
#:   "DRIVER NEARLY SIDESWIPES ME THEN CORRECTS",
#:   "The truck feinted at our lane and steadied.",
#:   "Neighbouring truck gave a lunge our way, then got itself straight.",
#:   "Let the bus in the adjacent lane twitch egoward and recover.",
#:   "He came over at me for a heartbeat, then held his lane.",
#:   "Moto at side leans suddenly to us, after this goes straight again.",
#:   "Nearly kissed our door, that cab, before it pulled itself together.",
#:   "The lorry running next to us bulged over the dashed line without warning, hung there for a moment and slotted back where it belonged.",
#:   "The adjacent target performs a brief lateral deviation towards the lane of the vehicle under test, whereupon it realigns itself with its own lane.",
#:   "woman in the next lane mustve dropped something bc her car yawed in our direction, a second later she had it pointing forward again",
#:   "V2 departed briefly toward the lane occupied by V1 before its driver steered back and resumed a straight course in the original lane.",
#:   "If that coach beside you sways over like that again, don't retaliate; look, he's woken up, and he's running true in his own lane.",
#:   "Side lane's pickup, he all of a sudden shook towards my car, my heart stopped, then he made his steering straight and continued.",
#:   "I was alongside a furniture van on the ring road when it flinched in my direction, so near that I could have touched the lettering. Just as quickly it was upright and in its proper lane, going along as if nothing had occurred.",
#:   "An agent in the neighbouring lane should produce a scare rather than a collision. It darts laterally at the ego's lane for about a second, then countersteers and goes on in its own lane at its former speed, never really joining ours.",
#:   "Through the side window I watched the motorcyclist look over his shoulder, and as people do, he went where he looked. The bike dipped over towards us; then he caught it, set it upright and rode on parallel to us, shaking his head.",
#:   "Old habits, said the coach driver when they asked him. He'd seen a bag in the road and his hands had done the rest, a quick tug at the wheel toward the car in the next lane and another to put the bus straight.",
#:   "Ever had your life flash by at sixty? The saloon next door made a grab for our lane, mirrors almost touching, and while my passenger was still screaming it had already straightened its wheels and was sailing along on its own side of the dashes.",
#:   "Coach alongside sways at our lane, thinks better, runs straight.",
#:   "Bike next lane: one dip towards us, one dip back, carries on.",
#:   "that hatchback leaned on me like a drunk mate, then stood up straight",
#:   "A horsebox which was keeping pace in the lane beside ours skipped towards us for a moment, was collected, and resumed its straight course.",
#:   "The adjacent target performs a transient steering input in the direction of the VUT's lane, followed by a counter-input restoring it to its lane centre.",
#:   "Give it room, that skip lorry's just bulged over towards you; no, he's noticed, he's pulled it true again and he's sticking to his lane.",
#:   "The pickup of the neighbour lane gave me a fright, it came with the shoulder against me, then it took again its good line and went on.",
#:   "In lane two, the bus shall kick out at the ego's lane for about a second and then settle down in its own again.",
#:   "V2 made a sudden movement to its right in the direction of V1's lane but was redirected by its operator and resumed a straight path in lane 2.",
#:   "I had a paper cup of tea on the dash, and that's the only casualty. The tanker next to us bellied out at our lane so that its tank was all I could see through the window, and I braced; then daylight came back in, and it was trundling along inside its own lines as it should.",
#:   "Somebody in the Corsa beside us must have reached for the crisps. There was a hop in our direction, wing mirrors no more than a hand apart, and a hop the other way; and for the rest of the journey she drove in her lane as straight as a die.",
#:   "The rumble strip between the lanes is what gave the warning. Brrrp, it went, under the wheels of the lorry that was abreast of the robotaxi, and the trailer loomed; the driver must have been woken by it, for the loom went off and he continued straight up his own lane.",
#:   "Wind on the viaduct does it. The motorcyclist on our flank was slapped sideways, toward our front wheel more or less, he leaned into it, and he was bolt upright and riding straight ahead in his own lane before I'd got out the word \"careful\".",
#:   "The defendant's wheels did approach the plaintiff's lane, quickly and without warning, and it may well be that she screamed. They did not remain there. He at once brought his bus straight and he held it straight, which is why there isn't a scratch on anyone.",
#:   "Range to the neighbour on the right: 3.4, 3.4, 1.1, 3.4, 3.4. That one short value is all the scenario consists of, a jab at our lane by the truck running beside us, and a return to a straight course in its own that comes about as quickly as the jab.",
#:   "Uncle Ted calls them lane-leaners. One leaned at us by the reservoir, a big green furniture van with a yawning man in it, so near that I could've drawn in the dirt on its side; Uncle Ted hooted, and it stood up straight again and kept itself to itself.",
#:   "I cycle a lot, I notice drift. This wasn't drift; the minicab one lane over from the silver saloon whipped a good metre towards it, as if its steering had been nudged, and whipped itself straight again, and both of them sailed on side by side down to the lights.",
#:   "You'll be asked what you'd have done, so say: nothing. The van beside you darted your way, and a swerve of your own would have put us in the ditch. It's corrected itself, see, wheels straight, dead centre of its lane, and the man's waving sorry.",
#:   "In the rain the two of them went on abreast, the motor coach and her little car. Once only, as a sleeper turns over, the coach heaved towards her; its tall lit windows hung above her for a second, and it heaved back, and ran on smoothly where it had been before.",
#:   "Side by side we were going, I and one Tata truck. His cleaner was giving him tea, so the truck jumped towards my lane, khatam I thought, finish. But driver caught the steering, straight he made it, and went on in own lane drinking that tea.",
#:   "Tanker alongside twitched our way, caught itself, ran true again.",
#:   "Bike next door: one lurch at us, one correction, back to dull.",
#:   "Felt its mirror coming for ours; then it didn't.",
#:   "The rumble strip buzzed under the bus that was running beside us, its side swelled in my window, and then both the noise and the swelling went away.",
#:   "For about a second our two door handles could've shaken hands, and then the saloon in the next lane had itself pointing up its own lane as before.",
#:   "Have the neighbouring lorry make a grab for our lane, sudden and brief, and settle back into its own course as though a hand had slapped it.",
#:   "He dropped off, I'd say, that pickup next to you: there was a dart at your front wing, and now he's awake and steering up the middle of his lane.",
#:   "A lateral excursion of 1.2 m in the direction of V1's lane was recorded for V2 in the adjoining lane; within 1.5 s its alignment was restored.",
#:   "My neighbour on the second track made suddenly such a hip swing against me that I pulled in the belly, and immediately he rode straight again in his track.",
#:   "The light in our car went off and came back on, that was all. It went off because the coach in the lane next door had heaved itself at us, so that its side was between me and the sun; and before I'd got my arm up it was heaved back, bolt upright, humming along on its own side of the dashes.",
#:   "If she'd been texting I wouldn't be surprised. We were running level, her in her lane, us in ours, with a comfy two metres between. It went to half a metre. My passenger sucked his teeth. It went to two metres again, and she'd both hands on the wheel, and they stayed there, and so did the two metres.",
#:   "There's rubber on the dividing line, a smear shaped like an eyebrow. It leaves the lorry's lane, touches the paint and returns into the lorry's lane. What you can't see from it is the noise, says the witness, who was driving on the other side of that paint and thought her last hour had come.",
#:   "In the regression set this is called \"bite\". The neighbour keeps station one lane over; its yaw rate shows a short pulse towards the ego and, about a second later, a pulse of the opposite sign. Net result: nothing. Same lane, same heading, same speed. The ego should neither brake hard nor leave its own lane.",
#:   "It's always you who's told off for swerving, isn't it? You didn't, well done. It was the motorcyclist on your right who dipped a shoulder at us, came over till I could smell his exhaust, and then stood his bike up and went straight on where he belongs. A wasp in his helmet, possibly.",
#:   "\"I never changed lane,\" the van driver insisted, and in a manner of speaking it was true. His wheels had shot over towards the robotaxi's, a sneeze he said; its passengers had screamed; and by the time that the sneeze was done with, he was travelling up his own lane on his own line like a tram.",
#:   "From the saddle of my bike I had a view up the alley between two moving vehicles, a bus and a grey saloon. The alley pinched. It was the bus's wall that moved, in at the saloon and out again, quick as a gill; and from there on the alley was as wide as it'd been, for as far as I could see up it.",
#:   "They'd been side by side for so long that she'd quite ceased to hear it, the big Daimler in the next lane. There was a chirp of tyres. Its running board was rushing at her knees; she shut her eyes; and when she opened them it was rolling along at its old distance, and the old gentleman in it was reading a map.",
#:   "You bring the load, the wind brings the rest. I'd a curtain-sider, empty, and a small car next to me on the viaduct. The gust put me over at her, not into her lane quite, but her face went white as a plate. I'd caught it by the next expansion joint and held it dead straight to the end of the bridge.",
#:   "Do we pay for a scratch that isn't there? The claimant was startled by the other party's vehicle, which from the adjoining lane darted in her direction and was at once put straight by its driver. It didn't enter in front of her, it didn't strike her. It drove on beside her. The kerb she hit is another matter.",
#:   "On NH48 I was in left, one tourist bus was in right, both doing seventy. His boys were dancing inside, so driver also started little bit! Whole bus came dhak towards my lane, I saw Ganesha sticker bigger than my window. Then he remembered he is driver, straight he made it, and in his own lane only he went to Goa.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["swerve"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -8.0
#: high = 24.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.5
#: high = 2.6
#: unit = "m"
#: meaning = "how far it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE_TIME"
#: low = 1.2
#: high = 1.8
#: unit = "s"
#: meaning = "for how long"

param OPT_ADV_DISTANCE = Range(-8, 24)
param OPT_ADV_SPEED = Range(5, 9)
param OPT_SWERVE = Range(1.5, 2.6)
param OPT_SWERVE_TIME = Range(1.2, 1.8)

behavior AdvBehavior():
    others = [other for other in simulation().objects if other.body is not self.body and other.body is not ego.body]
    # At the latest where it would pass somebody else.
    do KeepStation(advLane, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE or any(0 < headway(advLane, self, other) < 32 for other in others)
    do SwerveOnPath(advLane, globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_SWERVE if offsetFrom(ownLane(egoRoute), self) > 0 else globalParameters.OPT_SWERVE) for globalParameters.OPT_SWERVE_TIME seconds
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED)
