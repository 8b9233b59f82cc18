#: description = "The car moves in front of the ego, rolls to a stop and stands in the ego's lane."
#: rephrasings = [
#:   "A taxi squeezes in ahead of us, rolls out and parks itself in our lane to drop somebody.",
#:   "Vehicle 2 entered the lane of vehicle 1, slowed and came to rest there.",
#:   "Cut-in, soft stop, stationary obstacle.",
#:   "The target merges in front of the VUT, decelerates comfortably to standstill and remains.",
#:   "He changes to our lane and then he only stands there, we cannot go.",
#:   "The bus pushes over before us and eases to a halt at its stop.",
#:   "A van from beside takes our space, fades to nothing and plugs the road.",
#:   "The motorbike filters in front, runs out of go and leaves us nowhere.",
#:   "The bus drifted over ahead of me, coasted down to nothing and just sat there in my lane.",
#:   "Unit 2 moved over in front of Unit 1, gradually came to a halt, and remained standing in the lane.",
#:   "Taxi changes lane ahead, rolls out, parks itself there.",
#:   "After the lane change the target decelerates gently to zero and remains stationary ahead of the test vehicle.",
#:   "Lorry goes in my lane before me, gets slower and slower, and stays there.",
#:   "Merging actor coasts to v=0 and never clears, lane stays occupied; not a hard brake.",
#:   "She watched it slide across into her lane, lose its pace little by little and come to rest there as if it had arrived home.",
#:   "He's pulling over in front of you, he's rolling to a halt, and now he's staying put right in your lane.",
#:   "he came into my lane, slowed down n down til he just parked there lmaooo",
#:   "A bus slid over into the lane, lost way and was left standing there with traffic stacked up behind.",
#:   "And once in my client's lane you let your car run out of speed and left it there, did you not?",
#:   "Taxi changed to my lane, then slow slow slow and full stop, he is not moving at all.",
#:   "Drifts over in front of me, dribbles to nothing and plonks himself there, picking up a fare I bet.",
#:   "Lane occupation by merging vehicle after gradual loss of speed to rest",
#:   "He merges in front... then just DIES there",
#:   "The coach sidles into our lane and settles there.",
#:   "Slots in ahead of the AV, fades out, stays put.",
#:   "coach nosed acros into our lane, dawdled to nothing, didnt budge",
#:   "Have the cab merge before us, glide to rest and remain.",
#:   "He came in front, slowly slowly no more moving, blocked.",
#:   "Veh 2 entered lane, gentle decel to nil, remains stationary.",
#:   "An ambulance worked its way over from the next lane into the space before me, let its speed drain away and then simply occupied the road.",
#:   "Once the hatchback was in front of you, having changed lanes to get there, it ran itself down softly and you were left looking at its boot.",
#:   "The artic indicated, came across ahead of our car, and without any sharp braking whatever lost its speed till the wheels ceased turning, and there it stood.",
#:   "I want a motorbike that changes into the ego's lane just ahead, trundles down to zero without drama, and stands there as an obstacle.",
#:   "Pupil, what do you do when somebody takes the gap ahead of you, eases up until he's not moving at all, and then makes no move to go?",
#:   "Sir, my lane was plugged by a pickup, which had first crossed over to it before my bonnet and then gradually gone to sleep on the spot.",
#:   "The recording starts with the van abreast of us in the other lane. It eases over into our space, and you expect it to carry on, but it loses way bit by bit until it is standing, hazards on, and that is where it was when we gave up.",
#:   "There was nothing violent about it, I must tell you. The little saloon put itself before me, and I watched the gap shrink as it grew slower and slower, as if it had used up its last drop; and at the end it was at rest and I was stuck.",
#:   "A parcel van had come to a stand in the lane of Vehicle 1, about fifteen metres ahead. Seconds earlier it had been in the lane next to it, from where the driver changed over and permitted the van to run out gently to a full stop.",
#:   "my bus is late bc of this taxi: shifts across in front of us from the lane next door, drops its speed nice and soft, then it's stopped, then it's just there. No reason, no passenger, nobody gets out. We wait behind it like idiots",
#:   "Dispatch, we've got a bus sitting in lane two for no reason I can see. Caller says it came across from lane one just ahead of her, took its speed off nice and easy until it was at nothing, and it's been a roadblock ever since.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cut-in", "stop"]
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 3.0
#: high = 9.0
#: unit = "m"
#: meaning = "how far its rear is ahead of the ego's front before it moves over"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.2
#: high = 0.4
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(0, 30)
param OPT_ADV_AHEAD = Range(3, 9)
param OPT_BRAKE = Range(0.2, 0.4)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 4
    do DrivePath(egoRoute, 7) until abs(offsetFrom(egoRoute, self)) < 1
    do BrakeOnPath(egoRoute, globalParameters.OPT_BRAKE)
