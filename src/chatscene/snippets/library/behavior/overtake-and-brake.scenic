#: description = "The car overtakes the ego and then brakes hard in its own lane."
#: rephrasings = [
#:   "He gets past us and then drops anchor in the lane next door.",
#:   "Vehicle 2 passed vehicle 1 and decelerated rapidly without changing lanes.",
#:   "Passes, stays in lane, hard brake.",
#:   "The target overtakes the VUT and performs strong braking in the adjacent lane.",
#:   "He overtakes, doesn't come in, but brakes very much.",
#:   "The bus goes by and screeches to a stop beside our front.",
#:   "A motorbike rushes past and then sits up and hauls on the brakes.",
#:   "Once by, the van slams to a halt one lane over.",
#:   "He flew past in the next lane and then chucked out the anchors, without even coming over.",
#:   "Unit 2 passed Unit 1 and braked severely while remaining in the adjacent lane.",
#:   "MC overtakes us, stays in own lane, hard brake.",
#:   "The target vehicle overtakes in the neighbouring lane and applies strong braking there, with no lane change.",
#:   "The car goes past me and then brakes very strong, but in its own lane.",
#:   "Passer does not cut in; it decelerates hard one lane over so we fly by it again.",
#:   "It swept by on the outside, and no sooner was it ahead than it dug its heels in where it was.",
#:   "Ambulance going by on your left, he's past, and he's braking hard over there in his lane.",
#:   "he passed me then hit the brakes hard but stayed in his lane, like why even",
#:   "A car went by in the next lane and thereupon braked fiercely, though it never changed lanes.",
#:   "You overhauled my client, kept to your own lane, and there braked with great force; for what purpose?",
#:   "He overtook me in side lane and put full brake there itself, did not come to my lane.",
#:   "Has to be first, doesn't he, whizzes by and then stands it on its nose over in his own lane.",
#:   "Severe deceleration of passing vehicle within the adjacent lane",
#:   "PASSES ME JUST TO SLAM HIS BRAKES (next lane)",
#:   "The motorbike overhauls us and digs in on its own side.",
#:   "Gets by us one lane across, then anchors up over there.",
#:   "Biker zips past, then sheds speed savagely, no lane change.",
#:   "Let a hatchback pass the AV, then decelerate brutally without merging.",
#:   "No cut-in: overtaking cab, hard braking in its own lane afterwards.",
#:   "SUV leaves us behind, then stamps on it in the adjacent lane.",
#:   "The convertible went sailing past on the other strip of tarmac and, without ever moving over, put its brakes on as hard as they'd go.",
#:   "First the motorcycle makes an overtaking of me, then it brakes very heavy, but always in the lane from the side.",
#:   "Upon gaining a defined lead over the subject vehicle in the neighbouring lane, the passing vehicle shall execute emergency braking while remaining there.",
#:   "He's come up alongside, he's past you, now his nose has gone down, hard braking, but see, he hasn't come into your lane.",
#:   "Would someone explain the pickup that went round me in the outside lane only to jam its brakes on out there?",
#:   "The brake lights I saw belonged to a saloon in the next lane, which had only just drawn ahead of me at some speed.",
#:   "A young woman in a sports car was in a terrible hurry and left me standing. She stayed out in her lane, and a little farther up she must have seen the camera, for the car practically knelt down under its brakes.",
#:   "V2 passed V1 in the number two lane. When approximately sixty feet ahead, V2 was subjected to maximum braking for reasons unknown; at no time did it enter the number one lane, in which V1 was traveling.",
#:   "What happens with our following-distance logic if somebody goes by in the lane beside ours and then throws out everything he has? He mustn't merge. I want to see that the robotaxi doesn't brake along for nothing.",
#:   "The motorbike came up behind his shoulder like a wasp, droned by on the far side of the dashed line, and was in front. There, still on its own side, it suddenly reared back on its brakes with a shriek of rubber.",
#:   "Yesterday on ring road one car has overtaken me from the side lane with good speed. After going ahead he has applied brakes full force in his same lane, luggage falling and all, and I passed him comfortably.",
#:   "Went by in the next lane and stood on its brakes there.",
#:   "Passed, kept out, braked brutally; our lane stayed clear.",
#:   "Biker overtakes alongside, then full squeeze, never coming over.",
#:   "A coupé tore past on the neighbouring track of the dual carriageway, and no sooner was it ahead than it was on its brakes, still out there.",
#:   "The hatchback, having drawn ahead of us in lane two, anchored up in lane two, so that we came level with it again.",
#:   "He has passed me by the side lane, and there, in that same lane, he braked like a crazy; I only drove on in mine.",
#:   "Let someone overtake the robotaxi in the parallel lane and, a couple of lengths ahead, hit the brakes as hard as possible without merging.",
#:   "Why would he bother to get in front of me, in his own lane mind you, only to throw the whole lot away with a stamp on the brake?",
#:   "Motorcycle gained twelve metres on the subject vehicle by way of the adjoining lane and braked at 7 m/s² therein; lateral distance unchanged.",
#:   "My lane was free, it never stopped being free, and yet my foot went down out of sheer sympathy. The sports car that had just swept past me one lane over had its tail up and its lamps blazing, and there was smoke coming off it. I suppose he'd spotted the camera van. I sailed by.",
#:   "You needn't brake for everything red. He's overtaken you, grand, he's out there in the other lane; he's hit his brakes ever so hard, look at him dip; and is he in our way? He isn't. Kept to where he was, lane-wise. So we cover it, we look, and on we go.",
#:   "Out of the window on the right my son follows the cars that get by us, and he gives them marks. The yellow one got a nine as it went past, zoom. \"It's broken!\" he said then, because, a bit ahead and in its lane still, it was suddenly slowing so hard that the yellow wing was coming back to us.",
#:   "Forward radar sees the passer at +6 m/s relative to us in the next lane to the left. At a lead of fourteen metres this becomes minus nine within a second. Azimuth increases accordingly, there's no lateral component, and the correct decision was to do nothing. Our stack, I am sorry to report, did an emergency stop.",
#:   "It may have been a wasp in the helmet. What I know is that the motorbike had been behind, was beside me on the outer lane, was ahead; and that the rider then squeezed for dear life, so that his back wheel left the ground. All of it took place out there. On my own strip, there was only me and some rain.",
#:   "The man who'd been so anxious to get in front of us had all the outer lane to himself, and he used it, too, going by as though we were milestones. We next met him, if meet is the word, when he had flung out every anchor he'd got, in that very lane. His passenger was rubbing her neck.",
#:   "For this collision there were two ingredients, both out of V1's lane. V2 passed V1 via the left-hand lane. Upon being a few car lengths ahead, V2, which didn't change lanes at any time, underwent heavy braking. V3, directly behind V2, struck it. V1 was hit by a wheel cover only.",
#:   "Lorry's eye view: pocket rocket comes up my offside, goes by, and I lose him for a sec beyond the mirror. Next I see he's there in the middle lane with a blue cloud round each wheel, hauling it down for all he's worth. Never came in on me, I'll give him that. But what for? Road's empty.",
#:   "Some cars overtake you as an insult, and she had a feeling that this was one. It came up the adjoining lane, went by her door with a sneer of its exhaust, and was hardly ahead before its brakes seized it. Still in that other lane it bowed low before nobody, lamps ablaze; she drove past, chin up.",
#:   "So test case seven is meant as a false-positive trap. There's an overtaker. It uses the lane beside, it's quicker than the ego by ten, and as soon as it has its nose well past ours it makes an emergency braking, holding its own lane all the while. If the ego brakes as well, we've failed.",
#:   "it was the m6 n a black merc comes past me in lane 2, gets in front a bit, still lane 2, then BANG full on the brakes nobody ahead of him nothing. i just went past on the inside lane like ???. my dad says he prob missed his exit",
#:   "Whizzed by one lane over, then anchored up out there.",
#:   "Past us, ahead, full brakes, still in lane two.",
#:   "The biker led briefly, nosedived, never left his strip.",
#:   "A roadster that had nosed by in the lane alongside was suddenly shedding all it had gained, with its wheels smoking, and its side of the dashes was where it stayed.",
#:   "Mind the logic here: the passing motorbike never comes over to the ego, it goes by, it's ahead, and it then hauls itself down out there, as hard as it can.",
#:   "Twice we saw the yellow hatchback's profile, once as it went by on our left and again as it came back to us there under screaming brakes.",
#:   "Why did your van brake, when the saloon that had overhauled it and was standing on its nose had the whole of the other lane for doing so?",
#:   "With much speed it has left me on the side, the motorcycle, and I see it dipping strongly, but it's dipping there, in its line, mine is free.",
#:   "The car to be used overhauls the subject vehicle by way of the neighbouring lane, gains fifteen metres, and there is brought down at 8 m/s² on an unaltered course.",
#:   "His passenger, who'd blown me a kiss as they went by, had her forehead on the dash when I next saw her. They were a length or two in front, still in the fast lane, and that coupé was trying to dig itself into the tarmac. I had nothing ahead of me except a crow. I kept my speed and blew it back.",
#:   "There's a kink in the armco and a sign that says \"exit\" and I've seen it many times. They are in the outer lane, they get by you, by half a dozen lengths, they read the sign. Down goes the snout. They can't get over, as you're in the way, so what you see is a man in the wrong lane throwing his car away.",
#:   "The lane assist stayed quiet, the collision warning didn't. Let me reconstruct it for you. A motorbike draws up from behind on my right, as it may, being in a lane of its own. It shows me its tail. Its tail rises, the lamp flares. It is off to one side by a good three metres, the bike, and my car shrieks as if it lay under us.",
#:   "What would you say was the purpose of it? He used up a lot of petrol in order to put his taillights in front of us, over there on the other side of the broken line. Then he used up a lot of brake pad to take them away again, and never so much as touched the paint. We drew level, and I looked in. He was laughing.",
#:   "V1 and V2 were northbound in adjacent lanes. V2's speed exceeded that of V1 by 12 mph and V2 went by. When about 50 feet in the lead, V2 left two parallel skid marks 61 feet long. The marks lie entirely within the left lane. V1, in the right lane, was not impeded, but its following traffic reacted to V1's sympathetic braking.",
#:   "Sympathy's a poor driving instructor. You saw red lights and your toes curled, admit it. But whose were they? They belonged to the Porsche that'd blown by us on the outside. And in which lane was he doing his big emergency stop? The outside. So all that you need from it is a bit of interest, like in a neighbour's row.",
#:   "A bee, two hundred and ten kilos of motorcycle, a man of sixty. The bee came last. First he'd passed us, rather nicely, on his half of the carriageway, the chrome twinkling by at our window, so that we had the back of him. The bee got in. From the way the fork went down you'd have said a wall. He was never in our half.",
#:   "The radar is looking straight ahead and has nothing. The camera's looking half-left, and it has a lot: a small sports car that, a second and a half ago, came in at the left edge of the picture, ran forward, got smaller. It's getting bigger now, at nine metres per second squared, without sliding toward the middle. We shall fly by on its right. Please don't brake.",
#:   "The children had a bet on which of the passing cars would be red. It was, they cheered, it was by our front wheel in the next lane and then beyond. \"Daddy, it's doing a bow!\" It was doing a bow to nobody, right there where it was, its bumper all but on the ground. \"And here it comes again,\" for we were the faster now.",
#:   "He swept past, and in the moment of his being in front the whole grandeur of it collapsed. There was blue smoke. It was his own lane he was smoking in, nobody could say he had thrust himself upon them; the lane that lay before their bonnet went on, pale and empty, into the hills. They glided by him with averted eyes, as past a man who's been sick.",
#:   "m25 inside lane doing 60, beemer goes by me in the next one, fine. gets like 3 cars up and then HARD brakes, nobody in front, doesnt come over or anything. im just in my lane like ok?? now im in front of him again. weirdest overtake of my life",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: place = "road"
#: actions = ["overtake", "brake"]
#: position = "behind-beside"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 11.5
#: high = 15.0
#: unit = "m/s"
#: meaning = "how fast it overtakes at most"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 6.0
#: high = 14.0
#: unit = "m"
#: meaning = "how far ahead of the ego it is when it brakes"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_SPEED = Range(11.5, 15)
param OPT_ADV_AHEAD = Range(6, 14)
param OPT_BRAKE = Range(0.5, 1)

behavior AdvBehavior():
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do BrakeOnPath(advLane, globalParameters.OPT_BRAKE)
