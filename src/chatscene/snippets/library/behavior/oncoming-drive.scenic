#: description = "The oncoming car keeps coming along its lane."
#: rephrasings = [
#:   "A vehicle approaches from ahead and does not give way.",
#:   "The adversary drives toward the ego at a constant speed.",
#:   "Opposing traffic comes on steadily.",
#:   "The cyclist rides toward the ego and holds the line.",
#:   "The other driver, facing the ego, carries straight on.",
#:   "he just keeps on coming",
#:   "Vehicle 2 was travelling in the opposite direction at constant speed.",
#:   "The oncoming target drives at constant speed in the adjacent lane.",
#:   "The other car just carried on towards me in its own lane, nothing out of the ordinary.",
#:   "Unit 2 was proceeding in the opposite direction within its lane at a normal speed.",
#:   "Oncoming bus, steady, holds lane.",
#:   "The opposing vehicle continues in its own lane at constant speed without deviation.",
#:   "From the front comes a truck, it stays on its side and drives normal.",
#:   "Plain opposing traffic: lane keeping, no manoeuvre, just doesn't give way.",
#:   "It neither slowed nor swerved; it simply came on down its own side of the road.",
#:   "There's a cyclist coming the other way, he's on his side and he's staying there, so wait for him.",
#:   "theres a car coming the other way, just normal, nothing weird",
#:   "Traffic came from the opposite direction and kept to its proper side.",
#:   "The opposing vehicle held its lane and its pace, and did nothing to which anyone could object.",
#:   "Opposite side one bus is coming in its own lane, simply normal driving.",
#:   "Something coming the other way, keeping to his own side for once, no bother.",
#:   "Regular opposing traffic in its own lane, no deviation",
#:   "Oncoming car does... absolutely nothing wrong",
#:   "The oncoming lorry plods along its own lane.",
#:   "A lorry approaches from the front, keeping to its side.",
#:   "Oncoming moped stays its course and passes as expected.",
#:   "Opposite-direction cyclist, constant pace, own lane throughout.",
#:   "just put a bus coming the other way nothing fancy",
#:   "Facing us, a car drives down its own lane undisturbed.",
#:   "The van coming towards you isn't going to do anything clever; he is staying on his half of the road at the speed he's got.",
#:   "V2 was westbound in the westbound lane, approaching V1 at an unchanging speed, and made no steering or braking input before the two met.",
#:   "Can I get some simple opposing traffic, say a motorbike that comes from the far end and rides down its own lane without any change?",
#:   "I had to wait for him, naturally, since he was coming from the opposite side in his proper lane and had no intention of slowing down.",
#:   "The bicycle which was coming in the contrary direction has continued on its way, on its part of the road, always with the same speed.",
#:   "The opposing target travels in its designated lane toward the VUT with constant velocity and zero lateral deviation during the entire test run.",
#:   "The other motor car was simply coming towards us on the left-hand side, as motor cars do. It didn't hurry and it didn't dawdle, and so far as I could see the gentleman at the wheel never moved his hands. It just kept on.",
#:   "We need a baseline with oncoming traffic that does nothing surprising. A coach comes the other way, stays between its lane lines, holds its speed and does not yield to anybody, and the vehicle under test has to fit its own plans around it.",
#:   "I'm not saying the bus did anything wrong. He was on his side, I was on mine, he came along at thirty or so towards me the whole time and he carried straight on. I only mention it because I couldn't have gone out in front of it.",
#:   "In the clip you can see the headlights of a truck coming down the opposite carriageway from way back. It sits square in its lane and its speed never varies. It's the sort of vehicle you have to let by before you can do anything yourself.",
#:   "When you look up the road, what's there? A lady on a bicycle, coming this way, on the other side, pedalling evenly. She has no reason to stop for you and she won't, so treat her as something that will keep right on coming.",
#:   "Opposing Skoda, own side, unvarying, gives way to nobody.",
#:   "A bus ahead, coming our way, sticking to its half, nothing more.",
#:   "Here comes a moped from the front, steady as a clock.",
#:   "On the far half of the road a lorry was heading our way, and it neither hurried nor hung back nor drifted.",
#:   "Adversary: opposite heading, centred in its proper lane, speed held from spawn to despawn, no reaction to the ego of any kind.",
#:   "What was the other driver doing when you first saw him? Approaching in his lane, sir, and he went on approaching in it.",
#:   "Put in a coach that approaches us down its own lane and minds its own business until it has gone by.",
#:   "From opposite side one scooter was there, correct side, same speed, it was coming and coming, no problem with it, but I had to let it pass.",
#:   "There's a bicycle bound this way along the other lane, it'll keep up its twelve miles an hour whatever we decide to do.",
#:   "I was waiting behind a skip and hoping for a friendly soul. The blue van wasn't one, though I can't fault him. He'd right of way, he was where he should be across the white line, and he drove on toward us at the same pace until the skip was shaking in his wake.",
#:   "The number on his front, the dead flies on his headlamp, the postcard behind his windscreen: all of it came up slowly and evenly, as when you turn the ring on a camera lens. The lorry had its half of the road, I had mine. He never lifted and never pressed.",
#:   "The control run is deliberately dull. A passenger car starts at the far end of the road, faces the vehicle under test, and proceeds along its designated lane with speed and lateral position both constant. It will not brake to oblige anybody. Any conflict arises solely from what the VUT itself does.",
#:   "Do look up, dear. There's a motorbike on its way to us on the other side. It isn't racing, it isn't dithering, and it isn't going to let you through, because why should it? It'll be here in about six seconds and past in about seven, and then it's our turn.",
#:   "Relative speed of the approaching object: 22 metres per second, and 22 again a second later, and so on to the last frame. Relative offset: three and a half metres to the left, likewise unchanging. In other words a bus in the opposite lane, behaving like a bus, and we braked for it.",
#:   "Everybody wants to know about the other cyclist and there's nothing to tell. She was riding towards the car from the opposite end, in her own lane, at a pace you could have set a watch by. She had her eyes open and hands on the bars. She just kept pedalling.",
#:   "Nobody could have called it a challenge, yet he felt it as one. The grey saloon had appeared at the end of the avenue, on its own side, and it was drawing on towards him without haste. It didn't waver. He saw that if either of them were to yield, it would have to be he.",
#:   "On our road there's only room if somebody stops. A fellow in a tipper was headed my way in his lane, and going by his face he'd no plan to be that somebody; the needle can't have shifted by one mile an hour. So I was. He lifted a finger off the wheel going by.",
#:   "The wind of it rocked our little car, and that was the most exciting thing it did. Before the wind there'd been half a minute in which a coach came nearer and nearer on the other carriageway, in a dead straight line, at a dead level speed, and I sat with my hands in my lap.",
#:   "I make complaint against my robot, not against the truck. The truck came from front in the lane where it belongs, with normal velocity, always equal, it did not go left or right. A human sees that such truck will not wait for him. My robot did not see it.",
#:   "Traffic at the scene was light, consisting of one taxi. It was travelling east as V1 travelled west, was at all times within the eastbound lane, and was neither slowed nor accelerated before the two drew level. Its driver had seen V1 and, having priority, continued as he was.",
#:   "Facing traffic: one lorry, own lane, steady as a metronome.",
#:   "There was a cyclist coming. He went on coming. That's it.",
#:   "Opposite lane, constant speed, no surprises: the school bus",
#:   "The approaching moped's lamp stayed where a lamp should be, across the line, and it got bigger at exactly the rate you'd expect.",
#:   "Neither the horn nor the flashing made any odds to the tractor coming the other way on its own half; thirty it did and thirty it kept.",
#:   "I just need a car on the opposing side that heads for us, sticks to its half of the road, and leaves its speed well alone.",
#:   "The opposite coach is a good boy, he comes in his line, he does not run, he does not sleep, so it is I who must wait.",
#:   "From the moment it rounded the bend until it drew level, the oncoming pickup had altered neither its pace nor its distance from the centre line.",
#:   "You may write down that there was an oncoming vehicle, that it was in the right place, and that it proceeded; more I cannot tell you.",
#:   "You're hoping he'll do you a favour, I can tell by your hands. He won't. It isn't rude, it's his road, he's on the proper side of it coming down, the same twenty-five he's been at since the top. So you tuck in behind this skip and you let him through, and then it's your turn.",
#:   "What the milk did in the pail, that's how Grandfather judged a driver. If it lay flat, he was a good one. The man bringing the lorry up the other side of the lane toward us must have had milk lying like a mirror, for nothing he did could have rippled it: straight, level, unhurried, and presently past.",
#:   "We waited for the trick. It was that sort of test, there's always a trick; they swerve, they brake, they come at you flat out. So we watched the blue estate approaching in the lane over yonder, mirror covered, foot ready, and it arrived, and went by, at the speed at which we had first seen it. No trick.",
#:   "Clip 30 is the boring one, so why do I show it? Because the boring one killed our demo. A bus faces us, on its half. It's doing forty at the start of the clip, and forty at the end, and it doesn't move off its half by so much as a hand. Everything exciting in the picture is done by us.",
#:   "Never have I seen anybody so calm as this bicycle. In front of me the street was narrow because of a truck with bricks, and I flashed her, that she should perhaps halt. No. She has her side, she has her rhythm, tram, tram, tram, and she came with it at me and through, saying bonjour.",
#:   "I took my foot off, put it on, took it off. He did nothing of the kind, the fellow in the van over on the other side. There's men that would have speeded up to beat me to the narrow part, and there's others that'd have hung back to let me have it. He came on down and left all the deciding to me.",
#:   "Position of the opposing motorcycle relative to its lane centre: 0.0 plus or minus 0.1 m. Speed: 13.9 m/s plus or minus 0.2. Reaction to the ego's manoeuvre: none, by design. In this scenario the entire responsibility for avoiding a conflict with the approaching motorcycle rests with the system under test.",
#:   "It's dark, you see one white dot on the other half of the road. Could be a bike a long way off, could be a car with a light out, nearer. Wait. It's getting brighter, no faster and no slower than it was, and it isn't wandering. So it'll be beside you when you'd think it would be. And it is.",
#:   "Rain was coming down, my wipers were going, and there was a coach on its way up from the ferry on the other side of the double line. I set my wipers by it afterwards, I said to my wife, for it passed one road post per wipe, one post per wipe, from the far end of the causeway till its spray hit us.",
#:   "The old man had hoped for a sign, a slackening, a dip of the lights. The car that was drawing towards him along the farther lane gave none. It had been set rolling at some hour that morning, so it seemed, in the middle of that lane and at that speed, and would still be so rolling when he and his mule were dead.",
#:   "Incident review, 14:20. Blue saloon inbound on Elm, keeping to the inbound lane. Our vehicle outbound. Saloon's driver was asked if he had braked, \"no, why\"; if he had sped up, \"no\"; if he'd given way, \"it was my road\". Footage bears him out on each point. He drew nearer as any car would and passed on his side.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "follow"]
#: position = "oncoming"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_SPEED = Range(4, 10)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
