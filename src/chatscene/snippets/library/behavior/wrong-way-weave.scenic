#: description = "The oncoming car weaves about in the ego's lane, against the traffic."
#: rephrasings = [
#:   "some drunk is coming up our lane, all over the place",
#:   "Vehicle 2 was travelling the wrong way and weaving within the lane of Vehicle 1.",
#:   "wrong-way, zigzag, our lane",
#:   "The target approaches in the lane of the VUT against its direction on a sinuous course.",
#:   "A bicycle comes in contrary direction and makes slalom on our lane.",
#:   "A cyclist wobbles toward us on the wrong side of the road.",
#:   "The biker snakes up the ego's lane head on.",
#:   "Swinging to and fro, an intoxicated motorist bears down on us on our own side.",
#:   "Someone was coming at me on my side of the road, wandering all over it as if he'd had a skinful.",
#:   "Wrong-way driver was observed drifting from edge to edge in Unit 1's lane, possible DUI.",
#:   "Cyclist in our lane, wrong dir, zigzag.",
#:   "The target vehicle travels counter to the permitted direction in the test vehicle's lane with lateral oscillation.",
#:   "A motorbike comes against me on my lane and goes left, right, left.",
#:   "Head-on actor snakes inside our lane, stays in it, moderate speed.",
#:   "It came towards them on their own side, reeling from edge to edge, so that they could not tell which way to dodge.",
#:   "There's a drunk on a bike coming the wrong way up your lane, he's all over it, I can't tell which side he'll pick.",
#:   "this car is on the wrong side coming at me swerving like hes texting",
#:   "A car on the wrong side of the road lurched from edge to edge as it neared other motorists.",
#:   "He was where he had no right to be, in my client's lane, and he could not hold even that in a straight line.",
#:   "One cycle is coming wrong side in my lane, swaying this side that side.",
#:   "On my side, facing me, and tacking about like a yacht.",
#:   "Counterflow travel in own lane with unsteady lateral course",
#:   "WRONG SIDE AND ALL OVER THE PLACE - drunk driver?",
#:   "The wrong-way cyclist zigs and zags down our lane.",
#:   "Wrong-way scooter approaches, snaking about within our lane.",
#:   "Cyclist comes at us in our lane, wandering side to side.",
#:   "Ghost driver, our lane, serpentine course, distance closing.",
#:   "HEAD-ON DRUNK: car in my lane, swaying left and right",
#:   "Have a motorbike slalom toward the AV inside the AV's lane.",
#:   "The hatchback was where it shouldn't be, coming up my side, and it rolled from one edge of my lane to the other.",
#:   "The opposing target travels in the lane of the VUT contrary to its permitted direction while oscillating laterally between the lane boundaries at a moderate speed.",
#:   "He's in our lane and coming this way, the lad on the bike, and he can't keep it straight: kerb, middle, kerb, middle, all the way.",
#:   "It is a motorcycle against us, on our own side, and it makes like a fish, to right and to left, one doesn't know where to pass.",
#:   "A man who had been riding his bicycle the wrong way, and in wavy lines at that, along the lane of oncoming motorists was fined on Tuesday.",
#:   "which side do i go when the taxi thats facing me in my lane swerves to the left one second and to the right the next??",
#:   "I was on the lake road, in my own lane, when headlights came up it from the wrong end. The car wouldn't hold a line. It swung over to the bank, back to the centre marking, over to the bank again, always on my side and always nearer.",
#:   "V2 had crossed to the wrong side of the road some seventy metres before and was proceeding toward V1 within V1's lane. Its course was sinuous, with three complete swings between the edge line and the centre line, which its driver ascribed to having fallen half asleep.",
#:   "To make the head-on case harder, the counterflow car does not drive straight. It stays in the lane of the robotaxi, it faces the robotaxi, and the whole time it wobbles across the width of that lane, so that neither side offers a dependable way out.",
#:   "Right, slow right down, this is a bad one. That moped oughtn't to be in your lane at all, he's coming up it the wrong way, and look at him zigzag. Don't try to guess which side he will be on, because he doesn't know himself.",
#:   "We were nearly at Granny's when a lady on a bike came towards us on our side and not on hers. She had a dog on a lead and the dog kept pulling, so she went wibble-wobble from here to there in front of us, right up our lane.",
#:   "Head-on moped, our lane, wobbling rim to rim.",
#:   "Contraflow cyclist snakes up our half, no telling which side.",
#:   "Saloon on the wrong side meets us in wavy lines.",
#:   "A motorbike was on my half of the road, coming at me, and it slopped about between the lines like water in a tray.",
#:   "Opposing target travels counter to traffic inside the ego lane and follows a sinusoidal path whose amplitude spans most of that lane.",
#:   "What do you do with a bicycle that's in your lane, facing you, and lurching about so that neither left nor right looks safe?",
#:   "Wrong side he is coming in my lane, that Bullet fellow, and not even straight, like a kite without a tail he is going.",
#:   "I'd like a hatchback head-on in the robotaxi's own lane, against the flow, yawing to one side and the other the whole way up.",
#:   "Caller's got a sports car heading into traffic in his lane, can't keep a course, one moment it's by the kerb, the next by the paint.",
#:   "I looked left and there he was; I looked right and there he was too. That's what comes of meeting a cyclist in your own lane, coming against you, who rides from the gutter to the white line and over to the gutter again. So I stopped and prayed, and let him choose.",
#:   "Examination of the footage puts V2 in V1's lane, opposing V1, for the final four seconds. During that time its headlamps are seen to swing from the edge line toward the centre line and back on three occasions. The operator of V2, who had consumed a bottle of wine, believed he was on his own side.",
#:   "Don't steer round him, whatever you do. That scooter has no business in your lane, he's coming up it against you, and see how he reels? If you go to the outside he'll be at the outside, if you go to the inside so will he. Stop, lights on, and stay in your seat.",
#:   "Papa said a word in Spanish. There was a car in front of us on our side, and it looked at us, and it came like a snake comes, a bit here and a bit there and a bit here. It wasn't far away any more. I held the cat's box tight.",
#:   "The head-on variants so far hold their line, which is generous of them. In this one the cyclist comes against the traffic in our lane and, moreover, serpentines: two metres of lateral swing, about three seconds per cycle. He remains inside our lane, so there is a face, but no fixed place for it.",
#:   "A ribbon, said the woman at number six, as if somebody had laid a ribbon along the lane that the bus was in and the motorbike had to follow each curl. It was coming to meet the bus, on the bus's side. She couldn't look. She heard the air brakes and a voice singing.",
#:   "I had a drunk on my side last night. He was on the wrong half, nose to nose with my wagon, in an estate with one headlamp. And that one headlamp went tick-tock like a metronome, right edge of my lane, left edge of my lane, all the way up to where I'd managed to stop.",
#:   "The trajectory set of the oncoming object fans out over the entire width of the ego lane, and rightly so. It's a bike going the wrong way there, toward us, and within each two seconds it visits both boundaries. No evasive path was rated safe, so the vehicle braked to a stop, which we consider correct.",
#:   "It's the lamp I would paint, if I painted. It was in our lane, where there should have been only darkness, and it was coming; and it swayed, now to the wall, now to the crown of the road, now to the wall, as though carried by a drunken watchman. It belonged to a small car.",
#:   "In the holidays I have met a Dutch lady on her Hollandrad. She was on my side of the street, against me, because in her country it would be, I don't know, romantic. With one hand she held an ice, so she made big bows, to the grass, to the line, to the grass, and always nearer.",
#:   "My evidence is that I couldn't have avoided him, sir. He was on my half, not on his, and heading for me. If he had kept to one side of that half I'd have taken the other; but he was rolling across it and rolling back without cease, that car of his, until we met.",
#:   "Wrong lane, wrong direction, and can't hold a line either",
#:   "Drunk cyclist, our lane, facing us, kerb-paint-kerb-paint, closing",
#:   "Head-on moped serpentining up our half. Which way out?",
#:   "The saloon that faced us on our side slopped from the kerb to the line and from the line to the kerb as the distance melted.",
#:   "Coming at us in our lane was a single headlamp, and a restless one, for it swung edge to edge like a bell without once leaving that lane.",
#:   "Go left, he's left; go right, he's right; and the whole time the Yamaha, contrary to all traffic, is nearer in the lane I am driving.",
#:   "He is ghost driver and he is sailor too, this taxi, in my lane against me and rolling from one board to the other board.",
#:   "Opposing bicycle within ego lane, heading reversed, lateral path sinusoidal about the lane centre, amplitude one metre, closing throughout.",
#:   "I counted five swings to the hedge and five to the white line before the hatchback, which had no right to our lane, was on top of us.",
#:   "The student had his gown on, and it was the gown that showed you how he was steering. It streamed to the right, it streamed to the left. He was on a bicycle, he was in the lane we were in, and it was us he was pedalling at. We'd stopped. He needed the whole of our lane, both edges of it, to arrive.",
#:   "Don't look for a way past him, since he hasn't got one himself. That car's on our side, it's pointing at us and it's coming. So far so bad. Now watch its front wheels, they're going over to the kerb, and they're coming away from the kerb to the paint, and back over to the kerb. Brake, stop, lights on, horn.",
#:   "If I were asked to act it out I'd take a watering can. You start at the far end of our lane, facing our car. You walk towards our car, you water the left border, you water the right border, left, right, all the way. You're never on the other half of the road. That's what the Mazda was like.",
#:   "One witness had V2 on the kerb side of V1's lane, a second had it on the centre-line side, and a third one changed his mind. They're all correct. V2 was proceeding against the direction of that lane and was oscillating across its width, so its position depended on when each looked. All agree that it was getting nearer.",
#:   "It's half past two, we're coming home from the gig in the van, and there are these two headlights doing the hula. On our side! Over to the ditch, over to the paint, over to the ditch. Nobody said anything, we just watched it come. Davey stopped in the end and we all leaned left, then right, then left.",
#:   "The trouble with the bandsman wasn't that he was cycling home with a tuba. The trouble was that he'd chosen the lane of the oncoming mail coach to do it in, and that the tuba wanted to go to one side of this and the band's beer to the other. He veered as the one or the other prevailed, and came ever on.",
#:   "Our evasive routine picks the side with the larger opening. Against this opponent it picked left, right, left, right, eight times, then gave up. The opponent is a motorbike that runs head-on in the ego lane; its rider leans to one boundary and then to the other every two seconds. The larger opening never lasts for longer than one.",
#:   "Report of an intoxicated male on a mobility, sorry, on a moped. He's northbound in the southbound lane of Quay Street. A southbound bus has stopped for him. Bus driver says he can't see which side to let him by on, the guy's touching the gutter, then he's touching the yellow line, then the gutter. Fifty feet off and approaching.",
#:   "I have never been so glad of good brakes, as there was no telling where to dodge. You'd see him come up our lane, the wrong way, a little red hatchback, with its nose going like a dog's on a scent. Nose to the edge line, nose to the divider, edge, divider, and always nearer. I stopped dead and hooted.",
#:   "In the beam the road was all their own, a narrow bright alley between the edge and the line. Something was in the alley with them. It had a lamp and a white face; it blundered against the edge and was thrown to the line, it blundered against the line and was thrown to the edge; and it was coming up the alley.",
#:   "The tide of cars on her own side parted for nobody, so she came up ours. A courier, cargo bike, great box of parcels in front. With that weight you can't ride straight when you're slow, and you can't see round it. Tack to the kerb, tack to the middle line, tack to the kerb, face to face with a whole lane of us.",
#: ]
#: adversaries = ["car", "motorcycle", "bicycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "weave"]
#: place = "road"
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 0.8
#: high = 1.3
#: unit = "m"
#: meaning = "how far it swings to either side"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 2.2
#: high = 3.5
#: unit = "s"
#: meaning = "how long a full swing takes"
#: [[parameters]]
#: name = "OPT_ADV_OFFSET"
#: low = 0.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far toward its own side it keeps when it meets the ego"

param OPT_ADV_SPEED = Range(4, 8)
param OPT_ADV_AMPLITUDE = Range(0.8, 1.3)
param OPT_ADV_PERIOD = Range(2.2, 3.5)
param OPT_ADV_OFFSET = Range(0, 3)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < 70
    do WeaveOnPath(against(egoRoute), globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD) until abs(offsetFrom(egoRoute, self)) < 1.4 and gap(self, ego) < 26
    do WeaveOnPath(against(egoRoute).offset(-globalParameters.OPT_ADV_OFFSET), globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
