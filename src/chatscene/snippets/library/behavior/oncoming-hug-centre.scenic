#: description = "The slow oncoming truck hugs the centre of the road."
#: rephrasings = [
#:   "this big slow thing is coming at us right down the middle",
#:   "Vehicle 2, an oncoming truck, straddled the centreline at low speed.",
#:   "opposing truck, slow, half over the line",
#:   "The oncoming heavy vehicle travels at less than 14 km/h with a constant offset toward the lane of the VUT.",
#:   "A bus comes slowly and it takes a part of our lane because is too wide.",
#:   "A wide load lumbers along, sticking out into the ego's half.",
#:   "The lorry opposite crawls over the white line and leaves hardly any room.",
#:   "A coach from ahead plods along far too near the middle.",
#:   "There was a great big lorry trundling towards me with its wheels right on the white line.",
#:   "Opposing commercial vehicle was traveling slowly, riding the center line.",
#:   "Bus oncoming, slow, close to middle line, little room.",
#:   "The opposing heavy vehicle proceeds at low speed with a lateral offset towards the road centreline.",
#:   "A truck comes slow from the front and drives too much in the middle.",
#:   "Opp. HGV with lane offset at the divider, low v, squeezes our lateral clearance.",
#:   "It lumbered towards them down the very middle and left them hardly room to breathe.",
#:   "That wagon coming at you is taking his half out of the middle, and he's in no hurry, so keep well in.",
#:   "big slow truck coming at me basically sitting on the middle line",
#:   "A lumbering lorry came the other way with its flank against the dividing line, leaving little room to pass.",
#:   "The opposing coach, travelling gently enough, kept as near the centre of the highway as it could without going over.",
#:   "Opposite bus moving slow but sticking to the middle line, my side also became tight.",
#:   "Great lump of a lorry chugging towards me, half an inch off the middle, move over can't you.",
#:   "Reduced lateral clearance owing to slow opposing heavy vehicle close to road centre",
#:   "TRUCK HOGS THE MIDDLE - squeaky bum moment",
#:   "The oncoming bus lumbers by with its side against the median line.",
#:   "Coach from ahead, dawdling, almost astride the middle line, watch your mirror.",
#:   "Oncoming artic crawls by with its wheels kissing the centre stripe.",
#:   "Bring a sluggish lorry towards us, tucked up against the road's middle.",
#:   "De frente a big bus, slow, and glued to the central line.",
#:   "Dustcart, oncoming, at a dawdle, no daylight between it and the centreline.",
#:   "The milk tanker came chuntering round the bend to meet us with its offside tyres on the cat's eyes, so we scraped by along the hedge.",
#:   "Opposing HGV to be driven at 12 km/h, offset from its lane axis towards the road centre, for the full length of the passing manoeuvre.",
#:   "Breathe in, there's a double-decker trundling this way, and he likes the middle of the road, so you'll want to be right over by your kerb.",
#:   "It passed at last, an ancient truck going no quicker than a barrow, and the whole time it had kept itself pressed up against the white line.",
#:   "Why does the driver of that oncoming coach, with a yard to spare on his own side, plod along right beside the divider and make me sweat?",
#:   "My mirror was taken off by a lorry travelling slowly the other way, its driver having positioned it as close to the centre markings as he could.",
#:   "Up here in the hills the road is narrow enough as it is. The quarry truck that met us yesterday came down at about the speed of a walker, which would've been kind of him if he hadn't kept so far over to the middle that I had two wheels in the ditch to get by.",
#:   "The robotaxi stopped dead, and I don't blame it. There was a sightseeing bus heading our way, barely moving, so the tourists could get their pictures, and instead of using its own half it was sitting hard up against the dashed line, its mirror hanging over our side.",
#:   "Statement of the cyclist: I was following the blue car when a large lorry approached from the opposite direction. It was in no hurry whatsoever. What struck me was its position, since all its width seemed to be shifted towards the middle of the road, leaving a good metre unused next to its own kerb.",
#:   "I want to see how the ego handles a squeeze. Have a wide, heavy vehicle approach in the opposing lane at a low and steady speed, biased towards the centreline rather than in the middle of its lane. It shouldn't cross into our lane or swerve, it just stays there, near the line.",
#:   "The old lorry was in no haste to reach us. It came on at an ox's pace, groaning, and like an ox it would have the crown of the road and nothing else, so that the coachman, who knew it of old, drew well aside and took off his hat to it.",
#:   "Bus coming, dawdling, wheels practically on your white line.",
#:   "truck towards us going super slow n basically sat on the middle",
#:   "Oncoming tanker: unhurried, and mean with the middle of the road.",
#:   "Why so close to the line, and at that funeral pace, when the whole of his verge side is free, I asked of the approaching cement mixer.",
#:   "The opposing coach never came over into our half, yet for all its leisurely advance it left no more than the thickness of a hedgehog between itself and the divider.",
#:   "V2, an agricultural truck travelling toward V1 at under ten miles per hour, had its left wheels running along the centerline and over two metres vacant on its right.",
#:   "The lorry from the front, it is very calm, very slow, but it wants to be in the middle always, so my mirror says hello to his mirror.",
#:   "Bring in a double-decker from the opposite direction, let it trundle, and shift it inside its own lane till its offside tyres brush the dashes.",
#:   "He isn't speeding and he isn't on your side, that dustcart coming towards you, but he's hogging the crown of the road at his snail's gait, so breathe in.",
#:   "I could have counted the bolts on that wheel. It was the front one, on the driver's side, and it came by me turning over so gently that I had all the leisure in the world. It was on the paint, never an inch over, and I'd my own nearside in the brambles. Behind it were eleven more like it.",
#:   "There's plenty of tarmac on that bridge for two vehicles, if each of them takes his share. The timber lorry that faced us took all of its share, but from the wrong end, as it were. It rumbled up at a speed suited to oxen, its great tyres along the middle marking and a full lane's worth of daylight on its other flank.",
#:   "What our side camera recorded is clearance, nothing else, and it makes dull watching, since the bus needed nearly nine seconds to go by. The clearance begins at thirty-one centimetres. It ends at thirty-one centimetres. At no time did the bus enter our lane, and at no time did its driver think of moving over to where his own lane was empty.",
#:   "Objection to the planning application. Lorries to the quarry come down towards the village in low gear, which we appreciate, but they come down with the centre line under their belts, so that anyone going up has to stop and fold in the mirrors. I enclose a photograph of one such, taken at my leisure, because leisure was what it gave me.",
#:   "On the podcast we call this one the slow squeeze. Nothing's fast. You've got a coach, coming at you, doing what, eight or nine miles an hour. You've also got a centre line, and the coach's flank is running along that line as though it were on rails, when there's a lovely wide strip by its own kerb. What do you do?",
#:   "I held my trike tight to the fence and let it come. It was a furniture van the size of a chapel, and it must've had a fear of gutters because it kept well clear of its own one. It kept hard by the white paint instead, and it kept to about my speed, which is no speed at all, so the meeting lasted for ever.",
#:   "The bus was almost empty, the driver almost asleep, and the road ahead, which was ours, almost wide enough. He had drawn it along, at the pace of a barge on a canal, with its side so near the division of the road that our lad leaned over and patted it. It gave no sign of having noticed.",
#:   "In the debrief the safety operator said \"felt like being ironed\". He's referring to the opposing semi. It approached at a constant twelve km/h with a bias of eighty centimetres towards our side, though still within its lane. There was nothing dynamic about it. The challenge lies in how little road it leaves and for how long.",
#:   "Regarding the broken mirror, number plate unknown, make unknown, colour green. It is a lorry with gravel. I am in my lane, correct. It arrives from opposite, maybe fifteen kilometres the hour, not more. On its right hand there is place for a second lorry. But it drives with the left wheels upon the middle, and so klack, no more mirror.",
#:   "Mind that bus, love. It's the tours. He'll have somebody on the microphone telling them about the abbey, so he'll be in no rush to get to us, and he likes to be in the centre so both sides get a view. There's a ditch on your left, but you'll have to use what there is of it.",
#:   "It took up the picture from edge to edge, that snowplough truck coming down the pass. The blade was up and it wasn't ploughing. It merely ambled, and it ambled with its flank along the poles that mark the centre, keeping those soft banks on its own side at a respectful distance, while our wing mirror scraped the rock.",
#:   "Oncoming dustcart, walking pace, tyres polishing the middle line.",
#:   "big bus coming my way, slow, sat tight on the dashes. mirrors in",
#:   "HGV opposite: no haste, no verge side used, no room for us.",
#:   "The lorry that met us had two metres of empty tarmac on its own kerb side and, at its donkey's trot, wasn't using any of them.",
#:   "It took that coach so long to get by, and it left me so little beside the centre stripe, that I had leisure to fold in both my mirrors.",
#:   "Anyone could have passed the oncoming low-loader comfortably had its driver only kept to the outer half of his own lane, instead of plodding along its inner rim.",
#:   "Opposing heavy vehicle, low constant speed; lateral position: left wheel track coincident with the centre marking, no intrusion; clearance to the ego accordingly minimal.",
#:   "Bring a cement truck up the road to meet us, in bottom gear by the sound of it, with its flank flush against the dividing line.",
#:   "You'll think there's no hurry because the bus from the front's hardly moving, but see where he's put his wheels, hard up to the line; get left.",
#:   "The cat's eyes were clicking. That was the thing I noticed, with the window down, a click and then a good long wait and then a click, and each one was the front tyre of the gravel lorry that was making its way towards us. It wasn't a foot over. It wasn't a foot back, either, and my door had a foot and a half.",
#:   "One could measure his speed by the sparrows, which had time to hop off. One could measure his manners by the strip of road between him and his own hedge, broad enough for a wedding. All of the latter he disdained. The carrier's great waggon came on down the crown of the highway, and my gig made itself thin against the bank.",
#:   "Lateral clearance is what we logged, in centimetres: 40, 40, 40, 40, 39. An artic normally takes a second and a half to pass us by in the other direction. This one took six, and throughout these six seconds its offside tyres were following the centre dashes as a tram does its rails.",
#:   "Does anybody know the farm that the cattle truck belongs to? I've passed it coming the other way three mornings running. It's in no rush, I'll say that, a child could run beside it. But it will have its wheels on the white paint, and that mirror of mine is a hundred and ninety euros.",
#:   "For the squeeze series the ego sees a wide vehicle in the opposite lane. It isn't in the ego's lane and never will be; but it's sitting as near as it can to it, with all its spare room on its far side, and it's doing ten at most, so the squeeze lasts. The ego may shift to its right or wait. It mustn't freeze.",
#:   "My pupil breathed in, as if that would help. It was the number 9, coming up Castle Street towards us at the speed at which you push a lawnmower. \"He's in my bit,\" she said. He wasn't, quite. He was on the very last inch of his own bit, the inch next to ours, and from the way it lumbered he'd be on it for a while.",
#:   "In my statement I said \"scraped\" but it is not scraped, it is polished, from the mirror until the petrol lid. The autobus from the other direction had so little speed that it polished slowly. It was in its lane, I confess; but it had pushed itself in the corner of its lane where I am.",
#:   "We held the parcels up over our heads, like people wading. That's on the cargo bike, with the handlebars all but touching the parapet. What was wading the other way was a crane lorry, dead slow, the whole quay to itself on its off side, and its bolts going by me one at a time along the middle line. I could've tightened them.",
#:   "It's the ones who aren't doing anything wrong you remember. Not speeding: this tipper was crawling up to meet me like it had a bad back. Not on my side: I checked, I could see a thread of white paint by its wheels, all the way along. It's simply that I've an eight-foot cab and he'd left me eight foot and a bit.",
#:   "Pressed for details, the deponent agreed that the furniture van, which was approaching him, was moving at a pace suited to its age; that it kept to its side of the marking; and that it did so by the thickness of the marking. He'd had to stop with two wheels in the ditch. It had needed, he thought, the better part of half a minute to go by.",
#:   "The mist took the edges off things, and so I steered by the stripe in the middle until I found that somebody else was doing the same. His lamps were level with my roof. They came up the stripe towards me no quicker than a man with a lantern, never to one side of it, and it was I who had to make room for eighteen tons of timber.",
#: ]
#: adversaries = ["truck", "bus"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "slow", "follow"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.2
#: high = 3.8
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 0.7
#: high = 1.6
#: unit = "m"
#: meaning = "how far towards the ego's side it keeps"

param OPT_ADV_SPEED = Range(2.2, 3.8)
param OPT_SWERVE = Range(0.7, 1.6)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE)
