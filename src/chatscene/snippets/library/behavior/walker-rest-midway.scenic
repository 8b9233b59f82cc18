#: description = "The pedestrian shuffles across slowly, stops for breath in the lane and shuffles on."
#: rephrasings = [
#:   "The old dear creeps over, has a breather in the middle and creeps on.",
#:   "The elderly pedestrian paused in the lane while crossing slowly and then resumed walking.",
#:   "slow ped, rests mid-lane, goes on",
#:   "The target crosses at 1 m/s with one interruption within the VUT's lane.",
#:   "The grandfather goes slow, must make a pause, goes slow again.",
#:   "A lady with a rollator inches over, catches her breath and inches further.",
#:   "He hobbles off the pavement, leans on his stick a while and hobbles the rest.",
#:   "Plodding across, the frail walker takes a little break just where we want to be.",
#:   "This poor old thing was shuffling over with her stick and had to stop for a breather in my lane.",
#:   "Elderly pedestrian crossing slowly, paused to rest in the travel lane, then resumed at a slow pace.",
#:   "Old ped, slow, rests mid-lane, then slow again.",
#:   "The elderly pedestrian target crosses at reduced speed with one rest period within the lane.",
#:   "Grandfather goes slow over the street, in the middle he is tired and makes pause, then goes slow on.",
#:   "Slow crosser, one long dwell in our lane to recover, then same low speed.",
#:   "Halfway over he leaned on his stick and puffed, and they waited till he had wind enough for the rest.",
#:   "Give the gentleman a moment, he's only small steps, he's stopped to get his breath, there, he's off again.",
#:   "this old man had to take a break halfway across, i felt bad",
#:   "A frail pensioner halted in mid-road to recover her strength and then resumed her slow progress.",
#:   "The old gentleman, walking feebly, was obliged to rest in the lane before he could go further.",
#:   "Ah gong walk halfway tired already, stand there take breath, then slowly walk again.",
#:   "Poor old girl runs out of puff in front of my cab, has her minute and then hobbles on.",
#:   "Slow crossing of infirm pedestrian with recovery stop in own lane",
#:   "GRANDPA TAKES A BREATHER IN MY LANE",
#:   "The pensioner hobbles out, pants awhile in the lane and hobbles on.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "slow", "hesitate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.7
#: high = 1.2
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 40.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.2
#: high = 1.5
#: unit = "m"
#: meaning = "how far from the ego's line it rests"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.8
#: high = 2.5
#: unit = "s"
#: meaning = "how long it rests"

param OPT_ADV_SPEED = Range(0.7, 1.2)
param OPT_ADV_DISTANCE = Range(10, 40)
param OPT_STOP_DISTANCE = Range(0.2, 1.5)
param OPT_STOP_TIME = Range(0.8, 2.5)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
