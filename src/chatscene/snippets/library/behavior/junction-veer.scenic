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
#:   "Pickup reels over the crossing like a drunk sailor.",
#:   "Crossing coach yanks left, yanks right, all the way through.",
#:   "Motorbike negotiates the junction in jerks to either side.",
#:   "Let the lorry pass the intersection with continual, unforeseeable deflections of its course to left and to right, its speed being kept.",
#:   "The saloon's tyre tracks through the box looked like a child had drawn them, here to the one kerb, there to the other, and no straight bit anywhere.",
#:   "We have a van, possibly a drunk, lurching its way over the lights at Fifth, one lane to the next and back, stay clear of him.",
#:   "The moto go through the crossing like snake with fever, I not know if I must go before him, behind him, or stay.",
#:   "Nobody at the crossroads could have told you which way the hatchback would pitch next, its driver apparently including himself.",
#:   "As it traverses the intersection, the target bus shall depart alternately to both sides from its nominal path, at an amplitude exceeding half a lane.",
#:   "I've a good view of the junction from the scaffolding. The brick lorry came into it and I thought he was going left, then I thought he was going right, then left again, harder, so that a few bricks went over. That's how he went on until he was out at the other side. A wasp in the cab, it turned out.",
#:   "The difficulty for us, waiting at the line, was that there was no part of the crossroads one could call safe. The motorcyclist coming over it had a pillion passenger who was clearly drunk and leaned whichever way he fancied, and with each lean the machine plunged off its line, now towards us, now towards the bank.",
#:   "In the matter of Vehicle 2's path, all four witnesses concur that there was no discernible one. One says that it swerved right first, another left. The video settles it: within the limits of the intersection the steering was reversed seven times, at irregular intervals, and the vehicle went through without having slowed.",
#:   "Was I scared? I was parked in a Mini with a bus on its way over the junction and the bus couldn't find the road. Its big flat face would point at the bank, then at me, then at the bank, then at me again, with a heave every time, and the people inside hanging off the straps like washing.",
#:   "Steering fault, variant C. Having entered the intersection, the actor's lateral control becomes unstable and it staggers through: excursion to one side, overcorrection to the other, another excursion, with the period and size as configured. The subject vehicle can't rely upon the actor's lane at any time before it's left the box.",
#:   "He had been sneezing, he told the magistrates. A sneeze might account for one lurch, the chairman allowed, but the film from the garage forecourt showed his estate car lurching this way and that at least five times between entering the crossroads and leaving it, and people in other vehicles visibly at a loss where to look.",
#:   "When someone comes through a junction like that tipper, you don't try to be clever. Look, it's ducking towards the island. Now it's ducking towards the shops. Now it's the island again. You can't read it because there's nothing to read. Foot on the brake and wait until he's staggered out of the far end.",
#:   "On the heat map for the truck's predicted positions the whole of the junction lights up red. That is not a bug, that's the truck: three metres off to the left, two off to the right, then left again with a jolt, all while crossing. Our own vehicle stayed behind the line, as it ought to when somebody drives so.",
#:   "She supposed that they must be quarrelling in there. Through the windscreen of the taxi that was coming over the crossroads she could see two pairs of hands on one wheel, and with every tug of either the taxi flung itself to that side, so that it passed through more like a fly at a window than like a car.",
#:   "Namaste, writing as witness. The school bus of other school was crossing the signal when it went mad. Sometimes fully left, sometimes fully right, no fixed line, children screaming inside. Driver was not stopping also. I kept my Activa back behind the line because God knows on which side it will be coming.",
#:   "ok the scooter guy. he had like four helium balloons tied to the handlebar and the wind got em. all thru the intersection hes getting dragged one way, wrenching it back, going too far, getting dragged the other way. looked like a glitching npc. my car's autopilot literaly gave up and beeped at me",
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
