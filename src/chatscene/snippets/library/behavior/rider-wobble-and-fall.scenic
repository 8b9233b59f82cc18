#: description = "The rider ahead starts to wobble, loses balance and falls in the lane."
#: rephrasings = [
#:   "The cyclist in front gets the wobbles and comes off right before us.",
#:   "The bicyclist lost control, fell, and came to rest in the lane of travel ahead of Vehicle 1.",
#:   "bike ahead wobbles, rider down",
#:   "The target ahead oscillates laterally and becomes stationary on the VUT's path.",
#:   "The cyclist before us has trouble with the balance and falls down.",
#:   "A front wheel caught in the tram rail, the biker sways and tumbles.",
#:   "The scooter shakes from side to side and then lies on the tarmac.",
#:   "Overloaded, the bike up ahead snakes about until it topples over.",
#:   "The poor bugger in front started wobbling on his bike and went over in the road.",
#:   "The bicyclist ahead lost control, began to sway, and fell to the pavement in the travel lane.",
#:   "MC ahead unstable, goes down, lying in lane.",
#:   "The leading two-wheeler shows increasing instability and topples over, remaining in the lane.",
#:   "The man with bicycle before me shakes left and right and falls down on the road.",
#:   "Lead rider: growing wobble, tip-over, stationary obstacle at ground level in our lane.",
#:   "The front wheel shivered, she fought it for a yard or two, and then she came off and lay there before him.",
#:   "Biker's got a tank slapper on, he's losing it, he's down, rider down in your lane.",
#:   "the guy on the bike started shaking all over and then ate it right in front of me",
#:   "A cyclist lost her balance and came down in the path of following traffic.",
#:   "The bicycle began to oscillate, the rider could not master it, and he was cast upon the road.",
#:   "Cycle in front started shaking, balance gone, and the fellow fell down in the road.",
#:   "Wibbling about like jelly, that rider, and next thing he's flat on the deck ahead of me.",
#:   "Loss of balance and fall of preceding two-wheeler rider into own lane",
#:   "BIKER WOBBLES AND WIPES OUT ahead of me",
#:   "The scooterist in front teeters and tumbles.",
#:   "Postman's bike ahead shimmies, tips, and dumps him on the tarmac.",
#:   "Motorcyclist in front fought the handlebars and ended up lying in our lane.",
#:   "Ahead: rider swaying, balance lost, down he goes.",
#:   "Let the leading cyclist totter and then drop onto the road.",
#:   "Splat went my brother off his bicycle after wiggling before the car.",
#:   "A carrier bag had got caught in her spokes, so the woman we were following on the bicycle began to rock from side to side and finally crashed onto the road.",
#:   "The preceding two-wheeler executes lateral oscillations of growing size for three seconds and then comes to rest, lying on its side, within the lane of the VUT.",
#:   "was about thirty yards behind this scooter when the back end startd snaking left n right and then he parted company with it middle of the lane",
#:   "Please put a cyclist ahead of our robotaxi who becomes shaky, cannot catch his balance any more and keels over so that he lies in front of us.",
#:   "Officers were told that the motorcycle leading the insured's vehicle developed a speed wobble which its rider couldn't control, and that both rider and machine finished up on the asphalt.",
#:   "The uncle on the cycle ahead was carrying two gas cylinders, he went shaking this side that side, and then cycle and cylinders and uncle, all fell in my way.",
#:   "See him in front, with the phone in one hand? His front wheel's going all over, little left, little right. Give him more room. More. And there you are, he's come off, he's sprawled in our lane, so it's a good thing you listened to me.",
#:   "V1 was following a bicycle at fifteen miles per hour. The bicyclist, age seventy-one, was seen to waver with increasing swings for some yards, after which he toppled to the pavement in the lane ahead of V1 and did not get up before its arrival.",
#:   "Diesel on the road, nothing you can do. I was leading the group on my old Triumph when the bars started to slap from lock to lock, I thought I'd got it, I hadn't, and next I'm on my back in the lane looking at the bumper of the car that'd been behind me.",
#:   "Bug: perception loses a fallen VRU. The lead cyclist rides normally, then oscillates about the lane centre, then tips and is at ground level, stationary. From that frame on the track is dropped as debris although he's lying right in our lane, twelve metres off.",
#:   "For a moment it was almost pretty, the way the girl on the bicycle in front of them swung to one side and the other like a leaf coming down. Then the swings grew too wide for her, and she fell, and the bicycle lay ticking in their lane.",
#:   "Handlebars flapping, the cyclist ahead loses it and lands in our lane.",
#:   "Lead scooter: sway, bigger sway, rider on the deck.",
#:   "Overloaded bike before us teeters this way and that, then keels over.",
#:   "The man on the motorbike we were following fought three or four swings of his front wheel before he and it went down in the middle of our lane.",
#:   "Leading PTW is to show lateral instability for the set duration, to topple, and to lie at rest in the VUT's path thereafter.",
#:   "Give him a shaky front wheel, that cyclist up ahead, make the shaking last a moment, and then have him tumble onto the tarmac before us.",
#:   "I had seen the lady before me trembling on her bicycle, to left, to right, and then she has lost the equilibrium and was lying on my street.",
#:   "Courier ahead, bag swinging, bike swinging with it, and then neither of them upright any more, just a heap of turquoise in the lane.",
#:   "What made the subject vehicle brake was the sight of the moped it was behind rocking from side to side and then spilling its rider into the road.",
#:   "I followed his rear lamp since it was all I could see in the drizzle. It began to draw little arcs, like a pendulum, and the arcs got wider. Then it was not an arc, it was a spark that went sideways along the ground and stopped, and he was there beside it, in my lane, holding his elbow.",
#:   "It's hard on the father, who was jogging next to her. She'd had the stabilisers off a week, she was pedalling along in front of our car, and first the front wheel couldn't make up its mind. Left, right, left. Then there was a small bike on its side in our lane and a small girl under it.",
#:   "The deceased, riding a solo motorcycle, preceded my client by some thirty metres. Two witnesses saw the machine \"shake its head,\" as they put it, from one side to the other with mounting force. It then fell, and my client was faced with machine and rider lying in the lane he was driving in.",
#:   "One for the tram-track collection. Bloke on a fixie is ahead of me, gets his wheel in the groove, and you can watch him lose it bit by bit, wobble, save, wobble, save, bigger wobble, no save. He's on his back in the lane like a beetle. I got stopped, he's fine, the cake isn't.",
#:   "You've been told to give cyclists a metre and a half to the side. Here's why you want it in front as well. She's got a bag on one handlebar, she is starting to sway, it's getting worse, hang well back, and down she goes. Now she's on the road in our lane and we've stopped with plenty in hand.",
#:   "Log 3318: lead VRU heading oscillates plus and minus nine degrees over 2.6 s, period shortening, roll angle following. At 14:02:11 the height of the bounding box drops from 1.8 to 0.6 and its speed to zero. It stays there, in lane, and the ego, which had been following, needs the full brake.",
#:   "The first I knew was the melons. He carried them in a net on the rack, the boy who was cycling ahead of us, and a net swings. It swung and he swung against it, this way and that way, and there came a swing for which he'd no answer. Boy, bicycle and melons were all over our lane.",
#:   "V1 was traveling behind a moped occupied by two persons. The moped commenced to weave within the lane as its passenger shifted a package. The operator was unable to regain balance, whereupon the moped went over on its left side and both persons came to rest on the pavement directly ahead of V1.",
#:   "She had not ridden since her illness. It showed in the front wheel, which asked a question of the road, to the left, to the right, to the left, and got no answer. When it lay spinning in the air and she beneath it on the stones, the car that had been coming after her stood two paces off.",
#:   "On ice you've got about a second and a half between knowing and lying there. I was on the Vespa with that white electric car at my back. The rear stepped out, I caught it, it stepped out the other way, I caught that, and the third one I didn't catch. I was down in the lane, looking at its headlamps.",
#:   "Family \"loss of stability,\" member two. The motorcycle leads the AV at constant distance. For three seconds it oscillates about the lane centre, like a rider who's struggling to keep upright, and then it's over: it falls, and remains as a low obstacle in the AV's lane. It is not to get up.",
#:   "Handlebars twitching, twitching worse, then sparks: rider down in our lane.",
#:   "The biker in front shook, lost it, and lay there.",
#:   "Let our leading cyclist sway, fail to catch it, and drop.",
#:   "His rear light swung like a bell that's being rung, wider each time, and then it was at tarmac height and still, in the lane before us.",
#:   "From upright to horizontal took the scooter ahead about three seconds, and for all three its rider was sawing at the bars.",
#:   "We owe our good brakes to the pillion who sneezed, as the moped before us set to swaying and ended up, with both of them, on the road.",
#:   "The leading PTW's lateral oscillation about the lane centre is to last for 2.5 s, after which it is on its side, at zero, in the VUT's path.",
#:   "She's fighting it, she's all over her bit of road, hang back, and there she goes, flat out in front of us with her wheels up.",
#:   "Bhai, cycle before me started dancing left side right side, I thought he is singing, then whole singer was on the road with his dabba.",
#:   "In the mirror of the pond by the road there was a cyclist upside down. That was the better picture, as it turned out. I watched her reflection bend this way and bend that, more each time, and when I looked up from it to the real one she was also upside down, or nearly, on our lane with her bicycle on top.",
#:   "The scratches in the asphalt start eight metres before the body. Ahead of the scratches, for another twenty, there's a single tyre line which isn't straight but goes in curves, tight ones, to either side. V1, following, left two straight ones. They stop short of the motorcyclist by less than his own length.",
#:   "Ask me how I knew to brake. His saddlebags. I've ridden thirty years, and when the bags on the bike ahead begin to flap in turn, left one, right one, left one, he's got a shake he can't get out of. I had my wagon at a crawl by the time he hit the deck. He was lying there looking at my tow hook.",
#:   "Pedestrians clapped, which I thought heartless. The waiter had been riding along in front of our taxi with a tray on one hand. You could see that he had started to correct, and to correct the correction. Each was bigger than the last. When there was no more room for correcting, he, tray and bicycle were spread over the lane.",
#:   "For a moment our following distance was to a bicycle, and then it was to a pair of shoes. The soles faced us. What lay in between, on the safety driver's account, was a \"death wiggle,\" that is some four swings of growing size around the line on which the rider had been riding so nicely, and a thump.",
#:   "The question isn't whether your client overtook, he didn't, he was behind. It's whether he'd warning. He says the moped in front \"dropped like a stone.\" A stone does not go to and fro first, as the film shows it doing for two and a half seconds, before it and the boy came to lie in your client's lane.",
#:   "Mum says you should hold on with both hands. The man we drove behind was holding an ice cream. His bike went a bit to the house side and a bit to the river side and a lot to the house side. And then he was lying down! In the road! Mum stopped in time and the ice cream was under our car.",
#:   "Sim card \"rider down.\" He is our lead, at constant headway, and there's nothing wrong with him. On trigger give him the shakes: side to side, quick, for some seconds. Then he's to be on the ground in our lane, machine too, low and at rest; the detector ought to go on seeing him, and the ego ought to stop.",
#:   "One learns from the wind. On the viaduct it takes you from the left, and when you lean into it, it stops. The young woman on the Vespa up ahead leaned, and was dropped, and leaned the other way, and was dropped. I counted five. At the fifth her visor was on the ground, in my lane, and I on my brake.",
#:   "It had been such a steady little lamp, and he'd followed it down from the pass as one follows a thought. There was black ice by the shrine. The lamp started at something; it shook its head, no, no, no, with more and more passion; and then it lay in the road before his wheels and shone into the sky.",
#:   "Le facteur, he goes in front of me with all his letters. One bag is lost on the left, so he hangs to the right; he corrects, he hangs to the left; to the right; I say aloud \"aïe.\" And he is laid down in the middle of my lane, his bicycle too, and the letters are coming down on us all, slowly.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["weave", "stop"]
#: position = "ahead"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 6.0
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 1.0
#: high = 1.6
#: unit = "m"
#: meaning = "how far it wobbles to either side"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 3.0
#: high = 3.6
#: unit = "s"
#: meaning = "how long a full swing takes"
#: [[parameters]]
#: name = "OPT_ADV_TIME"
#: low = 6.0
#: high = 8.0
#: unit = "s"
#: meaning = "how long it wobbles before it falls"

param OPT_ADV_SPEED = Range(4, 6)
param OPT_ADV_AMPLITUDE = Range(1, 1.6)
param OPT_ADV_PERIOD = Range(3, 3.6)
param OPT_ADV_TIME = Range(6, 8)

behavior AdvBehavior():
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD) for globalParameters.OPT_ADV_TIME seconds
    do Halt()
