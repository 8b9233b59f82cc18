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
