#: description = "The parked car creeps out from the kerb and trundles along in front of the ego."
#: rephrasings = [
#:   "A parked lorry oozes out into our lane at a snail's pace.",
#:   "Vehicle 2 departed the curb and proceeded in the lane at very low speed.",
#:   "Parked veh pulls out, crawling.",
#:   "The target leaves the parking strip and travels at walking speed ahead of the VUT.",
#:   "It goes out from the side very slowly and stays slow.",
#:   "The overloaded bus heaves itself from its stop and dawdles off.",
#:   "A learner inches away from the roadside and plods on before us.",
#:   "The old motorbike wobbles out of its parking space and barely moves.",
#:   "An old boy eased off from the side of the road at a snail's pace and then pottered along in front of me.",
#:   "The parked vehicle slowly entered the lane of travel and continued at well below the posted limit ahead of Unit 1.",
#:   "Parked bus eases out, plods on ahead of ego, low spd.",
#:   "The parked target leaves the kerb at low speed and proceeds ahead of the VUT at low speed.",
#:   "The truck at the side comes slow, slow on the road and drives slow before me.",
#:   "Kerbside actor merges gently and never speeds up; becomes a slow lead, no hard brake.",
#:   "Inch by inch it came away from the pavement, and having got out it ambled along before her as if on a Sunday outing.",
#:   "That delivery van's easing out, and he's in no hurry, so we'll be stuck behind him dawdling along.",
#:   "grandma pulled out of her parking spot at 0.5 mph and stayed that slow",
#:   "A street-sweeping lorry left the roadside gently and trailed along at the head of a growing queue.",
#:   "She left the kerb slowly and continued slowly, with my client obliged to travel in her wake?",
#:   "Bus slowly came out from the side and going ahead of me like bullock cart.",
#:   "Sunday driver slides off the kerb under my nose and then it's a funeral procession all the way.",
#:   "Low-speed kerbside departure and continued slow travel ahead of ego.",
#:   "SLOWEST PARKING EXIT OF ALL TIME, NOW I'M STUCK BEHIND HIM",
#:   "A parked truck oozed off the kerb and lumbered ahead.",
#:   "From the kerbside a bin lorry slowly emerges and ambles ahead of us.",
#:   "Moped eases off the roadside, then potters at 10 in our lane.",
#:   "Parked van comes out very gradual and stays like a tortoise before me.",
#:   "Ambulance pulls away from the kerb gently; remains a slow leader.",
#:   "Let a parked bus dribble out, then hold us up.",
#:   "With its indicator going for an eternity, the camper rolled away from the pavement into my lane and went ahead of me no faster than a hearse.",
#:   "An elderly gentleman left his parking place by inches in front of the robotaxi and after that could not be induced to exceed a jog.",
#:   "The stationary target leaves the kerb at a low constant speed and keeps to that speed as the lead vehicle in the VUT's lane.",
#:   "We'd have lost no time had the truck not slipped out so sluggishly from the side of the road and rumbled on ahead at a walk.",
#:   "What I need: a parked car that joins our lane gingerly, never stops, never picks up, and makes the AV tail it at bicycle speed.",
#:   "Traffic news: a loaded coach has drawn out from the roadside at a crawl and is leading everyone along Mill Lane at ten miles an hour.",
#:   "You can see him in the mirror of the shop window, the driver of that parked police car, looking for his sunglasses. So of course he drifts off the kerb into our lane ever so softly, and then he strolls along before us as though nobody else had anywhere to go.",
#:   "Unit 2 had been legally parked. It was edged from the curb into the lane of Unit 1 and continued in that lane at approximately eight miles per hour, with Unit 1 behind it. At no time did Unit 2 halt or make any appreciable gain in speed.",
#:   "My gran drives like that. She lets the handbrake off, the car comes away from the pavement like a boat from a jetty, out into everybody's way, and off she goes in front of them all at the speed of her shopping trolley, quite content.",
#:   "The motorcyclist had sat astride his parked machine for a time. He slid it out into her lane in no hurry whatever, and for the rest of the street there was nothing for her to do but look at his back while he chugged along.",
#:   "I'm on my bike behind a car that's behind this removals lorry, and he only came off the kerb a minute ago, at about the pace you'd push a wardrobe. He hasn't sped up since, he's still lumbering along and all of us are stacked up behind.",
#:   "Off the kerb at a dawdle, ahead of us at a dawdle.",
#:   "Parked moped dribbles into our lane and never gets above trotting pace.",
#:   "Slowest van ever leaves the roadside and leads us a funeral march.",
#:   "The coach came away from the pavement so gradually that I noticed it only once it was ahead of me, plodding up the road.",
#:   "Unit 2 left the curb at a crawl, took up the travel lane ahead of Unit 1 and maintained roughly six miles per hour thereafter.",
#:   "my man leaves his parking spot like he's defusing a bomb and then keeps driving like that right in front of us for two blocks",
#:   "That police car's drifting out from the side, no rush at all, so come down to second and resign yourself, he's ambling.",
#:   "I need a stationary truck that eases from the kerb into the AV's lane and from then on plods ahead of it at a constant low speed.",
#:   "From parking he is coming out so slowly slowly, and afterwards also he's moving in my front like bullock with stomach pain.",
#:   "It took him so long to leave the kerb that I'd time to read the whole of his side, plumbing and heating, emergencies. Then I'd all the time in the world to read his back doors, which said the same thing. I did twelve miles an hour behind those doors as far as the bypass, and he never found another gear.",
#:   "With regard to the delay on route 9: the bin lorry had been standing at the roadside near the library. It moved by degrees out of there into the path of the robotaxi and went lumbering on at about the pace of its own crew on foot. The robotaxi reached the terminus seven minutes late.",
#:   "I could have walked it quicker, with my knees. Mr Alder's old Rover slid from its place beside the hedge, ever so gently, out before the car my nephew was driving. We were at its bumper from that moment until the post office, and the needle never got past the little ten.",
#:   "Parameters for the low-speed leader: starting position against the kerb, start velocity zero, target velocity 2.5 m/s. The transition into the ego's lane is carried out at that velocity, and the vehicle carries on along the lane at that velocity. There is neither a braking event nor an acceleration phase, so that the closing rate stays high.",
#:   "The bunch of us behind him had become a proper peloton by the end. It began with an ambulance that was parked outside the home and must have had somebody fragile aboard. Out it floated, inch upon inch, into the lane ahead of a silver car, and it went on floating, ahead of us all, at a speed at which my bike will hardly stay upright.",
#:   "You'll find this on every market day. A pickup full of sheep rolls off the side of the road in front of you, and I do mean rolls, you could've finished a crossword. Once out, it doesn't pull itself together either; it's just there before your bonnet, baaing along at a walk, and you might as well change down.",
#:   "My claim concerns the clutch. The defendant allowed his motor home to creep out of a parking bay into the lane in which I was approaching, and having done so he kept on as he'd begun. For two miles I was compelled to follow him in first gear, slipping the clutch, until it burned.",
#:   "Nobody shouts at a hearse, and at first I took it for one: long, black, and coming off the kerb like treacle off a spoon. It wasn't, it was a stretch limo with a hen party. It stayed like treacle, too, all along the seafront, with our lane full of it and me looking at twelve waving arms.",
#:   "Scooter with an old grandfather on it, he was parked at the trottoir. He goes away from there so soft that I believe he only moves with the feet, and he comes in my lane. Then I must drive behind him to the market, him ten kilometres in the hour, me with my foot on the brake.",
#:   "There are two kinds of hazard, he used to say, the sort that comes at you and the sort that won't get out of your way. The removals truck was of the second sort. It left its mooring at the pavement with infinite caution, filled the lane before them, and chugged on ahead, at three miles an hour, towards the evening.",
#:   "Log excerpt, 09:12. Parked bus begins to encroach on our lane at 1.9 m/s, completes entry eleven seconds later, headway eight metres. 09:14, same bus, same lane, still 1.9 m/s, still directly ahead; the safety driver asks whether he may get out and push.",
#:   "Leaves the kerb like cold syrup, goes on like cold syrup.",
#:   "Parked hearse eases into our lane and stays a hearse.",
#:   "Off the edge by inches, ahead of us by inches.",
#:   "At the speed of a man pushing a car, which I first thought it was, the taxi parted from the pavement and led me down the hill.",
#:   "Kerb target: single low speed for the merge and for everything after it; ego to fall in behind at that speed without a collision warning.",
#:   "this bus takes a whole red light cycle to get off the curb in front of me and then never goes over 8, my uber meter is crying",
#:   "You have time to change down, time to sigh and time to settle in behind, for that's a loaded wagon sliding off the kerb and it won't get brisker.",
#:   "From the side one truck full of sugarcane is coming out inch by inch, then in my front it is going also inch by inch, what to do.",
#:   "No bang, just a police van that drifted out off the kerb as I came up and that I've been staring at in second gear ever since.",
#:   "My tea was hot when the horsebox began to part company with the kerb, and it was drinkable when it was in front of me. It was cold by the time I saw any road. I'm not complaining, there was a horse in it; only that at no point in two miles did that horse go faster than it could've walked.",
#:   "We have a plot that nobody believed. Time runs to the right and our own speed downwards from fifty. It meets that of a previously parked ambulance at nine, just when the ambulance has finished seeping out into our lane; and from there the two lines are one line, flat as a pond, right across the page.",
#:   "I could have overtaken him while he was still parked, so to speak. He'd his wheel over, he'd begun, you had to look at the hubcap to see that it was going round. Then he was out, my lane was full of removals van, and I thought, now for it. Now for what? I looked at the hubcap, and I could still read it.",
#:   "It isn't what you'd call pulling out, said the constable, it's more what I'd call leaking. She leaked off her parking place into the lane, right in the path of the coach. Did she accelerate afterwards? No, sir, she leaked all along Church Row, and the coach had to leak after her with its passengers making remarks.",
#:   "Ten of us were cycling to a wedding behind the bride's car, and it got no quicker than us. That was owing to a scooter with a sidecar and a double bass in it. It had come away from the kerb in front of the bride as gingerly as if the bass were asleep, and it stayed as ginger and it stayed in front.",
#:   "What the passenger of a robotaxi wants to know is why. I told her: that steamroller, I mean the van with the glass on its flanks, was beside the pavement until a minute ago. It has come off it in front of us so smoothly that I couldn't tell you when. And glass is glass, so ten kilometres an hour it'll be from here to the glazier's.",
#:   "The operator of Vehicle 1 complained of no sudden movement; her complaint was of the reverse. Vehicle 2 had required some nine seconds to travel from the curb to the center of her lane. It continued ahead of her at the rate of three car lengths every four seconds, neither halting nor improving on this, for eleven hundred feet.",
#:   "My late husband used to leave the house like that, a button at a time. The old gentleman in the Morris undid himself from the kerb by degrees, there in front of my niece's car. I said, he'll be off now. He wasn't, he had only come out to be slow in the middle of the road rather than at the side of it.",
#:   "Gentlemen colleagues, you know the feeling when the third gear becomes lonely. There is a camion by the border with tiles on it up to heaven. He slides out, softly, softly, you could paint him, and I have the second gear. He's before me in the lane now and he continues to be painted, and I've the first.",
#:   "Some kid had drawn a face in the dust on the doors, and I got to know that face. It slid into my lane sideways, a nose, an eye, another eye, because the old bus it was on was shifting off the kerb at about the pace of a sunrise. After which it hung there before my windscreen, grinning, at walking pace, the length of Bath Road.",
#:   "Nothing dramatic was done to them, and that was the cruelty. A motorcycle with an old couple on it withdrew from the row along the pavement, as gently as a drawer is opened, and was in their lane. There it puttered, and there they puttered behind it; the ferry's whistle went, and it puttered on, and the ferry's whistle went again.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "slow"]
#: side = "right"
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 40.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.6
#: high = 3.0
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_DISTANCE = Range(18, 40)
param OPT_ADV_SPEED = Range(1.6, 3)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED)
