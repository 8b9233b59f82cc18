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
#:   "Bicycle coming our way, stitching the centre line, left, right.",
#:   "oncoming pushbike all snaky down the middle of the road",
#:   "A facing cyclist, meandering either side of the paint.",
#:   "The lamp that came up the road to us couldn't make up its mind about the middle: it was over on our half, on its own half, and over on ours.",
#:   "Give me a schoolgirl on a bike, riding towards the AV, with a line like a sine wave laid on the centre of the carriageway.",
#:   "I saw his left pedal, I saw his right pedal, I saw his left one again, and every change was a trip over the middle line as he came to us.",
#:   "For all the time that she was pedalling up to meet us she drew noughts and crosses on the road, a bit of this side, a bit of that.",
#:   "The bicyclist target, opposing the VUT, follows a laterally periodic course, the mean of which coincides with the middle of the road and whose extremes reach into either half.",
#:   "He's looking at his phone, this cyclist who's heading for you, and he's roaming from one side of the middle to the other, so be ready to stop.",
#:   "It was market day, and he had a goose under one arm. With the other he steered, if it's the word. First we'd have said he would pass us on the one hand, and then, having wobbled through the middle, on the other, and then on the first again. He came all that long hill down in this fashion, goose foremost.",
#:   "A puddle had dried in the middle of the road, and behind him it showed what he'd done: a wavy line of wet tyre across the dashes, across them again, across them again, as regular as the hem of a curtain. And before him there was us, with our wheels on the verge by now, because the next wave but one would have us.",
#:   "I teach my lot to ask where the bike will be when they meet it. With this one nobody could tell. It was coming along the crown of the road, and a second later it'd be well in our half, a second after that well in the other, and it did this as far as I could see it, which was two hundred yards. So we stopped.",
#:   "If it had been his side he kept wandering about on, no one would have rung. The caller's point is that he's using the middle, that he comes toward the traffic and that his swings carry him as far beyond the middle as short of it. Grey coat, no lights, a crate of bottles on the carrier. He's singing. Unit to attend, please.",
#:   "The optical illusion at second thirty: you'd say the bike was standing and it was the centre line that wriggled under it. It isn't so, the guy is really doing curves, two per second or thereabouts, over the line and back over it, and he's riding up at the cammer. What for? There's a bet in the comments; I'm for the headwind.",
#:   "The tracker carries two hypotheses for an oncoming bicycle, passes-left and passes-right, and it's nice to see them alternate. Each time the rider's excursion crosses the road's centre, the weights swap. They swapped nine times before we met. On the tenth we'd ceased to move, which is the only plan that both hypotheses allow.",
#:   "She rode like a hand waving goodbye, only she was coming. The lane was white with dust, the midday empty. To and fro over the middle of it went the straw hat, now above the poppies of his side, almost, now above hers. Giulio took the van down to nothing. He would've known that hat's owner anywhere, she couldn't steer.",
#:   "My client was on his own side; where the bicycle was is a question of when. At the oak it was beyond the middle, at the milestone this side of it, at the gate beyond it. Throughout, it was advancing on him. Nobody can be asked to keep clear of an object that is by turns in each half of the highway.",
#:   "Monsieur the curate has a bicycle without brakes, everybody knows it. In order to slow it he makes the snake. From the top of the village he descends in our direction, traverses the centre to the one side, traverses it to the other, and lifts each time the hat. I took my truck on the grass until the end of the lesson.",
#:   "I'm in the habit of giving a bike five feet. It's a good habit, but you have to know what to measure from. From his left-hand end he'd have left me fifteen, from his right-hand end none, and he visited both ends by turn, across the centre of Quay Road, each yard bringing him nearer to my scooter's front wheel.",
#:   "There was ice. Not where we were driving, up at his end, and I suppose that he'd started to correct and then corrected the correction. The result was a man on a bicycle coming at us in slow swings, like a pendulum with a hat on, with the middle of the street for its lowest point. I switched the hazards on and prayed for him.",
#: ]
#: adversaries = ["bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "weave"]
#: position = "oncoming"
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
