#: description = "The oncoming car unexpectedly swerves into the ego's lane."
#: rephrasings = [
#:   "A driver coming the other way veers across the centre line.",
#:   "The approaching vehicle jerks over in front of the ego.",
#:   "Opposing traffic suddenly leaves its line and heads into the ego's side.",
#:   "The adversary from ahead lurches sideways toward the ego.",
#:   "The car driving toward the ego yanks the wheel over.",
#:   "he comes the other way and yanks it into our lane",
#:   "Vehicle 2, oncoming, swerved across the centreline into the lane of Vehicle 1.",
#:   "opposing veh, sudden swerve into our lane",
#:   "A car coming the other way suddenly lurched onto my side, I nearly had it head on.",
#:   "Vehicle 2 crossed the center line abruptly into the path of oncoming Vehicle 1.",
#:   "Opp. truck jerks over CL into ego lane. Head-on threat.",
#:   "The oncoming vehicle target makes a sudden lateral deviation into the lane of the VUT.",
#:   "The truck from the other direction suddenly jumps in my lane.",
#:   "Opposite car snaps over the centre line into us; abrupt, one-off, not a drift and not a weave.",
#:   "One moment he was safely over there, the next his headlamps were on her side and coming straight for her.",
#:   "He's over the line! That van coming at you has just lurched onto our side!",
#:   "van coming the other way jerked into our lane we nearly DIED",
#:   "The oncoming lorry leapt over to the wrong half of the road, leaving a motorist with seconds to react.",
#:   "In one movement your car left its own side and entered hers, coming toward her; do you dispute that?",
#:   "The car from opposite suddenly came to my lane, direct face to face.",
#:   "One second he's on his side, next second I'm staring down his headlamps on mine.",
#:   "Abrupt head-on lane incursion of opposing vehicle.",
#:   "ONCOMING TRUCK SWERVES INTO MY LANE - HEAD ON!",
#:   "The oncoming bus lurched athwart into our lane.",
#:   "A bike that comes the other way veers over the centre line in front of the ego.",
#:   "A bicyclist travelling in the opposite direction crossed the centreline abruptly.",
#:   "A lad on a pushbike coming the other way suddenly veered over the white line at me.",
#:   "biker coming the other way just darted over the line into my lane",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "swerve"]
#: position = "oncoming"
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 40.0
#: unit = "m"
#: meaning = "distance to the ego at which it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.5
#: high = 3.5
#: unit = "m"
#: meaning = "how far it swerves"

param OPT_ADV_SPEED = Range(4, 10)
param OPT_ADV_DISTANCE = Range(12, 40)
param OPT_SWERVE = Range(1.5, 3.5)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE)
