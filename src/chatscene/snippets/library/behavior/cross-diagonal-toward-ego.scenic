#: description = "The pedestrian crosses diagonally toward the ego, facing it."
#: rephrasings = [
#:   "She comes over at a slant and heads right for us while doing it.",
#:   "The pedestrian was crossing at an angle against the direction of travel of Vehicle 1.",
#:   "ped diagonal, toward us",
#:   "The target's course makes an acute angle with the oncoming VUT.",
#:   "He crosses not straight but in our direction, with the face to us.",
#:   "A stroller traverses the carriageway obliquely, getting closer to us with every step.",
#:   "Somebody drifts over the lane, angling back toward the traffic that approaches.",
#:   "The man shortens our gap as he goes across slantwise, looking at us all along.",
#:   "a bloke came over the road at a slant, walking up towards us and looking me dead in the eye",
#:   "Pedestrian walked across the roadway at an angle, facing oncoming V1 and closing on it.",
#:   "Ped X-ing obliquely, heading our way, face to us.",
#:   "The pedestrian target crosses on an oblique path with a longitudinal component opposite to the VUT's heading.",
#:   "The woman does not cross straight, she goes slantwise and comes in my direction, she sees me.",
#:   "Walker path: skewed crossing, vector pointing back at the SUT, so the distance shrinks as they cross.",
#:   "He cut the corner of the street on a slant, marching to meet them rather than going square over.",
#:   "Watch the lady: she isn't going straight over, she's coming at you on an angle, face on, getting nearer with each step.",
#:   "this woman is crossing but like towards us?? on a diagonal staring at the car",
#:   "A man took a slanting line over the carriageway and advanced on approaching vehicles, looking straight at the driver",
#:   "She did not go directly over but bore towards the defendant's car, face turned to it, is that your evidence?",
#:   "That aunty is crossing cross-ways only, coming towards our car itself and looking at us",
#:   "Course he can't cross straight like a normal person, has to come slantways at my headlights eyeballing me",
#:   "Oblique pedestrian crossing with component opposed to vehicle travel; frontal approach",
#:   "Guy crosses at an angle STRAIGHT AT my car",
#:   "The walker slanted over the road to meet us.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "diagonal", "oncoming"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.6
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 4.0
#: high = 26.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.8
#: high = 1.05
#: unit = "rad"
#: meaning = "how far its way turns from straight across"

param OPT_ADV_SPEED = Range(1.6, 4)
param OPT_ADV_DISTANCE = Range(4, 26)
param OPT_ADV_ANGLE = Range(0.8, 1.05)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 9 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 4
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 2.4
    # Against the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else globalParameters.OPT_ADV_ANGLE)
