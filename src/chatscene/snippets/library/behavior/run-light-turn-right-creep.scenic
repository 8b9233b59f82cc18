#: description = "The crossing car turns right on red into the ego's lane and crawls along."
#: rephrasings = [
#:   "right on red without looking, and then he dawdles along in front of us",
#:   "Vehicle 2 made a right turn on red and proceeded slowly in the lane ahead.",
#:   "right on red, merges, crawls",
#:   "The target turns right against the red signal into the lane of the VUT and continues at low speed.",
#:   "A bus turns to right with red light and after it goes very slow before us.",
#:   "A cyclist slips round to the right on red and pootles on ahead of the ego.",
#:   "The lorry eases right through the red signal, taking its time, and stays slow.",
#:   "Ignoring the lights, a van trundles right into our way at walking pace.",
#:   "he came round to the right on a red and then dawdled along in front of me at nothing miles an hour",
#:   "V2 turned right against the red signal into V1's lane and proceeded at a very low speed.",
#:   "Truck: R on red -> our lane, then snail pace.",
#:   "The crossing target turns right at the red signal into the VUT's lane and continues at minimum speed.",
#:   "The bicycle has red but turns right to my lane and then goes very slow before me.",
#:   "Right-on-red NPC lands in our lane and then becomes a slow-moving plug, ~2 m/s, no stop.",
#:   "The bus slunk round the corner to the right under a red light and then loitered along in front of them.",
#:   "He's come out right on red, straight in front of you, and now look, he's tootling along like it's a Sunday.",
#:   "he turned right on red into our lane and now hes going like 2mph",
#:   "A bus went right against the signal, took the lane, and then idled along at the head of a queue",
#:   "Having turned right on a red signal into my client's lane, you saw fit to dawdle there?",
#:   "Red light he turn right come into our lane, then drive like sightseeing",
#:   "Red's for other people, right he goes into my lane, and then he's pootling like it's a Sunday",
#:   "Right turn on red into own lane with persistent low speed",
#:   "Cyclist turns right on RED then crawls in front of me",
#:   "The lorry slunk right on red and dawdled ahead.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "turn-right", "slow"]
#: control = "signal"
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -5.0
#: high = 15.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.5
#: high = 3.8
#: unit = "m/s"
#: meaning = "how fast it turns and goes on"

param OPT_ADV_DISTANCE = Range(-5, 15)
param OPT_SLOW_SPEED = Range(2.5, 3.8)

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED) until abs(offsetFrom(egoRoute, self)) < 6
    do DrivePath(egoRoute, globalParameters.OPT_SLOW_SPEED)
