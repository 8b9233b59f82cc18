#: description = "The car veers erratically through the intersection."
#: rephrasings = [
#:   "A vehicle lurches from side to side as it crosses the junction.",
#:   "The adversary cannot hold its line and swings about.",
#:   "The other driver swerves unpredictably over the crossroads.",
#:   "On its way through, the car sways left and right.",
#:   "The approaching motorbike wobbles erratically across the intersection.",
#:   "he's all over the place as he comes through the crossing",
#:   "Vehicle 2 followed an erratic path through the intersection.",
#:   "The car goes left, right, left, right over the crossing, very dangerous.",
#:   "The thing was all over the shop going through the crossroads, like the driver was plastered.",
#:   "Unit 2 failed to maintain a straight course through the intersection, making several erratic steering movements.",
#:   "Car thru junction, steering all over, no clear line.",
#:   "The target vehicle crosses the junction with unpredictable lateral deviations from its nominal path.",
#:   "The truck drives not straight in the crossing, goes left and right, I don't know where he wants.",
#:   "Actor's path in the box wobbles left/right at random; speed unchanged.",
#:   "It lurched one way, then the other, as if two people were fighting over the wheel in the middle of the crossroads.",
#:   "That biker's wandering all over the intersection, you can't tell which way he'll jerk next.",
#:   "this car was going everywhere in the intersection fr is he ok",
#:   "A lorry staggered through the crossroads on a course no one could foretell.",
#:   "The vehicle held to no line at all; it pitched now this way and now that over the whole of the junction.",
#:   "Uncle go through the junction like drunk, suddenly left suddenly right, dunno want to go where.",
#:   "Steering like he's stirring soup, this one, right through the middle of the crossroads.",
#:   "Unpredictable lateral deviations of vehicle during intersection passage",
#:   "DRUNK? Car lurches all over the junction",
#:   "The van reels across the intersection.",
#:   "Scooter careers through the crossroads, zigging one moment, zagging the next.",
#:   "Truck over the junction, steering like mad, every which way.",
#:   "The bus went wiggly-waggly all through the crossing.",
#:   "Crossing target: irregular lateral oscillation throughout intersection, transit completed.",
#:   "Could that coach pick one line through this junction, please?",
#:   "Make the crossing hatchback wander wildly as it goes through, first to one side and then to the other, so that nobody can guess its path.",
#:   "We were told by three people at the bus stop that the pickup had snaked through the intersection as if nobody were holding the wheel.",
#:   "It is like the conductor has bees in the cabin, his camion goes to here, goes to there, all along the crossroads.",
#:   "V2 traversed the junction along a sinuous line, the lateral movements to either side being abrupt and following no recognisable pattern.",
#:   "Keep well back, love, that motorcyclist can't hold it straight, he's lurching about all the way through the lights.",
#:   "One thing stood out in the video: from entering the intersection until leaving it, the van never had its wheels straight for two metres together.",
#:   "Being a cyclist I watch wheels. Those on the tipper were turning left, then right, then harder left, the entire time it was crossing the junction, and the body on top was rocking with it. There was no telling which bit of tarmac it'd want next.",
#:   "Suspected medical episode, the driver said he felt faint. His saloon came across the intersection drifting left, was yanked back, overshot to the right and was yanked again, and so on from one side of the box to the other till it had got through.",
#:   "The AV's path predictor was given a hard time here. The other vehicle, a motorbike with a wobbling topbox, came through the crossroads with sudden tugs to either side at no regular interval, and each tug sent its predicted trajectory into somebody else's lane.",
#:   "I was waiting to go when this lorry came through the junction from my right, and my lord, I have seen steadier men come out of the Crown on a Saturday night. It pitched to port, pitched to starboard, and never did find the middle.",
#:   "ok so update on that junction near my work, this morning a whole bus came thru it like it was dodging invisible cones, hard one way, hard the other, no rhythm to it. driver was fighting a wasp apparantly. we just sat there praying",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["weave", "swerve"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 1.6
#: high = 2.6
#: unit = "m"
#: meaning = "how far it swings to either side"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 2.0
#: high = 3.0
#: unit = "s"
#: meaning = "how long a full swing takes"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(5, 9)
param OPT_ADV_AMPLITUDE = Range(1.6, 2.6)
param OPT_ADV_PERIOD = Range(2, 3)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
