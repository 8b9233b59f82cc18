#: description = "The motorcycle squeezes past the ego inside its lane and brakes in front of it."
#: rephrasings = [
#:   "A biker filters past our mirror, swings in ahead and brakes.",
#:   "The motorcycle split the lane, passed vehicle 1 and slowed in its path.",
#:   "PTW lane-splits by us, cuts back, brakes.",
#:   "The powered two-wheeler overtakes the VUT within the lane and decelerates ahead.",
#:   "The moto passes between us and the line, comes before us and brakes.",
#:   "A scooter threads by our door with inches to spare and chops its throttle.",
#:   "A courier on two wheels squirms through beside us and anchors.",
#:   "The rider shaves our flank, tucks in and jabs the lever.",
#:   "Some lad on a scooter threaded himself between me and the kerb, popped out under my nose and slammed his anchors on.",
#:   "Operator of motorcycle #2 passed Unit 1 on the left without leaving the lane, then decelerated sharply directly ahead of Unit 1.",
#:   "MC from rear, filters thru in our own lane, brake-checks us.",
#:   "A powered two-wheeler approaching from the rear shares the lane of the vehicle under test while passing, then applies its brakes ahead of it.",
#:   "Motorbike comes from back, goes by very near me in same lane, and after it he brakes.",
#:   "Repro: biker lane-splits past us from the rear (never leaves our lane), merges to centre and hits the brakes.",
#:   "He had been in her mirror a second ago; now he scraped past her door with an inch to spare and his brake light flared right in front of her.",
#:   "Watch that rider behind, he's going to filter up through your lane, and there, he's past your mirror and he's braking on you.",
#:   "bro this moped literally went thru the gap next to my door n then stopped short on me lol",
#:   "A motorcyclist slipped by the car without ever changing lanes and then pulled up sharply in front of it, witnesses said.",
#:   "Your Honour, the rider shared my client's lane as he went by, and no sooner was he ahead than he shut off his speed.",
#:   "This bike fellow came from back, adjusted himself between me and the divider, then simply put brake in front only.",
#:   "Them delivery riders, they shave your mirror going through and then have the cheek to slow down on you.",
#:   "In-lane passing by powered two-wheeler from the rear with subsequent deceleration ahead of own vehicle",
#:   "BIKER FILTERS PAST AND INSTANTLY REGRETS NOTHING - brake check!",
#:   "The motorcycle wriggles by inside our lane and clamps down ahead.",
#:   "Moped forces its way past us without leaving our lane, then stamps on the brake.",
#:   "Overtaken inside my own lane by a Vespa that promptly slowed up ahead.",
#:   "Biker brakes under our bumper right after wedging himself between us and the dashes.",
#:   "Zwischen-durch motorbike: same lane as me, past me, brake light in my face.",
#:   "Have a motorcycle share our lane to get by, slot in ahead, decelerate.",
#:   "I want a scene where a motorbike comes up from behind, slips through the narrow strip left in the ego's own lane, settles in front of it and hits the brake.",
#:   "According to the claimant, a motorcyclist rode alongside within the same marked lane, drew in ahead of the insured vehicle and abruptly reduced his speed.",
#:   "Ticket 4471: PTW tracked at 0.4 m lateral distance while going by in our lane, then centred itself before us and decelerated at 5 m/s²; planner reacted late.",
#:   "Never trust the gap at your side, because that's where a bike will come through, line up in front of your bonnet and suddenly knock his speed off.",
#:   "Mummy, the motorbike went by so close I could have touched him, in the same lane as us, and then he went in front and braked!",
#:   "In the reconstruction the two-wheeler gains on the AV, passes it with less than half a metre of clearance inside the lane, moves to the middle ahead and slows hard.",
#:   "I was in the queue on the ring road, doing perhaps forty, when a big touring bike came up behind. Instead of going round he forced himself between my door and the lane marking, pulled in before me and grabbed his front brake. My wife screamed.",
#:   "Dash cam, 17:42. You can hear the engine on the left before you see anything. The rider never touches the other lane, he just squeezes up along our flank, noses in ahead of the bumper and then his brake light is on and we're nearly in his panniers.",
#:   "The motorcycle had been following the robotaxi for some time. Without a lane change it wormed its way alongside, gained the space in front and there scrubbed off most of its speed, which left the robotaxi no choice but an emergency stop.",
#:   "With forty tonnes I don't see much down the side. First thing I knew, this dispatch rider was coming up between me and the kerb, in my lane mind you, then he popped across my front and braked. I stood on everything I had.",
#:   "Simulate a lane-splitter, please. Our car keeps to its lane at city speed; the motorcycle approaches from the rear, uses the leftover width of that very lane to get by, shifts back to the centre in front of us and applies its brakes sharply.",
#:   "Biker slides past inside our own lane, then sheds his speed ahead.",
#:   "Same-lane pass from astern by a moped, nose in front, brake light.",
#:   "Sneaks by between my wing and the paint, then loses pace before me.",
#:   "A Ducati arrived from the rear, used the spare metre of our lane to draw level, got its wheel in front and then dropped its pace right there.",
#:   "The rider shall catch up with the VUT, go by it without crossing any lane marking, take up a central position before it and apply service braking.",
#:   "Delhi style only: two-wheeler from the back, adjusting through my own lane, coming to my front and then suddenly pressing brake.",
#:   "Let the courier on the scooter come up from behind us, share our lane for a second to get by, line up before the bonnet and slow hard.",
#:   "Why would anyone thread a Harley past my door, both of us between the same two lines, and then ease it down sharply the moment he was in front?",
#:   "PASSENGER SCREAMS as motorbike comes from behind, shaves the mirror without leaving our lane, takes the spot ahead and stands it on its nose",
#:   "I heard the exhaust behind my left ear before I saw anything, and I remember folding my elbow in from the open window. There was a knee, a pannier, a number plate, all this within the two lines of my lane. Then the plate was straight ahead and the red lamp over it came on and stayed on while it grew.",
#:   "Claim 5512-K. Our policyholder's left-hand mirror was knocked flat by the handlebar of a motorcycle which came through from the rear in the very lane he was occupying. The rider then placed himself in front and reduced speed sharply; the policyholder, still looking at his mirror, touched the rear mudguard.",
#:   "I was eating my sandwich in the back of the robotaxi, not thinking of anything. It stopped so hard the lettuce flew. When I looked up there was a scooter in front with its brake lamp burning, and the lady beside me said it had just scraped by on our side of the line, from behind.",
#:   "Put it down to the heat, they'd been crawling since the bridge. The rider behind Unit 14 got fed up and forced a passage beside it, no lane change, just the eighteen inches between its flank and the dashes. Once he was ahead and centred he chopped his pace, and the coach had to do likewise.",
#:   "Look in your right-hand mirror. See that headlamp getting bigger? He isn't going out round us; he'll come through here, next to your door. There. Now what's he doing, he's in front of you and his tail light's on, so off the gas and brake, gently.",
#:   "The gap I had been keeping to the car ahead vanished in an instant. A police motorcyclist now sat in it, wheel straight, back brake glowing, and he could only have got there by coming up from behind through my own lane, for the next one was packed nose to tail.",
#:   "What came of it was a bruised collarbone from the belt. Before that, according to the logger, a PTW had closed from 20 m astern, run alongside with 0.35 m of clearance and all wheels of both vehicles between the same markings, slotted in at 5 m and decelerated at 6 m/s².",
#:   "The young fellow delivering pizzas did not even trouble to use the empty lane. He came up on us from the rear and pushed by in ours, so near that his box brushed the paint, settled himself before our radiator and, as though he had remembered something, throttled right back and braked.",
#:   "This is the bit in the podcast where I get angry. You're filtering, fine, you've come past me in my lane, fine, I made room. But why brake? Why get your back tyre dead in front of my bumper and then brake, with sixteen tons of gravel behind you?",
#:   "For run 12 we want the nasty filterer. Motorcycle behind the ego at the start; it closes in, does its pass in the leftover width of the ego lane, eases across to lane centre once its rear wheel is clear, then decelerates. The neighbouring lane stays untouched throughout.",
#:   "Mein Beifahrer cried \"Achtung\" but I saw nothing in the mirror any more. He was already at my side, this motorcyclist, in my lane with me, and one moment after he was before me. Then he made the brake and I also, so that the coffee was everywhere.",
#:   "Biker barges through on our side of the paint, then red lamp, too close.",
#:   "Handlebar at my window, same lane, then a number plate slowing under my nose.",
#:   "Have a two-wheeler use up our spare lane width, get ahead, scrub off speed.",
#:   "Lane-sharing moped, rear to front in two seconds flat, then its tail lamp glares and the robotaxi behind has to dig in too.",
#:   "The rider caught the ego up, wriggled along its side with both of them inside the same pair of lines, and hauled himself down right ahead.",
#:   "There was a metre left in my lane, he took it, from the back to the front, and once he was the first he closed the gas and pulled the lever.",
#:   "First a headlamp in the right-hand mirror, then an elbow at the passenger window, then, in the middle of our lane, a back tyre that wasn't going fast enough.",
#:   "Why should I leave room at my side, asked the cabbie, when the last chap I left it to came up through it and sat down hard on his brake in front?",
#:   "Subject vehicle yielded no lane; the motorcyclist nevertheless came by from the rear within that lane, centred himself ahead and shed his speed abruptly.",
#:   "My window was open and I got his exhaust in the face, that's how little there was between us. He had been tailing me since the pier. Neither of us crossed a line, there wasn't a need to, he is thin and so is my car. What there was a need for, a second later, was my brake, because his had come on a yard from my bumper.",
#:   "Engineer's ticket: the motorcycle left the rear radar and entered the side radar at 0.5 m, lane assignment unchanged at \"ego lane.\" It turned up in the front camera at six metres, laterally centred. Range then dropped though we weren't gaining speed; the rider was decelerating at 6 m/s².",
#:   "The policewoman asked which lane he had used to go round me, and I had to say none, dear, only mine. One minute he was behind. Then I felt a bump on the mirror, and then my shopping went off the seat, since he'd planted himself in front and stopped being in a hurry.",
#:   "The scratch runs along the whole left flank of Vehicle 1, from rear door to front wing, and both sets of tyre prints lie between the same lane markings. The brake-lamp filament of the scooter was hot at impact. Its rider had thus worked forward beside Vehicle 1 and been slowing in front of it.",
#:   "\"Mind the gap,\" my instructor said, and I thought he meant the one ahead. He meant the strip by my door. A Vespa had come up through it, still in our lane, and now it had popped in before us, and its little red eye was alight, so the gap ahead had gone too.",
#:   "For the PTW family we need the impatient one. He starts at the ego's back. The next lane is full, so he makes do with what the ego leaves of its own, comes level, gets by, settles on the centreline in front. When he has about a length in hand he throws out the anchors.",
#:   "Lorry driver to the tribunal: I've a camera on the nearside for exactly this. You see his wheel come up from the tail, never over the dashes, you see him hold his breath to get by the tank, and then the front camera takes over. That one shows his stop light on and my bonnet closing.",
#:   "What woke the baby was the horn, and what made me use the horn was a motorbike. I'd held my lane, I swear. He must have thought it was wide enough for two, and it just was, until he was past the headlamp. There he tucked in and clapped his brakes on as if a cat had run out.",
#:   "On our street in Pune it is daily only. Activa is behind you, no side lane is free, so he will take the left-over portion of your own lane, knee touching the door. Then he comes to the front, remembers some turning, and presses both levers. Your tea is on the dashboard.",
#:   "She knew that he was there by the sound, which had been at her back, and was at her shoulder, and was before her. It had not gone round; there was no room in the world for going round, only that ribbon of her own lane. Then the sound dropped, the lamp reddened, and the distance was eaten up.",
#:   "Dash cam comments, 312 of them, are all about whether two vehicles may share one lane. Fine, argue. The kid on the Grom went up my side without leaving it. What nobody mentions is the second half, when he's slotted in ahead and grabs the brake so that I stop with my plate over his rear tyre.",
#: ]
#: adversaries = ["motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "swerve", "brake"]
#: position = "behind"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.65
#: high = 2.1
#: unit = "m"
#: meaning = "how far beside the ego's line it passes"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 1.0
#: high = 5.0
#: unit = "m"
#: meaning = "how far ahead of the ego it is when it moves over"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_SWERVE = Range(1.65, 2.1)
param OPT_ADV_AHEAD = Range(1, 5)
param OPT_BRAKE = Range(0.5, 1)

behavior AdvBehavior():
    do DrivePath(advTrajectory, 11, globalParameters.OPT_SWERVE) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do SwerveOnPath(advTrajectory, 8, 0) until abs(offsetFrom(advTrajectory, self)) < 0.8
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 1
    do DrivePath(advTrajectory, 4)
