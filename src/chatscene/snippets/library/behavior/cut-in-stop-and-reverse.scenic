#: description = "The car cuts in, stops in front of the ego and backs up into it."
#: rephrasings = [
#:   "A crash-for-cash scammer cuts us up, stops and comes back at us in reverse.",
#:   "Vehicle 2 merged ahead of vehicle 1, halted and then backed toward it.",
#:   "Cut-in, stop, reverses at us.",
#:   "The target cuts in before the VUT, comes to standstill and moves rearward.",
#:   "He drives before us, he stands, and then makes back gear until it touches.",
#:   "The van pulls across, halts and backs up to a loading bay.",
#:   "A taxi grabs our lane, overshoots its fare and reverses without looking.",
#:   "The bus moves in from beside, pulls up and shunts backwards.",
#:   "nutter carved me up, pulled up dead and then stuck it in reverse and came back at my bonnet",
#:   "The operator of the Ford cut off V1, halted, then intentionally backed into the front of V1.",
#:   "Truck: swoops in, full stop, R gear -> into our front.",
#:   "The target cuts in, decelerates to standstill and then travels rearwards towards the VUT until impact.",
#:   "The car comes before me, he stops, and then he goes backward against my car!",
#:   "Crash-for-cash actor: lane change ahead, v=0, then negative v until it hits the SUT's nose.",
#:   "It barged in before her and halted; then the white lights came on, and it rolled back until metal met metal.",
#:   "Caller says an ambulance pulled across in front of her, stopped, and then backed up into her bumper. Insurance scam if you ask me.",
#:   "he cut us off, stopped, and REVERSED INTO US im not even joking",
#:   "Driver accused of insurance plot after barring the way, halting and slamming his van backwards into a nurse's hatchback",
#:   "You moved in ahead, you stopped, and you then engaged reverse gear and struck my client, yes or no?",
#:   "Fellow overtakes the lane, stops in front and takes reverse directly on our bonnet, full fraud case",
#:   "Carves in, sticks it on the spot, then shoves it in reverse and comes for my radiator, that's a claim job if ever I saw one",
#:   "Lane intrusion, standstill and rearward motion toward own vehicle; staged-collision scenario",
#:   "INSURANCE SCAM: truck blocks me then backs into my car",
#:   "The sedan butted in, planted itself and rammed backwards.",
#:   "Barges in ahead, pulls up, then comes backwards into us.",
#:   "Lane change in front of VUT, standstill, rearward travel into VUT.",
#:   "Van: in front, dead stop, reversing lights, crunch.",
#:   "The bus got in our way and stopped and came at us bottom first.",
#:   "Who swerves in front of you, halts, then rams you in reverse gear?",
#:   "Let the ambulance slip over from the next lane, come to rest with its back doors at our bumper, and then drive rearwards at us.",
#:   "The front damage arose when the insured's adversary, having changed into her lane and brought his lorry to a stand, set it moving backwards.",
#:   "Reversing alarm beeping, the dustcart rolled back onto the AV, which it had moments before boxed in by changing lanes and halting.",
#:   "He enters my lane with force, he puts the car at zero, and then with marcha atrás he comes to hit my front.",
#:   "Be advised, caller reports a grey SUV pulled across her, stood there, and has now backed at her deliberately, possible staged accident.",
#:   "Three steps for the adversary: take the ego's lane from the side, brake down to nothing just ahead, then roll tail-first at the ego.",
#:   "I know what a swoop-and-squat is, I've driven a cab since 1988, but this was new. Passat whips over in front of me and anchors up, fine, I stop in time, no bump, so what does he do? Finds reverse and gives me one on the radiator.",
#:   "According to the narrative, V2 entered V1's lane from the left, slowed until it was no longer moving, and after a brief pause accelerated rearward. V1's driver sounded the horn to no effect, and the tow bar of V2 penetrated the grille of V1.",
#:   "It seems the coach driver had spotted his stop too late. He veered in from the lane beside the robotaxi, brought that great thing to a stand, and then, without so much as a glance in his mirrors, shunted it backwards with the robotaxi right behind him.",
#:   "Court heard how the defendant would select lone drivers, steer his hatchback into their lane a few metres ahead, halt it completely, and then throw it into reverse so that it looked as if they had hit him from behind.",
#:   "What I felt first was annoyance, because the police car had taken my lane and then come to a stop for no reason. The annoyance turned to fear when its white lamps came on and the boot began to grow in my windscreen.",
#:   "Pickup slots in, parks itself, then comes at us boot first.",
#:   "Jumped in ahead, stood still, rolled backwards into our grille.",
#:   "Artic from next lane: in, halted, then tail towards us.",
#:   "Police van swings across before me, anchors itself to the spot, finds reverse, and the next thing I hear is my own number plate cracking.",
#:   "Please model a fraudster's saloon that changes lanes to get before the ego, decelerates to rest and then drives backwards against its front end.",
#:   "Coach has boxed a Fiesta in by moving across, it's stopped, its white lights are on, and yes, he's now backing on to her.",
#:   "The lorry took my place in front, then stood, and then the beep-beep-beep began and the distance between him and me went away.",
#:   "No, constable, I didn't run into her; she nosed in from lane two, pulled up, and it was her towbar that came to my bumper.",
#:   "Give the hatchback three orders: get into the lane of the robotaxi from the side, come to a dead stand, then run tail-first into it.",
#:   "The photographs speak for themselves. My bonnet is stove in, yet my wheels had not been turning for several seconds. The other motorist had forced his way in from the adjoining lane and braked to a stop, I had stopped behind him, and it was at that point that his reversing lamps lit and he came back.",
#:   "Our episode tonight is about staged accidents. The textbook goes like this: pick a nice new car, come in from the lane beside it so that you're right in front, stop. If the mark's quick and doesn't hit you, never mind. Put it in R and hit him yourself, then jump out holding your neck.",
#:   "Poor Mr Osei, he is seventy-nine and drives like a bishop. A removal lorry shoved over in front of him from the other lane and came to a standstill, for no earthly reason that he could see. He waited behind it. And then, he says, that enormous roller shutter began getting nearer, by itself.",
#:   "Test 7b extends the cut-in family. After the lane change in front of the vehicle under test, the target brakes in lane until its speed is zero. Following this its direction of travel is reversed, and it moves rearwards at constant low speed for four seconds, closing on the stationary test vehicle. Contact counts as a fail.",
#:   "Bus driver overshot the stop, that's my reading. She'd whipped out of lane two into mine to get at the kerb, pulled up beyond the shelter, and instead of letting the folk walk ten yards she brought the bus backwards. With me behind it. In a Smart.",
#:   "The dent in the radiator was the end of the story; this is its beginning. We'd an ambulance running abreast, a little ahead. It edged into our lane, and I gave it room. It halted, and I halted. The crew, I believe, had overrun the house number, for in place of drive they now took reverse.",
#:   "What I expected after he had barged over and ground to a halt was for a door to open and some bruiser to climb out. Doors stayed shut. Instead I heard the gearbox whine, and the whole back of that Shogun, spare wheel first, came rolling towards me and pushed in my grille.",
#:   "Log 3315, unprotected AEB case. NPC changes lane into ours with a 6 m gap, v goes to zero, SUT stops 3 m behind, all fine. Then NPC velocity reads minus 2 m/s until the gap is nil. SUT just sits there because nothing in our stack thinks that a lead car can come back.",
#:   "My cousin in Pune had exactly same case. One tempo came from side lane to front of his car and put full stop there. Cousin also stopped, he was safe. Then this tempo fellow took reverse gear and came and banged the bonnet, and now is demanding money as if it is cousin's fault.",
#:   "Q. You say that you did not collide with the truck? A. The truck collided with me. Q. It was in front of you? A. It had just moved in there from the left lane, yes, and stopped. Q. Then how could it collide with you? A. In the only way it could, by going backwards.",
#:   "Let me set it up as a scene. Rain, a two-lane street, our car on its own. A police car comes over from the other lane and takes up position ahead, loses all its speed, and stands with its blue lights turning. Then the white ones come on as well, and it travels back until the bumpers meet.",
#:   "Over, halt, white lights, and my bumper's in his boot.",
#:   "Lorry took our lane, stood in it, beeped back into us.",
#:   "Bus: lane change, v zero, v negative, contact.",
#:   "We were stationary behind the ambulance that had just squeezed over in front of us, and then it was its back step that came to us.",
#:   "Have the van barge over from the side, sit there at zero, and afterwards drive tail-first towards the ego for about four seconds.",
#:   "I didn't rear-end that cab; it had shoved in, gone dead still, and after that it was he who shrank the gap, not me.",
#:   "He jumps before you from the other lane, he stops himself like a nail, and then comes with his back part to kiss your front part.",
#:   "Expected behaviour after the intruding pickup has braked to zero is that it stays or leaves; in this one it selects R and closes on us.",
#:   "The coach hadn't even indicated into our lane before it was at a stand in it, and now it's rolling its big rear window towards us, Sarge.",
#:   "First there was a space in front of me, then there was a police van in it, from the left, then it was a police van that wasn't moving. I left two metres. I've got a photo of those two metres. What happened next is that the reversing lamps lit up and the two metres went away, and I hadn't let my brake off.",
#:   "My daughter films everything, thank heaven. You can hear me say \"charming\" as the estate bulldozes into our lane. You can see its brake lights, and both of us at rest. What her clip then shows is its number plate getting bigger and bigger while the lamp post beside us stays just where it was. Crunch.",
#:   "Contact damage: front of V1, rear of V2. The initial assumption of a rear-end collision was not sustained. V1's wheels were locked and cold. V2 had arrived in the lane sideways from the adjacent one, had been brought to rest ahead of V1, and was in reverse gear with its rear axle driving at the moment of impact.",
#:   "Hark at the beeper, I said. My husband was too busy cursing the removal lorry, which had chucked itself across his path out of the lane alongside and then pulled up for no reason. But I know what beep beep beep means. It means that tail lift's on its way to your bonnet, and that's where it ended up.",
#:   "How the scam works: two lads in an old Passat draw up beside you on the dual carriageway. They nip in, close. They come to a full stop, so you come to a full stop, well done. You think you've passed. Then the passenger says \"now\", and the towbar's through your radiator and they want four grand.",
#:   "We had no room for going back, there was a bus behind us. The truck has come from the right lane to our lane and there he has put himself still. My colleague said, he will search an address. Then we see white light and we make horn, horn, horn, but he comes with his backside until it makes crack.",
#:   "The AV did everything correctly. It yielded when the SUV forced its way over, it stopped when the SUV stopped, it kept 2.8 metres. It even sounded its horn as the 2.8 became 1.5 and the 1.5 became nothing, the SUV's back wheels turning the wrong way all the while. The only thing it can't do is evaporate.",
#:   "\"Somebody's in a hurry,\" thought Miss Pym, as the bus heaved over out of the lane beside hers and shut off her view. \"Or perhaps not,\" as it subsided to a complete halt. She had opened her crossword by the time its engine growled afresh; and it was not until the advertisement on its stern touched her bonnet that she shrieked.",
#:   "Line 4 of my statement should read as follows. The silver hatchback had been on my right. It was then ahead of me, and slowing, and then it was ahead of me and not moving at all. I was not moving either. It was then, under its own power, underneath my front bumper, going the wrong way.",
#:   "You're in the seat, what do you look for? He's barged across you, that dustcart, and now he's standing there. Everybody looks at the brake lights. Look at the ones next to them. If those come on white, he's not finished with you, he's coming your way, arse first, and he can't see you. There. See?",
#:   "robotaxi ride review, one star, not its fault. a dodge carves over from the next lane, parks his tailgate six feet off our nose. we sit. he doesnt get out. his tailgate comes to five feet, four, three, im screaming at a car with no driver to back up and then theres a thump",
#: ]
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cut-in", "stop", "reverse"]
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
#: low = 6.0
#: high = 15.0
#: unit = "m"
#: meaning = "how far its rear is ahead of the ego's front before it moves over"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 0.9
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_BACK_SPEED"
#: low = 0.6
#: high = 1.8
#: unit = "m/s"
#: meaning = "how fast it backs up"

param OPT_ADV_DISTANCE = Range(0, 30)
param OPT_ADV_AHEAD = Range(6, 15)
param OPT_BRAKE = Range(0.4, 0.9)
param OPT_ADV_BACK_SPEED = Range(0.6, 1.8)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 4
    do DrivePath(egoRoute, 7) until abs(offsetFrom(egoRoute, self)) < 1
    do BrakeOnPath(egoRoute, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do ReverseStraight(globalParameters.OPT_ADV_BACK_SPEED) for 4 seconds
    do Halt()
