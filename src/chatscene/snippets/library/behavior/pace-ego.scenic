#: description = "The car drives parallel to the ego and blocks its path."
#: rephrasings = [
#:   "A vehicle stays level with the ego, leaving no gap to move over.",
#:   "The adversary matches the ego's speed beside it.",
#:   "The neighbouring car keeps abreast and shuts the ego out of the lane.",
#:   "Side by side with the ego, the driver refuses to let it in.",
#:   "The car shadows the ego door to door.",
#:   "He sticks to our flank and won't let us over.",
#:   "Vehicle 2 travelled abreast of vehicle 1 at an equal speed.",
#:   "The target keeps lateral station alongside the VUT, zero relative velocity.",
#:   "this coach sat alongside me matching me mile for mile, so I couldn't get over",
#:   "V2 traveled abreast of V1 at the same speed, preventing V1 from moving over.",
#:   "Truck parallel, same v, lane shut for us.",
#:   "The target remains level with the VUT in the adjacent lane at identical speed, denying the lane change.",
#:   "The car goes always next to me, not faster, not slower, and I can not change the lane.",
#:   "Parallel runner keeps the SUT boxed: copies its velocity, stays abeam for the entire run.",
#:   "Whatever speed they chose the motorcycle chose too, and so it kept them walled in.",
#:   "He won't go forward and he won't drop back, he's just sat at your shoulder shutting the door on you.",
#:   "this car is right next to us and wont let us over, speeds up when we do slows when we do",
#:   "A driver was hemmed in by a bus that kept station at her side mile after mile",
#:   "You remained level with my client's doors, so that she was denied the lane?",
#:   "I go fast he go fast, I go slow he go slow, side by side, don't want to let me change lane",
#:   "Want to get over, can't, this fella's stuck to my ribs and he ain't shifting",
#:   "Parallel travel of adjacent vehicle at equal speed; blocked lane change, no braking",
#:   "Truck REFUSES to let me change lanes, matches my speed",
#:   "The motorbike mirrored our speed at our elbow.",
#: ]
#: adversaries = ["car", "motorcycle"]
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
