#: description = "The rider pulls out from the roadside into the ego's lane, rides a few metres along it and brakes to a stop."
#: rephrasings = [
#:   "A cyclist swings out in front of us and then jams on the brakes.",
#:   "The bicyclist entered the travel lane from the shoulder, then braked to a stop ahead of Vehicle 1.",
#:   "bike joins lane, short ride, hard brake",
#:   "The two-wheeler joins the VUT's lane and decelerates to standstill shortly thereafter.",
#:   "The scooter comes in our lane and after some meters it stops hard.",
#:   "A delivery rider cuts in off the pavement and pulls up dead.",
#:   "The moped joins us only to halt a moment later.",
#:   "Barely in our lane, the biker grabs both levers and stands still.",
#:   "some kid on a bike came off the verge into my lane, did a few yards along it and then pulled the brakes and stopped",
#:   "The bicyclist entered V1's lane from the roadside, traveled several feet ahead of it and braked to a halt.",
#:   "MC from verge -> our lane, few m along, brk, stands.",
#:   "The PTW enters the VUT's lane from the roadside, follows it for a few metres and then brakes to standstill.",
#:   "The bike comes from the side in my lane, rides little bit before me and then brakes and stays.",
#:   "Two-wheeler joins from the shoulder, aligns with our lane, 5 m of travel, then an active stop.",
#:   "She had come off the grass on her moped and ridden but a few lengths ahead of them when she squeezed the brakes and stood.",
#:   "He's joined from the side there on his bike, he's going your way, and now he's stopped on you. Not even three bike lengths!",
#:   "bike comes off the side into our lane, goes like 3 metres then slams on",
#:   "A courier joined the road ahead of traffic, covered a few yards and pulled up smartly",
#:   "You rode out into the lane, travelled along it a very short way and then braked to a halt?",
#:   "Delivery bike came from side into our lane, went little bit, then sudden brake and stopped",
#:   "Pops out off the verge, pedals two yards up my lane and pulls up like he's home",
#:   "Two-wheeler joining the lane from the roadside with early braking to standstill",
#:   "Scooter pulls out, rides 5 meters and STOPS DEAD",
#:   "The moped hopped in, hummed along briefly and braked to nothing.",
#:   "Scooter off the verge, in our lane, three lengths along, anchors, stationary.",
#:   "Courier joined from the roadside, rolled a bit ahead, then stopped sharply.",
#:   "Have a cyclist enter the lane, pedal briefly ahead, then brake to nought.",
#:   "Bike came from grass to my lane, goes short piece, brakes, stands.",
#:   "Kid wheels off the pavement, rides ahead a moment, skids to a halt",
#:   "A moped that had been waiting at the edge of the road set out in front of me, buzzed along for a second or two and then braked until it stood.",
#:   "The bicycle target departs from the roadside, aligns itself with the VUT's lane, covers roughly five metres ahead of it and decelerates to a standstill.",
#:   "She'd scarcely found her balance after coming out into our lane, a handful of pedal turns maybe, when she pulled on the brakes and put a foot down.",
#:   "V2 entered from the shoulder, proceeded a short distance in the same lane and direction as V1, and was then braked to a complete stop.",
#:   "Why come off the side, go up my lane for the length of a bus, and then clap the brakes on and stand there looking at your phone?",
#:   "From left side footpath one boy on cycle got into our lane, was going in front maybe five metres, and then full brake he put and stopped.",
#:   "I saw him sitting on his motorbike by the hedge and I saw him look right at me. He came out all the same, trundled along in my lane for a few yards as though to warm up, and then hauled on the brake and stayed where he was.",
#:   "A word about delivery riders, says the trucker. They hop off the kerb into your lane, they ride up it just far enough for you to think fine, he's off, and then they spot the house number and brake to a dead stand under your bumper.",
#:   "The parcel bike's log is brief. Away from the roadside at 14:02:07, in the traffic lane at 14:02:09 and heading the same way as the robotaxi behind it, brakes fully applied at 14:02:11, stationary in that lane from then on.",
#:   "He had been tying his shoe against a lamp post. He threw his leg over, wobbled from the gutter into the lane, rode five or six yards up it with his coat flapping, and there remembered something, gripped the brakes and stopped.",
#:   "Pupils always ask how long they have to be careful once a cyclist has joined. Well, this one came out from the side, did barely a few metres along your lane and has braked to a standstill in it, so the answer is: the whole time.",
#:   "Scooter joins from the verge, leads us ten yards, anchors, done.",
#:   "Cyclist off the kerb, up my lane briefly, levers squeezed, statue.",
#:   "waits at roadside, pulls out, goes 4m, full brake, congratulations on the journey",
#:   "From where he'd been standing by the fence the biker rolled into our lane, went along with us for a breath or two and jammed himself to a halt.",
#:   "The bicycle target shall enter from the roadside, travel 5 m longitudinally ahead of the VUT and then be brought to rest by firm braking.",
#:   "She pushed off from the hedge into my lane, we travelled together for as long as a sneeze, and then her brakes shrieked and she stood.",
#:   "I require a moped leaving the side of the road for the ego's lane, riding along it for about two seconds and then braking down to nothing.",
#:   "He comes from the border of the route, he installs himself on my lane, he rolls five metres, and hop, the brakes, and he is planted.",
#:   "V2 departed the shoulder, traveled in the lane of V1 for approximately 15 feet and was stopped there under heavy braking as V1 approached.",
#:   "There was a lad astride a motorbike outside the bakery, and I was past worrying about him because he'd looked. He came off the side anyhow. Into my lane, along it for the length of the shop front, and then he had both brakes on and was at a stand, patting his pockets for his wallet.",
#:   "The whole trip can't have taken four seconds. It began at the edge of the road, where the bicycle had been waiting; it led into our lane and a few metres up it, the same way as us; and it ended with a squeal and a foot on the tarmac right before our bumper.",
#:   "I'm glad I held back. The old boy had wobbled from the gutter into the lane, that was one thing; he'd got himself pointing the way we were going and done half a dozen turns of the pedals, that was another; and then he clapped his brakes on and was standing there.",
#:   "The expert put chalk on the road for us. Here, by the lamp post, the moped had left the side; this line, four metres or so in the claimant's own lane, was its ride; and here, where the line grows thick and black, it had been braked until it stood.",
#:   "Any cyclist you see waiting at the roadside, treat her as if she's coming. She is, look, she's in front of us now and heading our way; and just as we've got used to that, after about three bike lengths, her back wheel locks and she's stationary in the lane.",
#:   "Our closing speed had almost come right, which is what makes the case interesting. The scooter pulls in from the shoulder, aligns, rides ahead of the robotaxi for a couple of seconds; the follow controller relaxes; and then it's on the brakes, down to zero, dead ahead.",
#:   "Poor lamb had L-plates and a brand-new helmet. She'd been plucking up courage at the side for minutes, she got her motorbike out into the road in front of my coach, she did all of five yards up it, and then her nerve went and the brakes went on and that was that.",
#:   "The dog ran along with the boy, so you can't blame the dog. When the boy rode off the grass into our lane it ran beside him, the few yards he did along it, and when he pulled his brakes hard and stopped it sat down, and we all sat there.",
#:   "Never in my life had I seen so short a ride. The postman had mounted at the kerb, come out into the lane in front of the grey car, gone along it for one garden and a half, and there he braked hard and stood, for he'd dropped a letter.",
#:   "We couldn't have predicted the braking, but we should have left more space when the rider joined us. At 08:12 the bike is beside the road; at 08:12 and two seconds it's rolling up our lane in front; two more, and it's at rest under full brakes.",
#:   "On highway side one fellow was eating sugarcane sitting on his Splendor. Seeing me only he started, came into my lane, five six metres he drove before me in same direction, and then, brake he caught, and full stop, because sugarcane fell down.",
#:   "Kerb, lane, three bike lengths our way, squeal, foot down. Finis.",
#:   "Scooter's whole trip: out, up our lane a bit, brakes, done.",
#:   "Off the verge he came, led us five yards, jammed on everything.",
#:   "I'd scarcely begun to follow the moped, which had come in off the hard shoulder, when there was nothing to follow any more, just a back wheel skidding to rest.",
#:   "The bike was beside the road, then it was our leader for about six metres, then it was our obstacle, and its tyre had left a mark to prove it.",
#:   "Build us a cyclist who's waiting at the edge, joins our lane going our way, does two seconds in it and then squeezes till the wheels stop.",
#:   "He's got himself off the grass and into your lane, same way as you, nice; and there go his brakes, four yards on, and he's put his boots down.",
#:   "V2, a pedalcycle, had been in V1's lane for no more than six meters since quitting the roadside when it was halted there under abrupt braking.",
#:   "From the border she entered in my row, we had one moment the same way, then cried her brakes and I had her luggage carrier before my nose.",
#:   "I was relieved, for a second, because the hard bit was over. He had been dithering on his motorbike at the side and I'd been wondering about him; and he'd joined, he was in front, he was rolling the way I was. We passed one gate together. At the second gate he'd both brakes locked and was stationary.",
#:   "There's a bus shelter, a hydrant and a bin. The courier started at the shelter, where he'd been leaning. By the hydrant he was well in our lane with his back to us, pedalling. He didn't see the bin: by then his fingers had closed, his rear wheel was smoking, and the robotaxi was stopped behind him.",
#:   "I should have liked him to choose. Either stay on the pavement, or ride to town. What the lad did was to ride out from the pavement into my lane and ride to town for as long as it takes to say so, and then all I could see was an orange flag shaking on a bicycle that had been braked to nothing.",
#:   "When you're heavy you do sums. Biker sat at the lay-by's edge. He goes, so I lift; he's in the lane, running on before me, so I do the sum with him at thirty. He never got to thirty. He was there three lengths, four, and he clutched, grabbed and stopped, and the sum came out at my bumper and his tail-lamp.",
#:   "The grass still shows where the scooter had stood, and the tarmac shows where it stood next. It's not ten paces. The first three or four of them lead from the grass into the middle of the claimant's lane; the rest go up that lane, the way that she was driving; and the last two are black.",
#:   "My follow-distance function had one second of happiness. Target acquired: two-wheeler, entering from the right edge, now aligned with the lane, moving off ahead. Target speed: three, four, four. And four became zero, by way of a hard brake and not a gentle one, with the ego nine metres behind.",
#:   "Mum was cross with me, but it was the duck's fault. I got on at the hedge and I looked and I went out on the road, and I was biking along it in front of the post van, only a little way, two or three pushes. And the duck came. So I pulled both handles and stopped and so did the post van.",
#:   "What gave it away was his helmet. It came down off the bank, turned from profile to the back of a helmet, bobbed along before us for a breath or so like any rider's, and then it dipped, sharply, as when someone has gripped the front brake with all his fingers. We stopped a yard from it, and it was no longer bobbing.",
#:   "Would you say that he was riding in the road, Mr Lee? I'd say that he began to. He had put out from the roadside into the lane of the taxi; he had gone with it, ahead of it, a matter of five metres; and he had then braked so hard that his riding was at an end.",
#:   "She'd been waiting by the milestone with her bicycle against her hip, and it was as though the sight of their car had decided her. She came down into the road. For a few turns of the wheel she went before them, upright, her scarf flowing back; then, with a wail of brakes, she was off the saddle and at a stand, and staring at her watch.",
#:   "Side of road, tea stall, one fellow on Activa is finishing biscuit. Biscuit finished, he started, came down in my lane, now he is my front man, same direction we are going, I thought till Mysore. Till next pole only! There, without anything, brake he pressed full, stood, because for the tea he had not paid.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "brake", "stop"]
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.0
#: high = 5.5
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 6.0
#: high = 26.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_TIME"
#: low = 1.5
#: high = 3.5
#: unit = "s"
#: meaning = "how long it rides along the lane before it brakes"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_SPEED = Range(3, 5.5)
param OPT_ADV_DISTANCE = Range(6, 26)
param OPT_ADV_TIME = Range(1.5, 3.5)
param OPT_BRAKE = Range(0.6, 1)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 3
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_ADV_TIME seconds
    do BrakeOnPath(egoRoute, globalParameters.OPT_BRAKE)
