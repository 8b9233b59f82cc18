#: description = "The pedestrian dashes across the road at a run."
#: rephrasings = [
#:   "A runner sprints over the street in front of the ego and does not slow down.",
#:   "The pedestrian races through the lane from one kerb to the other.",
#:   "A child chasing a ball tears across the carriageway.",
#:   "Someone bolts over the road at top speed right before the vehicle.",
#:   "The person hurries across flat out, without looking.",
#:   "This kid legs it across right before our bumper.",
#:   "The pedestrian darted into the path of Vehicle 1 while running.",
#:   "The child target crosses the VUT's path at running speed.",
#:   "Some kid bolted over the road right in front of me, going like the clappers.",
#:   "Juvenile pedestrian darted into the street and ran to the other side.",
#:   "Child darts out, running, straight over.",
#:   "The child pedestrian target accelerates from rest to running speed and passes in front of the VUT.",
#:   "A boy runs suddenly over the street to other side.",
#:   "Dart-out ped, runs all the way through without stopping or turning back.",
#:   "She broke into a run off the pavement and was over to the other side in three breaths.",
#:   "Kid's making a run for it, he's going right over, brakes!",
#:   "little kid just ran out n over the road my mom screamed",
#:   "A schoolboy tore over the road chasing a football, missing a car by inches.",
#:   "The child did not walk, he ran, and he kept running until he had reached the opposite pavement?",
#:   "One small boy suddenly came running and crossed full road, so dangerous.",
#:   "Nipper goes haring over in front of my cab, not a glance left or right.",
#:   "Sudden running crossing by pedestrian from roadside.",
#:   "KID BOLTS ACROSS STREET - TOO CLOSE",
#:   "A girl rocketed over the road on foot.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.5
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it runs"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 6.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to run"

param OPT_ADV_SPEED = Range(3.5, 7)
param OPT_ADV_DISTANCE = Range(6, 18)

behavior AdvBehavior():
    # Earlier where it has farther to go, or on a wide road it would pass behind the ego.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
