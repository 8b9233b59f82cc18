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
