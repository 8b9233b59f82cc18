#: description = "The oncoming car unexpectedly swerves into the ego's lane."
#: rephrasings = [
#:   "A driver coming the other way veers across the centre line.",
#:   "The approaching vehicle jerks over in front of the ego.",
#:   "Opposing traffic suddenly leaves its line and heads into the ego's side.",
#:   "The adversary from ahead lurches sideways toward the ego.",
#:   "The car driving toward the ego yanks the wheel over.",
#:   "he comes the other way and yanks it into our lane",
#:   "Vehicle 2, oncoming, swerved across the centreline into the lane of Vehicle 1.",
#:   "opposing veh, sudden swerve into our lane",
#:   "A car coming the other way suddenly lurched onto my side, I nearly had it head on.",
#:   "Vehicle 2 crossed the center line abruptly into the path of oncoming Vehicle 1.",
#:   "Opp. truck jerks over CL into ego lane. Head-on threat.",
#:   "The oncoming vehicle target makes a sudden lateral deviation into the lane of the VUT.",
#:   "The truck from the other direction suddenly jumps in my lane.",
#:   "Opposite car snaps over the centre line into us; abrupt, one-off, not a drift and not a weave.",
#:   "One moment he was safely over there, the next his headlamps were on her side and coming straight for her.",
#:   "He's over the line! That van coming at you has just lurched onto our side!",
#:   "van coming the other way jerked into our lane we nearly DIED",
#:   "The oncoming lorry leapt over to the wrong half of the road, leaving a motorist with seconds to react.",
#:   "In one movement your car left its own side and entered hers, coming toward her; do you dispute that?",
#:   "The car from opposite suddenly came to my lane, direct face to face.",
#:   "One second he's on his side, next second I'm staring down his headlamps on mine.",
#:   "Abrupt head-on lane incursion of opposing vehicle.",
#:   "ONCOMING TRUCK SWERVES INTO MY LANE - HEAD ON!",
#:   "The oncoming bus lurched athwart into our lane.",
#:   "A bike that comes the other way veers over the centre line in front of the ego.",
#:   "A bicyclist travelling in the opposite direction crossed the centreline abruptly.",
#:   "A lad on a pushbike coming the other way suddenly veered over the white line at me.",
#:   "biker coming the other way just darted over the line into my lane",
#:   "Oncoming cyclist yanks the bars and he's in our lane.",
#:   "Out of nowhere the approaching coach lunges at our half.",
#:   "Let a motorbike facing the AV dart abruptly into its lane.",
#:   "Opposing van, one violent steer, now heading at us in our lane.",
#:   "Suddenly the lorry coming towards me flung itself over the white line.",
#:   "The pickup, which was minding its own side as it neared us, shot sideways into our lane for no reason I could see.",
#:   "A bus is arriving from in front, all is normal, and in one instant he breaks out of his line into mine.",
#:   "With the gap at its threshold value, the approaching target shall be steered rapidly over the centre line into the VUT's lane.",
#:   "Why would a man on a pushbike, coming the opposite way in broad daylight, whip across into the lane of a moving car?",
#:   "Ambulance requested; the subject vehicle was forced off after a southbound SUV cut hard over into the northbound lane without any warning.",
#:   "everything fine then the taxi coming at us just SNAPS over into our lane like someone kicked the wheel",
#:   "My lane was clear and the moped opposite was puttering along in his. I think a wasp got into his helmet, because he gave the handlebars an almighty wrench and was suddenly right there ahead of me on my side.",
#:   "V1 was eastbound, V2 was westbound. For undetermined reasons V2's operator made an abrupt steering input to the left and entered the eastbound lane in front of V1; no phone use, alcohol or mechanical defect was established.",
#:   "Keep an eye on what's coming, always. That builder's lorry looked perfectly settled on his own side, and before you could have said knife he'd jumped over the paint and was nose-on to us.",
#:   "What I need is plain: traffic from ahead, in its proper lane, behaving nicely. At short range one saloon does a single vicious swerve and intrudes into the lane of the robotaxi; no drifting beforehand, the reaction time is the point.",
#:   "He remembered the headlights, two calm yellow eyes keeping to their own half of the rain. Then they flicked aside, as if the road had been jerked from under them, and were in front of him, in his lane, growing.",
#:   "One flick of his wheel and the oncoming cab was ours.",
#:   "Approaching motorbike, sharp dive over the centre, into our lane.",
#:   "The bus meeting us suddenly swapped its half for ours.",
#:   "A cyclist was approaching on the far side; he jinked over the middle without the least notice and I had him dead ahead.",
#:   "Please let the lorry that comes toward the ego be yanked over the white line, so that it ends up in our lane, on our nose.",
#:   "From the other direction, a very normal taxi; then there is one brutal movement, and this taxi is on my part of the road, before my eyes.",
#:   "Where there'd been two headlamps on their own side there were now two headlamps on mine, and nothing gradual lay between.",
#:   "What could make a sober woman, driving the other way, snap her wheel round until her people carrier was in the lane of a driverless shuttle?",
#:   "Witness 3: the moped from the opposite side did, quote, a crazy hop over the line at them, end quote, into the lane of the test car.",
#:   "I think about the half second a great deal. Before it I was on an empty stretch with a coach coming along in the opposite lane, as a thousand have; after it the coach's destination board, \"Lourdes\", filled my windscreen. Whatever the driver did with his arms, he must have done it all at once.",
#:   "Because of the pothole, the council admits, \"the odd vehicle may deviate\". The odd vehicle, a plumber's van, was coming toward me. It deviated in one bang from its lane to the one I had, and the reason I'm writing this with my left hand is that I went through a bus shelter to get out of its way.",
#:   "If you watch nothing else, watch the front tyres of what's coming. I saw his turn before the car did, so I was already braking when that pickup leapt off its own half and into our lane. A yard a second would be a drifter. He came over in one go, and it was us who had to find somewhere else to be.",
#:   "Telemetry of the partner car, which was to approach us in its own lane: steering wheel angle 0, 0, 0, then minus 140 degrees within 300 ms. Two tenths later it has three quarters of its width over the centre line, on our side. The automatic evasion went to the right, which I consider the only choice.",
#:   "My mum goes to church and she said a swear. There was a motorbike coming along the other way and it was good, it was on its own bit, and then it just jumped. It jumped sideways to our bit, with us in it, so it was pointing right at Mum, and she drove in the corn.",
#:   "Can't fault my brakes, can't fault my eyes. The low-loader was where he ought to be, his side, coming at a fair trot, and me on mine. Somebody opened the door of a parked car over there, I learnt, and he threw the whole rig over to miss it, so now it was coming in my lane.",
#:   "V1 was traveling west. An eastbound vehicle, V2, was within its lane until approximately 90 feet from V1, at which point, per the video, it \"darts\" left across the double yellow line. V1 departed the roadway to the right to avoid a frontal collision with V2, which then occupied V1's lane.",
#:   "She remembered that there had been music, and a long fence, and somebody in a little green car coming toward them with the sun on its roof. There was a noise of tyres. Without having passed through anything between, the little green car was on their side of the road, its radiator in the middle of the music.",
#:   "Nothing to do with overtaking, mind, there wasn't a soul in front of him. He came round by the pond, this baker's lad, he was on his side of the road and I'm on my side of the road. A duck, he says. He flung the wheel over for a duck, and I got a bread van in my lane, face on!",
#:   "On our bus tour in the Rhine valley the guide was just telling about a castle. From opposite came a camping car, and with a hook like a boxer it was in our lane. The guide fell on a Japanese gentleman. Our driver has steered in the vineyard, which the gentleman has photographed.",
#:   "For a sudden head-on intrusion the following is to be arranged. The bicycle dummy travels toward the vehicle under test on the far side, at 20 km/h, in a straight line. At the set gap its platform is commanded to the opposite lane with the highest available lateral acceleration, and it ends the run in that lane.",
#:   "His headlamps snapped from their side to mine.",
#:   "Approaching tipper, one wrench of the wheel, our lane.",
#:   "Cyclist coming the other way darts over, face to face.",
#:   "There was a minibus on the far side, minding its own business, and then there was a minibus on the near side, minding ours; I saw no in-between.",
#:   "At thirty metres the opposing cab, until then a model of lane discipline, should be hurled over the divider in one stroke so that the robotaxi has it dead ahead.",
#:   "I'd moved nowhere, yet the motorbike which would have passed two metres to my side had me exactly in line with its mudguard, all in the flick of an eyelid.",
#:   "From opposite a lorry comes correct, and in one tick he makes a hook over the white line and stands with his whole face in my lane, driving.",
#:   "Dispatch, two vehicles in the ditch on the B road; the northbound says the southbound jumped over at her, no warning, and was coming down her lane.",
#:   "The tread marks of the car that was going east leave its own lane at an angle of nearly thirty degrees and continue, as eastbound marks, in the westbound one.",
#:   "How do you tell a drift from what I saw? By the noise. A drift is silent. This was a yelp, from over there, where a coach was coming along as good as gold, and before the yelp was over the whole front of it, wipers, crest, driver's tie, was on our side of the paint. It's as though the road had tipped.",
#:   "I'm told there was a plank. I never saw a plank. I was driving along my lane with a pickup coming along his, and it's a boring road, so I was watching his tie-down straps flap. They all flapped to one side. Straight away he'd no lane of his own any more, he had mine, bull bar first, and I'd the field.",
#:   "\"Tell it slowly.\" But it was not slow. \"Then tell it in order.\" There's a bicycle, it comes against us, it is on its part. There's us, on our part. \"And then?\" Then the handlebar is like this, sir, from one moment to another, and the bicycle's on our part, with its lamp in my eyes. That's all the order there is.",
#:   "For the first forty seconds of this clip you'll think I've sent the wrong one. It's empty moor and a caravan, miles off, coming along in its lane. Wait. It gets to be the size of a matchbox, then of a shoebox, dead steady. I blinked at 0:41, it's why I bought the camera. At 0:42 I am looking down its throat, on my side.",
#:   "In a flat calm you don't expect a boat to capsize. That's how I felt about the estate, which was drawing near on the opposite half, the driver sitting bolt upright. There was no nodding, no wandering. Her hands flew, I noticed them through the glass; the car flew after them; and she was heading up the lane I was heading down.",
#:   "What made our AV brake and pull for the hard shoulder was the lateral velocity of the bus. Buses come toward us all day at three metres' offset. This one's offset was three, three, three, and then nothing, the entire move having been carried out in 0.7 s. It had not passed anybody. It did not go back while we had it in view.",
#:   "Grandad says in the war they'd call it jinking. He was taking us to the baths. A man on a moped was coming the other way, in the right place for him, and he must've had something in his eye, because he jinked. So he was in the wrong place for him, which was the right place for us, and coming. Grandad jinked as well.",
#:   "You're looking at the van that's coming. Good. You're thinking, he's on his side, I'm on mine, what could go wrong? A burst tyre, a bee, a dropped cigarette: and in the time you need to say \"bee\" he'll be over here with you, nose on. Like that one! Brake, left, left! Sorry, I didn't arrange that.",
#:   "Section 4, the event. V2 was established in the eastbound lane. V1 was established in the westbound lane. At a separation of 130 feet V2's steering angle went to its limit toward the left. V2 was thereby transferred into the westbound lane in less than one second. It was still in that lane, eastbound, at the moment of impact with the guardrail-bound V1.",
#:   "They would marvel at it afterwards, over the brandy: not that the lorry had got on to their side, lorries do, but that it hadn't been getting there. It was over yonder with the poplars, growing at the ordinary rate. It was here. He'd had the impression of a card being turned. And on the card there was a radiator, and it was on their half of the road.",
#:   "straight road, sun out, robotaxi doing its thing. scooter coming towards us on his side, im not even lookin. next thing the car throws itself at the hedge n i look up n the scooter is IN OUR LANE like hed been teleported. driver says a wasp. always a wasp",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "swerve"]
#: position = "oncoming"
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 40.0
#: unit = "m"
#: meaning = "distance to the ego at which it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.5
#: high = 3.5
#: unit = "m"
#: meaning = "how far it swerves"

param OPT_ADV_SPEED = Range(4, 10)
param OPT_ADV_DISTANCE = Range(12, 40)
param OPT_SWERVE = Range(1.5, 3.5)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE)
