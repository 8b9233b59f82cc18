#: description = "The car moves over in front of the ego and then drives very slowly."
#: rephrasings = [
#:   "Someone slides in ahead of us from the next lane and then just dawdles.",
#:   "Vehicle 2 changed lanes in front of vehicle 1 and proceeded at well below the traffic speed.",
#:   "Adjacent veh cuts in, then slow travel.",
#:   "The target merges ahead of the VUT and continues with a low constant speed.",
#:   "It comes in our lane before us and goes like a snail after.",
#:   "A tractor unit noses across our bonnet and trundles on.",
#:   "The bus wanders over from beside and then holds us all up.",
#:   "A motorcyclist slots in before us only to potter along.",
#:   "so this bus shoves its way in ahead of me and then trundles along at a dead slow pace, cheers mate",
#:   "V2 merged into V1's lane immediately ahead, after which it traveled at an unreasonably slow speed.",
#:   "Truck changes into our lane, then dawdles 5 km/h. No halt.",
#:   "Following its lane change ahead of the VUT, the target continues at a residual speed of 10 km/h.",
#:   "The car comes in my lane before me and after he is slow like a tractor.",
#:   "Actor merges ahead, then holds a creeping velocity so the SUT gets stuck behind a moving plug.",
#:   "The patrol car slid across before them and then, having won its place, ambled on at the speed of a funeral.",
#:   "Typical: fights to get in front of you and, now he's there, he potters. Just dawdling along at walking speed.",
#:   "he pushes in front of us and THEN decides to go 3mph, make it make sense",
#:   "Having elbowed its way to the front, the bus then held up the line at a stroll, witnesses said",
#:   "You were in haste to get before him, Mr Cole, and yet once there you practically stood still, though you kept moving?",
#:   "Cut already then drive like bullock cart in front, what is this man",
#:   "He's desperate to be in front of me and once he's there he's got all day, dawdling like he's window shopping",
#:   "Lane intrusion ahead with persistent low residual speed",
#:   "Truck squeezes in, then goes SLOWER THAN WALKING",
#:   "The motorbike muscled in and loitered along.",
#:   "Coach nudges into our lane and we're down to walking pace behind it.",
#:   "Lane change in front of VUT, thereafter rolling at 8 km/h.",
#:   "Van took the gap before us only to mope along like treacle.",
#:   "From the next lane a fire engine moves over and goes dead slow.",
#:   "Now following at a snail's speed: the cab that had just barged in.",
#:   "A lorry from the lane beside you pulls across in front of your bonnet, and from then on it grinds along so slowly that the speedo hardly moves.",
#:   "Insured states that the third party, until then in the adjacent lane, filtered in immediately ahead and then persisted at little more than walking speed.",
#:   "Please let the neighbouring minibus switch to the ego's lane shortly before it and from there on roll forward at about 2 m/s, without ever standing still.",
#:   "I was stuck doing four miles an hour because a hatchback which had been running level with me had helped itself to the space in front.",
#:   "She indicates, she moves across in front of us, fine, and you'd expect her to keep up with traffic, but no, she dribbles along with everyone piling up behind.",
#:   "Monsieur comes from the lane at side, puts himself before my capot, and after he advances like a turtle, I cannot explain why.",
#:   "We were side by side past the garden centre, me and this horsebox. All of a sudden it shifted over into my lane, right at my nose, and from there to the roundabout it went no faster than my grandmother walks. It never did stop, it merely crept.",
#:   "The HGV occupied the lane to the right of the AV. At the marked position it shifted left into the AV's lane with a gap of six metres and continued at a very low residual speed, so that the AV was obliged to follow at a crawl.",
#:   "Title says it all, but for context: motorbike beside me, loads of room, chooses my lane, plonks himself just ahead of my front wheels and then putters along as if he was looking for a house number. Followed him like that for half a mile.",
#:   "My daughter said he must be lost. He had been in the other lane, next to us, and then the big taxi came over in front of our car and went ever so slowly, rolling along with his hazard lights off, and I could only trundle after.",
#:   "Test case: slow plug after a lane change. The actor starts in the adjacent lane; it merges ahead of the subject vehicle with little margin and then keeps to a speed far below the limit for the rest of the run. No standstill is wanted.",
#:   "Swaps into our lane, front of queue, and tootles at jogging speed.",
#:   "The neighbour steers before our nose and proceeds at ten kilometres an hour.",
#:   "Grabs the gap in front of me, then it's tortoise time.",
#:   "An ice-cream van that had been level with us shifted across into the space ahead, and the rest of the afternoon was spent looking at its slow back doors.",
#:   "The vehicle in the next lane claims the ego's lane at close range and subsequently maintains a residual velocity so low that traffic bunches.",
#:   "4-6 to base, marked car has moved across out of lane two ahead of the subject vehicle and is now leading it along at a crawl.",
#:   "I am not against changing lane, but who comes to my front from the side and after that rolls like a wedding procession?",
#:   "Make the lorry alongside drift over to a spot right before the AV and then just toddle, five or six miles an hour, wheels always turning.",
#:   "On being asked why he had slid over from the other lane when he meant to do barely walking pace, the cabbie said he was looking for a fare.",
#:   "The needle in my car hung about the seven for so long that I thought it had broken. Nothing broken, just a horsebox before me. A minute earlier it had been in the lane to my right, next to my window, and it must have wanted mine very badly in order to go nowhere in it.",
#:   "We missed the ferry on account of a pensioner in a Micra. She'd been keeping us company on the left. For no earthly reason she came over, neatly I admit, into the few yards I had before my bumper, and from there to the harbour she did not once exceed a trot.",
#:   "Subject vehicle was northbound in lane 2, V2 northbound in lane 1 and abreast. V2 entered lane 2 at a distance of about fifteen feet ahead of the subject vehicle. Its speed over the following block, per the transit camera, averaged six miles per hour, and it did not come to rest.",
#:   "Ever had your view of the road replaced by a coach's engine lid? It'd been a row of windows at my side, a moment later it was a lid, hot and close. And then you wait for it to pull away with the traffic and it doesn't, it just rumbles forward about as fast as a milk float.",
#:   "Instructor's diary. Told Priya to expect the gap ahead to be taken, and taken it was, by the moped running next to us. What she hadn't reckoned on is that it would then dawdle along there at ten. First gear, clutch, first gear, clutch, all the way to the test centre.",
#:   "Reporting the following. Speed limit 60, own speed 58, clear road before me. Fire appliance in right-hand lane puts itself into mine, six metres ahead of the bull bar. Thereafter it is rolling along with barely 12. No blue lights, no breakdown, I had thirty cars behind me.",
#:   "It was the quietest traffic jam I was ever in, and I was at its head, or second. A hearse, which had been gliding beside me in the other lane, glided sideways until it lay in front of me. Then, naturally, it kept to the pace for which hearses are built.",
#:   "Yaar, this school bus was going parallel. Suddenly driver puts it across my front, hardly one scooter length left, okay I have adjusted. But after coming he is not driving, he is strolling, children are making faces at me from back window and I am in first gear only.",
#:   "My brother timed it on his watch while I drove. From the moment the pickup came across out of the outside lane to the moment it left the road we covered half a mile, and that took four and a half minutes. It kept rolling, mind; I kept looking at the same bumper sticker.",
#:   "Requirement: planner shall not assume that a vehicle merging ahead intends to travel at flow speed. Stimulus: target alongside in the adjacent lane merges with short headway, then goes on at 2.5 m/s with no halt. Observe whether the ego closes in, hunts, or settles behind it.",
#:   "In the novel of my life that motorbike would get a chapter. It wanted to be where I was going to be, and it leaned over out of its own lane until it was there, a hand's breadth off my grille. And having arrived it lost all ambition, and puttered, and I puttered behind it, through the entire town.",
#:   "Came across into our lane up front, then inched along forever.",
#:   "From next door to our nose, then seven miles an hour.",
#:   "He takes our lane and we take root behind him, nearly.",
#:   "The bus moved out of its lane into ours with a yard to spare and then behaved as if petrol were rationed, rolling at a trot.",
#:   "Instead of a clear road we had the back doors of a van which had slid over from the side and which now moved no quicker than a pram.",
#:   "Third gear, second, first: that was the price of letting the cab next to us step over into our lane ahead.",
#:   "The target changes to the VUT's lane at a headway of 0.6 s; after completion its speed is 2 m/s, held, standstill excluded.",
#:   "If someone's that keen to have your bit of road, dear, he'll surely use it, I thought, but the coupe that had edged over before me merely trickled along.",
#:   "It was not a breakdown, officer; the horsebox had come over from the neighbouring lane under its own steam and kept dribbling forward.",
#:   "You could follow on foot, and in the end our conductor did. The trouble started when the lorry that had been keeping beside the tram-bus leaned over the dashes and became the lorry in front. No brake lamps, no hazards. Its wheels turned as slowly as a mill's, and behind it ours did too.",
#:   "The arrival estimate on my robotaxi's screen said four minutes. Then a wing, a door, a tailgate slid over from the lane to our left and filled the windscreen, and the estimate said six, nine, fourteen. We hadn't stopped. We were rolling behind that tailgate at a speed at which one can count paving slabs.",
#:   "Sergeant, I kept hoping he'd either go or stop. It was a fire engine, no blues on, that had been on my outside. In it came, ahead of me, not a lot of room. From there to the depot, three quarters of a mile, I had time to read the phone number, the crest and the motto on its back.",
#:   "Some riders take your lane in order to go faster. This fellow on the chopper, who'd been alongside, took mine in order to pose. He leaned it over till his exhausts were a yard from my grille, and after that the speedometer on my side said nine. It went on saying nine all along the sea front.",
#:   "Claim: the policyholder's radiator boiled over. Cause: nineteen minutes in first gear. Reason for the first gear: a car with a trailer, initially level with him in the other lane, had transferred to his own directly ahead, and travelled on without a halt at what a passing walker called \"our speed.\"",
#:   "The following gap, set at two seconds, had to be rebuilt from three metres after the neighbour claimed the lane. This took the ego down to 15 km/h. One would have expected the gap to open as the newcomer picked up pace, but it wouldn't; the newcomer went on at 8, and the ego ended at 8 as well.",
#:   "\"Is it a parade?\" asked my son. We'd had an open road and a coach beside us. Now we'd the coach in front of us, it had come over like a door closing, and the people on the pavement with their bags were going past us. The coach's wheels did turn, if you watched one nut you could see it.",
#:   "There is a special loneliness in being second. She had been first, with nothing but road, and a taxi for company on her right. The taxi had crept sideways across the line until it stood, no, not stood, moved, but moved like honey, in front of her. Behind her somebody began to sound his horn.",
#:   "Watch the milk float, because it's faster than the chap I mean. He's in the SUV that was at your side; I told you he'd come in, and in he's come, close. And having made us give way, what does he do with it? Eight miles an hour, if that. Just crawl after him, don't sit on his bumper.",
#:   "I have done the calculation, sir. Distance to my office 1.2 kilometre, time taken eleven minutes, so average six and half. Reason is one tempo which was going parallel. He took my lane from the side, putting his back in my face, and afterwards he was going like he is carrying eggs, never halting, never increasing.",
#:   "Dash-cam title \"He needed that gap SO BADLY.\" At 0:09 the ambulance, not on a call, is on the left edge of the screen. At 0:11 it's the screen. Skip to 3:40, it's still the screen, and the same lamp post takes about a minute to go by. No it never actually parks, I keep waiting for it to.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "UN R157 cut-in; own code"
#: [slots]
#: actions = ["cut-in", "slow"]
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -10.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 4.0
#: high = 12.0
#: unit = "m"
#: meaning = "how far its rear is ahead of the ego's front before it moves over"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.8
#: high = 3.3
#: unit = "m/s"
#: meaning = "how fast it drives in the ego's lane"

param OPT_ADV_DISTANCE = Range(-10, 25)
param OPT_ADV_AHEAD = Range(4, 12)
param OPT_ADV_SPEED = Range(1.8, 3.3)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED)
