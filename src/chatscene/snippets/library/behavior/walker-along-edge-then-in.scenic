#: description = "The pedestrian walks along the edge of the lane with its back to the ego and suddenly turns across it."
#: rephrasings = [
#:   "She's minding her own business along the side, then hangs a turn straight across us.",
#:   "The pedestrian walking along the shoulder with traffic turned abruptly into the path of Vehicle 1.",
#:   "ped along edge, sudden turn across",
#:   "The target walks parallel to the VUT beside its lane and then turns through a right angle to cross it.",
#:   "He goes along the border and all at once he turns over the road.",
#:   "A rambler on the verge wheels round without a glance and traverses the lane.",
#:   "Someone keeps to the gutter for a stretch before veering over to the other pavement.",
#:   "The dog walker trails along beside the traffic until the dog pulls him over.",
#:   "this woman was walking along the side with her back to us and without a look she just turned and came right across",
#:   "The pedestrian was walking with traffic along the lane edge, back to V1, and abruptly turned to cross in front of it.",
#:   "Ped same dir. on edge, back to us, sudden turn -> across.",
#:   "The pedestrian target walks in the VUT's direction at the lane border and changes to a crossing path without warning.",
#:   "A man walks on the side of the lane, I see his back, and suddenly he turns in front of my car.",
#:   "Walker moves parallel to SUT, same heading, then a 90° heading change over our lane on trigger.",
#:   "He had been trudging along the edge before them, never looking round; then he wheeled and walked over under their headlights.",
#:   "Careful of that fellow with his back to you, he doesn't know you're here, and there, he's turned over into your lane.",
#:   "guy walking along the side with his back to us just turned and crossed, headphones in obv",
#:   "A woman strolling beside the traffic with her back to it struck out over the road unannounced",
#:   "She was walking the same way as you, at the margin, and turned over your path without looking behind?",
#:   "Fellow walking on the roadside, back side to us, suddenly he turned and started crossing",
#:   "He's ambling along the gutter, back of his head to me, then hangs a sharp one straight over my front",
#:   "Edge-walking pedestrian facing away with sudden right-angled lane entry",
#:   "Man walking along the road TURNS into me without looking",
#:   "The walker trudging along the edge peeled off across us.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["follow", "swerve", "cross"]
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 3.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 26.0
#: high = 46.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_REACT_DISTANCE"
#: low = 3.0
#: high = 13.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it turns across"

param OPT_ADV_SPEED = Range(1.5, 3)
param OPT_ADV_DISTANCE = Range(26, 46)
param OPT_REACT_DISTANCE = Range(3, 13)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(3) until abs(offsetFrom(egoRoute, self)) < 2.7
    # A quarter turn into the ego's direction, from whichever side it comes, and later back.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1.57 if offsetFrom(egoRoute, self) > 0 else -1.57) until headway(egoRoute, ego, self) < globalParameters.OPT_REACT_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -1.57 if offsetFrom(egoRoute, self) > 0 else 1.57)
