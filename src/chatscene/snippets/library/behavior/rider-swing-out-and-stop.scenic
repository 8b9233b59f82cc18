#: description = "The rider ahead swings out to the left and stops there."
#: rephrasings = [
#:   "The cyclist in front moves out and then just stops.",
#:   "The bicyclist swerved left within the lane and came to a stop ahead of Vehicle 1.",
#:   "bike ahead swings out left, halts",
#:   "The target ahead shifts laterally and then comes to rest.",
#:   "The cyclist before us goes to the left and stays standing.",
#:   "To wait for a gap to turn, the biker ahead edges out and puts a foot down.",
#:   "The moped we follow pulls over toward the centre line and halts.",
#:   "A courier up front wanders out and props himself in the road to read his phone.",
#:   "the cyclist in front of me veered out left and just planted himself there",
#:   "The bicyclist ahead moved abruptly to the left and stopped, obstructing the lane.",
#:   "MC ahead: wide L, then halts there, way barred.",
#:   "The bicyclist ahead of the VUT deviates to the left and comes to standstill at that lateral position.",
#:   "The bike in front goes out to the left and then stays there standing, I can not pass.",
#:   "Lead two-wheeler: lateral jump to the left, then v=0 so the passing side is shut.",
#:   "The biker before them had leaned out to the left, and there he pulled up and would not budge.",
#:   "She's come out wide to her left, that cyclist ahead, and she's stopped right where you'd want to overtake.",
#:   "cyclist in front swung out to the left n just stopped there",
#:   "A motorcyclist ahead veered to his left hand and pulled up, leaving no way by",
#:   "You moved out leftward without warning and then came to a stand in front of the claimant?",
#:   "The cycle in front suddenly swing left and stop there, how to pass",
#:   "Bike ahead of me slings it to the left and plants it there, like he's dropped his wallet",
#:   "Leftward swing-out of leading two-wheeler with blocking standstill",
#:   "Biker ahead swings left and PARKS IT",
#:   "The cyclist ahead lunged left and anchored himself.",
#:   "Moped in front sheers off to the left and halts right there.",
#:   "Let the leading cyclist dart leftwards, then stop and stay.",
#:   "Biker ahead jinks left, pulls up, boots on the ground.",
#:   "Lady on a bike before us veers leftward and comes to rest.",
#:   "Preceding scooter: lateral step left, zero speed, stays in that spot.",
#:   "The courier we were following sheered away toward the centre line on his left and stood his bicycle there like a bollard.",
#:   "In front of me the motorcyclist makes a bow to the left and there he is stopping, so the place for passing is gone.",
#:   "With the two-wheeler in front, first a leftward swing of about a metre is produced, and then a halt at that offset.",
#:   "You were setting yourself up to pass that bicycle, weren't you, and look, it's kicked out left and come to a dead stand.",
#:   "What on earth made the lad on the scooter ahead lurch out to his left hand and simply stand about there?",
#:   "She's stationary by the middle of the road now, the cyclist who a second ago flicked left in front of the shuttle.",
#:   "A motorbike had been leading us along at a modest pace. With a twitch of the bars it moved across to the left, its brake lamp came on, and it stayed there, engine ticking over, while the rider searched his jacket.",
#:   "V1 was following a bicyclist at approximately 10 mph. The bicyclist steered sharply to the left, then brought the bicycle to rest at the left portion of the lane, stating afterwards that he had seen a nail in the road.",
#:   "My claim is as follows. The moped before me was keeping right and I intended to go by it; instead it shot out leftwards and stopped on the spot, without turning off anywhere, so I had nowhere to put the car.",
#:   "Please build me this: one cyclist ahead of the AV, steady at first. Next he goes wide, to the left, quickly, and as soon as he's out there he brakes and stands still, closing the side where we'd overtake.",
#:   "On my ride home the woman cycling ahead must have spotted a friend over the road. She swept out to the left, no hand signal, clapped on the brakes and remained, one toe down, chatting, with a car waiting behind.",
#:   "Rider up front jinks left, stops, and stays out there.",
#:   "Bike ahead: quick move left, foot down, finished.",
#:   "Our lead scooter whipped out leftwards and died on the spot.",
#:   "The girl cycling ahead of our car shied off to the left like a pony and stood fast there, one hand on the saddle.",
#:   "Make the motorbike the ego is behind dart over to its left side and brake to a halt at that offset, upright and in charge of itself.",
#:   "In front of me he goes with his bicycle, and at once he's making a hook to the left hand and is staying there like planted.",
#:   "What am I meant to do with a moped that jumps out to the left in front of my bus and just parks itself at that spot?",
#:   "Lead rider: lateral step of 1.4 m to the left within one second, followed by deceleration to rest; offset retained, machine vertical.",
#:   "There he was, stopped, out to my left, the very place by which I'd have overtaken him; he had flung his bike over to it with no arm out.",
#:   "Wild strawberries, would you believe. The old gentleman had been cycling along ahead of us, close in to the right. They grew on the other bank. With one sweep of the handlebars he was over on the left, and there he had both shoes on the ground and was shading his eyes, while our taxi stood behind him.",
#:   "There are gaps that you lose while looking at them. I'd planned to slip by the courier on his left; he'd been steady on his bit for a mile. The bag on his back leaned, and leaned toward my gap. The next thing that moved was nothing. He'd come to a stop in it, and was reading a house number.",
#:   "My pupils always say, \"but he didn't indicate\". No, he didn't. He was riding that motor scooter ahead of you, he'd a shufti at something, and out to the left he lurched and put the brakes on. Now he's sat out there. It isn't a turn, he's not going anywhere. And you, thank goodness, weren't already overtaking.",
#:   "For the passing module I need somebody to spoil the plan at the last moment. A cyclist is in front, a bit to the right, everything's inviting. When we're near, swerve him to the left, hard, and brake him to zero at the place he swerved to. He should remain on two wheels, with no fall and no wobble.",
#:   "V2, a bicycle, was preceding V1 in the same lane. As V1 prepared to pass, V2 veered to the left by an estimated four feet and came to a standstill there. The bicyclist explained that she'd dropped a glove and wished to wait for it to be brought to her. V1 struck V2's left handlebar grip.",
#:   "The sergeant asked which way he had fallen, and I told him that he hadn't. He had been riding his motorcycle in front of the bread van, as right as rain. He then cut out, left, sharp as a knife, as if to see what lay beyond the van in front of him; there wasn't any. And out there he had pulled up.",
#:   "In my helmet I sing, so I saw it singing. The other motorbike, the one in front of me, made a big wink with his body to the left side, not a curve, a wink. The stop lamp. And he was standing, with his boot on the line, and I was not singing any more, as left of him I wanted to pass.",
#:   "A wasp, the widow thought; a puncture, said the vicar, but neither tyre was flat. What all the parish had seen was Dr Lamb on his bicycle, ahead of the hearse, shooting off to his left as if plucked by the sleeve, and bringing himself up there, dead still, his hat over one eye, with the hearse behind him.",
#:   "Truckers' rule: a pushbike in front is as wide as it wants to be. That nurse was on the right, doing all right. I'd me indicator on. Woosh, she's out wide to the left, and not content with that she's on her brakes and stood there having a look at her phone. And me half alongside, on the air brakes, swearing.",
#:   "It took the coroner some time to see what I meant. When I hit him he was stationary. Yes, out on the left. No, he hadn't been standing there in the first place; he'd been scooting along in front of me till just before. He'd hopped over to that side and stopped, all in about as long as it takes to say so.",
#:   "so im behind this kid on a bmx right, robotaxi, im not even driving. hes in front, goes left like someone pushed him, stops. just stops, out there, lookin at a girl on a balcony. car says \"obstacle\". yeah mate he is",
#:   "Bike in front: out to the left, brakes, planted.",
#:   "The moped leading us hopped leftwards and died there.",
#:   "Suddenly wide left, then stock-still: our cyclist ahead.",
#:   "I was about to go by the courier when he filled the very strip I had in mind, to his left, and put a foot down in it.",
#:   "Let the ego follow a cyclist for a bit; he then jinks a metre or more to the left, hauls up at that offset and isn't to leave it.",
#:   "First came the elbow, sticking out over to the left side of our lane, and then the whole scooter was over there, upright, not rolling, engine puttering.",
#:   "He's riding in front of me on the right, he throws himself with his moto to the left, brakes, and there he stays, exactly where I want to pass.",
#:   "On our left-hand side, where seconds before there'd been clear road, a nurse was standing over her bicycle, having darted there from dead ahead and clapped on both brakes.",
#:   "Was there a junction for that motorbike to turn into, when it cut out leftward before your bus and came to rest? No, sir, there was only my overtaking room.",
#:   "The gap on his left was one metre eighty when I pulled my seat belt straight, and nothing at all when I let go of it. He hadn't gone from the road. He had been before me on his butcher's bike and he was before me still, just further over; and whereas he had been moving, he was not. He was looking at a cloud.",
#:   "What you heard on the tape as \"oi\" was me. I'd been drafting the bloke for a mile. His back wheel went away sideways to the left, so now I've nobody in front of me, I've somebody beside my front wheel, and he's grabbing brake like mad. By the time the car behind us both had stopped he'd been stood still out there a good second.",
#:   "A dropped purse lay by the centre line, that's what the fuss was about. Our robotaxi was following a lady on a yellow scooter. She must have spotted it on passing, since she pitched the scooter over to that side, the left, with a fine disregard for us, and halted on the spot, with her sandal on the purse.",
#:   "Rear wheel, left pedal, left hand: watch these three when you're behind a bicycle. In this one the left hand goes to the brake, but before that the bars are kicked round and he's off to the left like a frog. And now all three are at rest, over there, by the line. It's a good thing you hadn't put your nose out.",
#:   "My uncle drives the ice truck and he says cyclists are fish. One was swimming before him. He wanted to pass by its left, the fish felt it perhaps, with one stroke of the tail it was in that place. There it made no more movement, a boot on the asphalt, a mobile at the ear. Uncle sat behind and his ice melted.",
#:   "Between camera frames 310 and 340 the bicycle's lateral position changes by 1.3 metres, toward the left marking. Between 340 and 380 its speed goes from 4.8 m/s to zero. From 380 until 900 neither of the two changes. It's upright, its rider's texting; the side on which our planner had wanted to pass is taken.",
#:   "The vicar's theory is that the motorcycle had meant to overtake, and I said what, there was nothing before it. It was the head of the line. We came next, with the piano. It lurched from the crown of our lane out to its left hand, so that one saw the whole of the rider, and came to a dead stop before one had seen enough.",
#:   "V1's operator was preparing to pass a bicyclist who was traveling in the right portion of the lane. The bicyclist moved abruptly to the left portion and stopped there, straddling her machine. She'd observed a turtle. V1 came to a stop with its left front corner eleven inches from her rear wheel. She declined to move until the turtle had.",
#:   "It wasn't that he fell, he was too good a rider to fall. It was as if somebody had whistled for him from the opposite bank: the motorbike, which had led them so soberly up the valley, broke off to the left, shut its eye of red, no, opened it, and was still. It stood there at the road's middle, ticking, while they waited behind.",
#:   "Control, it's the gritter here. I've had to stop. There's a young fella on a pedal bike in front, he was tight in on the right and going along OK. He's only gone and flung it over to his left and jammed it on. He's stood there now, out in the lane. No, nothing's hit him. No, he's not turning. He's taking a picture of me.",
#:   "so in the sim the bike ahead is all nice and hugging the right side. ego goes oh cool ill overtake. bike goes NOPE, snaps left, brakes, sits there. ego nearly has him. we run it 50 times, ego gets him 3. bike never falls never leaves, just blocks",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "stop"]
#: position = "ahead"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.5
#: high = 5.5
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 0.95
#: high = 1.3
#: unit = "m"
#: meaning = "how far it swings out to the left"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 0.8
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_SPEED = Range(3.5, 5.5)
param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_SWERVE = Range(0.95, 1.3)
param OPT_BRAKE = Range(0.4, 0.8)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE) for 1.2 seconds
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE, globalParameters.OPT_SWERVE)
