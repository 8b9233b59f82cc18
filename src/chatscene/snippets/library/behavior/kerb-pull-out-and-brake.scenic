#: description = "The parked car pulls out, drives a little and then brakes hard to a crawl."
#: rephrasings = [
#:   "He pulls out on us, gets going and then hits the brakes.",
#:   "Vehicle 2 left the curb, gained speed and then decelerated abruptly.",
#:   "Parked veh joins, then brakes.",
#:   "The target starts from the roadside, travels ahead of the VUT and brakes strongly.",
#:   "It goes out of parking, drives some metres and brakes much.",
#:   "A lorry sets off from the side only to check itself sharply.",
#:   "The rider starts up, gets before us and grabs the brake.",
#:   "Forgot something: the driver pulls away from his space, then jams on and creeps.",
#:   "A car that'd been parked up came out in front of me, went a few yards and then stood on its brakes down to a crawl.",
#:   "Vehicle 2 left its parking space, traveled a short distance and then decelerated sharply to near walking speed.",
#:   "Parked van out, rolls few m, brakes hard, creeps.",
#:   "The parked target enters the carriageway, travels briefly and decelerates strongly to a residual low speed.",
#:   "The parked truck goes out on the road, drives short and then brakes strong and is very slow.",
#:   "Pull-out followed by a late hard decel to ~5 km/h; tests re-braking after the first reaction.",
#:   "He left the kerb well enough, had hardly got going, and then he hit the brakes so hard that he was barely rolling.",
#:   "Bus is leaving the stop, fine, but now he's anchored up and gone right down to nothing, mind him.",
#:   "this parked car comes out, goes like 5 metres, then brakes super hard n creeps",
#:   "A van left its parking spot and had barely got going when it braked fiercely to a dawdle.",
#:   "Having left the kerb you drove but a few yards before you braked severely, and thereafter barely moved?",
#:   "He came out from parking, went little bit, then sudden brake and moving like ant.",
#:   "Leaves his spot in front of me, gets up to nothing much, then bangs the brakes on and we're all down to a shuffle.",
#:   "Kerbside departure followed by severe braking to residual speed ahead of ego.",
#:   "PULLS OUT OF PARKING SPOT THEN BRAKES HARD FOR NO REASON",
#:   "A parked taxi emerged, rolled on, then choked its pace to a shuffle.",
#:   "Off the kerb, short hop down our lane, brakes, crawl.",
#:   "Cab leaves its bay, trundles off, suddenly stamps hard and inches along.",
#:   "Parked van emerges, covers ten metres, dives onto its brakes, then creeps.",
#:   "Simulate: scooter departs kerbside, rides briefly, decelerates violently, dawdles.",
#:   "He'd just unparked in front of me when he braked savagely to walking pace.",
#:   "It was crawling when I hit it, because it had braked like mad only a moment after coming away from the kerb.",
#:   "The ambulance which stood at the side goes into my lane, makes few metres, brakes with all force and then rolls like a baby stroller.",
#:   "A police car parked at the roadside moved off ahead of us, got going nicely, then shed nearly all of it and plodded on.",
#:   "Following departure from its parking position the target proceeds for two seconds, decelerates at 6 m/s² and holds 1.5 m/s.",
#:   "Do you see the parked SUV there? It comes out, has a little run, then the driver jams on the anchors and just toddles.",
#:   "Coach driver pulls away from the stop, changes his mind about speed, and stamps it down to a dribble right in front of me.",
#:   "A delivery fellow jumped into his van by the kerb and set off before me. I'd hardly settled in behind when up came the rear end, all brake lights, and from there on he poked along hunting for a house number.",
#:   "V2 was legally parked facing the direction of travel. It entered the lane in front of V1, continued some thirty feet, then braked heavily without stopping, and was moving at approximately 3 mph when it was struck.",
#:   "The old Volvo by the chemist's came to life and slipped out into the street. For a few yards it behaved; then its nose went down, its tail went up, and it proceeded no quicker than the shoppers.",
#:   "I want two surprises in a row for our robotaxi. A parked lorry gets into the lane first and gets rolling; when we've just adapted, it bites hard on the brakes and then keeps moving at a mere creep.",
#:   "So I'm pedalling along with the camera on, and this parked Corsa decides to join the road. He goes about four car lengths, brakes so hard the tyres chirp, then potters on at less than my granny's pace.",
#:   "Leaves kerb ahead, gets rolling, brakes savagely, dribbles on.",
#:   "Out of its bay, ten metres, nose dive, then snail's pace.",
#:   "Unparked moped joins our lane, hardly going before it's hauled down to a crawl.",
#:   "Could you start a box van off from the parking strip into our lane, let it roll a bit and have it brake violently down to walking speed, no stop?",
#:   "The ambulance that had been standing by the pavement came out, took a short run along our lane and then braked so hard that it was barely moving.",
#:   "What use is an indicator, if you pull off the kerb, go four car lengths, tread on the brakes and then pootle along at nothing in front of me?",
#:   "He quits the parking place, he makes perhaps fifteen metres on my lane, and then comes a brake like for a deer, but no stop, only creeping.",
#:   "Target leaves marked parking bay and joins test lane; after 2 s heavy deceleration to 1.5 m/s; target continues at 1.5 m/s until end of test.",
#:   "first the scooter that was parked up by the kebab shop hops into my lane, then a few metres later hes braking like mad n crawling, WHY",
#:   "I had made my peace with the hearse. It had been waiting at the kerb; it came away from it, quite smoothly, into my lane, and I tucked in behind. Then the bearers' heads all nodded at once, the tail lamps blazed, and from there to the corner I could have walked beside it.",
#:   "There was a school run of cars by the pavement, and it was from there that the trouble came. One of them slid into the road before us, we fell in behind, all well so far. A second later I had my face in the headrest, and the thing was still going, if you can call it going.",
#:   "How it ended I can tell you straight away: with us rolling in first gear for two hundred metres behind a baker's van. How it got there? It had been parked. It came off the kerb, put on some speed, so I did likewise, and then, as though he'd dropped his sandwich, the fellow hit the brakes with all he had.",
#:   "Bug or feature? At the start the police car is stationary at the roadside, correct. It enters the lane ahead of us, correct. It travels some twelve metres. Then it brakes at 6 m/s² but never reaches zero, since the controller holds it at 1.5. I'm told that's on purpose: nobody plans for a crawler that has just joined.",
#:   "Taxis, eh? I'm coming up Corn Street on the bus. He's on the rank; he isn't on the rank, he's in my lane. Fine, he's shifting. So I leave the brake alone, silly me, and the moment I do his back end's in the air. And does he stop? He doesn't. He toddles. Eleven standing passengers I'd got.",
#:   "We had understood the truck wanted out, and out of its parking place it came. After my husband had got used to it, because it went ahead normally for some metres, it braked like at a cliff. It did not stand, though; all the way until the bridge we were following it with the speed of a nurse pushing a wheelchair.",
#:   "You've let him out from the kerb, that was kind, and he's on his way. Don't follow too soon, mind. He's not sure where he's going, I can tell by his... whoa, there you are, brakes. Right down. He's still trickling, see, so we trickle too, and no, you may not use the horn.",
#:   "The parked motorcycle had been noted by the system and labelled static. It rode out into the lane 31 m ahead and attained 7 m/s, upon which a following gap was planned. Its brake lamp then lit, its fork sank, and its speed fell within a second to that of a toddler. There it stayed.",
#:   "A cat sat on the bonnet, that's why. The woman in the little yellow hatchback hadn't seen it when she drove off from the kerb in front of me, nor for the first few metres in our lane. When she did, she braked as anyone would, hard, but then thought it kinder to roll on, inch by inch, with it sitting there.",
#:   "According to the plaintiff nothing could have been plainer. The coach, which had been at rest beside the carriageway, joined his lane; it proceeded a little; its brakes were then applied with great violence. It didn't halt, the tachograph is clear on that, but was going at four kilometres an hour when he ran into it.",
#:   "Granddad says it's the clutch, I think it's the handbrake. He got us away from the pavement all right, in front of a big lorry too, and we'd gone maybe as far as the postbox when he banged his foot down and my ice cream left the cone. Then we just dribbled along, with the lorry honking.",
#:   "Left the kerb, got moving, stood on it, now oozing.",
#:   "Unparked, ten metres of hope, then anchors and a shuffle.",
#:   "Bus leaves the lay-by, gathers way, nosedives to a trickle.",
#:   "She had slotted in from the parking bays and was well under way when her boot reared up at us, and from that point prams were overtaking her.",
#:   "In run 9 the kerbside target joins ahead of us, attains 25 km/h, then loses nearly all of it in a second and rolls on at five.",
#:   "Whoever was in that hearse at the roadside set off in front of me all right, but a few lengths on it was brakes like a train and then funeral pace, properly speaking.",
#:   "It didn't stop, mind, the taxi that had come off the rank before my nose; after that murderous brake it went trickling down the hill with me behind.",
#:   "I'd be glad of a delivery rider who starts from the pavement into our lane, makes some metres, hauls on both brakes and goes on at a toddle.",
#:   "From the parking he enters, he drives as normal person two seconds, and then he's braking like crazy and after rolling like an old tortoise.",
#:   "Second gear told me everything. I'd been in third, behind a camper that a moment earlier had been asleep at the kerb and was now out and bowling along ahead. Its lamps flared; my clutch foot and my brake foot went down together; third became second, second became first, and first was still too quick for him. He never quite stood.",
#:   "It's a matter of three alarms. The first, when the parked ambulance leaves its place and is on our road; the AV takes note and slows. The alarm goes out, for the ambulance gets going quite well. The second is the collision alarm: full brake lights, twelve metres. The third comes every four seconds for the rest of the street, \"vehicle ahead very slow\".",
#:   "The pigeons went up, and that's why he did it. Up to then I'd had no quarrel with the man. He'd brought his van off the kerb in good time and was drawing away along my lane; then pigeons, and the back doors came at me as though on elastic. And afterwards? He could not bring himself to go any faster than they walked.",
#:   "I'm fond of the moment when the pupil says \"phew\". Parked car's come out, we've let it, it's picking up, phew. And that's when I say \"cover it\". See? Down on its front springs, all that speed gone. Now you want to stop behind it. But look at its wheels: still turning, just, so you've nowhere to stop and nothing to follow.",
#:   "My tachograph disc has a little tooth in it for that street. The flat bit's me coming along. The dip's where the coach that'd been loading by the pavement moved off in front of me. It climbs again, since he did. Then there's a cliff, and beneath the cliff a line you'd take for zero, only it isn't. It's a coach looking for the theatre.",
#:   "\"I believe she'd left the gas on,\" said the neighbour. The lady had got into her car, which was at the kerb; she'd driven away, ahead of the robotaxi, perhaps as far as number thirty; and there she had stamped with both feet, he could see her hair go forward. From thirty to the corner she went no faster than thinking.",
#:   "The glass in the back of the truck didn't break, it's a wonder. The truck stood at the side, the men shut the door, it rolled out before us and took up speed, I was content. And then a braking, a braking, I hear all the glass say something. And then it's only sneaking on, half a metre, half a metre, and we sneak too.",
#:   "V2 was one of several vehicles parked along the east curb. V2 entered the travel lane ahead of V1 and had reached 16 mph when, for reasons not established, its operator made a panic brake application. This was released before V2 came to rest. At impact V2 was rolling forward at approximately the pace of a pedestrian.",
#:   "He wanted to see whether the handbrake held, that was the explanation the sergeant got. He'd fitted it himself. So first away from the kerb with the old police car, a bit of a run, and then a great yank; and it held so well that the couple in the cab behind kissed the partition. After which he thought he'd better nurse it home at three miles an hour.",
#:   "What do you do with someone who can't make up her mind what speed is for? I'd braked once when her scooter hopped off the pavement into my lane. Fair dos, she got going. I'd only just got going as well when her rear lamp lit and her back wheel squirmed. I braked the second time. And the third, the fourth, the fifth, she was barely keeping upright.",
#:   "ok so parked bmw. pulls out, doesnt bother me, hes moving. then for no reason hes ON the brakes, like abs noises n everything, and i wait for him to stop or go. does neither. just dribbles along like a shopping trolley for the whole street. i aged",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "brake", "slow"]
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 15.0
#: high = 34.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_THROTTLE_TIME"
#: low = 2.5
#: high = 4.0
#: unit = "s"
#: meaning = "how long it drives before it brakes"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(15, 34)
param OPT_THROTTLE_TIME = Range(2.5, 4)
param OPT_BRAKE = Range(0.6, 1)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), 7) for globalParameters.OPT_THROTTLE_TIME seconds
    do BrakeOnPath(ownLane(egoRoute), globalParameters.OPT_BRAKE) until self.pose[3] < 1.5
    do DrivePath(ownLane(egoRoute), 1.5)
