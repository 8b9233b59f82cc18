#: description = "The oncoming car suddenly accelerates and closes the gap."
#: rephrasings = [
#:   "A vehicle approaching from ahead puts its foot down, leaving no time to return to the lane.",
#:   "The adversary speeds up toward the ego.",
#:   "Opposing traffic gains pace without warning.",
#:   "The other driver, coming the opposite way, floors the pedal.",
#:   "The oncoming motorbike rushes at the ego faster and faster.",
#:   "he sees us out there and steps on it",
#:   "Vehicle 2, approaching from the opposite direction, accelerated.",
#:   "opposing veh speeds up, gap closing",
#:   "the fella coming the other way suddenly floored it and the space between us was gone in no time",
#:   "The oncoming vehicle abruptly increased its speed, reducing the distance to V1.",
#:   "Opp. truck: throttle up, gap shrinking fast.",
#:   "The oncoming target increases its speed sharply, shortening the time to the meeting point.",
#:   "The motorbike from the front side makes suddenly more gas and is very fast at me.",
#:   "Opposite-direction NPC: step increase of speed on trigger so the available gap collapses.",
#:   "The bus had been coming on lazily enough; now it gathered itself and bore down on them.",
#:   "He's coming towards you and he's put a spurt on, you've not got the gap you thought you had.",
#:   "the car coming at us just put its foot down like full send at us",
#:   "The approaching lorry picked up speed when there was every reason to ease off, the coroner was told",
#:   "Instead of slackening, you increased your speed as the vehicles drew nearer to one another?",
#:   "That bus from opposite suddenly pick up speed and coming coming, gap all finish",
#:   "There's room for me till that one coming the other way gives it some welly, and then there isn't",
#:   "Unexpected speed increase of opposing traffic; rapid loss of available gap",
#:   "Oncoming motorbike GUNS IT straight toward me",
#:   "The van bearing down on us quickened.",
#:   "Coming the other way, the lorry abruptly puts on speed.",
#:   "Oncoming scooter winds it up, and our gap melts away.",
#:   "Opposing bus: sudden speed gain, time gap collapses.",
#:   "Have the van opposite hurry up all at once toward us.",
#:   "HE SPED UP! Head-on traffic decides to rush me",
#:   "couldve sworn there was room but the car comming towards us gave a sudden burst of speed and was on us in a blink",
#:   "The oncoming target vehicle shall increase its speed sharply at a given distance, so that the remaining gap to the VUT closes sooner than anticipated.",
#:   "As she approached from the opposite end the driver of the hatchback pressed the accelerator right down, for reasons she could not give the officer.",
#:   "The motorbike of the contrary way was first calm, then it did a strong acceleration and the distance to us was eaten in a second.",
#:   "Judging an approaching vehicle is difficult enough when he keeps a steady pace; this bus has just opened the taps, so the hole you saw is shrinking.",
#:   "From ahead the coach comes toward the robotaxi at normal pace and then all of a sudden goes for it, leaving far less time than it seemed.",
#:   "There was a lorry coming down the hill on its own side, nothing unusual about it. Then I heard the engine roar and saw it heave forward, faster and faster towards me. The space I had been counting on was gone before I could do anything.",
#:   "V2 was approaching V1 from the opposite direction at a moderate speed. Approximately fifty metres before the vehicles met, V2's event recorder shows the throttle going to full and the speed rising steeply, which cut the time available to V1 to about half.",
#:   "Our gap estimator assumes constant velocity for opposing traffic, so let's break that. Spawn a motorbike coming the other way on its own side, wait until it is at the trigger distance, then pin its throttle so that it reaches us much earlier than predicted.",
#:   "In India we flash the light and then we speed up, it means I am coming, you wait. This car from opposite side also did so: it was coming gently, suddenly he has pressed full accelerator, and no gap was remaining.",
#:   "You know how a dog will trot towards you and then break into a run? The minibus did that. It had been trundling up from the far end of the village, and all at once it picked up its skirts and came flying at me.",
#:   "Opposite number suddenly gets a move on; our gap's gone.",
#:   "Van from up ahead floors it, the distance between us crumbling.",
#:   "He came at a stroll from yonder, then at a gallop.",
#:   "I'd done the sum for the coach at its old speed; it changed the sum by putting on a spurt straight down its own side.",
#:   "Opposing traffic element to maintain speed until the set separation from the ego, whereupon full accelerator is applied, the time to meeting dropping accordingly.",
#:   "Were you aware, when you pressed the pedal to the boards, that my client was coming the other way and needed that space?",
#:   "The two-wheeler from opposite was coming normal, normal, and then he twisted the accelerator fully and reached me in no time.",
#:   "A hatchback heading our way on the other half of the road was seen to dig in and come on a great deal quicker.",
#:   "oncoming lorry had miles of room between us then he went for it for some reason and there wasnt any room anymore",
#:   "The headlights had been the size of peas for a while, and I remember thinking there was heaps of time. Then they began to swell, much faster than peas ought. Whoever was in that saloon at the other end of the straight had put the hammer down, and in a few seconds it was upon us.",
#:   "Vehicle 2 was northbound, facing Vehicle 1, at a recorded 31 km/h. With the vehicles about 60 metres apart the operator applied full throttle, so he says, in order to \"get it over with\". The available interval was reduced from four seconds to little more than two.",
#:   "You can hear a diesel long before you can feel it. This one was idling down towards us from the top of the village, chuff, chuff, chuff. All of a sudden it was bellowing, the black smoke stood up out of the stack, and the cement lorry ate the road that was left between us.",
#:   "We're at a narrow spot and I tell my learner, you've time before that bus if it carries on like this. Well, it hasn't carried on like this. It's picked its feet up and it's coming at us hell for leather on its own side, so we haven't got time now, and we stay put.",
#:   "The prediction horizon is where it breaks. At frame zero the opposing motorcycle is due at the meeting point in 5.1 seconds; at frame ten, according to the same tracker, in 2.6. In between lies nothing but a wide-open throttle, with the bike's path down its lane as straight as ever.",
#:   "My neighbour says I exaggerate. But a little red car was coming along from the other end of the lane as meek as you please, and when it saw me it hurled itself forward. I never knew a distance to get used up so quickly. I had to stand on my brake.",
#:   "The others were still tying their laces when the motorbike, coming towards the minibus, let out a howl and lifted its front wheel. It had been a speck with a murmur, far down the road on the other side; now it was a man in leather, getting bigger at a dreadful rate.",
#:   "I saw a chance, and the chance was closed by the taxi itself. He approached from in front, rather leisurely, on his part of the street. Exactly when it counted he has given full gas, and from the sixty metres, which I believed to have, remained after a blink perhaps twenty.",
#:   "Simulate for me an approaching bus which at first lulls the robotaxi with a constant speed. When the two are within trigger range the bus should accelerate as strongly as it can, holding its lane, so that the space the robotaxi had counted on evaporates before its eyes.",
#:   "What we'd like listeners to take away is that closing speeds lie. I had a pickup coming the other way, nothing to worry about. Some devil got into the driver, his bonnet rose, and from nothing-to-worry-about he turned into oh-my-God within a second and a half, all on his own side of the line.",
#:   "My brother's bike has a meter on it, so we know: from the moment we saw the van coming towards us to the moment it reached us was supposed to be six seconds. It was three. The van's engine had gone up the scale like a trombone and the space in front of us had simply folded.",
#:   "Opposite bonnet rears up; our gap goes in two seconds.",
#:   "Trundling towards us, the bus suddenly isn't trundling any more",
#:   "Opposing pickup: foot to the board, time to meeting halved.",
#:   "I'd begun to count down from six for the motorbike coming the other way, but with that burst of throttle he was there at three.",
#:   "The pitch of the approaching lorry's engine climbed by an octave, and what had been two hundred yards of daylight were very soon none.",
#:   "He'd been sauntering down his half of the road towards us until, of a sudden, his grille started to grow twice as fast.",
#:   "Was it my indicator that made the taxi at the other end of the street stoke its boiler and devour the distance that lay between us?",
#:   "Down its own lane the target shall draw nearer at constant velocity, whereupon a step to full throttle shall curtail the remaining headway.",
#:   "My margin was correct for the velocity which he had, señor, not for the velocity which he took when I was already counting with that margin.",
#:   "The echo under the bridge is what told me. There's a hum you get from a car that's coming at you at thirty, and it hummed, and I was content. Then the hum turned into something like a dentist's drill. I looked up from the map, and the headlights that should've been beyond the pub were on this side of it.",
#:   "We have a good long view there, and at the far end of it a cement mixer heading in our direction, no bigger than a matchbox. It's uphill for him, so you'd expect a snail. A great lump of smoke stood up out of the matchbox, and another, and before I'd finished my sentence about snails I could read his plate.",
#:   "The kid in the hot hatch that's facing us won't have you get across first if he can help it. Watch the front of his car. There, it came up, didn't it? That's his right foot. He's staying in his lane, nothing wrong with that, he is just getting here much sooner than he'd led you to believe.",
#:   "It's in the nature of a wide road that one trusts it. He had seen the bus on its way down to meet him, small, sleepy, far over on its own side, and had trusted that too. What he next saw was the same bus with the sleep gone out of it, eating up the lamp posts by twos, by threes.",
#:   "My passenger's shopping list stops at \"eggs\". She'd been reading aloud while we waited to see how quick the scooter was that was coming up the other half of the road, and the answer was: not very. At \"eggs\" he must've wrung its neck. It screeched, he lay down flat, and she saw his teeth instead of writing \"flour\".",
#:   "Range to the opposing truck was 140 m with a closing rate of 18 m/s. According to this we had nearly eight seconds. The closing rate then went to 20, 23, 27, with our own speed held constant and the truck's heading unaltered, so the eight seconds were used up in just over five. The ego aborted.",
#:   "There wasn't anything the matter with where he was. He kept to his side; it was the rate at which he stopped being far off. As long as he was level with the orchards he'd come on like a hearse, I could have gone and come back. Past the last tree he jumped on it, and going was out of the question.",
#:   "The two drivers' accounts agree on the position of V2, in the lane opposite, and on its initial speed, which was moderate. They also agree that V2's driver then \"gave it some\". He said that he wanted to clear the narrows. As a consequence the interval that V1's driver had judged ample was, in her words, \"there and then not there\".",
#:   "A lorry driver has plenty of time to think, and what I thought was: lad, you've got a red van coming at you, steady as a rock, you're all right for this. It's then he sank at the back. They sink at the back when they're given the beans. No steady rock after that, more of an avalanche, down his own side.",
#:   "Every morning I face the same white Polo on my way to the bakery, she goes left and I go right of the line, and we're both half asleep. This morning she wasn't. Halfway along the straight her exhaust barked, I mean barked, and all the road I'd thought I had was underneath her wheels.",
#:   "Gentlemen of the jury, picture a telescope. With the large end to your eye, you see a motor-cycle upon its proper side, remote, in no haste. Let someone now turn the telescope about! With no more warning than that the rider, by opening his throttle to the stop, abolished the distance upon which the plaintiff had relied.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "accelerate"]
#: position = "oncoming"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.5
#: high = 3.0
#: unit = "m/s"
#: meaning = "how fast it drives at first"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 45.0
#: unit = "m"
#: meaning = "distance to the ego at which it accelerates"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_SPEED = Range(0.5, 3)
param OPT_ADV_DISTANCE = Range(10, 45)
param OPT_THROTTLE = Range(0.5, 1)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE)
