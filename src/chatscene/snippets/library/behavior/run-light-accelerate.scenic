#: description = "The crossing vehicle runs the red light and unexpectedly accelerates."
#: rephrasings = [
#:   "A car ignores the red signal and speeds up into the junction.",
#:   "The adversary jumps the lights, foot to the floor.",
#:   "Cross traffic shoots over the stop line on red, gaining speed.",
#:   "The other driver disregards the signal and surges across.",
#:   "Against the red light a car rushes through faster and faster.",
#:   "he sees red and steps on it",
#:   "Vehicle 2 accelerated through the red signal.",
#:   "red light, speeds up instead of stopping",
#:   "Jumped the red and then, instead of stopping, gave it some welly across the junction.",
#:   "Unit 2 failed to stop for the red signal and accelerated through the intersection.",
#:   "X-traffic jumps red, then speeds up mid-jct.",
#:   "The crossing target passes the red signal and increases its speed within the junction.",
#:   "The truck from the side goes with red and suddenly gives gas.",
#:   "Red-light violator that speeds up after the stop line; arrival-time estimate at the conflict point breaks.",
#:   "It was red for him, but he came on regardless, and halfway he put on speed.",
#:   "He's not stopping for that red, he's actually putting his foot down, hold it!",
#:   "he ran the red and then went even FASTER like bro",
#:   "Having ignored the signal, the lorry gathered pace over the junction rather than braking.",
#:   "You passed the red lamp, and your response, once within the junction, was to press the accelerator?",
#:   "He beat the red light, then inside junction press even more speed.",
#:   "Light's red, he's through it, and the further over he gets the more he gives it.",
#:   "Red-signal violation of crossing vehicle with increasing speed inside intersection.",
#:   "RUNS RED LIGHT THEN STEPS ON IT",
#:   "The crossing van flouted red and surged.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: actions = ["run-light", "accelerate"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it accelerates"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.8
#: high = 2.5
#: unit = "m/s"
#: meaning = "how fast it approaches"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(0.8, 2.5)
param OPT_THROTTLE = Range(0.5, 1)

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE)
