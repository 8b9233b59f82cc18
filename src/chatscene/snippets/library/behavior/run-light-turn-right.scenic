#: description = "The vehicle runs the red light and makes an abrupt right turn."
#: rephrasings = [
#:   "A car ignores the signal and hooks sharply to the right inside the junction.",
#:   "Jumping the lights, the adversary swings right in front of the ego.",
#:   "The other driver crosses on red and suddenly turns right.",
#:   "Against the red a vehicle enters and yanks the wheel rightward.",
#:   "The motorcyclist disregards the lights and cuts round to the right.",
#:   "he runs the red and chucks it to the right",
#:   "Vehicle 2 entered against the signal and turned sharply to the right.",
#:   "runs red, late hard right",
#:   "The van didn't bother with the red, he just whipped it round to the right in front of me.",
#:   "Unit 2 failed to stop for the red signal and made a sharp right turn.",
#:   "MC ignores red, snap R turn.",
#:   "The target vehicle passes the red signal and performs a right turn with high yaw rate.",
#:   "The bus has red but goes fast around to the right.",
#:   "Red runner with a sudden right turn into our exit, quick steering, no stop at the line.",
#:   "She had green; he had red, and still he threw the wheel over and barrelled round to the right.",
#:   "Truck's not stopping for that light, he's yanked it right, he's coming into your road.",
#:   "he didnt even stop for the red just whipped a right",
#:   "A car took a sudden right-hand turn against the red signal.",
#:   "The signal being against you, you nonetheless turned to the right, and sharply.",
#:   "Red signal was there but he cut the right turn just like that, full sudden.",
#:   "Red's only a suggestion for him, hard right and gone.",
#:   "Abrupt right turn of vehicle in violation of red signal",
#:   "NO STOP ON RED, snaps right in my face",
#:   "The truck flouts the red and lunges right.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: actions = ["run-light", "turn-right"]
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
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -1.5708)
