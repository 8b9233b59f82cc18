#: description = "The cyclist swings into the ego's lane from the side and rides on slowly ahead of it."
#: rephrasings = [
#:   "A rider enters from the kerb and takes the lane at low speed.",
#:   "The cyclist turns onto the carriageway right before the ego and dawdles along.",
#:   "A bike pulls out of the side and stays in front of the vehicle.",
#:   "The motorcyclist cuts in from the roadside and crawls onward.",
#:   "The rider merges from beside the road and forces the ego to tuck in behind.",
#:   "This bike just swings off the pavement into our lane and potters along.",
#:   "The bicyclist entered the travel lane from the shoulder and proceeded slowly ahead of Vehicle 1.",
#:   "bike joins lane from edge, slow, stays ahead",
#:   "A woman on a pushbike came in from the side and then pedalled along slowly right in front of me.",
#:   "The bicyclist merged from the roadside into Unit 1's lane and continued ahead at low speed.",
#:   "Bike moves in from side, plods on ahead of ego, same dir.",
#:   "The cyclist target enters the VUT's lane laterally and continues ahead at low speed in the same direction.",
#:   "The cyclist comes from the side in my lane and rides slowly before me.",
#:   "VRU merges in from the bike lane/edge and becomes a slow leader; no stop, no crossing.",
#:   "She slipped in ahead of him from the edge of the road and went on pedalling at her leisure.",
#:   "Cyclist moving in from the right, he's taken the lane and he's pottering along, so tuck in behind.",
#:   "a bike came in from the side and now were stuck going bike speed",
#:   "A cyclist filtered in from the roadside and led the traffic at her own leisurely rate.",
#:   "She came from the side into his lane and proceeded, in the same direction, at a modest pace before him?",
#:   "One cycle came from the side into my lane and going slowly in front, cannot overtake.",
#:   "In from the side he drifts, and now I'm chauffeuring behind a pushbike at eight miles an hour.",
#:   "Lateral lane entry by two-wheeler with slow onward travel ahead of ego.",
#:   "CYCLIST MERGES IN FRONT OF ME AND TAKES HIS TIME",
#:   "The moped slotted into our lane and ambled ahead.",
#:   "Boy on a BMX leaves the pavement, takes our lane, pedals gently onward.",
#:   "Moped in from the verge, now a slow leader for our AV.",
#:   "Make a cyclist come off the side path and dawdle ahead of us.",
#:   "From the roadside into lane, same heading, 12 km/h, that bike.",
#:   "Stuck behind grandpa's bicycle, which had swung in from the edge.",
#:   "A lady with a basket on the handlebars curved out of the park entrance into the lane in front of us and then went along in our direction at her own gentle speed.",
#:   "The bicycle target starts beside the carriageway, turns into the VUT's lane ahead of it and from there travels in the same direction at low constant speed.",
#:   "As I came past the chip shop a delivery moped came off the forecourt, bent into my lane and went puttering on ahead, so I had to brake down to fifteen.",
#:   "I want a rider waiting at the side of the street to enter our lane when we're near and stay ahead of us, moving the way we do but much slower.",
#:   "Investigating officer determined that the bicyclist had entered the lane of V1 from the right shoulder in a curving motion and was continuing northbound ahead of it at about eight mph.",
#:   "Un vélo enters from the side in my lane, he turns in my sense of driving and then he pedals quietly, me I must stay behind.",
#:   "I'd been waiting by the bus shelter for a gap and I thought that car was far enough away. So I pushed off, swung round into the lane and set off up the road with it behind me, and with my knees I don't go faster than a walk and a half.",
#:   "Look at the fellow with the trailer, at the edge there, by the bins. He isn't crossing. He's coming into your lane and now he's turned the way we're going, and that's us behind a pushbike, nice and slow, keep your distance until he's settled.",
#:   "The AV was doing about thirty when a small motorcycle left a field gate, joined the lane in front of it with an easy sweep, and kept on up the road at little more than a cycling pace. It never stopped; the AV just had to fall in behind.",
#:   "Nobody at the village fete took much notice when the vicar wobbled off the green, steered into the lane in front of a driverless shuttle and led it, at the stately pace of a man thinking about his sermon, all the way along the high street.",
#:   "Ticket: follower logic tailgates VRU. A scooter initially off to the side of the road turns in ahead of the ego, aligns with our heading and goes on at 3 m/s as new lead. It neither crosses out of the lane nor stands still, it is just slow.",
#:   "From the path's mouth a pedal-bike bends into our lane and ambles on.",
#:   "Moped comes in off the forecourt, turns our way, plods ahead.",
#:   "Our new leader: a slow cyclist freshly off the pavement.",
#:   "Just ahead of the car a girl on a Dutch bike rolled from the cycle path into our lane, straightened up in our direction and pedalled on without any hurry.",
#:   "The VUT approaches; the two-wheeler, waiting beside the lane, enters it in a curve, adopts the VUT's heading and maintains 10 km/h ahead of it.",
#:   "Put a rider by the kerb who, as we come up, steers onto our lane and then jogs along in front of us at bicycle speed.",
#:   "From the left side one cycle with milk cans came into my lane and after joining he is going in my direction only, gently gently.",
#:   "Unit 1 was slowed to nine miles per hour by a motor scooter that had entered the lane from the grass and kept on in the same direction.",
#:   "now i'm following some hipster on a fixie who came off the side of the road into my lane and hasnt got anywhere to be apparently",
#:   "The queue behind the post van was forty cars long, and what headed it was not the post van at all. It was old Pettigrew's tricycle. He had come wobbling out from the towpath, turned up the road in the direction everyone was going, and gone up it at his usual four miles an hour.",
#:   "I was reading in the back when the robotaxi said \"slow traffic ahead,\" and I looked for the traffic. It turned out to be one boy on a BMX. He'd been standing on one foot at the edge of the road; now he was in our lane, with his back to us, pushing down one pedal and then the other.",
#:   "Ahead of V1 a bicyclist left the west sidewalk at a curb ramp and entered the northbound lane at an angle, turning northbound. He was proceeding in that direction at an estimated seven miles per hour, and had done so for about forty yards, when V1's right headlamp contacted his rear rack.",
#:   "From up here in the cab I thought he'd be going over, straight across into the estate. He wasn't. The moped came out from between the bollards, leaned round till I'd his back light square in front of me, and there it stayed, doing twelve, all the way up to the roundabout, and me in crawler gear.",
#:   "Test engineer's remark: the follow-distance was set by a lead that did not exist a second before. Cyclist at rest 3 m to the right of our lane; starts, comes in, aligns with us, and then keeps up 2.8 m/s as our lead vehicle. Jerk on the passengers was 9 m/s³, which is too much.",
#:   "I told the police lady it was my own fault as much as his. I'd stopped at the side of the road for a pasty. I put the paper in my pocket and pushed the bike off into the lane, and then went along in it, steady, same way as the cars. I'm slow, I've a bad heart, so he had to brake.",
#:   "Nobody overtakes on our bridge. So when the delivery rider came off the footway at the beginning of it and tucked himself into the lane ahead of the shuttle, we all knew what was coming to us. He had no motor, two crates of beer and a headwind, and the bridge is nine hundred metres.",
#:   "Er kam von der Seite, from the small way beside the field. I had thought that he waits. But he steered his bicycle in my lane, he made the curve until we were looking in the same direction, and then he was my pacemaker. My speedometer has shown eleven for the rest of the village.",
#:   "The sun was down but the sky still light, and bats were about. Out of the orchard gate glided a rider without a lamp, took the turn into the lane as water takes it, and drifted on in front of them between the hedges. There was no sound but his chain, and the car purred after him, not daring to press.",
#:   "Let me describe the one we keep failing. There's a motorcyclist off to the side with his engine running. He joins our lane from there when we are twenty metres away, and he faces the way we face. Instead of accelerating like any normal rider he putters ahead at four metres a second, and we're in his pocket.",
#:   "You see her by the hedge with her foot on the kerb? She has looked at you, so she knows you're there, and she's still coming. In she swings, into your lane, round to our direction. Fine, she's a cyclist, she'll be doing eight or nine, so drop back, second gear, and let her have it.",
#:   "A pedal-bike now led us, fresh off the pavement and in no hurry.",
#:   "From the verge he curved in, straightened up, and dawdled before us.",
#:   "Have a scooter enter from beside the road, then potter ahead.",
#:   "What had been leaning on the fence as we came round the bend was in front of us by the pub, pedalling the way we were going, but at a quarter of our pace.",
#:   "The rear reflector that slid in before our bumper from the right-hand edge stayed there, at the height of a saddle, for the whole of Bridge Street.",
#:   "Until the chapel the AV had a clear lane, and from the chapel on it had a moped in it, just off the chapel path, phut-phutting along the same way.",
#:   "The two-wheeler starts at rest beside the lane, steers in ahead of the VUT through a quarter circle, and continues as a slow lead at 2.8 m/s.",
#:   "Don't wait for him to get over to the other side, he isn't crossing, he has turned our way and he'll be our snail for a while.",
#:   "One milkman on cycle has come from side gully into my lane, has put his face in my direction, and now his speed is my speed, what to do.",
#:   "The speedometer tells it in its own way. Forty, forty, and then a valley down to ten. That's where the lady with the basket rolled off the pavement and turned up the road. And after the valley, where you'd hope for a hill, there's a plain, at ten, all along the park, with her coat tails flapping at the front of it.",
#:   "I'm that rider, hello. I had a flat battery on the e-bike and thirty kilos of potting soil. I came out of the garden centre's footpath, into the lane, and set off home, which is up the hill, which is where the car behind me was going too. I heard it breathing. I can do about five an hour up there.",
#:   "Everyone behind us hooted, at us of course, since they couldn't see him. He was eight, perhaps. He'd shoved off from the grass in front of our bonnet and wiggled round until he had his back to us, and there he was in our lane, knees out, pedalling. It's a long street and he took it at his leisure.",
#:   "At the bus shelter camera: cyclist beside the road, bicycle at right angles to it; shuttle still a good way off. At the bakery camera: cyclist in the shuttle's lane, bicycle parallel to it; shuttle six metres behind, brake lights on. At the town hall camera, two minutes later: the same, six metres, brake lights on.",
#:   "The mother-in-law, who drives from the back seat, cried \"he's going over!\" Well, so did I think. I aimed to go behind him. But the rider who'd come out of the vineyard track bent his course till it lay along ours, and there he remained, a pair of panniers in our lane, as slow as if he were going to his own funeral.",
#:   "Our follow module was handed its lead by the roadside, so to speak. It had nobody to follow at t equals zero. A motor scooter was standing next to the lane then. At t equals three it had come in and lined up, with the same heading as ourselves, and was going at a fifth of our speed, and thereafter never faster.",
#:   "We lost the suspect on account of a monk. The monk was at the edge of the road with his bicycle, and we'd our lights on, but he's deaf, we've since learned. In he came ahead of us and off he went up the lane, same direction, at the pace of a psalm. The lane is nine feet wide. By the mill the suspect was gone.",
#:   "You were right to brake but wrong about why. She wasn't going to stop there in front of you. See, she's come in off the kerb, she has brought her handlebars round to where we're going, and she's got her rhythm. It's just not our rhythm. Two seconds behind her, second gear, and no breathing down her neck.",
#:   "Somewhere between the fishmonger's and the bank our taxi became a procession. At its head was a youth on a moped that could do no better than a goat. He'd been leaning by the fishmonger's, had kicked it into life and come round into the lane as we arrived. Had he gone over, or away, we'd have caught the train.",
#:   "It was still raining at four when a shape detached itself from the hedge. It had one wheel before and one behind and a sack over its head. It did not fly over the road, as the hares had done; it bent into their lane, and turned its back upon them, and trod on, slowly, slowly, as the road and they were going.",
#:   "V1's operator had slowed in anticipation of the bicyclist's passing over from the right shoulder to the left. Instead the bicyclist aligned himself with V1's lane of travel, about thirty feet ahead, and kept on in the same direction at what is described as \"just above falling-over speed.\" V1 was struck from the rear by V3.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cut-in", "slow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 3.8
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 40.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts"

param OPT_ADV_SPEED = Range(1.5, 3.8)
param OPT_ADV_DISTANCE = Range(10, 40)

behavior AdvBehavior():
    # Earlier where it has farther to go, or on a wide road it would pass behind the ego.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 2.5
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED)
