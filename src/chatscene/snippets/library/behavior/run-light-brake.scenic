#: description = "The crossing vehicle runs the red light and brakes abruptly."
#: rephrasings = [
#:   "A car ignores the signal and then slams to a standstill in the junction.",
#:   "Having jumped the lights, the adversary hits the brakes before the ego.",
#:   "The other driver crosses on red and stops short.",
#:   "Against the red a vehicle rushes in and decelerates hard.",
#:   "Cross traffic overruns the stop line on red and brakes in the middle.",
#:   "he shoots the red and then slams the anchors on in front of us",
#:   "Vehicle 2 entered on red and braked heavily inside the intersection.",
#:   "The truck passed with red and in the middle it brakes very strong.",
#:   "This van shot the lights and then stood on the brakes in front of me.",
#:   "Cross traffic unit disregarded the red signal and suddenly braked within the intersection.",
#:   "Bus jumps red, then hard brake, in our path.",
#:   "The crossing vehicle disregards the red phase and decelerates abruptly in the conflict area.",
#:   "The car goes over red and then brakes suddenly.",
#:   "Red-light runner realises too late, slams brakes in the box, sudden decel rather than a stall.",
#:   "He had gone through on red before he saw her, and then he stamped on the pedal with both feet.",
#:   "That motorbike's come through his red and now he's panicked and hit the brakes.",
#:   "ran the red and then panicked and braked right in front of everyone",
#:   "A lorry went through a red signal and then pulled up sharply amid the crossing.",
#:   "You passed the signal at red and, too late to any purpose, braked violently.",
#:   "He jumped signal and then in the junction put sudden brake, no sense.",
#:   "Goes through on red, sees me, and chucks everything at the brakes, bit late now sunshine.",
#:   "Red-signal violation of crossing vehicle with subsequent harsh deceleration",
#:   "BLOWS THE RED, THEN PANIC BRAKES",
#:   "The crossing truck ignores the red and suddenly clenches to slow.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: actions = ["run-light", "brake"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 11.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 4.5
#: unit = "m"
#: meaning = "how far beyond where their ways meet it comes to rest"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(6, 11)
param OPT_STOP_DISTANCE = Range(0, 4.5)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory)
