#: description = "The crossing car runs the red light and swerves to its left in the junction."
#: rephrasings = [
#:   "he blows the red and yanks the wheel left when he spots us",
#:   "Vehicle 2 ran the red signal and veered abruptly to its left.",
#:   "red-light runner, sudden swerve inside crossing",
#:   "The target crosses the stop line on red and performs an evasive steering manoeuvre to the left.",
#:   "An ambulance comes on the red light and makes a fast movement to the left side.",
#:   "The biker jumps the lights and lurches aside at the last instant.",
#:   "Going through on red, a van darts off its line.",
#:   "It disregards the signal, then jinks to the left.",
#:   "he jumped the red and then jinked to his left in the middle of the junction",
#:   "V2 entered against the red signal and veered sharply to its left within the intersection.",
#:   "Police thru red, jerks to own L mid-jct.",
#:   "The crossing target passes the red signal and makes an evasive steering movement to its left inside the junction.",
#:   "The motorbike goes by red and in the crossing he pulls suddenly to his left.",
#:   "Red runner plus lateral kick: after entering the box, step in steering to its left, keeps moving.",
#:   "He had paid no heed to the light, and halfway over, the car lurched to its left hand for no reason they could see.",
#:   "Ran the red, and now he's flung the wheel over to his left in the middle; no telling where he'll end up.",
#:   "he ran the red then freaked out and swerved to his left in the middle",
#:   "A car passed the red signal and then sheered off to its left inside the crossroads",
#:   "You disobeyed the signal, and within the junction you wrenched the wheel to your left?",
#:   "Jumped the red, then inside the junction he swing to his left side, macam stunt driver",
#:   "He's come through on red, seen me, and thrown it over to his left",
#:   "Signal violation by crossing traffic with abrupt leftward evasion inside the junction",
#:   "Ambulance blows red light and VEERS to its left",
#:   "The biker burst over on red and jinked to his left.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "swerve"]
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
#: low = 7.0
#: high = 11.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.4
#: high = 3.0
#: unit = "m"
#: meaning = "how far it swerves to its left"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 2.0
#: high = 9.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it swerves"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(7, 11)
param OPT_SWERVE = Range(1.4, 3)
param OPT_SWERVE_DISTANCE = Range(2, 9)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE)
