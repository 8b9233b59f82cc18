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
#:   "biker glued level with our door no way acros for us",
#:   "Hatchback rides abreast at equal speed and keeps our lane change shut.",
#:   "Keep a motorbike dead level with the ego the whole way.",
#:   "Adjacent saloon, zero drift, abeam throughout, lane change not possible.",
#:   "That car stays next to us and won't let daddy over.",
#:   "I braked a little, so did the cab; I sped up a little, so did the cab; it just remained at my side and kept the lane closed.",
#:   "The neighbouring target maintains longitudinal overlap with the vehicle under test at identical speed for the duration of the run and thus prevents it from changing lanes.",
#:   "You want to be over there by the next exit, but there's an SUV sitting off your right shoulder like a bodyguard, going precisely as fast as you.",
#:   "The motor bicycle was always exactly in parallel to me, so I could not go into the other lane, although I have waited very long.",
#:   "Is there anything more maddening than a car that neither passes you nor falls in behind, but just occupies the very spot you need beside you?",
#:   "For the entire length of the recording the pickup is level with the robotaxi in the lane it is trying to reach, and copies its pace.",
#:   "We had the neighbour's company for six kilometres. A silver estate, its driver staring ahead, kept its wheels in line with ours as if there were a rod between us. I needed that lane to get off at Fulda, and I never got it, because he never left my side.",
#:   "The Claimant indicated in good time. The motorcycle in the next lane did not yield and did not go ahead either; it adopted the Claimant's speed and held that position at her flank, so that there was no gap to enter. Having no choice, she missed her turn.",
#:   "Merge abort not triggered. NPC in the target lane locks on to our longitudinal position with no more than a metre of error and follows any change of speed we make. It does not enter our lane at any time. Requested: planner should abandon the merge after some seconds rather than insist.",
#:   "He had noticed the black car because it did not behave like traffic. Traffic comes and goes. This stayed. When he hurried it was beside him, when he idled it was beside him, a dark wall moving with his window, and the lane that he wanted lay on its other side.",
#:   "I ride a moped for the pizza place, so I was watching from behind. The two of them were like a pair of skates: the red coupé next to the test car, same speed, no gap front or back, mile upon mile, and the test car's blinker going the entire time for nothing.",
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
