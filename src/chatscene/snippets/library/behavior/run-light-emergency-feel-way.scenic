#: description = "The emergency vehicle feels its way over the line on red, halts to look, then accelerates across."
#: rephrasings = [
#:   "the ambulance noses out on red with its siren going, waits a tick, then puts its foot down",
#:   "An ambulance on an emergency run entered on red at low speed, paused, and then accelerated through.",
#:   "ambulance, red, slow entry, short halt, then gas",
#:   "The emergency vehicle passes the red signal at walking pace, stands briefly and subsequently accelerates across the VUT's path.",
#:   "The fire truck passes the red light carefully, makes a little stop, then it gives full gas.",
#:   "A police car edges past the stop line on red, looks both ways, and shoots off.",
#:   "Blue lights flashing, the fire engine inches into the crossing, hesitates and then surges over.",
#:   "A rescue vehicle with priority tests the traffic against the signal before it speeds up.",
#:   "ambulance nosed over the line on red, stopped for a gander both ways, then went for it",
#:   "The ambulance edged past the stop line against the red signal, halted to clear the intersection, and then accelerated across.",
#:   "Fire eng. on red: creeps over line, stops, looks, then full over.",
#:   "The emergency vehicle passes the stop line at low speed on red, pauses to check and then accelerates through the junction.",
#:   "The police car has red, it comes slow over the line, stands and looks, then goes quick across.",
#:   "Blue-light crosser at red: inch out, v=0 for a look, then accelerate through. Cautious phase first, not a flat-out blast.",
#:   "The engine had crept out beneath the red lamp, waited till every head had turned, and only then put on speed and was over.",
#:   "Ambulance is poking his nose out on red, good lad, he's having a look left and right, and now he's giving it the beans.",
#:   "ambulance kinda tiptoed out on red, stopped to check, then zoomed",
#:   "A fire crew probed its way out against the signal, stood to see the coast was clear, then hurried over",
#:   "The police driver entered on red with caution, stopped, looked, and only then applied power?",
#:   "Ambulance on red slowly slowly putting nose out, stop see left right, then go fast",
#:   "Credit where it's due, the fire engine pokes out on red, has a good look, then he's gone",
#:   "Cautious red-signal entry of emergency vehicle with check halt and subsequent acceleration",
#:   "Ambulance sneaks out on red, PAUSES, then blasts across",
#:   "The patrol car tiptoed over the red, paused, then pounced.",
#: ]
#: adversaries = ["emergency-vehicle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "hesitate", "accelerate"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.0
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it feels its way over the line"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = -8.0
#: high = -4.5
#: unit = "m"
#: meaning = "how far beyond where their ways meet it halts to look"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.3
#: high = 1.0
#: unit = "s"
#: meaning = "how long it looks"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(0, 20)
param OPT_SLOW_SPEED = Range(2, 3.5)
param OPT_STOP_DISTANCE = Range(-8, -4.5)
param OPT_STOP_TIME = Range(0.3, 1)
param OPT_THROTTLE = Range(0.6, 1)

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED) until self.pose[3] > 1 and distanceLeft(advTrajectory, self, advTrajectory.entry) < -1 and distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 9)
