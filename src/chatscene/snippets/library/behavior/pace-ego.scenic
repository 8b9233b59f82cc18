#: description = "The car drives parallel to the ego and blocks its path."
#: rephrasings = [
#:   "A vehicle stays level with the ego, leaving no gap to move over.",
#:   "The adversary matches the ego's speed beside it.",
#:   "The neighbouring car keeps abreast and shuts the ego out of the lane.",
#:   "Side by side with the ego, the driver refuses to let it in.",
#:   "The car shadows the ego door to door.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advLane"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["pace"]
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = -7.0
#: high = 7.5
#: unit = "m"
#: meaning = "how far ahead of the ego it stays"

param OPT_ADV_AHEAD = Range(-7, 7.5)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD)
