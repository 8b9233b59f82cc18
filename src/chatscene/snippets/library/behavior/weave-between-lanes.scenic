#: description = "The car in the target lane weaves between lanes."
#: rephrasings = [
#:   "A vehicle swings from side to side and cannot be predicted.",
#:   "The adversary slaloms along, now left, now right.",
#:   "The neighbouring car snakes to and fro across the lane markings.",
#:   "The driver wanders back and forth between two lanes.",
#:   "The lorry sways about its lane as if the driver were drunk.",
#:   "The drunk keeps wandering all over his lane.",
#:   "Vehicle 2 was observed weaving within and out of its lane.",
#:   "The target shows sinusoidal lateral motion.",
#:   "There was a car in the next lane slaloming from one lane to another and back again.",
#:   "Unit 2 was observed making repeated unsafe lane changes back and forth.",
#:   "Adj veh: lane hop L-R-L, over lines, same dir.",
#:   "The target in the adjacent lane repeatedly alternates between lanes.",
#:   "The motorbike in other lane goes always from one lane to the other and again back.",
#:   "Neighbour-lane actor can't keep a lane: serial lane changes back and forth across the dividing line.",
#:   "He darted from one lane to the next and back, stitching his way down the road beside her.",
#:   "He's flitting lane to lane, that one over there, so don't get caught level with him.",
#:   "this car couldnt pick a lane, kept going back n forth n back n forth",
#:   "A van flitted from lane to lane, never settling in either, callers told the station.",
#:   "He took one lane, then the other, then the first again, and so continued, did he?",
#:   "The next-lane car simply changing lane, changing back, changing again, what is this.",
#:   "This lane, that lane, this lane again, he's knitting a jumper out there.",
#:   "Repeated alternating lane changes of vehicle in neighbouring lane.",
#:   "CAN'T PICK A LANE: IDIOT KEEPS SWITCHING",
#:   "The motorcycle stitched its way between the lanes.",
#:   "Hatchback next lane over keeps zigzagging across the dashes.",
#:   "biker alongside swings betwen lanes like a metronome over and over",
#:   "Let the lorry in the target lane wander back and forth across lanes.",
#:   "Adjacent coach lane to lane to lane, cannot be predicted, over.",
#:   "That car there goes wiggle waggle in two lanes, Papa!",
#:   "The pickup where we wished to go would not stay in its own lane but drifted out of it and in again, out and in, all the time.",
#:   "In the lane neighbouring that of the VUT, the target follows an oscillating path whose amplitude takes it repeatedly across the lane marking and back.",
#:   "Don't go over yet, because the van in that lane can't make up its mind: a bit of this one, a bit of that one, forever swaying.",
#:   "The driver on the other lane was surely tired, his bus was going like a pendulum from his lane to the next and always again back.",
#:   "Is that motorcyclist warming his tyres? He's been swinging left and right over the lane line beside us for the last half mile without pause.",
#:   "I did not change lanes since the saloon in the lane I needed was tacking to and fro across the markings like a dinghy in light wind.",
#:   "It was about half past two in the morning and there was only this one van in the lane next to mine. It leaned over the white dashes, leaned back, leaned over, leaned back. I could see the driver's head nodding in time. I rang your people as I dared not go by.",
#:   "Ticket: weaving neighbour. Actor in our merge target lane runs a sine-like lateral pattern that carries it over the lane boundary and back every few seconds, at steady speed. Lane assignment in the tracker flips with each swing and the merge decision with it. Should simply not merge until the thing has calmed down.",
#:   "The police helicopter kept its camera on the silver coupé for nine minutes. During this time, the prosecution says, the car was seldom in one lane for longer than the blink of an eye; it curved from one into another and curved back again, to the alarm of the driver travelling next to it.",
#:   "Thirty years in artics and I know the signs. This other rig, in the lane I was hoping to move to, its trailer's over the line, then it's gone, then it's over again, a slow wag from side to side as if the whole outfit were humming a tune. He's asleep or texting, I said.",
#:   "Dash cam from a reader: the motorbike on the left of the frame, lane beside the cammer. Watch the dashes go under its wheels. There, there, there, there. Never commits to one side, merely swings across and returns, swings across and returns, while everyone around hangs back and prays. Comments: \"free snake charming\".",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advLane"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["weave"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 7.5
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 0.75
#: high = 1.05
#: unit = "m"
#: meaning = "how far it swings to either side"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 3.0
#: high = 5.0
#: unit = "s"
#: meaning = "how long a full swing takes"

param OPT_ADV_SPEED = Range(4, 7.5)
param OPT_ADV_AMPLITUDE = Range(0.75, 1.05)
param OPT_ADV_PERIOD = Range(3, 5)

behavior AdvBehavior():
    do WeaveOnPath(advLane, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
