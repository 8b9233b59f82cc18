#: description = "The pedestrian jogs off the pavement and runs on along the lane ahead of the ego."
#: rephrasings = [
#:   "A jogger pops out and keeps running down our lane, back turned to us.",
#:   "The pedestrian was running in the roadway with traffic, ahead of Vehicle 1.",
#:   "runner enters lane, keeps on same way as us",
#:   "The target enters the lane and moves longitudinally ahead of the VUT at running speed.",
#:   "The sportsman runs on the road in our direction before the car.",
#:   "A marathon trainee dodges the puddles by switching to the tarmac and pounding along it.",
#:   "A thief flees down the middle of the road with his loot.",
#:   "Someone breaks into a run down the carriageway as if racing us.",
#:   "a jogger hopped off the pavement and carried on running down the lane in front of me like it was a track",
#:   "The jogger left the sidewalk and continued running in the travel lane ahead of V1.",
#:   "Runner off pavement -> our lane, jogs along, same dir.",
#:   "The pedestrian target leaves the footway at running speed and continues along the lane in the VUT's direction.",
#:   "A sport man runs from the sidewalk in my lane and runs further there, before my car.",
#:   "Runner enters from footpath and then tracks the lane centre ahead of the SUT; he's a slow lead, not a crosser.",
#:   "She had come off the kerb with her earphones in, and her easy strides took her on ahead of them down the middle of their lane.",
#:   "He's out on his morning run, and he's come off the footpath and he's using your lane; he's heading the way you are.",
#:   "this runner just hopped off the pavement and is jogging in front of us like its a track",
#:   "A fitness fan forsook the pavement and ran on in the carriageway ahead of cars",
#:   "You left the footway and went running along the lane, your back to the traffic?",
#:   "Jogger uncle came down from footpath and running in our lane in front, like marathon",
#:   "Lycra's left the pavement and he's pounding along ahead of me like I'm his support car",
#:   "Pedestrian running lengthwise in own lane after leaving the pavement",
#:   "Jogger runs down MY LANE like I'm not there",
#:   "The jogger loped off the pavement and up our lane.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: leader = false
#: actions = ["fast", "follow"]
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.4
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it runs"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 6.0
#: high = 26.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 1.0
#: high = 2.4
#: unit = "m"
#: meaning = "how far from the ego's line it turns along the lane"

param OPT_ADV_SPEED = Range(3.4, 5)
param OPT_ADV_DISTANCE = Range(6, 26)
param OPT_ADV_REACH = Range(1, 2.4)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(2.5) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    # A quarter turn into the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1.57 if offsetFrom(egoRoute, self) > 0 else -1.57)
