#: description = "The car behind tailgates the ego, then pulls out and overtakes it."
#: rephrasings = [
#:   "First he's up our exhaust, then he swings out and goes by.",
#:   "Vehicle 2 followed at close range, changed lanes and passed vehicle 1.",
#:   "Tailgates, pulls out, passes.",
#:   "The target closes up to the VUT, moves to the adjacent lane and overtakes.",
#:   "He pushes from behind a long time and then passes on the other lane.",
#:   "The motorbike sits in our draught before it nips round.",
#:   "A van crowds our boot until it finds the next lane free and sails by.",
#:   "A coach leans on us from the rear and finally heaves itself past.",
#:   "Had a hatchback sat on my bumper for ages, then he lost patience, nipped out and went by.",
#:   "Vehicle 2 followed V1 at an unsafe distance before pulling into the adjacent lane and passing it.",
#:   "Rear car glued to ego bumper few secs, then out + past. No braking in front.",
#:   "The rear target maintains a very short headway to the VUT, subsequently changes lane and completes a passing manoeuvre.",
#:   "The moto is driving too close behind me, after some time he goes out and passes me.",
#:   "Rear vehicle holds sub-half-second headway for a while, then moves out and goes around; no brake check afterwards.",
#:   "He hung on her tail so close she couldn't see his headlamps, until at last he swung out and was gone past her.",
#:   "See him breathing down your neck? He's itching to get by; there, he's pulled out and he's off round you.",
#:   "this guy was literally up my butt for a whole minute then finally went around lmao",
#:   "After hounding the learner's car at arm's length, the impatient driver went by it, witnesses said.",
#:   "He remained within a metre of my client's boot, and only afterwards moved out and went ahead of her; is that so?",
#:   "Behind car was sticking to my back like anything, then only he overtook and went.",
#:   "Fella was breathing down my neck all along the street, then off he hops round me. Couldn't do that at the start, could he?",
#:   "Insufficient headway from following vehicle, ending in a passing manoeuvre.",
#:   "IMPATIENT TAILGATER CAN'T WAIT, GOES ROUND",
#:   "A motorcycle nuzzled our rear bumper, then leapt past.",
#:   "Follows us nose to tail, then switches lanes and leaves us behind.",
#:   "rides our bumper for abit before slinging himself past",
#:   "Scooter hugging our tail finally goes around us.",
#:   "CLOSE-FOLLOWING SUV LOSES PATIENCE AND PASSES CAMERA CAR",
#:   "Target: gap under 3 m behind ego, subsequently overtakes.",
#:   "All I could see in the mirror was his grille, that's how near he was, until he veered to the outside and pulled ahead of us.",
#:   "Simulate a saloon that sits far too close to the back of the robotaxi for several seconds and afterwards goes past it via the next lane.",
#:   "Before passing the subject vehicle on the left, the pickup had been driving almost inside its boot, according to the passenger on the rear seat.",
#:   "Why must he come up to within a hand's width of my number plate when he is going to overtake me anyway, as he then did?",
#:   "The motorbike came so close to our back window that I could see the man's face, and then it went round us and drove away, said the girl.",
#:   "The behind car is not keeping any distance from the autonomous car, it pushes, and when it has enough of pushing it makes an overtaking.",
#:   "I was doing the limit along the bypass when a white van closed right up on me and stayed there, so near that his headlights vanished below my rear screen. In the end he'd had enough, nosed into the other lane and drove by.",
#:   "V2 had been travelling behind V1 with a separation estimated at one to two metres. Its driver, who stated that he was late for a shift, then steered into the adjoining lane, drew level with V1 and continued past it without contact.",
#:   "Give me a scene in which the AV is harried from the rear: a hatchback sticks to it with hardly any headway, as though on a tow rope, for quite some time. After that the hatchback leaves the lane and completes a pass.",
#:   "My grandson was driving and kept glancing up at the mirror, because a young man on a motorcycle was practically sitting in our luggage. It made me dreadfully nervous. Then with a great snarl he steered around us and away he went up the road.",
#:   "The dash cam at the back shows it best, lads: a taxi so tight on us that you can read the badge, for about ten seconds. Then it slides out of frame on one side and turns up in the front camera, having gone by.",
#:   "Lexus welded to my rear plate, eventually steers out and pulls clear.",
#:   "After a spell of bumper-riding, the motorcyclist went by on the outside.",
#:   "Crowded from astern by a cabriolet, which finally left us standing.",
#:   "My pupil kept asking why the hatchback was so close, and before I could answer it had drawn out and gone on ahead of us.",
#:   "Subject vehicle was shadowed at about two metres by a black sedan; sedan later departed lane, came abreast and carried on in front.",
#:   "I am telling you, that bike fellow was almost kissing my dickey, full two minutes like that, then he took the side and went ahead.",
#:   "Could somebody add a sports car that presses up against the AV's back end for a while and only afterwards makes its way past?",
#:   "What good did all that shoving do the man in the Polo? He hung off our towbar for a mile and then nipped by like everybody else.",
#:   "The witness had ceased to see the road behind her, so near was the SUV, until it slid sideways out of the mirror and went by the window.",
#:   "From Junction 4 onwards the rear parking sensor would not stop chirping, with nothing behind but one motorbike and its rider's knees. My wife told me to ignore him. The chirping ended the moment he leaned out into the other lane, and a few seconds later it was his tail light we were looking at.",
#:   "Control, the complainant says a red saloon had been bullying her along the valley road, no daylight between the two cars. She held her speed at fifty. The saloon has since moved across into the free lane, gone ahead of her and been lost to sight.",
#:   "The approach phase is governed by headway: the rear target closes on the ego and keeps station a couple of metres off its bumper. When the ego is near the trigger point the target abandons the lane, uses the adjacent one to get by, and drives on. It interferes with the ego in no other way.",
#:   "I was reading the map and only noticed because Tom had gone so quiet. He was watching the mirror, where an estate car filled the glass from edge to edge, its badge almost in our boot. A little later it loomed up alongside my window, then the glass was empty and the estate was somewhere up the road.",
#:   "In France we say coller aux fesses, this means he glues himself to your bottom. So did the small white car with me on the nationale, I could not even see its number plate. When the second lane was there he took it, and me I stayed behind him.",
#:   "The robotaxi log shows a rear distance that shrinks to 1.8 m and stays there for eleven seconds. Then the track moves one lane over, the relative position runs from minus six metres through zero to plus forty, and the object is gone. Passengers reported feeling harassed; nothing else happened.",
#:   "As a lorry man you learn to leave them to it. This motorbike had tucked itself so tight under my tailboard that I only knew he was there by his headlamp on the kerbstones. When the road opened to two lanes out he popped, up my side and away, and that was the end of our friendship.",
#:   "He was gone at last, thank heavens, a pair of tail lamps shrinking up the bypass, and I could ease my shoulders. Before he went round me in the next lane I had had that taxi at my back for what felt like ages, close enough to push. I had my grandmother's china on the rear seat.",
#:   "Podcast listeners will know my rule: if you can't see their tyres on the road, they're too close. With this BMW I couldn't even see the bonnet. It sat on us like that all through the roadworks, and as soon as the cones ended it went out, drew level, and put us in its own mirror.",
#:   "The driver of V1 stated that he felt pressured into exceeding the limit by V2, which trailed him by less than a car's length. He maintained his lane. V2 thereafter relocated to the lane on its left and progressed beyond V1, there being no contact and no hard braking by either party.",
#:   "We were singing in the back and a motorbike came right up to our window, so near that I could see my face in its lamp. It stayed and stayed and I waved. Then it leaned over, rode past Daddy's door and went away in front of us.",
#:   "Estate up our backside for a mile, then away past.",
#:   "REAR CAM: Golf fills the glass, sidesteps, vanishes up the road",
#:   "Hogs our slipstream at a metre, changes lane, leaves us for dead.",
#:   "Rear gap to the pursuing scooter logged below one second throughout; gap subsequently negative, the scooter having used the left lane to get in front.",
#:   "You could have dropped a coat over my towbar and his bonnet both, and it stayed like that until he slipped into the other lane and went on ahead.",
#:   "Nothing to see through the back window but chrome teeth; some while after, those teeth were alongside, and after that there was only his exhaust in front.",
#:   "Please build me a hothead on a motorcycle, first stuck to the AV's rear like chewing gum to a shoe, later off round the outside and away.",
#:   "My sister said don't look back, he's only inches off, and when I did look back he wasn't there, because he had just gone by her window.",
#:   "The taxi man he doesn't keep the distance, he wants to sleep in my trunk; after that he takes the free lane and I see him from behind.",
#:   "The baby's sunshade on the back window had a grinning radiator painted on it, or so it seemed, from the church to the roundabout at Wick. I kept to thirty as the signs say. When the radiator finally peeled off to the outside there was a door, then a rear wheel, then a brown Jaguar in front of me, getting smaller.",
#:   "For eleven miles he lit up my cabin. I'd tipped the mirror to save my eyes, since with the beams that close it was like having a lighthouse for a passenger. The dark came back quite suddenly on the right, as the beams drew out, slid along the paintwork, and were pointing up an empty road ahead of us.",
#:   "I'm on a pushbike with a trailer so I know about being followed closely, but this was a van, mate, and it was practically in the trailer with the shopping. You could feel the heat of it. Lane opened on the right, out it came, the draught nearly had me over, and the last I saw was its back doors.",
#:   "Passenger statement: she was able to count the flies upon the windscreen of the car following the subject vehicle. This state of affairs persisted for roughly half a kilometre. She next observed the same car level with her own door in the adjoining lane and, seconds later, well in advance of them.",
#:   "We won't go faster just because that saloon would like to share our boot, will we? Good. Mirror again, still no tarmac between us and him. And once more: there's tarmac now, lots of it, as he's gone out and he's coming by. Let him. Wave if you like.",
#:   "By the third kilometre I'd stopped braking for anything, since a single dab would have put that biker on our back seat. Even the cows got a wide berth. What ended it was the dual carriageway, where he had a whole lane to himself, and it took him about four seconds to become somebody else's problem up front.",
#:   "Our rear bumper sensor raised \"object too near\" at 09:12:04 and held it for fourteen seconds. It cleared when the object transferred one lane to the left. The left-hand side radar then carried it from back to front, and the forward camera had it last, at ninety metres and growing more distant.",
#:   "All the way to the lights my mother kept saying he would be in with us in a minute, and asked whether she should move her knitting. He was that near. He never was in with us, as he found himself a lane of his own, rushed along it, and had crossed the hill before she'd finished her row.",
#:   "The coach trip was enlivened by a red convertible that had attached itself to our stern. From the rear bench we looked straight down on the driver's bald patch. Eventually the bald patch swung out to starboard, travelled the length of the coach below us, and the front rows reported it disappearing in the direction of Bath.",
#:   "Complainant says no contact, but that she \"felt towed backwards\". The other motorist had closed to a distance she puts at half an umbrella and would not drop off, whatever her speed. She got her road back only when he elected to use the offside lane, and he was soon out of her sight in front.",
#:   "In my country we say he was counting my rivets. I have forty tons and no hurry, he has an Alfa and no brain, and under my rear lamps was no asphalt any more, only Alfa. When it flew out beside my trailer, along my cabin and forward over the hill, I opened a window.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["adjacentLane", "advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["tailgate", "overtake"]
#: place = "road"
#: position = "behind"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 5.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_GAP"
#: low = 0.8
#: high = 4.0
#: unit = "m"
#: meaning = "how much room it leaves between its bumper and the ego's"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 10.0
#: high = 14.0
#: unit = "m/s"
#: meaning = "how fast it overtakes"

param OPT_ADV_DISTANCE = Range(5, 30)
param OPT_ADV_GAP = Range(0.8, 4)
param OPT_ADV_SPEED = Range(10, 14)

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 12) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(extended(adjacentLane, 20), globalParameters.OPT_ADV_SPEED)
