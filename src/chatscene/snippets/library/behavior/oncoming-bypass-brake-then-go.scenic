#: description = "The oncoming car brakes as if to let the ego around the obstacle, then accelerates."
#: rephrasings = [
#:   "he brakes like he's letting us through and then guns it",
#:   "Vehicle 2 decelerated as if yielding, then accelerated toward Vehicle 1 in the opposing lane.",
#:   "opposing veh brakes, then full gas, gap gone",
#:   "The oncoming target decelerates before the narrow place and then accelerates toward the VUT.",
#:   "The truck brakes, we think that we can pass, but it gives gas again.",
#:   "A biker checks his speed at the bottleneck, then opens up.",
#:   "The lorry opposite seems to give way but has second thoughts and surges on.",
#:   "A bus slows sharply for us, only to pick up speed a moment later.",
#:   "he slowed down like he was letting me round the skip, then the cheeky sod put his foot down",
#:   "The oncoming driver slowed, apparently yielding for V1 to go around the obstruction, then sped up.",
#:   "Oncoming van brakes (= go ahead?), then guns it while we pass obstacle.",
#:   "The oncoming target decelerates, suggesting priority to the VUT at the obstruction, and then increases its speed.",
#:   "The car from the front brakes, I think he gives me the way beside the blocked lane, but then he drives fast.",
#:   "Fake-yield at the bottleneck: oncoming actor drops its speed, waits for the SUT to commit, then goes full throttle.",
#:   "The lorry checked its pace as though to offer them the narrow way, and no sooner had they taken up the offer than it surged on.",
#:   "He's slowed to let you round that parked van... no, he hasn't, he's changed his tune, he's charging. False courtesy, that.",
#:   "he slowed down like \"you go\" and then sped up at us when we went around??",
#:   "An approaching lorry seemed to grant passage past the blockage, then surged ahead when the offer was taken up",
#:   "You braked, inviting my client to pass the obstruction, and then withdrew that invitation by accelerating?",
#:   "He slow down like giving way for us to pass the parked car, then suddenly press oil, cheater sia",
#:   "He eases up, I take it as \"after you\", I'm halfway round the skip and he only goes and floors it",
#:   "False yielding cue from opposing traffic during obstacle bypass; deceleration then renewed acceleration",
#:   "Oncoming bus PRETENDS to let me round, then charges",
#:   "The biker facing us made way with a brake, then revoked it with a roar.",
#:   "Oncoming bus: slows for you at the obstruction, then comes on fast.",
#:   "Cheeky van dips its nose for me at the skip, then barges on.",
#:   "Opposite truck brakes, \"please pass\", then pushes the gas, not please pass.",
#:   "I need an oncoming biker who checks, beckons almost, then blasts through.",
#:   "he brakes by the broken down car like go on then, ZOOM",
#:   "The coach facing us lost speed by the roadworks so nicely that I pulled round the barrier, and at that very instant its driver hurried it on again.",
#:   "At the obstruction the opposing target simulates yielding by a deceleration of 3 m/s², then, before standstill, re-applies full throttle towards the passing VUT.",
#:   "Don't be fooled by the brake dive on that car coming the other way, he's not giving you the gap past the skip; see, he's gathering speed again.",
#:   "In front of the fallen tree the lorry coming from opposite made itself slow, we understood \"you first\", and then it took speed and came.",
#:   "We were already alongside the parked dustcart when the oncoming motorcyclist, who had clearly braked to leave us the room, wound his throttle open after all.",
#:   "Having hauled his speed down in a manner that anyone would read as courtesy, the driver facing the AV at the blocked lane thought again and stepped on it.",
#:   "There's a heap of gravel outside number nine, so you have to go round on the wrong side. A woman coming towards me in an SUV saw me waiting and braked, ever so politely. I said thank you to the windscreen and set off, and blow me if she didn't put on a spurt.",
#:   "Claim narrative: a stationary removal lorry was obstructing my half of the road. The oncoming motorist reduced speed markedly, which I took as consent to go round it. While I was committed, he reversed his decision and drove towards me with increasing speed, so that I was obliged to squeeze in against the lorry.",
#:   "Scenario request from the negotiation team: static obstacle in ego lane, single opposing truck. It brakes in good time, down to about walking pace, as a human would read as an offer. As soon as our car pulls out to pass, the offer lapses and the truck powers up and keeps coming.",
#:   "He was a cab driver of the old school, and when he saw the hay cart standing in our way he drew in his reins, so to speak, and let the cab fall back almost to a stroll. Then some devil got into him, and on he came, faster than ever, into the gap he had given us.",
#:   "I ride that road on my bicycle, and I watched it happen to the car in front. A pickup from the opposite direction eased up hard as they both reached the cones, leaving the car to go round. It'd hardly poked its nose out when the pickup roared and charged for the gap itself.",
#:   "Oncoming pickup: brakes at the skip, I go, it goes harder.",
#:   "truck facing me slowed by the roadworks then changed its mind, pedal down",
#:   "Lorry from opposite: offer made, offer withdrawn, coming fast, obstruction still between us.",
#:   "As the subject vehicle prepares to pass a broken-down van, opposing traffic drops to a jogging pace, thereby seeming to cede the gap, and then powers up again.",
#:   "It looked like good manners, the nose of that coach going down on the other side of the blockage, till it came up again and the coach with it.",
#:   "We passed the tree trunk on two wheels, because the motorcyclist in front, after he had braked so kindly to let us round, has given gas like a devil.",
#:   "Of course I went round the parked tanker when she slowed for me, and how was I to guess that halfway she'd bury her right foot and come at me?",
#:   "Near head-on beside a stationary refuse vehicle: the opposing bus had checked itself sharply, as for a courtesy, and then regained speed into the occupied gap.",
#:   "Have the opposing driver brake for the ego at the roadworks in a manner anyone would trust, and break that trust with a bootful of throttle.",
#:   "It isn't the driver who charges that's dangerous, you wait for him. It's this one. There's a skip on our side, he's coming the other way, and you saw how he hauled it down to a crawl for you? Good job we didn't jump at it, because listen to that engine now. He wants the gap himself.",
#:   "A post van had broken down outside our gate, so everybody had to edge out round it. I saw a taxi do so, very properly, after the man coming down the hill had braked for him. I saw the man's face too. It said \"no, hang on\". And his car leapt on again with a screech, and the taxi had to dive behind the post van.",
#:   "Statement number two, bus passenger. The bus from the opposite direction was the 14. Its driver got his speed well down where the scaffolding narrows the street. We pulled out to go by the scaffolding and everyone could see that 14 beginning to grow again, quicker than it had any business to, till our driver swore and tucked us in.",
#:   "\"After you,\" said the brake dive of the lorry that was coming towards them. So out they went, round the hay bales, with a wave of thanks. \"On second thoughts, after me,\" said the black smoke that rose from its stack, and the gap that had been as wide as a barn door became as wide as a cat flap.",
#:   "There's a yield-detector in our stack, and this is how to fool it. Block our lane with something. Give it opposing traffic of one car. Let the car lose more than half its speed ahead of the blockage, hold it there just until our wheels have crossed the centre, and then hand it full power towards us.",
#:   "In my city if a driver brakes he is sick. So when the tempo from opposite side made slow near the sleeping cow, I thought, how nice, he is leaving me to go around her. I took my car out. Immediately he pressed accelerator so much that even the cow got up.",
#:   "It was the wife's birthday and I was being careful. Where the water board had dug up our half I stopped and looked. Big white SUV facing us, and it fairly stood on its brakes to let me through. Fine. I was alongside the barriers when its bonnet rose up in the air and it came bowling for us like the Charge of the Light Brigade.",
#:   "Two things made me commit: my half of the road was filled with a furniture lorry, and the driver on the other half had brought his motorbike down from fifty to hardly anything. What made me regret it was the howl. He'd dropped a gear and wound it open, and the pair of us were pointed at the same four metres.",
#:   "Your Honour will have noticed how the oncoming car's headlamps behave on the recording. They dip, which is the braking; my client understands it as an invitation to pass the overturned trailer. They then rise and swell. That is the invitation being torn up, at a rate which the expert puts at four metres per second squared.",
#:   "I don't get cross with sheep or with tractors, but I do with people who can't decide. I was out on the wrong side going by the hedge-cutter, where I'd only gone since this young woman had put her brakes on for me. And what does she do? Steps on it. Comes at me flat out with a face like thunder.",
#:   "Radio log 16:20. Recovery truck parked in lane one on the bridge, all northbound vehicles have to go round it. Southbound motorcycle braked heavily to allow a northbound van past, then opened right up before the van was through. Van scraped down the side of the recovery truck. Rider did not remain. No persons hurt.",
#:   "Opposing cab at the skip: nose down, come on, nose UP. Liar.",
#:   "he braked so i could pass the digger, then full send at me",
#:   "Oncoming truck gave you the gap past the wreck? He's taken it back.",
#:   "The dip of the approaching lorry's cab got me out from behind the broken-down van, and the lift of that same cab got me scrambling back in again.",
#:   "I was already past the skip's near corner, on the strength of the other driver's having lost most of his speed, when his engine told me he wanted it back.",
#:   "What the bus facing us gave with one pedal, room for us to get by the roadworks, it took with the other as soon as we'd accepted.",
#:   "Opposing target sheds speed to a jog short of the blockage, thereby suggesting the ego is to go first, and then without having stopped proceeds at full throttle to meet it.",
#:   "There's a hay cart in our lane, and I want the motorbike from the other direction to look for all the world as if it were giving way, until it charges.",
#:   "Whoever put \"courteous\" in the log was looking only at the first second, when the pickup facing us was braking for our detour round the crane, and not at the following two.",
#:   "I'd waited behind that dustcart for a gap, and I was offered one. The oncoming minibus came right down, to walking speed I should say, its bonnet sinking like a curtsy. Out I pulled. I was level with the dustcart's cab when the bonnet came up and I could hear its turbo; I finished with my mirrors folded and my tyres in the refuse.",
#:   "Two marks on the other half of the road, left by the vehicle that was travelling towards V1. The first is of braking, faint and regular, and it ends about thirty metres short of the stationary tractor. The second begins a metre further on and is of wheelspin. Between the first and the second, V1 had committed itself to passing the tractor.",
#:   "Think of a door held open for you. There was a heap of sand in my half and the van facing me held the road open, down to nearly nothing, no hurry. I thanked her with my hand and went. Then the door was let go in my face: she had her foot down, she grew, the sand was still at my side. I reversed out of it at a fair lick.",
#:   "The radar saw it sooner than I did. Closing speed with the thing from the front: seventy, fifty, twenty-five. Good man, I thought, he's letting us by these barriers. So out we went, the AV and me in it with my arms folded. Twenty-five, forty, sixty. I unfolded them. It was a coal truck, and its driver was looking at us without any expression at all.",
#:   "En mi barrio, the obstacle was a sofa. A real sofa, in my lane. The motorista that came in face of me made slow, very slow, and the light of his moto looked at the ground, so I believed, pasa, amigo. I pass. At the second cushion his light looks up, into my eyes, and it comes with all its gas. I have mounted the pavement.",
#:   "Listen, because this is how people get killed round parked lorries. You're waiting behind it. The fellow coming the other way takes his speed off, so you can see him rocking on his springs. That's not a promise! Has he stopped? No. He was just thinking. And there he goes, look, he's finished thinking, and anybody who'd pulled out would now be in front of his grille.",
#:   "\"I took it as an invitation,\" the woman stated, \"and I'd take it so again.\" A fallen branch had been lying on her side. The bus that was due to meet her had come from fifty down to hardly anything, at some distance, for no other reason that she could imagine. \"It was when I was among the twigs that it changed gear and drove at me.\"",
#:   "Grandpa's rule is never go until he waves. The man in the white car didn't wave. He only went slow, when we were stuck at the hole with the cones, and his lights went down like when you nod. So Mum went. Then his lights went up and he was coming and coming, and Mum squashed eight cones. Grandpa says eight cones is what a nod gets you.",
#:   "Negotiation failures, type three. The opponent's deceleration starts sixty metres short of the bottleneck that our lane is closed at, and ends at about four kilometres an hour, so any game-theoretic player concludes it has yielded. It hasn't. A second after we put our nose out the sign flips, and it's on its way into the bottleneck at everything its engine has got.",
#:   "He must have been in two minds, the tanker driver, and I met them both. Mind number one saw my lorry stuck behind that abandoned caravan, and he came down the box, good as gold, brakes hissing. I let my clutch up. Mind number two said he had a ferry to catch. With my cab well out past the caravan I'd a tanker coming at me, black smoke, gathering.",
#:   "It is in such trifles that a nation shows itself, the Count remarked. A cow lay in our road. From the other side a motor approached, and at the sight of our embarrassment it restrained itself so handsomely that we ventured out round the animal; whereupon, like one who has repented of a good deed, it bounded forward, bellowing, and disputed the passage with us, hoof and horn.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "brake", "accelerate"]
#: position = "oncoming"
#: maneuver = "bypass"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 7.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 28.0
#: high = 60.0
#: unit = "m"
#: meaning = "distance to the ego at which it brakes"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 0.9
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.7
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_SPEED = Range(7, 10)
param OPT_ADV_DISTANCE = Range(28, 60)
param OPT_BRAKE = Range(0.5, 0.9)
param OPT_THROTTLE = Range(0.7, 1)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 4.5 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 1.5
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 10)
