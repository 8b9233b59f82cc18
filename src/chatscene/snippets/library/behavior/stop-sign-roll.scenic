#: description = "The crossing car brakes for the stop line without quite stopping, and speeds up across."
#: rephrasings = [
#:   "classic rolling stop, he barely slows for the sign and then goes for it",
#:   "Vehicle 2 failed to come to a complete stop at the stop sign and accelerated into the intersection.",
#:   "rolling stop, doesn't halt, speeds up",
#:   "The target reduces its speed at the stop line without reaching a standstill and then accelerates across the path of the VUT.",
#:   "The driver brakes a bit at the STOP but he doesn't really stop, then he goes faster.",
#:   "A lorry does a California stop and pulls across.",
#:   "The biker brushes the brakes at the give-way line and nips over.",
#:   "It slows sharply, rolls past the sign, and picks up speed in front of the ego.",
#:   "He made a half-hearted dab at the stop line, never actually stopped, then gunned it over.",
#:   "The driver made a rolling stop at the stop sign and accelerated across the intersection.",
#:   "Rolling stop, then hard gas across. Wheels never at 0.",
#:   "The crossing target decelerates towards the stop line without reaching standstill and accelerates through the junction.",
#:   "The car brakes at the stop, but not to zero, and then goes quick over.",
#:   "California stop: actor dips to ~2 m/s at the line, then floors it through the conflict zone.",
#:   "He made a show of slowing at the sign, but the wheels never stood still, and off he leapt across.",
#:   "See that? He didn't stop at the sign, only rolled it, and now he's booting it over.",
#:   "he like almost stopped at the stop sign and then sped across instead",
#:   "The driver slowed for the line without ever coming to rest, then hurried over.",
#:   "You slowed, I grant, but your wheels never ceased to turn before you quickened across; yes?",
#:   "At the stop line he slowed little bit only, never fully stop, then went fast across.",
#:   "Stop means stop, doesn't it? Not to him, bit of brake, then foot down and over.",
#:   "Incomplete stop at stop line with accelerated crossing.",
#:   "CALIFORNIA STOP THEN GUNS IT ACROSS",
#:   "The crossing motorbike curtsied at the stop line and scooted over.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "accelerate"]
#: position = "crossing"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 15.0
#: high = 45.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 1.2
#: high = 2.4
#: unit = "m/s"
#: meaning = "to what speed it slows down at the line"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 6.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it becomes"

param OPT_ADV_DISTANCE = Range(15, 45)
param OPT_ADV_SPEED = Range(6, 9)
param OPT_SLOW_SPEED = Range(1.2, 2.4)
param OPT_ADV_SPRINT = Range(6, 10)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 4.5 and distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5
    do BrakeOnPath(advTrajectory, 0.6) until self.pose[3] < globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPRINT)
