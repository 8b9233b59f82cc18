#: description = "The adversary rides ahead of the ego at the right edge of the same lane."
#: rephrasings = [
#:   "A two-wheeler in front keeps close to the right border of the lane.",
#:   "there's a cyclist pootling along on the right-hand side of our lane",
#:   "cyclist ahead, right edge of lane, same direction",
#:   "The pedalcyclist was traveling in the same direction ahead, along the right side of the lane.",
#:   "The bicyclist target moves ahead of the VUT with a lateral offset to the nearside.",
#:   "The biker goes before the ego at the right side of the line.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advTrajectory"]
#: origin = "Euro NCAP CBLA: a cyclist ahead, off centre"
#: [slots]
#: position = "ahead"
#: side = "right"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 12.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"

param OPT_GEO_Y = Range(12, 30)

advTrajectory = egoRoute.line.offset(-1.2)
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
