#: description = "The oncoming rider turns left across the ego's lane."
#: rephrasings = [
#:   "A cyclist coming the other way hangs a left right in front of us.",
#:   "The bicyclist approaching from the opposite direction turned left across the path of Vehicle 1.",
#:   "oncoming bike turns left across us",
#:   "The oncoming two-wheeler turns left across the VUT's path.",
#:   "The cyclist from front goes left over our lane.",
#:   "A moped meeting us nips over to the petrol station on our side.",
#:   "The biker we face darts left into a driveway under our nose.",
#:   "A paper girl heading our way swings over to the houses on our right.",
#:   "A cyclist coming towards me just swung left over my side of the road.",
#:   "The opposing motorcyclist turned left across Unit 1's lane of travel.",
#:   "Bike oncoming, L turn over our lane.",
#:   "The opposing two-wheeler turns left across the lane of the test vehicle.",
#:   "The bicycle from the front turns left and passes over my lane.",
#:   "Opp. rider crosses our lane in a left turn and leaves the road, normal speed.",
#:   "The boy on the moped was coming to meet them when he leaned over and crossed to their side to take the turning.",
#:   "Biker facing you wants to go left, he's not waiting, he's going over in front of you.",
#:   "cyclist coming towards me went left right thru my lane",
#:   "A motorcyclist approaching from ahead turned left and so came athwart the car.",
#:   "From the opposite direction he bore left, and in so doing passed before my client's bonnet.",
#:   "Opposite bike took left turn over my lane without waiting for me.",
#:   "Pedal-pusher coming the other way decides he's off left, and I'm the one who has to stop.",
#:   "Left turn of opposing two-wheeler through own lane",
#:   "ONCOMING BIKE TURNS LEFT, DOESN'T WAIT",
#:   "The oncoming moped peels left over our lane.",
#:   "Scooter coming our way hooks left, straight over our lane.",
#:   "Facing pushbike: left turn, traverses ego's lane, gone off the side.",
#:   "He comes opposite with his cycle and cuts my lane for going left.",
#:   "An approaching girl on a bike bears left through our path.",
#:   "Have an oncoming motorcyclist turn left before the ego, crossing its lane.",
#:   "The postman on his bicycle was coming down the road towards me; he stuck out his left arm and without waiting rode over my lane to the cottages.",
#:   "Two-wheeled traffic from ahead made a left turn that took it clean through the strip of road in which the robotaxi was travelling.",
#:   "Motorbikes facing you that want the side road on your right have to go over your lane, and that one's leaning in to do so now.",
#:   "A moped courier heading towards V1 executed a left turn at the driveway of the restaurant and so passed at right angles over V1's lane.",
#:   "Why he couldn't wait I don't know, but the rider who was meeting us went left, right over our bit of tarmac, to the allotments.",
#:   "The cyclist target, initially moving against the VUT's direction, turns left by ninety degrees and continues straight on across the VUT's lane until it has left it.",
#:   "There's a coffee place on my side of the road and that's where she was bound. She had been pedalling along opposite, towards my car, with a basket on the front. She turned left, in a nice round bend, over my lane and up onto the forecourt.",
#:   "Unit 2 was an electric bicycle travelling in the opposite direction to Unit 1. Its rider turned left towards a private entrance, crossing the lane of Unit 1 at a distance of less than two seconds' travel, and continued into the entrance without having given way.",
#:   "As I passed the mill a motorcyclist was coming up from the village. I thought that he and I would simply pass each other. But he banked over to his left, crossed the whole breadth of the lane I had before me, and the yard gate swallowed him.",
#:   "For the urban turn-across series use the oncoming rider. At trigger distance it describes an arc to its left of small radius and then carries on straight, so that its path crosses the lane of the vehicle under test; it does not stop and it doesn't return.",
#:   "Mate, you'd think a bin wagon was hard to overlook. Bloke on a Vespa coming at me, sees me all right, gives me a nod even, and then he peels off to his left, across my lane, two yards off my bumper, and in at the chip shop.",
#:   "Moped from ahead peels leftward over our lane and away.",
#:   "bike coming at us turns left over our lane, keeps going",
#:   "Opposing cyclist bends left, passes athwart us, leaves the road.",
#:   "The lady on the tricycle who was riding to meet us bore away to her left over our half of the road and in at the churchyard.",
#:   "Facing motorbike leaned into a left-hander where there's only a farm track on our side, so of course he went through our lane to get there.",
#:   "The opposing rider follows a left-hand arc of fixed radius, transits the ego's lane at undiminished speed and departs on the ego's right.",
#:   "He's coming towards you and he wants the chip shop on our side, so he'll take a left over your lane, and off he pops.",
#:   "That cycle fellow was coming from front side, left he turned and passed in front of my bonnet only, to reach his house gate on my side.",
#:   "Put a motorcyclist in the opposite lane, and when the AV is near, have him turn to his left, ride over the AV's lane and carry on.",
#:   "For a while he was just somebody on a bicycle coming the other way with a ladder on his shoulder. I noticed the ladder begin to swing, which is what ladders do when the man turns, and he was turning left. All of it, man, bike and nine feet of ladder, went by before my bumper and up the drive on my right.",
#:   "The defendant rode a moped in the direction contrary to that of my client. He desired to reach premises situated on my client's side. To that end he turned to his left, rode through my client's lane from one border to the other without giving precedence, and was on the forecourt when she had stopped.",
#:   "You learn to watch the wheel and not the face. Her face was looking at me all right as she rode towards my wagon, and I took that to mean she'd wait. But the wheel was going over, and round to her left she came, over the strip I was about to use, and I saw her basket vanish through the park gates.",
#:   "In frame 212 there is a motorbike ahead, in the facing lane, upright. In frame 240 it is leaning, and we see its left side no longer but its right. In frame 275 it passes through the middle of our lane from left to right, and in 310 only the dust of the yard entrance is left.",
#:   "The post arrives at eleven and so does the trouble. Our postwoman cycles down while everybody else drives up, and the letter boxes are on the driving-up side. So she sweeps round to her left wherever she pleases, over the lane in front of whoever's coming, today a driverless taxi, and pedals straight on to somebody's porch.",
#:   "N-2, a bicyclist traveling southbound, met V1, which was traveling northbound. N-2 turned left ahead of V1 in order to enter the trailhead on the east side. N-2 traversed the full width of the northbound lane without slowing and had left the roadway when V1 came to a stop.",
#:   "I'm on a scooter myself, so no prejudice here, but mate, come on. You're coming the other way, you've a car bearing down in the lane you've got to go over. You can wait four seconds for it, or you can just lay the thing into a left, scoot over its nose and vanish up the alley, and guess which.",
#:   "The dog saw her before I did, being fond of cyclists. She was coming down as we were going up, on the far side, with a scarf blowing. The scarf blew the other way, that's how I knew she was on the bend to her left; she passed from there to here straight over our lane, and the wood closed behind her.",
#:   "Dispatch, no injuries, just a scare. The motorcycle was inbound, the delivery van outbound on the same road. The rider hung a left for the car wash, and that took him clean over the outbound lane in front of the van; he's in the car wash now, the van's stopped with its load on the floor.",
#:   "As foreigner I didn't understand why he holds the arm out. He came in front of us on a bicycle, the arm shows to his left. And yes, he goes to his left, through our lane, as if we are not existing, and on my right side he disappears in a small street.",
#:   "He'd always come home that way, the old man, and he didn't see why cars should alter it. He freewheeled down the hill towards them, let the bicycle fall round to the left of its own accord where his cottage stood on their side of the road, and rolled over their lane, under their noses, in at the open gate.",
#:   "Postie meeting us goes left, over our lane, in at a gate.",
#:   "Facing motorbike banks left through our strip and is off.",
#:   "From ahead, left across our bows, away: a girl cycling.",
#:   "The satchel coming towards me on the other side leaned left, went by from left to right before my grille, and was up the school drive.",
#:   "Oncoming moped at trigger distance: short-radius arc to its left, then straight on through the ego's lane at the same speed until clear.",
#:   "delivery ebike is coming at me on his side, and goes left to the kebab place that's on MY side, straight thru my lane, didn't even look up",
#:   "His house is on the side of my driving, so from the front he came on his bicycle, to his left he bent, through my lane he went home.",
#:   "We braked for a left-turner on two wheels: it had been facing us, and the way to the ferry, which is on our side, led right over our lane.",
#:   "You braked because the scooter facing you couldn't wait; it swung left, your lane was in its way, and it's in the garden centre by now.",
#:   "The car park attendant had his barrier up. He'd seen that the biker coming down the road was bent on getting in, and the car park's on the coming-up side, and so were we. The bike lay over to its left, there was a headlight in my headlight, a wheel, an exhaust, all going from my left hand to my right; and then the barrier going down.",
#:   "Draw a T and stand me on the upright. The cyclist comes down the upright to meet me. At the crossbar he goes off along it, on his left, my right, and I suppose you see what's in between him and that; it's me, or the lane I'm in. He rode over it without a break in his whistling and I stood on the middle pedal.",
#:   "By the ego's camera: rider, frontal view, adjacent lane. Rider, three-quarter view, leaning. Rider, side view, dead ahead at 9 m, front wheel to the right of the picture; that's the worst of it. Rider, rear view, small, on the drive at the right-hand side; and in none of the four has the rider's speed changed, whereas ours is zero.",
#:   "My old man sold papers from a bike and he had a rule, never cross traffic, go round. The lass who brings them now was coming along opposite our van, she wanted number nine, number nine is our side. Round she came to her left, and number nine's gate was banging, and I'd an inch of her rear reflector left to look at and both feet down.",
#:   "If she'd stayed on her side we'd have passed and never known one another. However, there is a ford on ours where people water their dogs, and a dog was running by her bicycle. Left it pulled her, dog first, lead second, lady third; all three were over our bit of road and down to the ford. We had stopped, and the dog shook itself over our number plate.",
#:   "It was decided on one point. The rider of the moped had the oncoming van before her and she wished to go to her left. In those circumstances one waits. She instead described what the map shows as a quarter of a circle, continued through the van's lane at right angles to it, and reached the forecourt; the van, braking for her, spilled its eggs.",
#:   "On the night bus you see it from above. There's a bike lamp coming the other way, it's well over, nothing to do with us. It goes round like a lighthouse, to its left, and I'm looking at spokes with beads on them, right beneath me, going from the one side to the other. \"Pizza,\" says the driver, and there's the pizzeria on our side, and in he goes.",
#:   "Every noon there's a bell, and a hundred boys on bicycles ride out of the factory, and they meet the lorries. Ninety-nine keep on. One has his mother's noodle shop on the lorry side. He makes a curve to left, he doesn't look, my bumper can smell his shirt, he goes through my lane and stops not before the noodles, and I've again two years less.",
#:   "For the robotaxi it was the easiest object of the day until it was the hardest. A motorcyclist, facing it, in his own lane, indicator blinking on his left. He'd yield, since that's the law. He kept up his thirty all the way round, so that his path and our lane met at a right angle eight metres from our bumper, and the drive-through on our right took him in.",
#:   "There's fresh gravel off the mouth of Hodge's track. I'd been looking right at him, a big lad on a dirt bike coming up as I went down. Then it's his boot and his knee that I'm looking at, he's tipped it over to the left, he's across my radiator; and a handful of gravel comes up from the track on my side.",
#:   "He came towards them with the sun at his back, and the sun had made a giant of his shadow. It was the shadow that turned first. It swung off to his left, it fell over the stretch of lane that they'd be using, and the small man on the bicycle followed after, without a pause, as if to pick it up, into the orchard on their side.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-left", "cross"]
#: position = "oncoming"
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.5
#: high = 6.0
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 11.0
#: high = 22.0
#: unit = "m"
#: meaning = "distance to the ego at which it turns"
#: [[parameters]]
#: name = "OPT_TURN_RADIUS"
#: low = 2.5
#: high = 4.0
#: unit = "m"
#: meaning = "the radius of its turn"

param OPT_ADV_SPEED = Range(3.5, 6)
param OPT_ADV_DISTANCE = Range(11, 22)
param OPT_TURN_RADIUS = Range(2.5, 4)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do TurnOff(1.5, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
