#: description = "The oncoming pedestrian comes along the road edge, enters the lane without warning and suddenly stops."
#: rephrasings = [
#:   "A person walking against the traffic steps into the lane and freezes.",
#:   "The pedestrian approaches from ahead, veers into the ego's way, and stands still.",
#:   "Someone who walks toward the ego slips into the carriageway and halts there.",
#:   "Facing the ego, the walker moves into its path and comes to a standstill.",
#:   "The jogger running toward the vehicle swings into the lane and stops dead.",
#:   "this guy walks toward us along the edge, steps out and just stands there",
#:   "A pedestrian walking against traffic entered the lane and stopped.",
#:   "walker facing us, steps in, halts",
#:   "A cyclist coming towards me along the verge wandered into my lane and stopped dead in it.",
#:   "The pedestrian was walking along the shoulder facing traffic, abruptly stepped into the lane and halted.",
#:   "Ped on edge, facing ego, steps into lane, stands.",
#:   "The cyclist target approaches along the carriageway edge, enters the VUT's lane without signalling and comes to a sudden halt.",
#:   "A man comes on the border of the road in my direction, suddenly he comes in my lane and stays standing.",
#:   "Oncoming VRU on the shoulder turns into our lane and freezes; no crossing afterwards.",
#:   "She had been coming up the edge of the road; then she stepped out before him and stood stock-still.",
#:   "Watch that moped coming up the edge towards you, he's swung in front of us and stopped!",
#:   "this guy walking towards us on the side just stepped in and STOOD there",
#:   "A pensioner approaching on the roadside turned into the lane with no warning and came to a standstill.",
#:   "She had been coming toward you at the margin of the road, she entered your lane, and there she stopped?",
#:   "One cyclist coming opposite side by the edge, suddenly came inside my lane and stopped, no warning.",
#:   "He's coming up the gutter to meet me, next thing he's in my lane and stopped like a lamp post.",
#:   "Unannounced lane entry and halt by oncoming road-edge user.",
#:   "MAN WALKING TOWARD ME STEPS INTO LANE AND FREEZES",
#:   "The oncoming moped rider left the edge and rooted himself in our lane.",
#:   "Old man facing us on the verge steps in, stands fast.",
#:   "Scooter coming up the gutter towards me veers in and halts.",
#:   "Oncoming VRU along edge: unsignalled lane entry, immediate standstill.",
#:   "Why would someone walking towards you step in and just stop?",
#:   "Lad pedalling our way along the edge swung in, then froze.",
#:   "I'd like a jogger to come towards the ego along the side of the road, turn into its lane without a glance, and halt there at once.",
#:   "The cyclist was approaching at the carriageway margin; she came off it into the claimant's lane unexpectedly and stayed where she was, one foot down.",
#:   "He was coming towards the AV on the hard shoulder, this motorcyclist, and without notice he pulled into its lane and put his feet down.",
#:   "A grandmother is walking in front direction on the border, all of a sudden she comes inside of our lane and she stands.",
#:   "Heads up, there's a male on foot coming against traffic on the fog line, he's stepped into the lane now and he's just standing.",
#:   "Unlike somebody crossing, the walker who met us along the roadside took two steps into our lane and there ended his journey.",
#:   "I noticed the woman with the pram quite early, because she was coming along the very edge of the road towards me. What I could not foresee was that she would turn the pram into my lane, and then stop with it, as if the thing had locked.",
#:   "The two-wheeler moves along the border of the carriageway in the direction opposite to the vehicle under test. At a given separation it alters course into the lane, giving no signal, and comes to rest there. It does not continue to the far side.",
#:   "A tricky one for the lads at the depot. Bloke on a moped was coming down to meet my wagon, right over by the kerb, not bothering anyone. Next second he'd wobbled out into my lane, grabbed a fistful of brake, and was sat there staring at me.",
#:   "My dog and I saw it all from the gate. A young man with those headphone things was marching along the verge, facing the cars, as one should. For no reason at all he walked off the verge into the path of the blue car and stood like a scarecrow.",
#:   "cyclist was on the wrong side hugging the kerb coming straight for me which is bad enough, then he turns INTO my lane no look no nothing and slams his brakes. just stops there with his phone out, i had to leave half my tyres on the road",
#:   "Moped hugging the kerb towards us cuts in and parks itself.",
#:   "Jogger approaching along the edge darts into lane and locks up.",
#:   "Cyclist head-on at roadside, sudden entry, dead stop in lane.",
#:   "An old chap shuffling towards us along the gutter took it into his head to step in before our bonnet, where he came to a full stop.",
#:   "The two-wheeler shall come from ahead on the shoulder, then bear into the lane of the ego with no sign given and brake to zero in it.",
#:   "Down the edge of the road towards me comes a Deliveroo lad, and for no reason that I can think of he veers in and just stands there.",
#:   "Runner, against the traffic, right on the verge, nothing strange; then with a single sidestep she is on my line and doesn't run any more.",
#:   "La señora came by the edge in the direction to me, with her bag, and without to look she put herself in my lane and froze like ice.",
#:   "Attention, there's a kid on a BMX who was riding towards you by the kerb, he's gone into your lane unannounced and he's halted there.",
#:   "I'm sixty-four and I've driven a school minibus for half of it. They walk along that bit of road towards you, single file, heads down. Always have. This one lad left the line, came into my lane and was a statue, that's what I said at the time, a statue with a rucksack. I'd no idea it was coming.",
#:   "The pedestrian, facing traffic as the Highway Code advises, was proceeding along the margin of the carriageway. The driver had her in view for some two hundred metres. At twenty metres the pedestrian altered direction, entered the driver's lane and there halted. No reason was given, and none is apparent from the recording.",
#:   "There was no pavement, so you do expect someone coming towards you on the side. What you don't expect is the turn of the handlebars. The man on the moped turned them when we were nearly on him, which put him in our lane. And then, instead of getting out at the other end, he stopped.",
#:   "Before the collision test the rider dummy is moved, at walking speed and opposite to the VUT, parallel to the lane and outside it. At the trigger it is steered on a slanting line into the lane. It reaches standstill inside. There's no second movement, and no light or arm signal precedes the first.",
#:   "I'd call it the letterbox problem. An old gent's coming up the edge of the lane to meet you. The letterbox is on your side of him, he has just remembered his letter, and so you get him in your lane, not across it, in it, patting his pockets and going nowhere. So yes, he's stopped, and you should have.",
#:   "In the picture you have the dead leaves at the side of the road, and, in the leaves, two wheel tracks running towards the camera. They leave the leaves and go in an angle on to the asphalt. The next photograph shows the motorcycle upright in the car's lane, its rider's foot on the ground. That's where it had stopped.",
#:   "He's walked this road for his paper every morning of his life, facing the cars, on the grass. I waved. He must've thought that I wanted something, as he came off the grass at once, right into where I was driving, and stood there waiting for me to say it. I missed his knees by a yard.",
#:   "Bike path closed, so she came along the edge against us. Class: cyclist, heading: opposite, lateral offset: 2.1 m. Three frames on the offset was 0.4 m. Another three and her speed had dropped to nothing. From that moment we had a stationary cyclist in our lane. No hand signal could be made out in the video.",
#:   "Two hundred metres of nothing, then a figure at the roadside growing larger, a hiker, walking to meet us with a stick. She thought of offering him a lift. He can't have wanted one, for when they were quite close he drifted off the verge and into their track, planted the stick, and looked at the sky.",
#:   "yo so delivery robot person here. street test today. jogger coming AT the car on the shoulder, music in. then he hops into our lane, no look, and im like ok he's crossing. nope. dead stop. starts tying his shoe in front of a two ton SUV. safety driver aged ten years",
#:   "Every evening I see the milkman on his cycle, coming opposite at extreme side of road, I also give him way. That day he suddenly came inside into my lane, no hand, no bell, and applied brake and stood there with one leg down. My car stopped one foot from his milk can.",
#:   "Facing us on the verge, then facing us, rooted, in-lane.",
#:   "cyclist opposite in the gutter then our lane then feet down",
#:   "Walker nearing at the edge sidesteps in, turns statue.",
#:   "The woman with the pram, who'd been coming our way beside the hedge, was now in our lane with her brake on, just like that.",
#:   "Let a moped putter towards the ego along the very rim of the road, veer into its lane with no hint, and stand there.",
#:   "Nothing on the left edge any more where the runner had been approaching; a pair of running shoes, side by side and unmoving, right before our bumper.",
#:   "What makes a man who's been walking to meet you on the hard shoulder step across into your lane and then just not go on?",
#:   "Hiker nears the VUT along the road's margin, deviates into its path unheralded, and remains motionless in there after a pace or two.",
#:   "The bicycle came in front of me at the border, quiet, then it is in my voie without to warn, and it does not roll more.",
#:   "What she'd done so far was what they teach at school: no pavement, so walk at the side, face the cars. I had her down as sensible. And that sensible girl, with me some fifteen yards from her, was suddenly two yards to the left of where she'd been, in my lane, and had stopped walking.",
#:   "The chestnut seller's brazier had rolled away, that's what he told the constable. All that I'd known was a man coming along by the ditch, towards my lorry, at a good stride. The stride took a turn, it brought him in front of my radiator, and there it ended, no more strides, him with his hands on his knees.",
#:   "Track 31. Class bicycle, distance 48 m, moving against us, clear of our lane by 80 cm. Nobody brakes for such a thing and we didn't. Distance 20 m, and the 80 cm have become minus 90; no arm out, no glance. Distance 14 m and its speed's zero. Distance remains an issue for the brake team.",
#:   "The bell of the ice cream van does it, I'm convinced. The lad had been scooting up the gutter at us, minding the drains. Ding, and he was in the middle of my side of the road with one foot on the ground, listening for it. Didn't look, didn't cross. I'd to stop with my bumper over his front wheel.",
#:   "Everyone in the minibus had seen the old gent, he was coming along the edge of the road to meet us, flat cap, stick. Then came a hiss from the driver, a jolt, and from my seat in the back I couldn't see the old gent at the edge any longer. I saw his cap, over the bonnet, dead centre, and it wasn't moving.",
#:   "Sudden, yes, but read the signs. She's coming at you on the shoulder on a heavy motorbike, she's slow, and her eyes are on the petrol station behind you. There: no blinker, and she has dropped into your lane. Now you'd think she'd hurry over. She's stalled it, or funked it, either way those wheels have stopped.",
#:   "Two blows of the horn are audible. According to the driver the first was meant for the jogger who, after running along the roadside in his direction, had slipped unannounced into the lane. The second was meant for the same jogger, who, so far from leaving the lane by either side, had ceased running and was standing in it.",
#:   "Me and Tito were out of juice so I was pushing the moped home up the road on the side where you see the cars come. I thought I'd get round a puddle. So I went onto the road a bit. Then I saw the truck and my legs locked. I couldn't go in, I couldn't go out. That's all.",
#:   "Why the test is hard: as long as the dummy approaches outside the lane, parallel to it, no alarm is justified. Its entry, at a shallow angle and without a signal, leaves little time. And whoever counts on its leaving again by virtue of its momentum, as crossers do, is mistaken, for it's brought to a halt inside.",
#:   "A road that's empty but for one mushroom picker with a basket. He comes towards us on the grass edge, whistling. I tell my wife, look, he has ceps. At this word the ceps are in the middle of our lane, in the basket, on the arm of the picker, who stands like he had grown there in the night.",
#:   "The tyre marks on the tarmac are mine; the hoofmarks, so to speak, are hers. You can follow the prints of her wet trainers along the gutter, toes pointing at where I came from. They bend. Two more prints, inside my lane. Then two side by side, very clear, because she'd stayed on them till the ambulance was called.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior", "advFacing"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "stop"]
#: position = "oncoming"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 3.0
#: high = 20.0
#: unit = "m"
#: meaning = "distance to the ego at which it enters the lane"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.6
#: high = 1.0
#: unit = "rad"
#: meaning = "how sharply it turns into the lane"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 1.0
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_SPEED = Range(1.5, 4)
param OPT_ADV_DISTANCE = Range(3, 20)
param OPT_ADV_ANGLE = Range(0.6, 1)
param OPT_STOP_DISTANCE = Range(0, 1)

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do Halt() until gap(self, ego) < 2 * globalParameters.OPT_ADV_DISTANCE + 6 * max(0, abs(offsetFrom(egoRoute, self)) - 4) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE + 6 * max(0, abs(offsetFrom(egoRoute, self)) - 4) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
