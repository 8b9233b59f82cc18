#: description = "The vehicle runs the red light and makes an abrupt left turn."
#: rephrasings = [
#:   "A car ignores the signal and swings sharply to the left inside the junction.",
#:   "Jumping the lights, the adversary turns left in front of the ego.",
#:   "The other driver crosses on red and suddenly cuts left.",
#:   "Against the red a vehicle enters and hauls the wheel over to the left.",
#:   "The motorcyclist disregards the lights and sweeps round leftward.",
#:   "he jumps the red and yanks it left",
#:   "Vehicle 2 entered against the signal and turned sharply to the left.",
#:   "runs red, late hard left",
#:   "He went through the red and then wrenched it left all of a sudden.",
#:   "Vehicle 2 disregarded the red signal and made a sharp left turn.",
#:   "Red jumped, then snap L-turn.",
#:   "The target passes the red signal and executes an abrupt left turn in the junction, without halting.",
#:   "The bus ignores red and turns very sudden to left.",
#:   "Red-light runner who hooks a hard left instead of going straight; completes the turn.",
#:   "The light was red, but through he came, and without a blink he threw it round to the left.",
#:   "He's jumped the lights and he's slinging it left, watch him come round!",
#:   "ran the red AND whipped a left, just casually",
#:   "The van ignored the stop signal and wheeled suddenly to the left, keeping going.",
#:   "It was against a red signal that you threw your vehicle to the left, was it not?",
#:   "Red signal, still he turned left suddenly, one shot, gone.",
#:   "Doesn't fancy waiting on the red, so it's hard over to the left and away.",
#:   "Abrupt left turn by vehicle in violation of red signal.",
#:   "BLOWS RED LIGHT WITH A CRAZY LEFT TURN",
#:   "The bus defied red and whirled left.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: actions = ["run-light", "turn-left"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 42.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 0.0
#: high = 8.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it turns"

param OPT_ADV_DISTANCE = Range(18, 42)
param OPT_ADV_SPEED = Range(5, 10)
param OPT_SWERVE_DISTANCE = Range(0, 8)

advTurn = "straight"

behavior AdvBehavior():
    # Where no way goes straight on, it leaves its way before that bends.
    start = self.pose[2]
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE or abs(self.pose[2] - start) > 0.15
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1.5708)
