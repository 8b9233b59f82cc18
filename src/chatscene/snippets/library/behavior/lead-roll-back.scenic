#: description = "The car ahead stops gently and then rolls backwards toward the ego."
#: rephrasings = [
#:   "The one in front stops and starts rolling back at us like somebody forgot the handbrake.",
#:   "Vehicle 2 halted without hard braking and subsequently rolled rearward.",
#:   "Lead stands, rolls back slowly, no reversing lights.",
#:   "The target comes to standstill softly and then moves backward at low speed toward the VUT.",
#:   "The truck before us is standing and then it goes back by itself on the hill.",
#:   "A heavy bus ahead eases to rest and slides back on the slope.",
#:   "The van's clutch slips and down it comes, tail first, onto our bonnet.",
#:   "The leader loses its hold on the incline and trickles toward us in reverse.",
#:   "car in front pulled up all gently and then started rolling back at me, must've forgot his handbrake",
#:   "The box truck preceding V1 came to a smooth stop and subsequently rolled rearward in the direction of V1.",
#:   "Bus ahead: soft stop, then drifts backwards twd us.",
#:   "After a mild stop of the lead vehicle, it travels rearwards at low speed towards the stationary VUT.",
#:   "The car before me stops slowly, and after that comes back to me, like on a hill without brake.",
#:   "Lead halts comfortably, then takes on slight negative velocity so the gap to the SUT closes from the front.",
#:   "The van had settled to a standstill, and then, barely to be noticed at first, it slid back towards their radiator.",
#:   "He's stopped nicely, but watch it, he's not holding it on the clutch, he's coming back at you!",
#:   "car in front stopped and now its rolling BACK into us help",
#:   "A coach drew up softly and then, to the horror of the driver following, slipped backwards at her",
#:   "Having come to rest, the vehicle before you began to travel in reverse, towards you?",
#:   "The lorry ahead stopped, and then it is coming back back back onto us, no handbrake or what",
#:   "He pulls up all gentle, then he starts drifting back at me, oi, handbrake, mate",
#:   "Rearward motion of lead vehicle after gentle standstill; shrinking front gap",
#:   "Truck in front starts rolling BACKWARDS at me",
#:   "The van ahead settled, then slithered back at our nose.",
#:   "Bus in front eases to rest, then begins slipping back at us.",
#:   "Gentle halt by the van ahead, followed by a backward drift.",
#:   "Lead lorry settles softly to zero, then trickles tail-first toward VUT.",
#:   "Have the car in front stop mildly and roll back on us.",
#:   "He stopped so nice, and then he came down the hill backwards.",
#:   "The ambulance we were behind slowed without fuss, stood for a breath, and then its rear step began to come nearer, although our own wheels were still.",
#:   "Nothing sudden: the pickup ahead sheds its speed, comes to rest, and after a short wait creeps the wrong way, down the incline to our bumper.",
#:   "Is his handbrake on? He pulled up smoothly enough at the top of this rise, but the gap's shrinking, he's running back into you, sound the horn!",
#:   "The motorist before me finished his halt with much softness and then, the slope being steep, his car descended again in my direction.",
#:   "I want the lead truck to decelerate comfortably to a stop and, some seconds later, to lose its hold and travel slowly in reverse at the ego.",
#:   "Claimant's bonnet was dented by the towbar of a taxi that had coasted to a stop ahead of her and thereafter ran backward on the gradient.",
#:   "Log review, lap nine. Lead vehicle comes to rest at a mild rate, waits briefly, then shows about minus one metre per second toward the ego. Our stack assumed that a stopped lead can only stay or move off forwards. Please add a horn request and check the gap logic.",
#:   "We were behind a removals lorry on Castle Hill. It came to a stand quite tenderly, as these fellows do with a full load, and for a while all was well; then the letters on its tailboard grew larger and larger, and I realised it was travelling back down toward my radiator.",
#:   "On the recording the patrol car preceding the subject vehicle slows with no more than a light touch of brake and stops. Some two seconds afterward its brake lamps go out. It then moves rearward, with gathering pace, in the direction of the subject vehicle, which had no room to retreat.",
#:   "My instructor had told me to keep back from old cars on hills and now I know why. The banger in front rolled gently up to nothing, sat there, and then came sliding back towards my nose, its driver looking at her phone with both feet off the pedals.",
#:   "Honestly the slowest crash in the world. Bus ahead of me brings itself to a lovely smooth stop, I stop behind it. Then it starts coming back. Like, backwards. At me. Two miles an hour, and I'm leaning on the horn the entire time lol",
#:   "The van in front settles to a halt, then begins trickling back toward us.",
#:   "Let the lead ambulance stop softly, wait, and run back at the ego.",
#:   "HANDBRAKE, LOVE! car ahead glides to rest, comes back at me",
#:   "We saw the coach in front come smoothly to a stand, and while we were still congratulating ourselves its big rear window had begun to approach us.",
#:   "Following a comfortable deceleration and a short standstill, the lead truck is to move rearward at low velocity in the direction of the vehicle under test.",
#:   "The police car before me has stopped very sweet, then it stays some moments, and then the back of it is coming to my front, slowly, slowly.",
#:   "You'd left him a car's length, hadn't you? Good, as he's pulled up nicely and now he's lost his biting point and he's drifting down on you.",
#:   "Did the lorry not halt before you in the gentlest fashion, and was it not only some seconds later that it moved backwards and found your radiator?",
#:   "On the ramp to the ferry a camper ahead slowed by degrees until it stood; shortly after, it let itself down the slope, stern first, towards our lights.",
#:   "The hill by the abbey is one in six. I'd been following a bread van up it, and near the top he lost his way, very gradually, till he was at rest and I was at rest. I got a peppermint out. When I looked up from the wrapper, the bread on his doors was twice as big, and growing.",
#:   "V2, a transit bus, slowed at a mild rate and became stationary in front of V1. Its driver left the seat to assist a passenger with a wheelchair. V2 then began to travel rearward on the grade at an estimated 3 mph, and its rear panel contacted V1's front bumper.",
#:   "Subject: negative lead speed. The lead pickup decelerates at one metre per second squared, stops, and holds for about two seconds. After that the range to it decreases although ego is at standstill, because it's going in reverse at us. Expect horn and, if there's space behind, a retreat.",
#:   "Nothing about it was violent. The fire engine ahead of the bakery car came to a stop the way a good lift does; one hardly felt it. There was a silence. Then the gap, which had been the length of a sofa, was that of an armchair, a footstool, and the bakery car started hooting for its life.",
#:   "I have passed my test only in May. In front of me, in the queue-free street, was an old Mercedes, and it braked so soft that I must almost not brake. It stood. I thought, now he will drive on. But he was driving off in the false direction, his trunk to my motor hood.",
#:   "Was a time I'd have jumped out and put my shoulder to it. The little saloon had only sat down for a rest on the brow, no brake lights to speak of, all very ladylike. A moment she stood, and then she started coming down again, rump first, with me and my trailer underneath.",
#:   "No skid marks, no debris beyond a cracked number plate. That fits both stories: the SUV, which the claimant was behind, had been brought to rest without haste, and the claimant had stopped short of it. The SUV afterwards descended upon her. Its handbrake cable was found to be broken.",
#:   "From my bike, waiting between the tram rails, I could see both drivers. The one in the cab in front had let it glide to a stop and was counting money. The one behind was reading. Neither of them saw that the cab had got tired of standing and was creeping bumper-first down to the other.",
#:   "What does it say that my first proper crash was at two miles an hour? The car ahead eases off, eases off, stops, lovely. I've got my elbow on the sill. Next thing I hear is a crunch, and it's not me that's moved, it's him, he's come back down like a cork out of a bottle in slow motion.",
#:   "There's a trick your eyes play. You stand behind a lorry that has drawn up as softly as snow, and your own car seems to roll ahead. So you push the pedal harder, and still it goes on. It took Emil three yards to grasp that it was the lorry that moved, and that it moved toward him.",
#:   "Taxi rank gossip: Ahmed in front stops dead gentle to look for a number. Doesn't pull the handbrake, never does. I'm right up behind him. Couple of seconds and his towbar's heading for my grille at the speed of a tortoise, and him with his head out the window looking the other way.",
#:   "Lorry ahead settles to rest, pauses, then sinks down on us.",
#:   "Soft halt in front, then its towbar creeps our way.",
#:   "bus in front stops all gentle, then slides back at my bonnet",
#:   "You know the car before you has lost its footing when the pothole it stood beyond is under its bumper, and then under yours, though you're both stopped.",
#:   "Have the ambulance leading the ego come to a comfortable standstill, remain so a moment, and then drift tail first into the space it left.",
#:   "A braking so mild that my coffee didn't notice put the van ahead at rest, and a handbrake so feeble that it didn't matter put it in my grille.",
#:   "The preceding target is brought to zero at low deceleration, dwells, and is then displaced in the direction of the VUT at a slow backward velocity for six seconds.",
#:   "I left him two lengths when he'd drawn up so nicely in front of me, and he gave me back one, and then half of the other, all without any white lamps.",
#:   "Caller's on the ramp at Hope Street, says the truck in front halted normally enough, and it's now coming down backwards on her, and she's someone behind.",
#:   "I've a sticker on the windscreen, a small one, and I use it as a sight. As the taxi in front drew gradually up, its number plate sat just over the sticker. We both stood. When I'd found a mint in the door pocket, the plate was under the sticker, larger, and going on getting larger, and no one at the wheel was looking.",
#:   "If the ego only brakes to hold its distance, that's no use. The other car in this story has already brought itself to rest, softly, with the ego behind it at rest likewise. Seconds pass. Then what shrinks the distance is the other car alone, which is moving the way its boot points. Can the ego hoot, can it make room?",
#:   "How the tow ball came to be inside my radiator? Not by hurry. The pickup I'd been following had slackened to nothing, as softly as a barge at its mooring; I'd come up behind it and put the lever in neutral. There was time to read a text. There was then a crunch, and the pickup was where its own shadow had been.",
#:   "Her reasoning was sound as far as it went. The coach stood; it had come to stand with no jerk; nothing further could come of it. What she left out was the hill. The gold letters above its rear window, which she'd been too far off to read, spelt themselves out to her, one at a time, KIRKBY'S OF HEXHAM, and then the mirror broke.",
#:   "Speed of lead in m/s, one value a second: 7, 6, 5, 4, 3, 2, 1, 0, 0, 0, minus 0.8, minus 1.4, minus 1.5, minus 1.5. Everybody looks at the first eight and says \"comfortable stop\". I'd ask you to look at the last four. Our gap at zero was four metres ten.",
#:   "Pupils are all the same on Station Hill. She had pulled up behind the fire engine beautifully, because it had pulled up beautifully itself. She lets her shoulders down. I say, watch his wheels, not his lamps. What's wrong with them, she says. They're turning, I said, and it's not toward the top, get us into reverse.",
#:   "It was my first gig as a bus conductor's mate in the museum, and the vehicle in front was a 1931 saloon with a gentleman of about the same year. He brought her to a stand most tenderly at the bridge. We waited in his rear. By and by his spare wheel, which hung outside, was kissing our starting handle.",
#:   "In the queue to the car ferry all is slope. The Dutch caravan before me had made a very soft arrival, no red light almost, and rested. I rested too. I have heard pebbles crack under rubber, and nobody was driving! But yes, it was him, he was coming downward at me, his whole kitchen, at the speed of a baby.",
#:   "Anybody who's got a manual box will feel for her. She'd eased her Corsa to a stop ahead of us on the incline, all very civil, nothing sudden. Then, with her looking for biting point and not finding it, the gap began to go. A brick's worth, a bike's worth. My horn found it for her when there was a hand left.",
#:   "V2 was ahead of V1 on a four per cent upgrade. V2 decelerated at less than 0.15 g and stopped. V1 stopped some twelve feet behind. After approximately two seconds at rest V2 began to travel downgrade, rear first, with its operator facing forward. Contact took place at walking speed, V1 being stationary.",
#:   "I shouted at the screen. The lorry stops ahead of the dash cam, lovely, you couldn't do it smoother. Cammer stops, leaves a good gap. He's humming. Number plate of the lorry: you can't make it out. Now you can. Now it's all you can make out. Cammer's still humming! It has come the whole of that gap tail first, poor fella.",
#: ]
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: backing up; own code"
#: [slots]
#: actions = ["slow", "stop", "reverse"]
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 35.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.14
#: high = 0.22
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.5
#: high = 1.5
#: unit = "s"
#: meaning = "how long it stands"
#: [[parameters]]
#: name = "OPT_ADV_BACK_SPEED"
#: low = 0.8
#: high = 2.4
#: unit = "m/s"
#: meaning = "how fast it rolls back"

param OPT_ADV_DISTANCE = Range(10, 35)
param OPT_BRAKE = Range(0.14, 0.22)
param OPT_STOP_TIME = Range(0.5, 1.5)
param OPT_ADV_BACK_SPEED = Range(0.8, 2.4)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK_SPEED) for 6 seconds
    do Halt()
