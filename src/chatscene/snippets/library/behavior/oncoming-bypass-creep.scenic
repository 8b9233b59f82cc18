#: description = "The oncoming car crawls toward the ego while it goes around the obstacle."
#: rephrasings = [
#:   "the one coming the other way is just crawling and we can't get past",
#:   "Vehicle 2 approached in the opposing lane at very low speed while Vehicle 1 was passing an obstruction.",
#:   "opposing veh at walking pace in the gap",
#:   "The oncoming target moves at less than 13 km/h in the lane that the VUT has to use.",
#:   "A bus comes very slowly from the other side and occupies the free lane.",
#:   "A cyclist pedals gently toward us in the lane we need.",
#:   "The lorry opposite inches along and leaves us hanging out there.",
#:   "A slowcoach facing us plods through the narrow bit.",
#:   "There was stuff in the road on his side, and he was inching round it towards me at a crawl.",
#:   "The opposing vehicle proceeded slowly around the obstruction in the direction of Unit 1.",
#:   "Oncoming truck bypassing blockage, dead slow, toward ego.",
#:   "The oncoming target circumvents the obstruction at very low speed while approaching the VUT.",
#:   "A bicycle comes against me very slowly because he must go around the thing on the road.",
#:   "Opposite actor detours round the blocked lane at 1-2 m/s, nose toward us; we need to wait it out.",
#:   "It came on at a snail's crawl, feeling its way past the heap in the road and toward her all the while.",
#:   "He's picking his way round that skip, ever so slow, coming at you; hold back and let him finish.",
#:   "the bus coming at us was going suuuper slow round the thing in the road",
#:   "A lorry picked its way at a crawl past the blockage, head to head with approaching traffic.",
#:   "The opposing vehicle was skirting the obstacle, and it did so very slowly, in my client's direction?",
#:   "Opposite van is coming slowly slowly from the side of the block, taking his own sweet time.",
#:   "There's a skip on his side and he's tiptoeing round it at me as if it might bite.",
#:   "Very slow detour of oncoming vehicle past obstruction in ego direction.",
#:   "ONCOMING CAR TAKES FOREVER TO GET PAST OBSTACLE",
#:   "The oncoming cyclist tiptoed round the blockage toward us.",
#:   "As we swing round the skip, an oncoming bus dribbles toward us.",
#:   "Oncoming lorry at a snail's pace while the AV clears the blockage.",
#:   "Bike opposite barely moves; our car is mid-pass round roadworks.",
#:   "Slow, slow, slow, the van facing us as we skirt the breakdown.",
#:   "Have the opposing car inch up while the ego rounds the obstruction.",
#:   "We had to go out past the broken-down tractor, and from the other end a coach was approaching with so little speed that you could have walked beside it.",
#:   "During the VUT's manoeuvre around the stationary object, an opposing vehicle advances in the adjacent lane at a constant speed not exceeding walking pace.",
#:   "theres a tree down on ur side so your going round it and the taxi comming the other way is only creeping which makes the timing a pain",
#:   "Vehicle 1 had moved left to clear a dumpster, and Vehicle 2, approaching from the opposite direction, was traveling at barely five miles per hour and did not stop.",
#:   "I want a pickup that comes from the front, dead slow the whole time, just when our robotaxi has to leave its lane because of a blocked one.",
#:   "De vrachtwagen, so the lorry, was coming against us like a turtle when we were driving around the hole in the road, and he never went faster.",
#:   "It was the gas people again with their barrier across my half of the road. I went out to get by it, and down the hill towards me came an old Volvo, hardly turning its wheels, and neither of us knew who would be at the pinch point first.",
#:   "Planner note: the obstacle in our lane requires borrowing the opposing one. Opposing actor is on the map at 1.5 m/s, steady, headed for us. It does not yield, it does not speed up, it takes forever; a gap estimate based on typical speeds is way off.",
#:   "I was the cyclist. I'd got shopping on both handlebars so I was pedalling as gently as can be, and here's this car coming out round the parked removal van on its side, straight into the bit I was trundling along. I didn't stop or hurry, I just kept trundling.",
#:   "You told the court that my client was passing the fallen scaffold at the time. And the bus, which came from the opposite direction, how was it moving? Like a hearse, you said? So it was still coming on, only extremely slowly?",
#:   "The fog had taken the far end of the street. While she steered out and around the heap of gravel, two dim lamps were coming to meet her, growing so gradually that she could not at first believe they moved; it was a lorry, advancing at a foot's pace.",
#:   "While we rounded the skip, the oncoming bus barely rolled at us.",
#:   "Opposing cyclist ambling towards us, ego mid-bypass, neither stops.",
#:   "Snail of a van facing me as I skirt the roadworks.",
#:   "I had to swing out past a fallen branch, and what came to meet me in the other lane was a hay lorry doing less than a brisk walk.",
#:   "During passage of the stationary obstruction by the VUT, an opposing vehicle shall advance at 2 m/s in the lane which the VUT needs.",
#:   "The moment the robotaxi leaves its lane to get by the broken-down car, I want an oncoming tractor unit to be inching along towards it.",
#:   "Because the coach coming the other way was moving so very slowly, it took Vehicle 1 eleven seconds to learn whether it would fit past the dumpster.",
#:   "I am going around one cow sitting in my half, and opposite side one tempo is coming like an ant, neither stopping nor finishing.",
#:   "You're out round the parked lorry now, and the hatchback facing you is hardly moving, but it is moving, so don't be fooled into dawdling.",
#:   "The trench took up all of our side, so out we had to go. I looked ahead and saw a bus, and I looked again a good while later and it was the same bus, a trifle larger. It was coming on all right, but at the rate at which a minute hand goes round.",
#:   "Ask anyone who was on the terrace. The self-driving car had pulled out to get by the beer dray and was on the wrong half of the street. And up that half came Mrs Lund on her bicycle, so slowly it's a miracle she stayed upright, ringing her bell, not giving way and not going any faster.",
#:   "Arrival time of the opposing vehicle was overestimated, then underestimated, then overestimated. Reason: at 1.2 m/s it's near the noise floor of the velocity estimate. The ego was at that time beside the construction barrier, half in the opposing lane, and would have liked to know that this pickup was in fact steadily on its way.",
#:   "There was a sofa on the road, an entire sofa. Going out round it I had the whole of the other lane before me with one thing in it, an ancient Morris with its lamps lit, headed my way. I waited beside the sofa for it to arrive. It arrived, at the pace of a man pushing a wheelbarrow.",
#:   "V1 had moved partially left of center in order to clear a stalled vehicle. V2, a loaded logging truck, was upgrade bound toward V1, and witnesses put its speed at no more than four or five miles per hour. Contact occurred mirror to mirror while V1 was still alongside the stalled vehicle.",
#:   "It could have been a picture that hung in the street, the lorry, for all the change there was in it. Only if you fixed your eye on the kerb could you tell that it was drawing nearer, stone by stone. And there she was beside the collapsed cart, out on its side of the road, with nowhere to go.",
#:   "Learners hate this one, there is no rhythm to it. They go out to pass the obstruction, as we're doing here past this bin wagon, and what's in the opposite lane? Something that isn't waiting and isn't really driving: that Fiat. It's trickling towards us at maybe five, and it'll go on trickling.",
#:   "My nephew, who does the driving on our farm, laughed that he could have had his lunch. He was steering the jeep past a heap of manure on our half, and along the other half a lad came to meet him on a bicycle, with a ladder on his shoulder, so he could only go dead slow.",
#:   "Von vorne ist gekommen ein Lastwagen, very loaded, very slow, I think four kilometre per hour. And I was exactly next to the building machine, which I had to drive around, so I was on his half. He didn't stop and he didn't hurry himself, and my hands were wet until I was back.",
#:   "Regression 77b. Obstacle in ego lane, ego bypasses it via the opposing lane. Opponent: a car that starts 40 m up that lane and rolls towards us with walking speed from first to last frame. The expected result is that the ego neither dashes through at any price nor waits beside the obstacle until the end of time.",
#:   "On the film there is a fair amount of swearing, so I'll summarise. I'm halfway round a broken-down caravan, there is a minibus coming from the front, and I can't read him. Is he letting me go? No, he's creeping up. Is he coming, then? Hardly. He just creeps on and on at me like cold treacle.",
#:   "We're out past the skip and the bus facing us barely rolls.",
#:   "Oncoming bike at a snail's pace, us beside the roadworks.",
#:   "Make the lorry opposite trickle along while we round the wreck.",
#:   "It took the cab from the bend eleven seconds to come five car lengths nearer, and all that time our wheels were over the line because of the fallen tree.",
#:   "With the AV half out of its lane to clear a stalled van, the pickup opposite kept coming, but so little at a time that one had to look twice.",
#:   "Either come or don't, I thought, as I got round the gas board's hole and that hatchback went on trickling down the other side to meet me.",
#:   "The opposing target has a constant 1.5 m/s towards the VUT, which is at that time moving past the obstruction by way of the opposing lane.",
#:   "An old gentleman was pedalling up the lane that I had to borrow, just fast enough not to fall off, and I was beside the broken-down tractor.",
#:   "I'm going out around the bin lorry, opposite side one bullock-slow tempo is coming, his tyre I can count the nuts on, and he isn't giving me way.",
#:   "The flowers in my lap were for my sister. I had arranged and rearranged them, and when I looked up the same bus was still to come. We were at an angle, halfway out, a heap of slates having come down on our side. It wasn't waiting for us, I could see the tread of its tyres come round, block by block.",
#:   "For a follow-the-leader sort of brain it's the worst of all worlds. The obstacle's in my half, so I must use his. He's in his half, headed for me. Were he fast I'd wait, were he parked I would go. He's neither, he's a coach going downhill in bottom gear with a full load of pensioners, and he keeps at it.",
#:   "There's a scrape along the skip and one along the lorry, both at the height of Vehicle 1's mirrors. Vehicle 1 was therefore between them. It had gone out to clear the skip at a time when the lorry, facing it, was still some way up the street, and had believed, since the lorry hardly seemed to move, that it did not.",
#:   "What are you looking at the cones for? You're past the cones with your front wheels, the cones are done. Look up the road. He's been there since we pulled out, that Corsa, and he is bigger than he was. Not much. A yard in the time I've said this. But it's towards us, and he isn't stopping, so keep on round.",
#:   "My grandfather steers his old car as if there were eggs on the road, and that's how we met the robot. It had come out from behind a fallen scaffold, on to our side, as it had to. We went on towards it. Grandfather didn't brake, there was nothing to brake, and I'd time to count its cameras, nine.",
#:   "Measured by the church clock he needed two minutes from the well to the smithy, which is eighty paces. He was bringing the threshing machine home. From the other end came the doctor's car, and the doctor had to swing out, for the timber was lying before the smithy. So they drew near each other, the doctor by jumps and he by inches.",
#:   "Scene request, low priority but fun. Put a stalled car in our lane. Our car goes out and by. In the other lane there's a cyclist, nose to us, pedalling so lazily that the usual gap rule says \"go\" and \"don't go\" by turns. He must not halt or speed up at any point; he's simply slow and on his way.",
#:   "We sat on the wall and watched the two of them. The first had gone out round the melted ice-cream van and the second, a removal truck with a piano in it, was coming up on the free side with a man walking in front. The man never had to lengthen his stride. \"They'll be at it till Tuesday,\" said Kev.",
#:   "On radar he was a parked car. On camera too, for the first twenty frames. In our plan, therefore, we were past the concrete blocks and home again. It was only that, each time we looked, the parked car's number plate had two more pixels: it was travelling down the lane we'd borrowed, at us, with one metre per second.",
#:   "Night shift, unit six. I was out on the offside to get by the burst water main. Single headlamp towards me, and I thought moped. I flashed him, no response. I waited for him to pass, still waiting. Turns out it's a van with one bulb doing maybe four miles an hour for fear of the ice, and he kept that up until we were abreast.",
#:   "Bei uns the tree was laying on the street and I drove on the left around. On the left came my neighbour with his VW bus, and he has a bad back, so he drives over the cobbles with the speed of a snail, I know it. He came and came. I had thought to be finished before him, but so slow as he was, no.",
#: ]
#: adversaries = ["car", "truck", "bus", "bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "slow"]
#: position = "oncoming"
#: maneuver = "bypass"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_SPEED = Range(1.5, 3.5)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
