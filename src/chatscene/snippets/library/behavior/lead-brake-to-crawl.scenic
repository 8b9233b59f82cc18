#: description = "The car ahead brakes hard and then creeps on at walking pace."
#: rephrasings = [
#:   "He hits the brakes in front of us and then just crawls along.",
#:   "Vehicle 1 decelerated abruptly and proceeded at a very low rate of travel.",
#:   "Lead veh hard decel to approx 5 km/h, continues.",
#:   "The target brakes strongly to a residual low speed before the VUT.",
#:   "The car in front is braking heavy and after it goes like a turtle.",
#:   "The bus ahead of us anchors up, then inches forward.",
#:   "A lorry in our lane dives on its nose and afterwards dawdles on.",
#:   "Sharp braking from the leader followed by a tedious creep.",
#:   "The car in front stood on the brakes for no reason and then dawdled along at a snail's pace.",
#:   "The lead vehicle braked sharply and then continued at approximately 3 mph.",
#:   "Bus ahead, hard brake, then inching fwd, no stop.",
#:   "The lead vehicle decelerates strongly to approximately 5 km/h and maintains that speed.",
#:   "Motorbike before me brakes strong and after that drives so slow like a man walks.",
#:   "Lead: heavy decel to a crawl, never reaches zero, stays there.",
#:   "He slammed his brakes, but did not stop; he crept on like a hearse and she crept after him.",
#:   "Brakes on in front, hard, he hasn't stopped though, he's just tiptoeing along now.",
#:   "he braked mega hard and now hes going like 3mph im gonna cry",
#:   "The leading car shed its speed in an instant and thereafter trickled along no faster than a stroller.",
#:   "He did not stop, my lord; he threw off nearly all his speed and went forward at the gait of a man on foot.",
#:   "Front bus suddenly jam brake, then go at tortoise speed, not stopping also.",
#:   "Anchors on, I nearly eat his bumper, and then he won't stop and he won't go, just trickles along like a funeral.",
#:   "Harsh deceleration of preceding vehicle down to residual walking speed without standstill",
#:   "BRAKES HARD... then drives slower than I WALK",
#:   "The lorry in front sheds its speed and oozes onward.",
#:   "Leader bins its speed at once, then ambles, never stopping.",
#:   "Van before us stamps on it, then moves at shuffling pace.",
#:   "Hard brake by the cab in front, then pram-pushing speed.",
#:   "Make the coach ahead brake sharply but keep rolling, barely.",
#:   "Fire engine ahead drops from fifty to next to nothing, then plods.",
#:   "All at once the pickup's brake lights blazed, and the next thing I knew we were both going along no quicker than pedestrians.",
#:   "The motorcyclist in front of the robotaxi scrubbed off nearly everything in two seconds and then balanced along at a wobbling crawl.",
#:   "Firstly the truck before me is braking like for an accident, then he doesn't stand, he goes further with five kilometres in the hour.",
#:   "Final speed of the preceding vehicle shall be 1.5 m/s, reached by emergency-type deceleration and kept until the end of the test.",
#:   "What's she playing at up front, hauling it down that violently only to tootle on as if she were counting daisies?",
#:   "There was a bang of brakes from the bus ahead; it never came to a stand, though, it just kept trickling up the road.",
#:   "We were trailing a hearse-black saloon down the high street when it braked fit to throw the driver through the glass. It did not halt, mind, it simply dragged itself along from then on, a yard at a time, and we behind it.",
#:   "The operator of V1 reported that the ambulance directly ahead decelerated without warning. It remained in motion, however, at approximately the pace of a person walking, and the operator, expecting a complete stop or a recovery, misjudged the gap.",
#:   "Two parts to this one, so listen. The lorry in front brakes fiercely, and you must too; but then he carries on rolling at a snail's trot, so you've got to drop in behind and have patience, not blast the horn.",
#:   "Hi all, I have question. Today front car suddenly pressed brake so hard that my phone flew off, after that he was driving on slow slow like ox cart. Why would the autopilot first panic and then jerk all the way?",
#:   "The motorhome in front had found its campsite sign. Down went its bonnet, my coffee went everywhere, and instead of stopping it oozed along the lane with the wife leaning out of the window reading every gatepost.",
#:   "Front car stamps it down to nearly nothing, then shuffles on.",
#:   "Coach ahead: fifty to five in a blink. Five it stays.",
#:   "Brake lights like a furnace, then it merely oozed forward.",
#:   "The moped we'd been following stood on its front wheel almost, settled, and went on no faster than its rider could have pushed it.",
#:   "From the moment of his great braking the bus in front made no more than four kilometres in the hour, yet he was never standing.",
#:   "Should I overtake somebody who brakes like he's hit a wall and then won't actually stop, just seeps along in front of me?",
#:   "Pickup ahead has anchored up for no reason visible and is proceeding at a funeral march, tailback forming behind the robotaxi, no stop as yet.",
#:   "Please have the preceding ambulance shed its speed with real violence and thereafter carry on at about one and a half metres per second.",
#:   "The preceding lorry dipped on its front springs till its rear axle hopped; what followed was a procession, with me as second mourner.",
#:   "My coffee is on the windscreen, thanks for asking. It left the cup when the estate we were behind, out in front since the motorway, threw its anchors out with nobody before it. And then we'd the pleasure of its rear wiper for ten minutes, because it neither stopped nor drove, it sort of seeped.",
#:   "Because a hedgehog was out walking, said the driver in front, when we finally got to talk to him. That explained the squeal and the nose-down business that put my dog in the footwell. It also explained why he went on at the rate he did: he was keeping the hedgehog company to the next gateway.",
#:   "Segment 3 of the log has a deceleration peak by the leader of 7.1 m/s², ego following at 5.8. Everyone then expects zero. Yet the leader's wheel speed settles at 1.4 and is still 1.4 when we break off, and our ACC keeps toggling between standstill and follow, which the passengers found unpleasant.",
#:   "Don't relax, he hasn't finished with you. I grant you he isn't flinging that police bike to a stop any more, it was a fearful squeeze of the brake, mind; but he hasn't stopped either. Feel how slow that is? Your clutch foot's doing all the work. That's how he'll go on, so leave him room.",
#:   "V1 was second in line. The operator of V1 saw V2's rear end rise abruptly and stated that \"you could smell the pads\". V1 was brought from 42 mph to a near stop without contact. V2 did not come to rest, but continued in lane at a rate comparable to a pedestrian's for the remaining 300 feet of video.",
#:   "There are two ways to frighten a cyclist who's drafting. One's to brake like the end of the world, and the chap in the camper did that, I was looking at his spare wheel from very near. The other's to leave him wondering whether you'll stop, and he did that too, tottering along at a pace I could barely balance at.",
#:   "Have you found what you were looking for, I wanted to shout. The old Mercedes we'd been pottering behind at forty had been reined in so sharply that our hats came forward, and now he was peering at house numbers, one, by, one, the wheels only just going round, never quite standing still.",
#:   "We have in our city a tram for tourists which goes on tyres, like a bus. It was ahead of us, all normal. Suddenly its conductor did pull the brake so that the tourists flew, and since this time it rolled only with the speed of an old nun, the whole avenue down, until he was sorry for us.",
#:   "She had braked before she understood why: the red had simply flooded her windscreen. The fire engine in front, which a heartbeat ago had been doing the speed of the road, loomed and loomed, and stopped looming when they were both at a walk. At a walk they went on, under the limes, like beasts to water.",
#:   "Is it right, Mr Okafor, that the van before you lost four fifths of its speed within a bus length? And that it then proceeded, if one may call it so, no quicker than a man with a wheelbarrow, without halting, until your employer's shuttle touched it? Then kindly tell us which of the two surprised your software.",
#:   "hgv in front bangs the anchors on, full abs, trailer shuddering, i thought right hes stopping. nope. just drops it in crawler gear n grinds up the hill same pace as a bloke walkin his dog. still no idea what that was about lol",
#:   "Leader throws out the anchors, then inches on for ever.",
#:   "From forty to four in front, never quite nought.",
#:   "Nosedive ahead, then a pram pace that won't end.",
#:   "The rear of the horsebox leapt at me, and when I'd finished being frightened it was ambling away at a speed that my stalled engine couldn't manage.",
#:   "On the command the coach that the AV follows scrubs off nine tenths of its speed at once; with the tenth that's left it continues up the lane.",
#:   "Nobody in the shuttle kept their seat when the van leading us hit the brakes, and nobody needed one in the minutes after, it was so slow that we could have walked.",
#:   "He's making before me a braking for life and death, this motorcycle, but he doesn't put the foot down, he goes further with steps of a snail.",
#:   "Why's my clutch burnt out? A bus we had been following did its level best to stop, changed its mind at two miles an hour, and held it at that.",
#:   "First the bonnet of the police car leading us went down till its aerial bent; later, I mean for the whole next mile, schoolchildren on the pavement were beating it.",
#:   "Two sounds, and then one. The two were his tyres and mine, as we both came down from fifty to hardly anything behind a gritter's wagon that was first in line. The one was ticking, gravel out of the treads, tick, tick, tick. So his wheels hadn't ceased to go round. I listened to it for the length of the reservoir.",
#:   "I kept waiting for his brake lights to stay on, as they do with someone who's come to rest. They'd come on like a house fire and I'd all but gone through the windscreen; and they were out again. There wasn't a wheel in front of me that stood. It was a hire van, at the pace of a wedding, looking for its church.",
#:   "The front-collision warning is a work of three seconds, in this log. The annoyance is the work of ninety. As regards the three: leader's deceleration minus 7.4, gap from eighteen metres to five. As regards the ninety: leader at 1.3 metres per second, gap five, our creep control hunting, lady in row two asking whether we'd broken down.",
#:   "With sheep you learn it. You come on them of a sudden, you brake like billy-o, then you've to go on with 'em, at sheep's pace, you can't just stand. I saw no sheep that day, I was two behind. I saw the lorry I was following do the first thing and then the second, and I thought to myself, sheep.",
#:   "My learner had a lovely gap and it was eaten within a heartbeat. Up goes the ambulance's tail, tyres yelping, and we're down to it with our seat belts locked. \"Handbrake?\" says he. But is it standing, I asked him. It was not. There was a crack in the road, and it was by and by getting over that crack.",
#:   "He must have been nodding at the wheel of his moped, and the wheel-nut of a lorry lay in the lane. That's my theory. He went from a lively forty to such a teetering trot, and so abruptly, that I finished with my bumper a hand from his mudguard. He carried on teetering. To this day he hasn't put a foot down.",
#:   "In the confusion the clerk wrote \"stopped\". I must insist on the correction. The saloon in front of us did everything which comes before stopping, with smoke, and my neck is the proof of it. But stopped it wasn't. It was travelling, if an hour hand travels, when we ran up against it, and it had been doing so for some twenty yards.",
#:   "The queue which formed on Tuesday behind a robotaxi wasn't the robotaxi's fault. It was second. First was a tourist coach whose driver had caught sight of the castle: a pedal to the floor, a scream from the upper deck, and from there to the car park, half a mile, the leisurely progress of people leaning over with cameras.",
#:   "When I was young one had a horse that did this. You would be bowling along; it would see a paper bag; and down she'd go on her haunches, so that you had her ears in your lap, and after it nothing would get her out of a mincing little walk. My nephew followed a pickup yesterday with just that temperament.",
#:   "In front of my taxi was one school bus, decent speed. Suddenly such a brake, baap re, my passenger's tiffin came to front seat. I also braked. Now I am thinking, okay, stop has come, children will get down. No stop. No children. He is only rolling, rolling, like a temple chariot, and I'm behind, in first gear, half clutch.",
#:   "Title of the clip: \"make up your mind\". 0:05 guy ahead in the Tesla does a full panic stop minus the stop. 0:07 we're all at like 3 mph. 0:30 still 3 mph. 1:15 an old dear overtakes on foot and waves. He never stands, he never speeds up, clip just ends.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "slow"]
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.45
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.0
#: high = 3.0
#: unit = "m/s"
#: meaning = "how fast it creeps on"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_BRAKE = Range(0.45, 1)
param OPT_ADV_SPEED = Range(1, 3)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
