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
#: leader = false
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
