#: description = "The crossing car runs the red light and turns left at walking pace."
#: rephrasings = [
#:   "he's got red but he just crawls round to the left in front of us",
#:   "Vehicle 2 made a slow left turn against a red signal.",
#:   "left on red, crawling",
#:   "The target turns left on red at a speed below 14 km/h.",
#:   "A bike turns slowly to the left also when the traffic light shows red.",
#:   "A scooter trundles left through the red, unhurried.",
#:   "Against the lights a car eases itself round to its left, holding everybody up.",
#:   "The cyclist ignores the signal and bends left at a snail's pace.",
#:   "He went through on red and then sort of oozed round to the left at a snail's pace.",
#:   "Cross vehicle disregarded the signal and made a left turn at a very low rate of speed.",
#:   "Bike over red, L turn, crawling.",
#:   "The crossing vehicle passes the red signal and performs its left turn at approximately 5 km/h.",
#:   "The motorbike ignores red and turns left very very slow.",
#:   "Red runner turning left at creep speed, long occupancy of our path.",
#:   "The light was against the cyclist, but he crept out anyway and made his leisurely way round to the left.",
#:   "He's come out on a red, he's going left, and you'd think he had all the time in the world.",
#:   "went thru the red and turned left at like snail mode",
#:   "A motorist ignored the red signal and eased round to the left at little more than walking speed.",
#:   "You disregarded the red, and then turned left with such tardiness that no one could get by.",
#:   "Red light also he is not stopping, and turning left slow slow like morning walk.",
#:   "Jumps the red, right, so you'd think he's in a rush, but no, he crawls round to the left like a milk float.",
#:   "Red-signal violation with slow left turn of crossing vehicle and long exposure in conflict area",
#:   "RUNS THE RED... IN SLOW MOTION (left turn)",
#:   "The crossing cyclist slights the red and meanders left.",
#:   "Red for the scooter; it dribbles round to its left regardless.",
#:   "Simulate a cross-street car disregarding its red and easing left at footpace.",
#:   "Bike from the side, light's red, goes left anyhow, slow as syrup.",
#:   "El semáforo is red for him, but he turns left, tranquilo, like walking.",
#:   "he didn't stop for red and went left slower than my gran",
#:   "Unperturbed by a light that was plainly against him, the gentleman in the hatchback coming from the side went leftward through the junction at the gait of a stroller.",
#:   "The crossing target fails to stop at its red aspect and executes a left turn in the path of the VUT, speed during the turn ≤ 6 km/h.",
#:   "With our green just lit, a motorcyclist sidled past his red from the cross street and swung left with his boots practically brushing the ground all the way.",
#:   "Look, his lights are red and he's still coming, and now he's bearing left in front of us at such a dawdle that we'll have to wait.",
#:   "V2 entered from the cross street on a red indication; its subsequent turn to the left was so slow that V1 had to brake and remain waiting.",
#:   "It had almost completed its turn to the left, this little saloon that had a red light and no business moving, at the speed you'd push a trolley.",
#:   "I was in my lorry, on green, third in the queue, and nobody was going anywhere. Turned out a lady on a bicycle had come out of the side road on red, and was describing the widest, gentlest left turn you ever saw, bell tinkling, basket full of leeks, no quicker than if she'd been wheeling it.",
#:   "The insured's light had changed to green. A saloon then came from the intersecting road in defiance of its own red signal and began turning to its left, and it accomplished this so sluggishly, hardly above the pace of somebody out for a walk, that the insured was forced to make an emergency stop.",
#:   "For the violation suite: cross traffic has red, yet one car goes anyway. It isn't a fast offender; it turns to its left through our path at roughly the speed of a person on foot and stays that slow to the end of the turn. The ego has green and must not assume it'll clear in time.",
#:   "My tuk-tuk passenger was laughing. The light for that side was fully red, sir, and one scooter man came out as if red is only for decoration. He was taking left, so slowly, so slowly, in front of all of us, like he is searching for a dropped coin on the road.",
#:   "Caption this, lads. Guy in a beige estate, his light's been red for ages, rolls out from the side road anyway and starts hooking a left. Ten seconds later he is still hooking that left, at zimmer-frame pace, and the robotaxi in front of me is waiting like a saint.",
#: ]
#: adversaries = ["car", "motorcycle", "bicycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "turn-left", "slow"]
#: control = "signal"
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 15.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.3
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it turns"

param OPT_ADV_DISTANCE = Range(0, 15)
param OPT_SLOW_SPEED = Range(2.3, 3.5)

advTurn = "left-turn"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED)
