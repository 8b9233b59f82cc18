#: description = "The rider rides out across the lane, brakes in it, puts a foot down and then tears off to the other side."
#: rephrasings = [
#:   "A biker comes out, slams the brakes on in our lane, then guns it across.",
#:   "The bicyclist stopped abruptly while crossing the lane and then accelerated to clear it.",
#:   "bike crosses, brakes mid-lane, then accelerates over",
#:   "The two-wheeler interrupts its crossing by hard braking and resumes it with strong acceleration.",
#:   "The scooter goes across, makes a full brake, then goes away fast.",
#:   "A courier sees us, grabs the levers, reconsiders and pedals like mad.",
#:   "The moped rider halts startled in our way and then opens the throttle.",
#:   "She hits the brakes in mid-crossing, wobbles upright and sprints clear on the pedals.",
#:   "lad on a pedal bike came out over the lane, pulled up, put his foot down on the tarmac and then pelted off over the far side",
#:   "The motorcyclist rode across the lane, stopped in it with one foot on the ground, and then fled to the opposite side.",
#:   "Cyclist X-ing: brakes in our lane, foot down, then sprints off over.",
#:   "The bicyclist target crosses, halts within the VUT's lane, pauses and then completes the crossing at high acceleration.",
#:   "The bike rides across, stops in my lane with the foot on the street, then goes very quick to the other side.",
#:   "Two-wheeler crossing with dwell in lane: ride out, brake, foot down for ~1 s, then max accel to the far kerb.",
#:   "She had wheeled out before them, stopped and stood astride her bicycle, and then as suddenly was off like a hare.",
#:   "He's ridden out, he's stopped in your lane, toe on the floor, and whoosh, there he goes to the other side.",
#:   "bike came across, slammed the brakes right in our lane, foot down, then zoomed off the other side",
#:   "A moped rider pulled up midway over the lane, steadied himself with a boot, then fled to the far pavement",
#:   "You stopped your bicycle in the lane, placed a foot on the road, and then made off with all haste to the opposite side?",
#:   "Cycle fellow crossing, in the middle put brake and one leg down, then vroom gone to other side",
#:   "Out he comes, stamps on it dead ahead of me, one trainer on the tarmac, then scarpers over the far side",
#:   "Crossing two-wheeler with intermediate stop in lane and abrupt flight to the far side",
#:   "Scooter stops in front of me mid-crossing then ROCKETS away",
#:   "The courier propped mid-lane, then scooted over.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "brake", "hesitate", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.8
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it rides out"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 8.0
#: high = 28.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.2
#: high = 1.25
#: unit = "m"
#: meaning = "how far from the ego's line it stops"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.3
#: high = 1.2
#: unit = "s"
#: meaning = "how long it stands"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 5.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it tears off"

param OPT_ADV_SPEED = Range(2.8, 5)
param OPT_ADV_DISTANCE = Range(8, 28)
param OPT_STOP_DISTANCE = Range(0.2, 1.25)
param OPT_STOP_TIME = Range(0.3, 1.2)
param OPT_ADV_SPRINT = Range(5, 9)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED + 2 * globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPRINT)
