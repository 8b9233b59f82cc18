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
#:   "Oncoming cyclist yanks the bars and he's in our lane.",
#:   "Out of nowhere the approaching coach lunges at our half.",
#:   "Let a motorbike facing the AV dart abruptly into its lane.",
#:   "Opposing van, one violent steer, now heading at us in our lane.",
#:   "Suddenly the lorry coming towards me flung itself over the white line.",
#:   "The pickup, which was minding its own side as it neared us, shot sideways into our lane for no reason I could see.",
#:   "A bus is arriving from in front, all is normal, and in one instant he breaks out of his line into mine.",
#:   "With the gap at its threshold value, the approaching target shall be steered rapidly over the centre line into the VUT's lane.",
#:   "Why would a man on a pushbike, coming the opposite way in broad daylight, whip across into the lane of a moving car?",
#:   "Ambulance requested; the subject vehicle was forced off after a southbound SUV cut hard over into the northbound lane without any warning.",
#:   "everything fine then the taxi coming at us just SNAPS over into our lane like someone kicked the wheel",
#:   "My lane was clear and the moped opposite was puttering along in his. I think a wasp got into his helmet, because he gave the handlebars an almighty wrench and was suddenly right there ahead of me on my side.",
#:   "V1 was eastbound, V2 was westbound. For undetermined reasons V2's operator made an abrupt steering input to the left and entered the eastbound lane in front of V1; no phone use, alcohol or mechanical defect was established.",
#:   "Keep an eye on what's coming, always. That builder's lorry looked perfectly settled on his own side, and before you could have said knife he'd jumped over the paint and was nose-on to us.",
#:   "What I need is plain: traffic from ahead, in its proper lane, behaving nicely. At short range one saloon does a single vicious swerve and intrudes into the lane of the robotaxi; no drifting beforehand, the reaction time is the point.",
#:   "He remembered the headlights, two calm yellow eyes keeping to their own half of the rain. Then they flicked aside, as if the road had been jerked from under them, and were in front of him, in his lane, growing.",
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
