#: description = "The adversary rides ahead of the ego at the left edge of the same lane."
#: rephrasings = [
#:   "A two-wheeler in front keeps close to the left border of the lane.",
#:   "a motorbike up ahead is hugging the centre line in our lane",
#:   "motorcycle ahead, left edge of lane, same direction",
#:   "The motorcycle was traveling in the left tire track of the lane ahead of Vehicle 1.",
#:   "The target moves ahead of the VUT with a lateral offset to the offside.",
#:   "The biker goes before the ego at the left side of the line.",
#: ]
#: adversaries = ["motorcycle", "bicycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advTrajectory"]
#: origin = "own code"
#: [slots]
#: position = "ahead"
#: side = "left"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 10.0
#: high = 24.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"

param OPT_GEO_Y = Range(10, 24)

advTrajectory = egoRoute.line.offset(1.2)
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
