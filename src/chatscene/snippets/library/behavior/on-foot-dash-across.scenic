#: description = "The oncoming pedestrian breaks into a sprint and dashes straight across the ego's lane."
#: rephrasings = [
#:   "A walker coming our way takes off like a shot and streaks over in front of us.",
#:   "A pedestrian walking against traffic suddenly ran across the roadway ahead of Vehicle 1.",
#:   "oncoming ped, sudden sprint across lane",
#:   "The target approaches at walking pace and then crosses at running speed.",
#:   "The boy comes slowly to us, then very fast he runs over the lane.",
#:   "Having spied a friend over the road, somebody who meets us tears across.",
#:   "The stroller ahead, facing us, hurtles over to the opposite pavement.",
#:   "A tourist we are about to pass rushes to the other side for a bus.",
#:   "A jogger coming towards me suddenly put on a spurt and legged it right over my lane.",
#:   "The pedestrian, walking toward Unit 1, suddenly sprinted laterally across its lane.",
#:   "Ped facing ego, walks up, then bolts straight over lane.",
#:   "The pedestrian target approaches the VUT head-on and then runs perpendicularly across its lane.",
#:   "A man walks in my direction against me, suddenly he runs fast over my lane.",
#:   "Oncoming ped on foot goes from walk to sprint and cuts our lane at a right angle.",
#:   "He'd been coming along to meet her at a stroll; all at once he took to his heels and shot across her front.",
#:   "Fellow walking up towards you, careful, he's broken into a run, he's going straight over in front!",
#:   "guy was walking towards us all chill then just BOOKED it across our lane",
#:   "A walker heading toward the car abruptly took to his heels across its lane.",
#:   "He was facing my client as he came, and then he ran, without warning, to the far side?",
#:   "One lady walking opposite to me suddenly started running and crossed in front.",
#:   "Comes strolling up to meet me, then someone fires the starting pistol and he's over my lane.",
#:   "Sudden sprint across ego lane by pedestrian approaching head-on.",
#:   "PEDESTRIAN WALKS TOWARD CAR THEN SUDDENLY SPRINTS ACROSS",
#:   "The approaching walker exploded into a run over our lane.",
#:   "Jogger facing us flips to full sprint, straight over our lane.",
#:   "Lady strolling to meet the van suddenly pelts over in front of it.",
#:   "Make a walker who's coming at us bolt directly through our lane.",
#:   "Man on foot, coming your way, off like a hare across you",
#:   "The boy walks against us, plötzlich he runs like hell over the lane.",
#:   "An old man had been ambling up the road towards me when, at the sight of his bus, he took to running and went right over my lane.",
#:   "V1's operator observed a pedestrian approaching on foot, face on; without warning that pedestrian changed to a run and traversed V1's lane at a right angle.",
#:   "She'd looked me in the eye through the windscreen, this girl walking my way, and then she just turned on the afterburners and raced across before my bonnet.",
#:   "The VRU target initially moves opposite to the travel direction of the VUT at 5 km/h, then turns by 90 degrees and clears its lane at 15 km/h.",
#:   "Who was to know that the lad dawdling up the verge to meet us would, within a few yards of our bumper, hare off to the other side?",
#:   "That fellow there, coming along facing you, keep an eye on him. What did I say? He's legging it, straight over in front, cover your brake.",
#:   "I was cycling home behind one of those robot cars. There was a woman in running gear trotting along the edge of the road towards it, quite relaxed, and for some reason she wheeled round sideways and ripped across the lane as though the pavement had caught fire behind her.",
#:   "The accused came on foot along the roadside in a direction opposed to that of the police vehicle. On recognising it, he did not turn on his heel; he took off at the run, directly over the lane in front of it, and vanished between the houses on the other side.",
#:   "Please give me someone walking towards the ego at an ordinary pace, the sort of person no one would think twice about. When we are near, that person must start sprinting and go square across our lane in one burst, without stopping in it or hesitating.",
#:   "I'm eighty-four and I still drive to the shops. A postman was coming up the road in my direction, sorting his letters as he walked. Then a dog barked somewhere, and off he shot like a man half his age, right over my side of the road, letters and all.",
#:   "Namaste, I share my near miss. One college fellow was walking from opposite side facing my car, talking in phone. When I came close only, he got some urgency and rushed at full speed through my lane to the other end, and not even once he checked for me.",
#:   "Man walking at us turns hare: square across, gone.",
#:   "Lady facing you, strolling. Correction: running, through your lane, far side.",
#:   "he was coming towards us then full usain bolt across",
#:   "One moment we could see the face of the postman on his way up the road to us, the next it was his profile, at full stretch, crossing our bows.",
#:   "Until about twelve metres off, the approaching pedestrian showed a walking gait and a frontal aspect; then he spun to the side and covered our lane in five strides.",
#:   "Let a woman with a pram-free afternoon dawdle in our direction along the verge and then, near to us, fly at right angles over the lane.",
#:   "Had she kept walking towards my bus as before we would simply have passed each other, but her toddler was over the road, and she tore through my lane.",
#:   "Vehicle 1 met a male subject on foot, northbound to its southbound, who for unknown reasons burst into a run and went directly over the lane to the opposite curb.",
#:   "Comes up the road against me one monk, so peacefully, and then a dog, and I never saw a monk so quick over from one side to the other.",
#:   "He'd nodded at me. That's what I can't get over. We were going to pass, he on foot on the edge, me at the wheel, and he nodded as one does. Whatever it was he saw behind me, it turned him into an athlete, and there was a brown coat streaming from right to left before my bonnet.",
#:   "It was on the school run. A big boy was walking towards our car, kicking a can. Mummy said watch him. He kicked it a bit hard and somebody shouted his name, and he went like a racehorse, straight over in front of us, not the slanty way, and into the sweet shop, and the can stayed behind.",
#:   "We've had walkers who approach and we've had walkers who dart, but never both in one. So what I should like is a jogger or the like who comes up the roadside with his face to the robotaxi, calm as you please, and at short range makes a ninety-degree turn and a flat-out burst right over its lane.",
#:   "I watched through the hairdresser's window with my head full of curlers. A traffic warden was making her way up the street, and the blue car was making its way down. They were nearly level. All at once she clapped a hand to her hat, and I've never seen a warden run like it, straight over, kerb to kerb, before his number plate.",
#:   "\"He was looking right at you, you say, and advancing along the hard shoulder?\" \"Yes, at a walk.\" \"And what was it that you saw next?\" \"His back foot. He'd pushed off with it. Then he was in my lane and going at it like a hundred-metre man, and he was out of it again before my horn had finished.\"",
#:   "Cyclists get shouted at for less. This fella's on foot, heading up the lane towards me and the van that's overtaken me. There's loads of room. He looks at his phone, goes rigid, wheels to his left and he's off, across the van's front with his knees up round his ears, and over a five-bar gate on the far side.",
#:   "The scene lasts four seconds, but I've watched it a hundred times. Second one: a figure under an umbrella strolling in our direction. Second two: a bit nearer. Second three: the umbrella has been thrown away. Second four: empty lane, wet footprints straight over it, and at the far kerb somebody bent double, getting their breath, at a tram door.",
#:   "For thirty yards or so she had come on to meet them, a slight grey woman of no particular haste. The general, who was driving, had already dismissed her from his mind. Then a child cried out beyond the road, and there was nothing slight or grey about the thing that went by under his headlamps, straight as an arrow to the sound.",
#:   "So the perception stack does well with people who come at us, and it classifies them as \"no conflict\", since they keep to the edge. That label's then held for too long. In this clip the person breaks from the walk to nearly six metres per second, perpendicular to our lane, with 1.2 seconds to go.",
#:   "If you can see their eyes, they can see you, I tell my learners, and mostly that's good enough. It wasn't on Friday. A builder walking our way had seen us all right. He'd also seen the last bacon roll go in the window opposite, and he went for it, bang over our lane with his hard hat in his hand.",
#:   "To be exact about the directions. I drove north. The gentleman walked south, on the edge of my carriageway, thus towards me. He ran east. It is the running east of which I complain, for he took it up at a moment's notice, with great velocity, and it led him through precisely the three metres which I was about to use.",
#:   "Walker facing us, then sideways and sprinting, kerb to kerb.",
#:   "he was strolling TOWARDS me then boom 90 degrees and gone over",
#:   "Ped inbound on foot, your verge; correction, bolting square over your lane.",
#:   "The face under the umbrella, which had been getting steadily nearer, was replaced without warning by a shoulder, two pumping knees and, on the far side, a closed umbrella.",
#:   "Until the last fifteen metres the postwoman had been doing what we were doing in the opposite direction; from there on she was doing a hundred metres final at right angles to it.",
#:   "You'd have taken her for just another rambler coming up to meet you, had she not spun off her line a few steps away and hared over under your bumper.",
#:   "The dummy advances head-on relative to the VUT at walking pace along the roadside, is rotated through ninety degrees at the trigger and leaves over the lane at maximum belt speed.",
#:   "We braked for the back of a man whose front we'd been looking at a moment ago, because his walk up the road to us had turned into a flight straight over it.",
#:   "Let the jogger come on towards the ego, gently; let her see a friend on the other pavement; then I want her over there in no time, by the direct way.",
#:   "I know his tie. It was green with ducks, since he'd been walking at me for a good half minute and I'd nothing else to look at. Then I hadn't the tie any more, I had the soles of his shoes going like a mill, off to one side, right before the bonnet. I stopped with the ducks, so to speak, on the far kerb.",
#:   "Look at the track history. Heading of the pedestrian: opposite to ours, constant, for eleven seconds. Speed: 1.3, constant. In the twelfth second the heading jumps by a right angle, no curve, and the speed quadruples. By the fourteenth it's left our lane by the other edge. The predictor had given that a probability of zero, and I can see why.",
#:   "The goat was across the road and it was eating her washing. How was I to know? I only saw an old woman, coming along the verge with a basket, our way, at her ease; I even lifted my hand to her. Up went the basket. She'd crossed in front of my lorry before it came down, at a speed I'd not have believed, and straight as a ruler.",
#:   "Officer, it wasn't that I didn't see the lad. I'd watched him from the garage on. He was walking against the traffic, like you're meant to, facing me, earphones. The bell went in the school, on the other side, and there was a sort of explosion of him. He wasn't facing me then. He was broadside, flat out, and over, and I'd all four wheels locked.",
#:   "From where I was on my bicycle, thirty yards back, you had the robot car going up the hill and a nun coming down it, on foot, quite sedately, and they'd have passed like ships. What made it stand on its nose was the nun. She gathered her habit, swung to face the convent opposite and covered the road in about five leaps, all within a car's length of it.",
#:   "Do not confuse this with the walker who merely turns off over the road. Ours does come down the roadside in the direction of the subject vehicle, yes, and does make the sharp corner; but with the corner comes a change of gear. What crosses the lane is not someone on a walk. It's someone running for his life, and his line over it is square.",
#:   "My student said \"friendly\", as I'd taught her to say when people make eye contact. Friendly was about ten yards off then, on her right, pottering up the road at us with a dog lead. There was no dog on the lead. The dog was on the other side. You never saw Friendly go so fast, at a dead right angle, and I'd never used the dual pedal so hard.",
#:   "Aunty's saree was yellow, so nobody can say it was not visible. She is coming from front side, slowly slowly, chewing something. I'm going my way. In the last moment she remembers the milk is on the gas! One cut she takes, and such a speed, full road to her gate opposite, and my bus with forty people is on its nose.",
#:   "There'd been a sort of understanding between them for the length of the wall, the way there is between people who approach each other on an empty road. He could see that she was tired. He could see she'd been crying. And then he couldn't see her, for she had wheeled about and flung herself over the tarmac, an arm's length from his lamps, as if the far hedge were on fire.",
#:   "The chat's asking why I slammed it in game. See the NPC in the hoodie? He's walking down the side at us, standard. Every other one keeps walking and goes by the window. This one snaps to the side at like ten metres, plays the run animation, and he's through the lane and up on the other pavement before you've found the S key.",
#:   "Claimant says that the runner \"came out of nowhere\". With respect, she came out of somewhere: she came out of the oncoming direction, along the edge, in plain view, and walking. What came from nowhere was the burst. It took her at a right angle over claimant's lane, and claimant's skid marks, nine metres, stop just where her heel marks cross them.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior", "advFacing"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "cross", "fast"]
#: blocker = false
#: position = "oncoming"
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.9
#: high = 1.8
#: unit = "m/s"
#: meaning = "how fast it walks at first"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 4.0
#: high = 6.5
#: unit = "m/s"
#: meaning = "how fast it sprints"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 5.0
#: high = 17.0
#: unit = "m"
#: meaning = "distance to the ego at which it sprints across"

param OPT_ADV_SPEED = Range(0.9, 1.8)
param OPT_ADV_SPRINT = Range(4, 6.5)
param OPT_ADV_DISTANCE = Range(5, 17)

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 1 seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE + 1.5 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPRINT, 1.57)
