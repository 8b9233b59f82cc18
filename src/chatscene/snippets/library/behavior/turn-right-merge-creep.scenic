#: description = "The car turns right into the ego's lane and crawls along in front of it."
#: rephrasings = [
#:   "pulls out of the side road in front of us and then just dawdles",
#:   "Vehicle 2 turned right onto the roadway ahead of Vehicle 1 and travelled at low speed.",
#:   "right turn into our lane, crawls",
#:   "The target turns right into the lane of the VUT and continues at less than 14 km/h.",
#:   "A bus comes from the right street before the ego and it drives very slowly.",
#:   "A cyclist rounds the corner to the right and pedals leisurely ahead of the ego.",
#:   "The tractor-trailer swings right and lumbers along, holding us up.",
#:   "A moped potters out to the right without giving way, and never gets going.",
#:   "He turned right out of the side road in front of me and then pootled along at walking pace.",
#:   "Unit 2 made a right turn into Unit 1's lane and continued at an unusually low speed.",
#:   "Tractor-trailer R turn into our lane, then crawls.",
#:   "The target vehicle joins the lane of the test vehicle by a right turn and proceeds at walking speed.",
#:   "A bus turns right into my lane and drives so slow before me.",
#:   "Cross traffic merges right into our lane, v stays ~5 km/h, doesn't stop or speed up.",
#:   "It came round the corner into her lane and there, when it ought to have got going, it merely ambled.",
#:   "Cyclist is turning right, out in front of you, and he's just dawdling now, so you'll have to slow.",
#:   "pulled out right in front of me turning right and then just... crawled",
#:   "A lorry came in from the side with a right-hand turn and held up the car behind with its sluggish pace.",
#:   "You turned right into the lane before my client, and having got there you scarcely moved along it.",
#:   "Lorry from side road turned right in front of me and then going like ant.",
#:   "Can't wait to turn out ahead of me, oh no, and then can't find second gear.",
#:   "Right-turn entry of crossing vehicle ahead of own vehicle with persistent crawl speed",
#:   "COULDN'T WAIT TO PULL OUT... THEN DOES 3 MPH",
#:   "The bus slips right into our lane and plods before us.",
#:   "Cab hangs a right into our lane, then inches along ahead.",
#:   "Cyclist from side street: right, into ego lane, remains very slow.",
#:   "He rights himself into my lane from the lateral street and goes snail.",
#:   "Side-road lorry joins our lane rightwards, then barely makes headway.",
#:   "Having turned right, ahead of you, that moped will not get going.",
#:   "A school bus came out of the side street to its right, took up the lane ahead of the robotaxi and went along it at a pushchair's pace.",
#:   "Could the crossing van make a right turn that puts it in our lane, and then dribble along there so that the AV is held up?",
#:   "From the minor arm a pickup rounded the corner to its right, straight into my lane, and then it was first gear and no more for ages.",
#:   "The elderly gent on the tricycle bore right out of Mill Street into our lane, where he pedalled along ahead of us as if it were a park.",
#:   "With a right turn the target vehicle transfers from the intersecting road to the VUT's lane, which it then occupies at 4 m/s as the leader.",
#:   "A queue formed because a tanker that had emerged from the side road by a right turn was dragging itself up the claimant's lane at a trot.",
#:   "It was the milk float, I suppose, or whatever they have nowadays. It came out of the lane on the left with its right-hand bend so wide that it was in front of me before I knew it, and then it hummed along ahead at the rate I walk.",
#:   "Vehicle 2 entered the roadway from the intersecting street by means of a right turn, which placed it in the lane of, and ahead of, Vehicle 1. It continued in that lane at no more than seven miles per hour. Vehicle 1 closed rapidly and had to brake.",
#:   "Pupil says: but he'd room enough to come out. Yes, if he'd pulled his finger out! A car that goes right out of a side road into your lane and then drives away is no bother; that hatchback went right into your lane and is crawling, so down through the gears.",
#:   "Bike commuter's gripe number seven, other bikers. This fella on a chopper rumbles out of the cross street, swings to the right, plonks himself in the lane I'm using, and then we're off on parade, him in front at a brisk stroll and everyone else behind.",
#:   "The side-street vehicle first slows for the mouth of the junction. When the ego comes near, it turns right at low speed into the ego's lane and sticks to that low speed as it follows the lane in front of the ego; no stop, no speeding up afterwards.",
#:   "Side-street van goes right, joins our lane ahead, inches along.",
#:   "Right out of the cross street, our lane, walking speed.",
#:   "Bus from the minor road rights itself into our lane and plods.",
#:   "A lady on a bicycle took the right-hand corner out of the side road, was in my lane before me, and pedalled as though through glue.",
#:   "This semi comes out of the cross street making a right, ends up directly ahead of me and then never breaks eight miles an hour",
#:   "From the intersecting arm the target shall turn right into the lane of the VUT, ahead of it, and travel on therein at a uniform very low speed.",
#:   "Pickup on the side road, he's making his right into your lane, so cover the brake; he's in, and he's dawdling, so use it.",
#:   "That scooter came from the cross lane, right side he turned, took my track in front, and from there he's moving only like tortoise.",
#:   "Have a lorry from the crossing street go right into the robotaxi's lane and then trickle along in front of it without ever gathering speed.",
#:   "What kept us was a hearse, an empty one as it turned out. It emerged from Chapel Street with a dignified curve to its right and there it was in our lane, ahead of us, and I naturally thought it'd get on. It didn't get on. We followed it at three miles an hour the whole way to the ring road, and I took my hat off.",
#:   "According to the third party she had \"plenty of time\". She turned right from the intersecting road into the lane that the insured was using, a few lengths ahead of the insured's front bumper. Her speed, having got there, remained no higher than a brisk walk, and a shunt followed from behind.",
#:   "I ride that road daily and I can tell you what the next hundred yards were like for the cab in front of me. They were like the last hundred of a marathon, since a cement mixer had swung right off the side street into our lane, and its drum was the only part of it that turned at any speed. The cab's brake lights never went out.",
#:   "At first the lead slot is vacant. A car then appears from the crossing road on our left, describes a right-hand quarter circle and ends it aligned with us, eleven metres ahead, at two metres per second. It stays at two metres per second; our own speed comes down from thirteen to two within that space.",
#:   "My rear end's been bashed in because of somebody I never touched. He'd a trailer with a piano on, came right-handed out of the cross street and into my lane, and from there he crept as you would with a piano. I braked for him in good time, but the gent behind was looking at the piano.",
#:   "Nobody minds a body coming out of a side road on a right turn if they then shift themselves. But this learner on a moped had got round the corner and into our lane in front of my husband, and that, she seemed to feel, was enough for one day. We'd have overtaken her on foot.",
#:   "V2 was northbound on the side street; V1 was eastbound. V2 executed a right turn onto eastbound Route 9 and thereby entered the travel lane of V1. V2 remained in this lane at approximately 6 mph, its operator being unfamiliar with the manual transmission, and V1's operator reduced speed to match.",
#:   "He comes from the little street, the autobus, he takes his right, large, large, and I find him in my lane before me. So I think, now he'll go. He doesn't go, he makes a promenade, the people inside read the newspaper, and I behind do ten in the hour.",
#:   "We'd been the fastest thing in the valley; a minute later we were the second slowest. The slowest was ahead of us, on our lane, loaded with hay to the height of a house. It had come round out of the crossroads, by the right-hand bend, while I was changing the station, and it crawled before us with straws dropping off.",
#:   "Dispatcher to 31, you'll be late on Mill Road, there's a slow cyclist. He's come off the side street, right turn, into the lane in front of a white Transit, and he's doing next to nothing. He's not stopping and he isn't pulling over, so everybody's got to go at his rate.",
#:   "Poor planning is when you save a second at the corner and then spend it a hundred times over. That estate couldn't let us by; it had to whip the wheel to the right and be out of its side road and in our lane before we got there. Ever since then it's been rolling along in front of us at the speed of a pram.",
#:   "Side-street coach: rightward into our lane, then a snail's progress.",
#:   "A right out of the lane, ahead of us, and then slowness.",
#:   "Bike comes round right before us and trickles along.",
#:   "The back doors that I've been reading since Mill Lane came round into my way by a right-hander out of it, and have not gone above six since.",
#:   "Crossing truck to slow for the junction mouth, turn right into the ego's lane when the ego is near and keep a constant crawl there as its leader.",
#:   "she hangs a right off the side st into my lane, like RIGHT in front, and i think ok now go, and she does not go, 5mph, three blocks, help",
#:   "From cross road right side he turned and sat in my lane with his motorcycle and three gas cylinders, and now he's leading me like my grandfather.",
#:   "What turns a fair gap into a foul one is speed: that van off the side road took a right into our lane in good time, then merely strolled.",
#:   "Would a bus that has swung rightwards out of a by-road to be ahead of you be so kind, please, as to do more than walking pace in your lane?",
#:   "If the ice cream's soft, blame a tanker. I was on time as far as the dairy. There's a road comes in there, and out of it, on a right-hand sweep, came this silver drum which ended up in my lane, ahead, lined up with me as if for a parade. It was a parade. I could hear every stone under its tyres for the next two miles.",
#:   "The signature in the lidar is odd but you'll meet it again. A short edge slides in from the arm on our right; it rotates clockwise by ninety degrees; it stops being a side and becomes a back. From there the back is a fixed eight metres ahead of us, in our lane, and our speedometer and its own show four.",
#:   "What I minded was the haste of the first half. The moped fairly had to scrape its stand on the corner, so as to be round to the right and in my lane before my bonnet got there. Having managed that, the young lady sat up, opened her jacket and gave herself over to the view, and I, in first, on the clutch, gave myself over to her number plate.",
#:   "There's a piano on the lorry ahead of us. It nosed out of Conduit Street to its right as I came up, into the lane I'd got to use. Once he was straight the driver looked in his mirror, at the piano, not at me, and thought of its legs. We've done seven stops at the speed of a pram.",
#:   "Court. \"You entered from the side road?\" \"Yes, with a right turn.\" \"In front of the claimant?\" \"Well in front.\" \"And did you then proceed at a proper speed?\" \"I proceeded.\" It's common ground that the defendant's camper was in the claimant's lane for six hundred yards, straight ahead of her, and that two schoolboys walking on the pavement reached the bridge before it.",
#:   "Our cycling group calls it a cork. The neck of the bottle's our lane. The cork comes from the street at the side, with a curve to the right, in this case it was a grey-haired man in a tiny electric car; and when it's well in the neck it doesn't stop, but it doesn't move so that you'd notice, either.",
#:   "The gap analysis gives a clean bill to the first manoeuvre. V2 completed a right turn from the stop-controlled leg into V1's lane 4.9 seconds ahead of V1. V2's speed at the end of the turn was five miles per hour; at the next driveway it was five miles per hour. The 4.9 seconds had been consumed, and V1's operator was braking, before V2 had covered forty feet.",
#:   "My son asked why we'd become a snail. Because, I said, look, there is the snail. He'd seen it himself, it had been a normal blue van in the road at the side, it went round the corner to its right, and now it was in front of us on our road. It had only its one speed, and we had it too.",
#:   "For a French person this is not possible. He has before him an open route; me I am still at fifty metres. He turns to right from his little street, he installs himself in my lane, before me, bravo. And then he does eight! He does eight at the bakery, eight at the church, the motorcycle doesn't even make noise, even the priest on foot overtakes.",
#:   "It isn't an obstruction if it moves, the sergeant says, so I can't book them. It's a float, with geese on. Came right-handed out of Fair Street, slotted in ahead of a black cab that was on its way up the lane. Cab driver's very civil about it. I'm keeping level with the pair of them, and have been since Fair Street, and I'm on my own two feet, over.",
#:   "The road had been theirs like a tune one knows, and then there was another instrument in it. From the side street, curving always to the right, there came out before them an old bus with bedsteads on its roof. It settled into their lane as if it had been asked. It had no quick notes; they played the tune to its end at the pace of a mule.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["turn-right", "slow"]
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 2.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.8
#: high = 3.9
#: unit = "m/s"
#: meaning = "how fast it turns and goes on"

param OPT_ADV_DISTANCE = Range(2, 20)
param OPT_SLOW_SPEED = Range(2.8, 3.9)

advTurn = ("straight", "right-turn")

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED) until abs(offsetFrom(egoRoute, self)) < 6
    do DrivePath(egoRoute, globalParameters.OPT_SLOW_SPEED)
