#: description = "The oncoming car swerves into the ego's lane, brakes hard, and stops there."
#: rephrasings = [
#:   "he swerves across at us and then stamps on it",
#:   "Vehicle 2 veered across the centreline, braked heavily, and came to rest in the lane of Vehicle 1.",
#:   "opposing veh swerves over, full brake, stands in our lane",
#:   "The oncoming target steers abruptly into the lane of the VUT and brakes to standstill.",
#:   "The truck makes a fast movement to our lane and brakes until it stays.",
#:   "A biker opposite loses it, shoots over the line and slides to a halt.",
#:   "To avoid something on its side, the van flings itself onto ours and skids to a stop.",
#:   "It darts over in front of the ego and pulls up with smoking tyres.",
#:   "The car coming towards me lurched onto my side, jammed on its brakes and ended up stationary in my way.",
#:   "Unit 2 crossed the center line, braked hard, and came to final rest in Unit 1's lane.",
#:   "Truck oncoming, veers over, full brake, stands in our lane.",
#:   "The opposing vehicle deviates into the lane of the test vehicle, performs full braking and remains at rest in it.",
#:   "The car from the front comes in my lane, brakes much and stands there before me.",
#:   "Opp. actor jumps the centreline, hard decel to 0, blocks us head-on.",
#:   "It slewed over to their side, tyres howling, and finished up nose to nose with them.",
#:   "Bus coming the other way's slid over the line, he's locked up, he's stopped smack in your lane.",
#:   "car coming at me jerked into my lane, slammed it n just stopped there facing me",
#:   "An oncoming car careered onto the wrong side, braked fiercely and was left standing in the opposite lane.",
#:   "You left your half of the road, you braked with all your force, and in my client's lane you came to rest.",
#:   "Opposite car came into my lane, sudden brake, and he is standing nose to nose with me.",
#:   "Chucks it over to my side, locks everything up and there he sits, headlamp to headlamp.",
#:   "Lane departure of opposing vehicle with full braking to standstill in own lane",
#:   "HE SWERVED INTO MY LANE AND STOPPED DEAD facing me",
#:   "The oncoming van yaws into our lane and screeches to rest.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "swerve", "brake", "stop"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 7.0
#: high = 11.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 22.0
#: high = 48.0
#: unit = "m"
#: meaning = "distance to the ego at which it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 2.2
#: high = 3.8
#: unit = "m"
#: meaning = "how far it swerves"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.6
#: high = 1.2
#: unit = "s"
#: meaning = "how long after it swerved it brakes"

param OPT_ADV_SPEED = Range(7, 11)
param OPT_ADV_DISTANCE = Range(22, 48)
param OPT_SWERVE = Range(2.2, 3.8)
param OPT_STOP_TIME = Range(0.6, 1.2)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 5 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE) for globalParameters.OPT_STOP_TIME seconds
    do BrakeOnPath(advTrajectory, 0.8, globalParameters.OPT_SWERVE)
