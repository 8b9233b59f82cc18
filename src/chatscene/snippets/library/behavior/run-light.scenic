#: description = "The crossing vehicle runs the red light at a steady speed."
#: rephrasings = [
#:   "A car ignores the signal and drives straight across.",
#:   "The adversary passes the stop line on red without slowing.",
#:   "Cross traffic disregards the lights and goes through.",
#:   "The other driver fails to stop at the red signal.",
#:   "A motorcyclist sails through on red in front of the ego.",
#:   "he just sails straight through the red",
#:   "Vehicle 2 disregarded the traffic signal and proceeded through the intersection.",
#:   "The car didn't respect the red light and passed.",
#:   "some bloke sailed through a red in front of me, didn't even slow, didn't speed up either",
#:   "V2 entered the intersection against a red signal at a constant speed.",
#:   "Truck from side: thru red, steady v.",
#:   "The crossing target disregards the red signal and passes the junction at constant speed.",
#:   "The bus has red light but he drives over, same speed as before.",
#:   "Signal violator: NPC ignores its red, constant velocity profile, straight over.",
#:   "The light stood red against him, and the cyclist pedalled by beneath it as calmly as you please.",
#:   "He's shot the lights, that van. Never touched his brakes, never touched his throttle, just carried on as if it was green.",
#:   "he just went thru the red like it was optional, didnt even slow down or speed up",
#:   "A coach ignored the stop signal and crossed at an unvarying pace, CCTV showed",
#:   "The signal stood against you, and yet you neither slowed nor quickened but went over?",
#:   "Red light also he is coming same speed only, no fear of police",
#:   "Colour blind, this fella, over he goes on red, cool as you like",
#:   "Signal violation by crossing traffic at constant speed",
#:   "Cyclist rolls right through a RED like it's nothing",
#:   "The truck waltzed over on red.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: actions = ["run-light"]
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
#: high = 13.0
#: unit = "m/s"
#: meaning = "how fast it crosses"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(6, 13)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
