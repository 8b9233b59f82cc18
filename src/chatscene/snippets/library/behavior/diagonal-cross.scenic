#: description = "The pedestrian crosses the road diagonally, slanting along it."
#: rephrasings = [
#:   "A person walks over the carriageway at a slant rather than straight across.",
#:   "The pedestrian takes an oblique line through the lane ahead of the ego.",
#:   "A jaywalker cuts the road at an angle.",
#:   "Someone wanders across on a long diagonal, with their back to the ego.",
#:   "The cyclist drifts over the street slantwise.",
#:   "He takes the lazy slanted shortcut over the road in front of us.",
#:   "The pedestrian crossed the roadway at an angle rather than perpendicular to traffic.",
#:   "ped crosses obliquely, same heading as us",
#:   "He didn't go straight over, he cut across at a slant as if the road was a field.",
#:   "Pedestrian traversed the roadway at an angle rather than perpendicular to it.",
#:   "Ped x-ing oblique, half along road, half over.",
#:   "The pedestrian target follows a trajectory at approx. 45 degrees to the lane axis.",
#:   "The man walks over the road not straight but oblique, so it takes long.",
#:   "Crosser heading is skewed, moves with the lane as well as through it.",
#:   "She took the long line over, edging down the street and over it at one and the same time.",
#:   "That cyclist is cutting across on the angle, he'll be in your way longer than you think.",
#:   "he crossed like corner to corner instead of straight over, took forever",
#:   "A pedestrian took a slantwise course over the road, with the oncoming car gaining on him the while.",
#:   "The witness did not walk straight over, my lord; she bore away along the street as she went.",
#:   "Uncle crossing in slanting manner, not straight, so whole time he is in front of my vehicle.",
#:   "Never learnt to cross square, this one, he's going over like a bishop on a chessboard.",
#:   "Skewed crossing trajectory of vulnerable road user with extended exposure in the lane",
#:   "JAYWALKER TAKES THE HYPOTENUSE",
#:   "The cyclist angles across the street.",
#: ]
#: adversaries = ["pedestrian", "bicycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "diagonal"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.3
#: high = 4.5
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 52.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.55
#: high = 0.9
#: unit = "rad"
#: meaning = "how far its way turns from straight across"

param OPT_ADV_SPEED = Range(1.3, 4.5)
param OPT_ADV_DISTANCE = Range(18, 52)
param OPT_ADV_ANGLE = Range(0.55, 0.9)

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 12)
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE)
