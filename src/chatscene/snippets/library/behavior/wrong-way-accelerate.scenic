#: description = "The oncoming car pulls out into the ego's lane and accelerates to overtake."
#: rephrasings = [
#:   "he swings out to overtake, foot down, straight at us",
#:   "Vehicle 2 moved into the opposing lane and accelerated in order to pass.",
#:   "opposing veh pulls out to overtake, accelerates in our lane",
#:   "The target changes into the lane of the VUT, against its direction, and accelerates.",
#:   "The truck goes out for overtaking and gives gas in our lane.",
#:   "A biker opposite pops out and winds it up, head on.",
#:   "The bus coming the other way sticks its nose out to pass and gathers speed toward us.",
#:   "An ambulance uses our lane to get past the queue, faster and faster.",
#:   "Some pillock coming the other way swung out onto my side and floored it to get past a lorry.",
#:   "Opposing vehicle entered Unit 1's lane and accelerated in an attempt to pass.",
#:   "MC oncoming pulls out to pass, full gas, in our lane.",
#:   "The opposing vehicle leaves its lane for an overtaking manoeuvre and accelerates in the lane of the test vehicle.",
#:   "The car from the front goes out on my lane and gives gas to pass another.",
#:   "Opp. overtaker enters our lane, a > 0, head-on, speeds up rather than aborting.",
#:   "He was tired of the bus ahead of him, so he came out into their side and put on all the speed he had.",
#:   "Ambulance coming the other way's pulled out to pass, he's in your lane and he's building up speed.",
#:   "oncoming car came out into MY lane n sped up to pass someone omg",
#:   "An oncoming lorry moved into the opposite lane and gathered speed to get by slower traffic.",
#:   "In order to overtake, you came over into my client's lane and pressed on the faster.",
#:   "Opposite bus came out to overtake and raised more speed in my lane itself.",
#:   "Swings out on my half to get round some dawdler, and instead of ducking back he piles on the coal.",
#:   "Opposing vehicle in own lane for overtaking under increasing speed",
#:   "OVERTAKES INTO ME AND SPEEDS UP",
#:   "The oncoming truck sallies out into our lane and pours on speed to pass.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "accelerate"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.0
#: high = 4.5
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 35.0
#: high = 90.0
#: unit = "m"
#: meaning = "distance to the ego at which it pulls out and accelerates"
#: [[parameters]]
#: name = "OPT_ADV_OFFSET"
#: low = 0.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far toward its own side it keeps when it meets the ego"

param OPT_ADV_SPEED = Range(2, 4.5)
param OPT_THROTTLE = Range(0.5, 1)
param OPT_ADV_DISTANCE = Range(35, 90)
param OPT_ADV_OFFSET = Range(0, 3)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(against(egoRoute), globalParameters.OPT_THROTTLE, 0, 14) until abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < 40
    do ThrottleOnPath(against(egoRoute), globalParameters.OPT_THROTTLE, -globalParameters.OPT_ADV_OFFSET, 14)
