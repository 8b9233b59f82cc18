#: description = "The cyclist ahead brakes hard and stops in the lane."
#: rephrasings = [
#:   "The bike in front slams on and stands there.",
#:   "The bicyclist ahead of Vehicle 1 braked abruptly and stopped in the travel lane.",
#:   "cyclist ahead, hard brake, full stop",
#:   "The bicyclist target decelerates at its limit to standstill in front of the VUT.",
#:   "The cyclist before us makes an emergency stop.",
#:   "A bike courier up front yanks the levers and halts dead.",
#:   "Both wheels locked, the lady on the city bike stops before our bumper.",
#:   "The kid on the BMX skids to a halt in our lane.",
#:   "The cyclist in front of me grabbed a fistful of brake and stopped dead.",
#:   "Bicyclist ahead of Unit 1 braked suddenly and came to a halt in the travel lane.",
#:   "Bike ahead, sharp brake, stands in lane.",
#:   "The bicyclist target travelling ahead decelerates strongly to rest and remains in the lane.",
#:   "The bicycle before me brakes strong and stands on the road.",
#:   "Leading bicycle v -> 0 with high decel, stays upright and stays in lane.",
#:   "She had been following the girl on the bike for a street or two when the girl clamped both levers and put her feet down.",
#:   "Pushbike in front's just slammed to a stop in the lane, don't run him over.",
#:   "the bike in front of me just stopped. like full stop. no warning",
#:   "A cyclist came to a sudden halt in front of a following car.",
#:   "The bicycle ahead ceased its progress in an instant and remained where it stood.",
#:   "Cycle uncle in front suddenly brake and stop in the lane, never signal also.",
#:   "Lycra boy in front yanks both levers and stands there, lucky I had my wits about me.",
#:   "Emergency stop of preceding cyclist with standstill in lane",
#:   "CYCLIST SLAMS TO A HALT IN FRONT OF ME",
#:   "The cyclist in front skids to rest.",
#:   "Girl cycling ahead hauls both brakes on, stops, blocks the way.",
#:   "Make the bike in front emergency-stop and remain in the lane.",
#:   "Commuter on a racer, dead ahead: squeal, standstill, no way by.",
#:   "Bike messenger we trailed clamped the discs and stood there.",
#:   "Cyclist stationary before the AV after violent braking, lane obstructed.",
#:   "The tandem in front of us went from twenty to nothing in a couple of metres and stood in the road like a gate.",
#:   "The boy rides his bicycle before my car, abruptly he pulls the two brakes and then he is standing and doesn't go away.",
#:   "When the trigger distance is reached, the preceding pedal cyclist brakes with the maximum possible force and stays at rest ahead of the ego.",
#:   "She's stopped, right there in front of you, see how little warning a cyclist gives when she grabs the levers like that?",
#:   "Because a pigeon flew up, the postman on his bike in front of our car jammed everything on and came to a stand.",
#:   "lad on a fixie ahead of us locks up the back wheel, bike stops, he stops, whole lane stops",
#:   "I had been pottering behind an elderly gentleman on his bicycle since the church. Without so much as a glance behind he squeezed the brakes for all they were worth and planted both shoes on the tarmac right ahead of me.",
#:   "The bicyclist preceded V1 in the same lane at about 12 mph. A loose dog ran out, the bicyclist braked to the limit of traction, and he was standing astride the frame in the lane when V1's operator reacted.",
#:   "From up in my cab you lose a pushbike under the windscreen if he's close. So when that delivery kid in front chucked out the anchors and just stood, I'd no more than a helmet to go by.",
#:   "The little family rode in single file, Mum last, and we rolled along after her. A shoe came off, so she braked so sharply that her basket emptied itself, and she remained there in the middle of our lane, laughing.",
#:   "Requirement for the bicycle scenario: the cyclist rides ahead of the robotaxi on the same line. He makes a panic braking and comes to complete stop. He doesn't move to side, he's not continuing, the lane is closed by him.",
#:   "Bike leading us: hard on the levers, stone dead, blocking.",
#:   "The schoolboy cycling ahead clamped up and stood there.",
#:   "She pedalled, she braked like mad, she was a statue in our lane.",
#:   "There was a postman on his bicycle in front of the van; he jammed the brakes to the bars, and there he stuck, in the lane.",
#:   "For this case let the lady on the e-bike whom the shuttle is following haul it down from twenty to nought and stay standing before us.",
#:   "He was pedalling ahead of me, this student, and suddenly both his brakes were shut, he stood with two feet on my lane, and didn't go away.",
#:   "Rubber stripe on the asphalt, eighty centimetres, rear wheel of the bike ahead; at its end the bike itself, upright, at rest, in our lane.",
#:   "Do you leave a gap to a pushbike in front? You'd better, for this one has gone from full tilt to standstill, and is just stood there.",
#:   "Preceding cyclist decelerated at 5 m/s² to zero within the lane; the ego was given no lateral escape, and target remained until the end.",
#:   "My first thought was that his chain had come off. He'd been a good ten lengths ahead of me, riding along my lane with a baguette on the carrier, and then the baguette went forward over his shoulder, so violently had he pulled up. He didn't get off. He stood astride the bike, staring at it.",
#:   "Funny thing with recumbents is the flag. I never saw the rider, only a flag in front of my lorry going along at fifteen mile an hour, and then the flag whips forward and it's not going along at all. It's still there when I've got forty ton stopped behind it. It's there when I climb down.",
#:   "The AV had been following a rental bike for two minutes and had settled into its rhythm. A dog barked. On the recording you see the tourist's shoulders jerk, both her hands close, and the back wheel lift; from there on the bike has zero velocity, she's rooted in the middle of the lane, and the AV is a metre off.",
#:   "I'm told I should have expected it, with a child. But she'd been riding so nicely ahead of me, her little legs going round. The legs stopped, the coaster brake bit, and there she was planted in the road in front of my car, because a snail was on it, and she wasn't going to move for anyone till it had gone.",
#:   "V1 was following a bicyclist at about 14 mph. The bicyclist applied both brakes forcefully and came to a stop in the lane, where he remained, looking at his telephone, at the time V1 reached him. He had neither left his line of travel nor given a signal. V1's front bumper contacted the rear wheel.",
#:   "Well, if it isn't our friend with the food bag. We've been behind him since the station, and he's been flying. Whoops, there go his brakes! Right down to nothing in about his own length. Count with me: he's not moving, he's still not moving. So neither are we; there's no room past, and he's checking his order.",
#:   "A racing cyclist is a vehicle with a very bad rear light, namely none. This one in front of me was doing thirty-five on the flat. If I hadn't heard the brake blocks scream I would have ridden him down, because the next instant he was there on the spot, one shoe unclipped, in the lane, having lost a bottle.",
#:   "It must've been love. The young fellow on the tandem, alone, with the back seat empty, had been plodding on before our taxi. He'd seen someone. So hard did he pull on the brake that the tandem groaned, and there was the end of plodding: he stood straight up over the frame, in our lane, and simply gazed.",
#:   "As the accused's dash camera shows, the bicycle before him wasn't swerving, wasn't turning and didn't fall. What it did was to stop: from a brisk speed to none, so sharply that its basket was emptied over the front wheel. And stopped it remained, in his lane, with the complainant upon it. The rest we know.",
#:   "In Delhi I've been driving thirty years, cycle in front is daily thing. But this milkman with four cans, he was going good speed, and one second later he had caught both brakes full. Cans came forward, milk came on the road. He stood there only, in lane middle, looking at his milk, and I stood behind him.",
#:   "New ticket, please: cyclist as lead vehicle, ego in steady following. On trigger he does an emergency stop. No dismount, no fall, no sideways shift, no second start; he ends up as an obstacle with one foot on the floor exactly in our lane. I'm curious how close our margin gets with wet tyres.",
#:   "Bike in front: levers to the bars, then a statue.",
#:   "Cyclist ahead of us came to nought, sharply, for good.",
#:   "She clamped up and stood there, mid-lane, on her bicycle.",
#:   "The reflector that had been bobbing along before my bonnet stopped bobbing, swelled to the size of a plate, and hung there at knee height till I'd come to rest.",
#:   "Once the shuttle has been following the pushbike for a while, lock its wheels, have it upright and still within three metres, and don't move it again.",
#:   "He was riding before me with a ladder; the ladder made a swing forward, the brakes cried, and then the ladder and he stayed on that place in my lane.",
#:   "Ahead of the van a boy on a bike ran out of road, in his own mind at least, since he threw out both anchors and planted himself in the lane.",
#:   "Who brakes a bicycle as if a cliff had opened, and then stays there astride of it, in front of a bus, to look for an earring?",
#:   "No debris, no fall, no steering: the rear wheel print simply gets darker for one metre and ends, in our lane, under the shoe of a standing courier.",
#:   "The last word he'd sung was \"glory\". He was always singing, that curate, pedalling ahead of one's car down the hill. There was a shriek of rim on rubber in place of the next word. When I'd put my own car on its nose I had a view of a bicycle clip and a trouser leg, straight as a post, in the middle of my lane, not going anywhere.",
#:   "A cargo bike has good brakes now, hydraulic. I didn't know. I'm behind one with three kids in the box and thinking, she'll need half the street. She needed about a metre. The kids went \"oof\" in chorus, and I'd to go \"oof\" as well. And it's not that she got off or pulled in; there she stood, one leg each side, wiping a nose.",
#:   "For two minutes the closing speed had been nil. The AV had got used to that courier: eighteen kilometres an hour, seven metres, nothing to do. So when the seven metres began to go at five metres per second it had first to believe it. Two metres later it did. He'd got a buckle caught in his chain, he was on the spot, in lane, looking down between his knees.",
#:   "We old ones used to stick out an arm and flap it if we were to stop. The young lady did nothing of the kind. Her plait, which had been hanging down her back while I followed her, flew up over her head, and that was the only signal I received. There she was, foot down, in my road, and there she remained, answering her telephone.",
#:   "Coming back from the depot I get a club rider in front of me, on the drops, shifting. He sees the pothole late. I don't see the pothole at all, I see him sit up with both hands full of brake and the back tyre hopping. Rest of the morning I'm looking at Gino's Cycles on a pair of shorts. He's stood over it, swearing, dead centre.",
#:   "It's her basket I drove over, not her. On her ride along my lane, before me, the basket was behind the handlebar; when she'd squeezed everything and was standing, it lay in front of the wheel. I thank my tyres. She didn't go to the side, she stayed with two feet on the floor and both hands in the air, crying for her tomatoes.",
#:   "The pupil said \"but bikes can't stop fast\". Oh yes? That lad in front of us had been nipping along at fifteen, with his chips. Look at him now: not nipping, not even rolling, both trainers down and a black stripe behind him. He's in your lane and he'll be there as long as it takes to pick up a chip. Lesson over.",
#:   "The bicyclist and V1 had been in line for several blocks, the bicyclist leading. According to her statement a squirrel \"froze\". So did she. The forensic download from her e-bike gives a drop from 14 mph to 0 in 1.3 seconds, without any change of heading. It logs no movement in the subsequent 20 seconds, the fifth of which contains the impact by V1.",
#:   "Mr Pym's umbrella, furled, was strapped along the top tube of the bicycle behind which the taxi was crawling. At the corner of the Crescent the umbrella slid out forward like a lance, which will tell you how Mr Pym had braked. It lay in the road; Mr Pym stood in the road; the taxi, by the grace of God, stood an inch from Mr Pym, and there was no getting round him.",
#:   "In the requirement it says \"sudden obstacle of low width\". We take a cyclist. He is in front of the ego in the same lane, and the ego is following him already. On the trigger he has no speed any more after one second and a half. He stands in the lane centre, he is not lying, he's not going to the kerb, he's just there like a pole.",
#:   "commuting on the shuttle, lady on a dutch bike ahead of us, super chill. then SCREECH and shes just... there. standing. one clog on the floor, bang in the lane. shuttle nearly parked in her flower basket. she was letting a hedgehog go by. netherlands moment",
#: ]
#: adversaries = ["bicycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "stop", "block"]
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.7
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_BRAKE = Range(0.7, 1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
