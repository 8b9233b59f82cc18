#: description = "The oncoming car drives against the traffic in the ego's lane."
#: rephrasings = [
#:   "there's a guy coming straight at us in our own lane",
#:   "Vehicle 2 was travelling the wrong way in the lane of Vehicle 1.",
#:   "wrong-way driver, our lane, head-on",
#:   "The target approaches the VUT in the VUT's lane in the opposite direction at constant speed.",
#:   "A car is driving in the wrong direction on our side of the road.",
#:   "A cyclist rides the wrong way up our lane, towards us.",
#:   "The ghost driver keeps to the ego's side for far too long.",
#:   "A motorbike comes head on, on the side where it has no business.",
#:   "Some doddery old fella was coming straight at me on my side of the road, going the wrong way.",
#:   "A wrong-way driver was traveling toward Unit 1 in its lane, against the flow of traffic.",
#:   "Ghost driver, ego's lane, head-on, holds spd.",
#:   "The target travels in the VUT's lane in the opposite direction at constant speed.",
#:   "A car comes against me in my lane, he drives on false side.",
#:   "Contraflow actor in our lane, no evasive move, head-on all the way.",
#:   "He came on down her side of the road as though it were his own, and never gave an inch.",
#:   "Control, we've got a wrong-way driver in your lane, coming head-on towards you.",
#:   "theres a car coming STRAIGHT for us the wrong way up our lane help",
#:   "A confused pensioner drove into the face of the traffic in its own lane, police said.",
#:   "You were in her lane, going the contrary way, and you maintained your course toward her throughout?",
#:   "One car coming opposite direction in my own lane, wrong side totally, not stopping also.",
#:   "I'm on my side and so's he, and we're pointing at each other. Somebody's wrong and it ain't me.",
#:   "Sustained contraflow travel of opposing vehicle in ego lane.",
#:   "WRONG WAY DRIVER HEAD ON IN MY LANE",
#:   "The truck breasted the traffic in our lane.",
#:   "Bus on our side, pointed at us, and it keeps on coming",
#:   "Unit 6, vehicle in your lane proceeding contraflow towards you.",
#:   "Moped riding against the stream, straight up the AV's lane.",
#:   "Put an ambulance head-on in the ego's lane, holding a steady pace.",
#:   "Why is that van in our lane facing us?",
#:   "The pickup had no right to be where it was, on my half of the road, travelling steadily towards me against everybody who was going my way.",
#:   "The oncoming target occupies the lane of the vehicle under test, opposed to the prescribed direction, and closes in at a constant 40 km/h.",
#:   "I blinked my lights at the lorry, for it was driving up our lane from the other end, but the driver just carried on in the wrong direction.",
#:   "V2 was proceeding in a direction opposite to that permitted and was in the same lane as V1, approaching it front to front at moderate speed.",
#:   "A tourist car, I think from the left-driving country, was coming on my lane against me, not quick, not slow, he did not understand his mistake.",
#:   "some delivery rider cycling the wrong way up my lane, towards me, keeping a nice even pace like thats totally normal??",
#:   "At first we took the headlamps for somebody overtaking who would soon be back on his side. He wasn't overtaking anything; he was simply travelling up our lane in the wrong direction, mile after mile for all we know, and he came on without a waver.",
#:   "Listeners, you've heard the traffic announcer say there's a vehicle going the wrong way. Well, I met it. It was a beige saloon, it had my lane to itself until I turned up, and it kept driving towards me as if I were the one in error.",
#:   "The parameter set is simple: opposing agent, lateral position within our lane, heading reversed relative to the lane, speed constant. No lane departure back to its own side, no braking, no swaying; the AV has to solve the head-on conflict on its own.",
#:   "He'd come out of the filling station by the wrong exit, I suppose, that motorcyclist. At any rate he was in the lane that belonged to us, riding against us and against the arrows on the tarmac, as regular as a clock.",
#:   "Q. Which lane was the fire engine in? A. Mine. Q. And which way was it heading? A. Towards me, against the traffic, and it stayed in my lane the whole time I could see it, at the same speed.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: opposite direction; own code"
#: [slots]
#: actions = ["oncoming", "wrong-way"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 35.0
#: high = 90.0
#: unit = "m"
#: meaning = "distance to the ego at which it comes over into the ego's lane"
#: [[parameters]]
#: name = "OPT_ADV_OFFSET"
#: low = 0.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far toward its own side it keeps when it meets the ego"

param OPT_ADV_SPEED = Range(4, 9)
param OPT_ADV_DISTANCE = Range(35, 90)
param OPT_ADV_OFFSET = Range(0, 3)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < 36
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_ADV_OFFSET)
