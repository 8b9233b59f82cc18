#: description = "The cyclist swings into the ego's lane from the side and rides on slowly ahead of it."
#: rephrasings = [
#:   "A rider enters from the kerb and takes the lane at low speed.",
#:   "The cyclist turns onto the carriageway right before the ego and dawdles along.",
#:   "A bike pulls out of the side and stays in front of the vehicle.",
#:   "The motorcyclist cuts in from the roadside and crawls onward.",
#:   "The rider merges from beside the road and forces the ego to tuck in behind.",
#:   "This bike just swings off the pavement into our lane and potters along.",
#:   "The bicyclist entered the travel lane from the shoulder and proceeded slowly ahead of Vehicle 1.",
#:   "bike joins lane from edge, slow, stays ahead",
#:   "A woman on a pushbike came in from the side and then pedalled along slowly right in front of me.",
#:   "The bicyclist merged from the roadside into Unit 1's lane and continued ahead at low speed.",
#:   "Bike moves in from side, plods on ahead of ego, same dir.",
#:   "The cyclist target enters the VUT's lane laterally and continues ahead at low speed in the same direction.",
#:   "The cyclist comes from the side in my lane and rides slowly before me.",
#:   "VRU merges in from the bike lane/edge and becomes a slow leader; no stop, no crossing.",
#:   "She slipped in ahead of him from the edge of the road and went on pedalling at her leisure.",
#:   "Cyclist moving in from the right, he's taken the lane and he's pottering along, so tuck in behind.",
#:   "a bike came in from the side and now were stuck going bike speed",
#:   "A cyclist filtered in from the roadside and led the traffic at her own leisurely rate.",
#:   "She came from the side into his lane and proceeded, in the same direction, at a modest pace before him?",
#:   "One cycle came from the side into my lane and going slowly in front, cannot overtake.",
#:   "In from the side he drifts, and now I'm chauffeuring behind a pushbike at eight miles an hour.",
#:   "Lateral lane entry by two-wheeler with slow onward travel ahead of ego.",
#:   "CYCLIST MERGES IN FRONT OF ME AND TAKES HIS TIME",
#:   "The moped slotted into our lane and ambled ahead.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cut-in", "slow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 3.8
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 40.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts"

param OPT_ADV_SPEED = Range(1.5, 3.8)
param OPT_ADV_DISTANCE = Range(10, 40)

behavior AdvBehavior():
    # Earlier where it has farther to go, or on a wide road it would pass behind the ego.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 2.5
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED)
