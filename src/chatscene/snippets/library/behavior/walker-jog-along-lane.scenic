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
#:   "runner quits the footway trots off up our lane with us behind",
#:   "Have a jogger leave the sidewalk and run ahead in ego's lane.",
#:   "He jogs down from kerb and runs away before our car, same direction.",
#:   "Kid scampers off the pavement and keeps legging it along our lane.",
#:   "Jogger off footpath, now proceeding with traffic ahead of V1, at a run.",
#:   "A woman in neon stepped up her pace, left the pavement behind her and settled into our lane, where all we saw was her ponytail bobbing on.",
#:   "The pedestrian enters from the footway at a run, aligns with the longitudinal axis of the lane and continues running ahead of the VUT in its direction.",
#:   "You can't pass this gentleman yet. He's come jogging down off the kerb and now he's using your lane as his running track, back to you.",
#:   "Suddenly the man has run from the walkway to my road, and there he did not cross, he ran always forward, and I drove behind his shoes.",
#:   "Because the pavement was full of bins, the runner moved onto the carriageway without breaking stride and carried on down it with the AV at his heels.",
#:   "Where did he go after he had left the pavement? Nowhere, officer: he kept running along the lane, the way I was driving, just ahead.",
#:   "My running club does this and I tell them off for it. Ahead of a grey minivan a tall fellow came off the pavement at a good trot and turned along the lane, the same way as the van was headed. He then ran and ran, right in the middle, deaf to its horn.",
#:   "Jira says closed, I reopened it. Pedestrian comes off the footway at roughly 10 km/h, rotates into our heading and runs on along the lane ahead of us. Never reaches the other side, never turns to face us. Ego expects a crossing to finish and is confused that the obstacle keeps moving away slowly.",
#:   "V1 was northbound. A pedestrian in athletic clothing ran from the sidewalk into the northbound lane in front of V1 and continued northbound therein at a jog. The operator of V1 followed at the jogger's speed for some distance, having first braked sharply, and stated that the jogger did not once look around.",
#:   "From my cab I saw the postman's dog first and then the reason for the postman's haste. He trotted off the kerb into the lane before me, bag flying, and instead of making for the far side he kept right on up the road, the two of us travelling in procession, me in bottom gear.",
#:   "She had run along the railings for as long as there was room. Where the scaffolding began she sprang lightly down, swung into the lane ahead of the evening traffic and ran on with it at her back, her breath white, as though all those headlamps had been lit to show her the way.",
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
