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
#:   "Pickup turns right through a red, then ambles along in our lane.",
#:   "Jumps his red to go right, lands ahead, inches onwards.",
#:   "Motorbike goes right against the signal into our lane and potters.",
#:   "Let a bus make a right on red, then trundle before us.",
#:   "Cyclist ignored the red, rounded right into my lane, barely moved along.",
#:   "With the signal firmly against him the taxi driver came round to his right, joined my lane and proceeded to take the air.",
#:   "A truck from the crossing street, red for him, bends right into our lane and from there he is rolling like a tractor.",
#:   "The cross-street vehicle, facing red, is to enter the VUT's lane by means of a right turn and maintain a very low velocity afterwards.",
#:   "You've a green, but that coach has nipped right on his red into your lane, and he's in no hurry now he's there.",
#:   "Who turns right under a red light, straight into the lane I'm in, and then toddles along hunting for a parking space?",
#:   "Going at a walk ahead of us was a saloon that had got there by rounding the corner, rightward, in defiance of its red light.",
#:   "The lady had her light on red, I could see it from where I was. Still she steered out to her right, took up my lane, and after that she drove as one drives behind a coffin, without ever coming to a stop.",
#:   "V2 faced a red indication on the intersecting roadway. V2 executed a right turn without regard to the signal, entered the lane of V1, and then traveled in it at an estimated five miles per hour until V1 had caught up.",
#:   "A lad on a butcher's bicycle paid no heed to the red. He leaned round the corner on his right hand into the lane of those who had green, ourselves, and pedalled up it as idly as if it were his own orchard.",
#:   "For this run the scooter shall misbehave doubly. It doesn't wait for its red to finish but turns to the right, onto the robotaxi's lane; once there it doesn't pick up any speed, it goes along like somebody window-shopping.",
#:   "In my mirror is a queue of twenty and in front is why. The cement mixer came off the side road at the lights, red, mind you, hung a right into our lane, and has been grinding along at jogging speed ever since.",
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
