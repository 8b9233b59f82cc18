#: description = "The car turns into the ego's lane, brakes hard, and stops."
#: rephrasings = [
#:   "he barges in front of us out of the side road and then slams on the anchors",
#:   "Vehicle 2 entered the lane of Vehicle 1 from the cross street, braked hard, and came to rest.",
#:   "comes into our lane at crossing, hard brake, standstill",
#:   "The target enters the lane of the VUT at the junction and performs full braking to standstill.",
#:   "The truck comes in front of the ego from the other street and then brakes until zero.",
#:   "A fire engine pushes in ahead and jams on its brakes.",
#:   "A biker takes our lane from the side street, then stops dead.",
#:   "It forces its way in ahead of the ego, only to pull up at once.",
#:   "A van swung out of the side road right in front of me, stamped on it and came to a dead halt.",
#:   "Unit 2 turned from the cross street into the lane ahead of Unit 1, braked heavily and came to a complete stop.",
#:   "Car turns in on us, hard brake, standstill.",
#:   "The target vehicle turns from the crossing road into the test vehicle's lane, then performs full braking to rest.",
#:   "A motorbike turns in my lane from the side street and then full brake and stands.",
#:   "Actor enters our lane from the cross arm, cuts us off, v goes to 0 quickly.",
#:   "It came round the corner, took her lane from under her wheels and then pulled up short.",
#:   "He's turning in ahead of you at the crossroads, he's cut you up, and now he's stopped dead.",
#:   "he turned right in front of me, braked super hard and then just stayed there",
#:   "A car swung round the corner into the motorist's lane and came to an emergency halt.",
#:   "He rounded the corner, took possession of my client's lane and brought his van up all standing.",
#:   "This lorry turn into my lane from the junction, jam brake, then stop there completely.",
#:   "Comes round the corner into my road, nicks my space and then drops the anchor for good.",
#:   "Turn-in ahead of own vehicle at intersection with full braking to rest",
#:   "TURNS IN FRONT OF ME THEN SLAMS TO ZERO",
#:   "The van hooks into our lane and halts with a jerk.",
#: ]
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["cut-in", "brake", "stop"]
#: position = "crossing"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 5.0
#: high = 28.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.5
#: high = 2.0
#: unit = "s"
#: meaning = "how long it drives in the ego's lane before it brakes"

param OPT_ADV_DISTANCE = Range(5, 28)
param OPT_ADV_SPEED = Range(6, 9)
param OPT_STOP_TIME = Range(0.5, 2)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 3.5
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_STOP_TIME seconds
    do BrakeOnPath(egoRoute)
