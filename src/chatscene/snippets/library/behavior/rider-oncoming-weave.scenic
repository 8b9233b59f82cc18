#: description = "The oncoming cyclist weaves from side to side across the middle of the road."
#: rephrasings = [
#:   "A bike coming at us is all over the road.",
#:   "The bicyclist approaching from the opposite direction weaved across the centerline.",
#:   "oncoming cyclist weaving over centre line",
#:   "The oncoming bicyclist target oscillates across the lane marking.",
#:   "The cyclist from front makes snakes on the road.",
#:   "A tipsy student pedals toward us in loops.",
#:   "No hands on the bars, the rider we meet drifts to and fro.",
#:   "The boy heading our way slaloms between imaginary cones.",
#:   "a cyclist coming the other way was wobbling all over the middle of the road",
#:   "The bicyclist, traveling toward V1, swerved repeatedly back and forth across the center of the roadway.",
#:   "Opp. bicycle meanders over centre line, both sides.",
#:   "The oncoming bicyclist oscillates laterally about the centre line of the road.",
#:   "One man on bicycle comes from front and goes left and right over the middle line like drunk.",
#:   "Opposite cyclist: sinusoidal path centred on the dividing line, repeatedly poking into our lane.",
#:   "He pedalled towards them in great loops, now on his own side, now on theirs, singing for all they knew.",
#:   "Pushbike coming at you, he's wandering either side of the white line, can't hold a course at all.",
#:   "bike coming at us wobbling all over the middle like he just learnt to ride",
#:   "A schoolgirl on a bicycle meandered to and fro over the centre of the road into approaching traffic",
#:   "Coming towards the car, you were now on one side of the middle and now on the other?",
#:   "Opposite cyclist going zig zag in middle of the road, coming our side, going his side, no balance",
#:   "Pushbike coming at me can't decide which half of the road he wants, so he's having both in turn",
#:   "Laterally oscillating opposing cyclist over the road centre",
#:   "Wobbly cyclist heads my way ALL OVER the center line",
#:   "The cyclist facing us meandered over the road's spine.",
#:   "Pushbike facing us snakes over the centre line, left, right, left.",
#:   "Opposing cyclist zigzagging about the dividing line, no straight riding.",
#:   "Let the kid on the bike approach in wiggles round mid-road.",
#:   "The boy rode to us like a worm, across the middle stripe.",
#:   "Tandem heading my way, lurching to and fro over the white paint!",
#:   "With a crate of beer on the carrier, a student cycled to meet us, swaying over the middle of the road and away from it in turns.",
#:   "The bicyclist target travels opposite to the VUT along the centre of the road with a periodic lateral displacement to both sides of the marking.",
#:   "Here's a bicycle coming; is he on your half, is he on his? He's on both, swapping every second, so slow right down for him.",
#:   "That cyclist in contrary sense was dancing on the line of the centre, one time in my half, one time in his, until he arrived.",
#:   "Our dash cam has an old woman pedalling at us on a course like knitting: over the middle, back, over the middle, back again.",
#:   "What business had the rider coming the other way to be swinging pendulum-fashion about the crown of the road with a lorry bearing down?",
#:   "I was in the cab with a full load of gravel when a lad on a racer came round the bend toward me. He was standing on the pedals and throwing the bike about, so he was a yard across the middle line one moment and a yard short of it the next.",
#:   "Vehicle 1's driver first observed the bicyclist at about sixty metres, approaching. The bicyclist was not keeping to the right but described a wavy line around the centre of the roadway. He crossed into Vehicle 1's half at least four times before the two met, returning on each occasion.",
#:   "Feature request, oncoming cyclist on a sine. Path oscillates about the road's centreline with two metres of amplitude, so for half of every period the bike intrudes on our side. It keeps coming at about 15 km/h. The planner sees the gap open and close and can't make its mind up; it should just wait.",
#:   "There must have been a wind, or a wasp, or a girl watching from a window, for the butcher's boy didn't ride up the road to meet us so much as sew it together, his front wheel stitching across the middle and back across the middle, whistling all the while.",
#:   "I ride to work every day so I don't like slagging off cyclists, but this one, oof. She's coming towards the car I'm tucked in behind, one hand on her phone, and drifting from her side to ours to hers to ours, the centre line just going under her wheels each time.",
#:   "Girl on a bike comes at us, looping over the middle line.",
#:   "Make the facing cyclist swing to and fro about the road's centre.",
#:   "pushbike heading for me doing the snake across the white line",
#:   "He'd a ladder on his shoulder, riding to meet us, and the weight of it pulled him across the middle and back again with each push of the pedals.",
#:   "The approaching bicyclist follows a sinusoidal track whose axis is the centre of the carriageway, intruding into the VUT's half during each alternate half-wave.",
#:   "Opposite side cycle-wallah is coming with gas cylinder behind, all over the middle of road, this side that side, his balance is totally out.",
#:   "Cyclist ahead, coming to you, and he's sewing the two halves of the road together with his front wheel, so drop your speed and give him width.",
#:   "Which side of the road was she on as she rode toward you? Both by turns, my lord; she kept swerving over the middle and back over it.",
#:   "The old man on the bicycle was coming against us with many curves, one time left from the middle line, one time right from it, without end.",
#:   "He can't have been more than nine, and the bicycle was his brother's. He was pedalling up the hill as we came down it, so with every stamp he lurched over the centre towards our side, and with the following stamp he lurched home. I had the car at a crawl by the time he drew level.",
#:   "V1 was descending Hill Street when its operator saw a bicycle ascending toward her. The bicyclist did not maintain a straight line but moved from side to side across the centerline, about three feet each way, with a regular rhythm. V1's operator steered to the edge and stopped.",
#:   "Somebody had tied balloons to the handlebars, which was pretty, but they caught the wind. I was driving the coach. This bicycle, coming the other way, would be blown over the dashes to my half, the girl would haul it back to hers, and then it was my half's turn again, all down the seafront.",
#:   "The lamp told it before there was any rider to be seen. In the dark ahead, a small white light was on its way to us; it slid across to the left of the middle, hung, slid across to the right, hung, and slid again, like a lantern on a ship's mast. My pupil asked me if it was a UFO.",
#:   "Please implement an oncoming bike that can't stay on its side. It rides against our direction, centre of the road, amplitude one to two metres, period three seconds or so. It is in our half for some of the time, in its own for the rest. Ego must treat the worst point of the swing as the edge.",
#:   "There's a technique for steep hills called tacking, and cyclists do it without asking. From the cab of my lorry I looked down on a chap coming up at me who tacked: from his own half slantwise over the middle to mine, then from mine over the middle to his. I had thirty tonnes pushing and I didn't find it funny.",
#:   "The postmistress was coming along the lane on her bicycle toward the doctor's car, and reading a letter. It was evidently a letter with two sides to it, for she swayed to the one side of the road's middle and to the other, and the doctor, who had written it, took his foot off the gas and blushed.",
#:   "I ride too, so I'm allowed to be rude. He had headphones on and he was dancing. On a bike! Heading straight for the car I was drafting, hips to the left and he's over the line with us, hips to the right and he's back on his own bit, hips to the left and so on. We nearly stopped.",
#:   "My niece said into the microphone, \"A man was riding his bike to us and it was all wiggly. First it was wiggly on our side and then it was wiggly on the other side and the stripe in the middle was always going under him. Mummy drove like a snail because of it.\"",
#:   "The damage is to my client's left mirror only. A bicyclist was nearing from the opposite direction, in a wavy course whose peaks lay a good metre inside my client's side of the road and whose troughs lay on his own. My client had the bad luck to meet a peak.",
#:   "What we have on the recording is basically a graph. Bike comes towards us from the top of the picture. Plot its distance from the centre marking and you get up, down, up, down, five full swings, both sides of zero. The beer crate on the rack may explain the amplitude.",
#: ]
#: adversaries = ["bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "weave"]
#: position = "oncoming"
#: leader = false
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.5
#: high = 5.5
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 1.2
#: high = 2.2
#: unit = "m"
#: meaning = "how far it swings to either side"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 3.5
#: high = 5.0
#: unit = "s"
#: meaning = "how long a full swing takes"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.0
#: high = 2.2
#: unit = "m"
#: meaning = "how far it keeps toward the ego's lane"

param OPT_ADV_SPEED = Range(3.5, 5.5)
param OPT_ADV_AMPLITUDE = Range(1.2, 2.2)
param OPT_ADV_PERIOD = Range(3.5, 5)
param OPT_SWERVE = Range(1, 2.2)

behavior AdvBehavior():
    do WeaveOnPath(advTrajectory.offset(globalParameters.OPT_SWERVE), globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
