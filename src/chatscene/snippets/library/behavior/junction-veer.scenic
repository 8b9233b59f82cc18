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
#:   "Tipper reels over the junction like a Saturday-night drunk.",
#:   "That motorbike wrote its name across the crossroads.",
#:   "Bus through the box: left, right, left, nobody steering.",
#:   "youd of thought someone was wrestling him for the wheel the way that pickup lurched this way n that over the crossroads",
#:   "Let the crossing van take the intersection in a wavering line, its flank swinging to and fro, and carry on without stopping.",
#:   "Which side of it was I meant to pass on, when it was changing sides every second all the way over the crossing?",
#:   "The path of V2 through the intersection was not straight but sinuous, with several reversals of steering; no reason for these was established.",
#:   "The scooter did not drive over the crossing, it danced over the crossing, one time to my side, one time to the other side.",
#:   "Caller at the lights says a white saloon's just gone through the junction swinging from side to side, can't hold a line, continuing.",
#:   "They'd marked its tracks in chalk by the time I got there: two lines over the crossroads that you could have used to teach the sine function. Whatever the lorry driver had been doing, it wasn't keeping straight. He'd been towards the claimant's kerb, off again, towards it again, off again, and so out by the road opposite.",
#:   "Every time I'd decided where it would come out, it pointed somewhere else. I was at the mouth of the junction, a sitting duck, and this minicab was crossing in front: bonnet at me, bonnet at the church, bonnet at me, bonnet at the bank. It was out of the other side before I'd remembered to breathe.",
#:   "It was a wasp, the poor man said. We didn't know that in our car. We only saw a great big bread van heel over one way in the middle of the crossroads, so all the crates went bang, and heel over the other way so that they all went bang again, and then back once more, and away.",
#:   "Bug: crossing-path prediction diverges. In this log the truck's heading within the junction box oscillates by plus minus twenty degrees about its route with a period of roughly two seconds. The predictor extrapolates a straight line from whichever heading it last saw, so that it announces a left turn, a right turn, a left turn. The truck exits straight ahead.",
#:   "Heads were wagging in the bus like at a tennis match, left, right, left. I was on the pavement with my dog, and it took a moment until I'd grasped that they couldn't help it: the whole bus was being thrown from one lock to the other on its way across the junction. The cars on the other road had all pulled up.",
#:   "Keep well back from the line, Tom. No, farther. See the motorcyclist crossing there? Tank bag's come loose, and he's got one hand on that. Watch where his front wheel goes. At us. Away. At us again. He'll get to the other road somehow, but I won't have you in the middle of it while he makes up his mind.",
#:   "No lane on that junction was safe, testified Mrs Achebe. She'd been first at the stop line. The coach used the near lane, the far one and a good deal in between, and then some of them a second time, in the course of a single crossing, and it wasn't turning off anywhere: it left by the exit opposite.",
#:   "The vodka was in the cup holder, it turned out. All that the dash camera of the robotaxi has is a Ford that comes in from the left with its headlights sweeping like a searchlight over us, over the shops, over us, over the shops, and that never does straighten up until it's out of shot on the other side.",
#:   "I am engineer for steering systems, so I recognise when a driver overcorrects. On the crossing before me a small truck deviates to one side, he counters too much, deviates to the other side, counters too much. Like a pendulum with wheels. With this he came through the whole Kreuzung and into the next street. We had to stand on the brake.",
#:   "His apologies were fulsome. A fit of sneezing, he'd said; five of them, one for each lurch, all within the bounds of the crossroads, so that his hatchback had been seen by the curate to threaten, in order, the curate, the pillar box, the curate, the pillar box and the curate, and finally to vanish up Church Lane.",
#:   "No two frames of the drone video put the taxi on the line that an ordinary crosser takes. It is left of it, right of it, left and right of it anew, over the whole width of the intersection. The subject vehicle, which was about to enter, delayed its entry by four seconds for lack of any usable gap.",
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
