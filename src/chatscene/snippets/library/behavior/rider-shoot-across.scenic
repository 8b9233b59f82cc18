#: description = "The rider shoots out from the side and races across the road, faster and faster."
#: rephrasings = [
#:   "A motorbike comes tearing out of the side and flies over the road in front of us.",
#:   "The motorcycle entered the roadway at an increasing rate of speed and crossed the path of Vehicle 1.",
#:   "moto darts across, full throttle",
#:   "The powered two-wheeler crosses the VUT's path under continuous acceleration.",
#:   "The bike drives over the street with full gas.",
#:   "A downhill racer pedals flat out from one pavement to the other.",
#:   "The moped screams over the carriageway, engine howling.",
#:   "Some kid on an e-bike goes hell for leather from kerb to kerb.",
#:   "A kid on a BMX came rocketing out of nowhere and tore over the road, getting quicker all the way.",
#:   "The bicyclist emerged from the side and crossed the roadway at an increasing rate of speed.",
#:   "MC out from side, straight over, still accelerating.",
#:   "The two-wheeler emerges laterally and crosses the lane of the test vehicle with continuous acceleration.",
#:   "A bicycle comes out very fast and goes over the street, always more fast.",
#:   "Crossing rider, speed ramps up during the crossing, no pause.",
#:   "She burst out between the hedges and flew over the road, pedalling harder with every turn.",
#:   "Dirt bike coming out from the side, he's gunning it straight over, don't try to beat him.",
#:   "kid on a bike flew out from the side n was still speeding up going across",
#:   "A young cyclist came hurtling from a gap and sped over the street, gathering pace all the while.",
#:   "The rider issued from the side, and so far from slowing, he went over the highway ever quicker.",
#:   "Suddenly one cycle came out from side and crossed with more and more speed.",
#:   "Out of nowhere like a cork from a bottle, and pedalling harder the further over he gets.",
#:   "Accelerating lateral dash of two-wheeler from roadside through own lane",
#:   "BMX KID FIRES ACROSS THE ROAD",
#:   "The moped whizzes out and over, gaining pace.",
#:   "Moped out of the alley, straight over, speed climbing all the way.",
#:   "Give me a bike bursting from the verge and accelerating to the far kerb.",
#:   "She flew across from the side, big sister, pedalling quicker and quicker and quicker!",
#:   "Desde el lado comes one moto, crosses, each metre more rapid.",
#:   "Dirt biker zips out sideways, opens it up, gone over before I blinked.",
#:   "Out from behind the hedge popped a lass on a racer, and she was picking up speed with every yard of road until she'd vanished down the opposite bridleway.",
#:   "Two-wheeler laterally released at trigger distance; traverses the roadway in one continuous motion under sustained positive acceleration; no speed reduction within the VUT's lane.",
#:   "By the time he reached the other pavement that lad on the scooter must have been doing thirty, though he'd only been rolling when he emerged beside us.",
#:   "V2, a motorcycle, launched from a field entrance on the right and gained velocity over the entire width of the highway, exiting on the left shoulder.",
#:   "Had the cyclist held back for even an instant we'd have met; as it was, he spurted from the side and rode ever harder to the far edge.",
#:   "A good rider would wait at that gap; this one's catapulted herself into the road and is winding it on and on as she goes over.",
#:   "I was in the passenger seat of the cab when a boy on an electric bike sprang out of a passage between the shops. He didn't look, he simply kept the throttle open, and you could hear the motor whine higher and higher as he crossed both lanes to the park gates opposite.",
#:   "The claimant's vehicle had almost reached the bridge. At this point a motorcyclist emerged from the footpath at its side and proceeded over the carriageway. Far from shutting off, he was speeding up continuously during the crossing, as the rising note of the exhaust on the recording confirms, until he was clear of the road.",
#:   "What I'm after is a bold rider at the roadside. They set off as the AV nears, charge out at right angles to us, and carry on building speed the whole way over, so anyone extrapolating their first half-second will get the arrival time badly wrong. No braking or foot down in the middle.",
#:   "We lorry drivers talk about the bike boys at that crossing place. Yesterday it was two wheels and a pizza box that came whizzing out from between parked vehicles on my nearside, and rather than think twice he leaned on the gas, more, more, more, until he was across and up the opposite ramp.",
#:   "It all took perhaps two seconds. From the shadow of the barn a bicycle shot forth; its rider, head low, legs blurring, was swifter at the ditch on this side than she'd been at the gate, swifter in the middle of the road than at the ditch, and swiftest of all as the far lane swallowed her.",
#:   "Pushbike out of the alley, quickening, quickening, over the road, gone.",
#:   "Scooter from the side, straight across you, revs never stop rising!",
#:   "dude on a dirtbike popped out sideways n kept accelerating all the way over",
#:   "Rolled off the pavement at a trot, was galloping by our bonnet and reached the opposite gateway at a speed I wouldn't attempt: such was the boy on the e-bike.",
#:   "The crosser's velocity over lateral position is a straight rising line, with its origin at the roadside and its maximum at the opposite edge.",
#:   "We'd reckoned on meeting him in the middle, but the motorcyclist from the footpath fed in more and more throttle and had left our lane well before us.",
#:   "Is it permitted that a bicycle comes out from beside, goes over the big street without one look and pedals each second stronger until the other side?",
#:   "Put a moped in a gateway at the edge and have it spurt out and over, its twistgrip being opened further with each metre until it's across.",
#:   "The engine note of the machine which sprang from the field track climbed without interruption, says a neighbour, until it had reached the track opposite.",
#:   "Behind the bus shelter there's a ramp that the kids use. It gives them a bit of a start. The one I nearly hit had his start from that, but what got him over was his legs; with every turn of them he was quicker, and by the far white line he was shifting so fast that my hand had only just reached the horn.",
#:   "V1's forward camera shows a wheel entering from the left between two parked trucks. The motorcycle to which it belongs covers the nearer lane in 0.9 seconds, the farther lane in 0.6. There is no indication of brake use by its rider, who left the roadway by a pasture gate on the right at the highest speed recorded.",
#:   "I always thought a person who finds a car bearing down on her would either stop or go back. My sister, on her first racing bicycle, found one on Heath Road, having just whizzed out of our drive. She simply trod harder. She trod so hard that she was over the road, through Mr Lamb's gate and in his roses.",
#:   "The trouble with motocross fellows is the noise comes first and you don't know where from. Then it was from the right. Then there was a thing with knobbly tyres going broadside through my headlights, and far from easing up it was hunched down and winding, and the noise left by the left and kept on climbing.",
#:   "Extrapolation fails here, that's why I like the case. At first sight the two-wheeler at the road's edge has a modest speed, and a constant-velocity model says it'll be in our lane at the wrong time. But it gains speed without let-up during the whole transit, so it's through the lane and out over the other kerb early.",
#:   "You mustn't wave him on, ever, and this is why. You think that bike's coming over at a nice steady pace and you'd let him. See his backside come off the saddle? He started at the drain, he passed us faster than he'd started, and he's hit the towpath on that side faster than he passed us.",
#:   "From the flat above the chemist one gets a fine view of folly. Tonight's was on a scooter. It darted out of Cooper's Passage; it had the whole of the High Street to think better of it; and instead it was given more and still more petrol till it vanished in Baker's Passage, which is right opposite, like a coin in a slot.",
#:   "For us old people everything is fast, but I had my new glasses. The young man with the pizzas, he was not on the road, and then he was on the road, from the side. He did not wait, he did not look. He was turning that handle and turning it, and the motor sang higher, and he had flown to the other side.",
#:   "It's a lovely piece of footage, sir, if one forgets what might have happened. The bicycle leaves the shelter of the hoarding. One, two, three, four strokes, each of them visibly stronger than the one before, and on the last the rider is past the lorry's far headlight, past the oncoming kerb, and gone down the steps to the river.",
#:   "Speed gun said 12 at our kerb. That was my colleague, who'd been pointing it at nothing in particular when the trail bike jumped out. It said 19 halfway. On the opposite pavement it was 27 and we couldn't see the plate for dust. The tanker driver who'd had to brake for him had a word with us about priorities.",
#:   "Most foxes trot over a road; hares don't. She was a hare. She burst from the gap in the wall with her coat flying, bent to the handlebars, and put on pace from the instant her tyres touched tarmac. The Bentley's brakes were still shrieking when she took the far bank at full tilt and was lost among the gorse.",
#:   "BMX from the alley: quick, quicker, quickest, opposite fence.",
#:   "moped popped out the side STILL gaining speed at the far verge",
#:   "Dirt bike from your flank, over, throttle opening all the way.",
#:   "The moan of it began low on our left, climbed the whole scale in front of our bumper, and was a shriek by the time the trail bike was in the trees on the right.",
#:   "Each lane he came to he took in less time than the one before, that pizza boy on his scooter, from our kerb clean over to the other.",
#:   "What I'd reckoned on was his speed at the pavement, but a girl who's pumping harder at every turn of the cranks is in front of you sooner than that.",
#:   "The two-wheeler is released at the roadside from rest; its speed shall increase monotonically over the full carriageway width; it shall leave by the opposite edge without any braking phase.",
#:   "There was no waiting to look and no thinking it over half-way: out of the gateway at the side with the grip twisted, grip twisted further in our lane, gone opposite.",
#:   "Let a courier on a pushbike be spat out from between two parked vans and be going harder with every metre until he's swallowed by the street across the way.",
#:   "The tyre print starts in a lady's flower bed, to my left. It's shallow there. It's deeper where it leaves the pavement, and all over my lane and the next there are little crumbs of rubber, more and more of them. In the opposite garden it has gone through a rose. From rose to rose a third of a second less than I'd needed for my brakes.",
#:   "I've played the clip at quarter speed for the kids' safety class. Here's an empty gap in a hedge, at the side. Here's a handlebar in it. You can see him sitting down in the hedge, standing on the pedals by the gutter, flattened over the bars by our bonnet. He's never so fast as on the last frame, where he's going off the other edge.",
#:   "Our instructor swears by sound. \"Which gear?\" he'll ask when a motorbike can be heard behind a wall. First, I said. It came out at us from the end of the wall. \"And now?\" Second; it was before our radiator. \"Now?\" Third, and it was off the road on the other side, so we could talk again, and I found out I'd stopped in a bus bay.",
#:   "When a dog's after you, you don't do sums. That's what the postwoman told us when she'd got her breath. She'd come bowling from the farm track on her red bike, right out before the milk lorry, with the dog behind; and the dog was why, instead of slackening, she kept on finding a bit more, till she was down the track over the road with her mailbag in the air.",
#:   "Lateral velocity of the crossing object: 3.0 at first sight, at the near edge; 5.5 at the centre of our lane; 8 at the far edge. Constant-velocity extrapolation therefore put it in front of us for nearly twice as long as it truly was, and the AEB came in hard for a motorcycle that had by then got itself to the other side.",
#:   "I'm from a village where every lane ends on the state road. So from my left I hear, vrrr. I look. A boy, two friends with him on one Hero Honda. They're not slow when they come out. In front of my jeep they are not slow at all, VRRRR, hair flying, and when they're in the sugarcane at right side I think they were flying only.",
#:   "She said that it was like a zip. Something at the left, by the bus shelter, had hold of the tab, and it pulled it over the road in front of our knees, slow teeth first and then the quick ones, zzzZIP. I saw it was her brother's moped only from what was lying in the hedge opposite, laughing, with its wheel going round.",
#:   "The dispute over speed is easily resolved; both witnesses are right. Mr Lowe, at the east kerb, where the cyclist came forth, speaks of a brisk jogging pace. Miss Hart, at the west kerb, where he went off the road, speaks of a man going like the wind. Between the two was V1, whose driver was midway between the two in her estimate as well, and in the ditch.",
#:   "A request with an eye on late braking: something on two wheels, hidden at the side until the ego's close. It isn't at its worst when it appears. It's got its worst in front of it, since its rider keeps on pouring it on, over our lane, over the others, right out at the far edge. Nothing in it of stopping, turning along the lane, or second thoughts.",
#:   "I'd the lorry down to ten before I understood there was no call for it. A thing had come out by the chapel, low and dark, whining. I'd stood on it, giving it time to get over. But it was making its own time. It wound itself up so over those thirty feet of road that I'd barely touched the pedal when I was braking for a puff of smoke.",
#:   "Have you ever seen a swallow leave a barn? The doors of the lock-up at the side stood ajar, and from between them issued a lad on a drop-handled bicycle, already quick, and with the whole of the high road to get quicker in. The constable on the corner had his hand half raised. It had got no higher when the boy was gone up the mews across the way.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "accelerate", "follow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 7.0
#: high = 12.0
#: unit = "m/s"
#: meaning = "how fast it wants to ride"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -2.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"

param OPT_ADV_SPEED = Range(7, 12)
param OPT_ADV_DISTANCE = Range(-2, 20)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
