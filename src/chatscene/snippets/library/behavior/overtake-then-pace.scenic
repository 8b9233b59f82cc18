#: description = "The car comes up from behind, overtakes and then eases off to hang beside the ego's front."
#: rephrasings = [
#:   "He passes us halfway out and then just hovers off our front wing.",
#:   "Vehicle 2 overtook vehicle 1, reduced its speed and travelled alongside its front.",
#:   "Passes, then matches speed just ahead in next lane.",
#:   "The target overtakes the VUT and then keeps station abreast of its front end.",
#:   "He goes before us and then waits near, always the same speed.",
#:   "The truck creeps past and then can't or won't get clear.",
#:   "A biker rolls by and lingers diagonally ahead, looking at us.",
#:   "Having gone by, the coach loses interest and loiters alongside.",
#:   "He caught me up, nosed ahead, then backed off the gas and just hovered by my front wing.",
#:   "Unit 2 approached from the rear, passed, then reduced speed and remained abreast of Unit 1's front fender.",
#:   "Moto passes, eases, hangs at our front corner.",
#:   "The target vehicle overtakes and thereafter reduces its speed to remain adjacent to the front of the test vehicle.",
#:   "The car comes from behind, goes past, then is slower and stays next to my front.",
#:   "Overtaker drops to ego speed once at our front corner and sits there, blocking a lane change.",
#:   "It came up from the rear and edged ahead, and there it lingered at her headlamp as though keeping her company.",
#:   "Police unit is coming by you, he's eased off now and he's riding by your front wheel.",
#:   "he sped up past me then slowed down to sit right by my headlight, creepy af",
#:   "After going by, the car slackened off and kept station at the other's front corner.",
#:   "You drew past, and rather than proceed, you abated your speed so as to remain off my client's bow.",
#:   "This car overtook half and then reduced speed, just staying near my front door side.",
#:   "Goes by me and then can't be bothered, just loiters off my front corner like a pilot fish.",
#:   "Station-keeping of overtaking vehicle beside own front after speed reduction",
#:   "OVERTAKES, THEN REFUSES TO LEAVE - lurks by my bonnet",
#:   "The motorcycle edges past and then loiters at our front flank.",
#:   "Taxi goes by from behind, throttles back, sits at our front wing.",
#:   "Follower passes the ego on the side, then matches speed off its nose.",
#:   "It overtake me and then stay all time at my front wheel.",
#:   "Having reeled us in and passed, the rider dawdles beside our bonnet.",
#:   "From rear, past, then station kept abreast of the robotaxi's front corner.",
#:   "A sports car appeared from the back, drew past in the next lane and, when its boot was level with my headlamp, settled down to my speed.",
#:   "Once the motorcycle that has come up from behind is ahead by a nose, let it roll off the throttle and accompany the AV's front end.",
#:   "I can't be doing with folk who hurry up behind you, go by, and then slacken and ride along next to your bumper for miles.",
#:   "The overtaking vehicle ceased to gain on V1 as soon as its rear axle was opposite V1's headlights, and there it stayed, at V1's own speed.",
#:   "Don't move over, Priya. That cab has overtaken you, yes, but he has come off the gas and he's lodged next to your front wing.",
#:   "What is the use of overtaking somebody, as this motorcyclist did, only to cut your speed and cruise along by his front tyre?",
#:   "I was pulling thirty tonnes and he came up my offside like a rocket, a little white Fiat. The moment his back end was level with my front bumper he came off it, and there he hung, in the next lane, right by my front corner, same speed as me.",
#:   "The target starts behind the ego in the lane adjacent to it, travelling faster. It passes the ego. As soon as it leads by the prescribed offset its speed is regulated to that of the ego, so that it continues next to the ego's front without entering its lane.",
#:   "We'd heard it a good while before we saw it. The motorbike came up out of the noise behind us, slid along our windows from the rear one to the front one, ran out of hurry beside our headlamp, and there it purred, no faster and no slower than we.",
#:   "Your Worship, I was in the left lane. The defendant came from behind in the right-hand one and overtook me, which is his right. But then he reduced his speed and stayed alongside the front of my car, so that I could neither see the junction nor pull out.",
#:   "Weirdest thing on the motorway yesterday. A saloon comes steaming up behind, goes past on the outside, I expect him to be gone, only he lifts and stays there with his rear door next to my headlight, minute after minute. Never came in, never went on.",
#:   "Up from the rear, past us, then lingering off our front wing.",
#:   "Bike passes the AV, rolls off, shadows its headlight.",
#:   "cab overtakes then eases down and camps at my front corner",
#:   "A hatchback reeled us in, went by in the next lane and, instead of clearing off, took up our speed with its rear bumper opposite our front wheel.",
#:   "He shot out of my blind spot, got his tail level with my headlight, came off the gas and has been floating there ever since.",
#:   "The target, starting from the rear, passes the VUT in the adjacent lane; on attaining a lead of one metre it reduces to, and maintains, the VUT's speed.",
#:   "You can't move over now, love, that motorbike has come by you and then let his speed drop, and he's keeping himself right next to your bonnet.",
#:   "First from the back he came and he crossed me, okay, but then speed he's reducing, and side by side with my front tyre only he is going.",
#:   "Simulate a car which comes up on the ego from the back, draws a little ahead in the lane alongside and then throttles down to match it.",
#:   "The baby likes motorbikes, so we had a running commentary. There he is in the back window, there he is at baby's window, there he is at mummy's. And there the commentary ended, as he'd shut off and wasn't going anywhere else; for miles his back wheel turned alongside our front one, neither faster nor slower.",
#:   "I was being boxed in, I'm sure of it. The Audi had been a good way behind me and it passed me quickly enough, in lane two. No sooner had it done so than it was doing sixty-one, like me, with its boot a foot or so in front of my bonnet, and my exit was on the other side of it.",
#:   "In the polar plot of relative position the target moves up from six o'clock, along our left side, past nine. At about eleven it stops moving. The relative speed, until then plus four metres per second, has been trimmed to zero, and the dot remains at eleven until the end of the log.",
#:   "How did it feel? Like being followed by somebody in front. He'd made up on me from half a mile back and gone by the side of my lorry in one sweep, so I'd have bet on never seeing him again; but his brake lights blinked, and for ten minutes I'd his little roof next to my front bumper.",
#:   "Statement of the driver of Vehicle 1: \"I became aware of the sedan when it was approaching from the rear at a higher speed. It passed along my left side. When it was slightly forward of me it slowed and held that position beside my front fender, at my speed, preventing me from changing lanes.\"",
#:   "Nobody on the coach could sleep for that Harley. First it grew up behind us and then it thundered the whole way along our windows, and we thought, good, it's over. The thunder sank to a mutter, up by the driver's front corner, and there the mutter stayed, at our speed and in the next lane, as far as Reno.",
#:   "It isn't forbidden, sir, and still I'd forbid it. He came from behind, he got ahead of me by the length of a bonnet, his own, and having spent so much petrol on it he then lifted his foot. So there we go, he and I, as two oxen under one yoke, with his back seat next to my lamps, all the way to Nagpur.",
#:   "The overtaking was done as it is in books, mirror, signal, a clean run past on the outside. The ending they left out. The little red car let its speed bleed away as soon as its back wheels were in line with our front ones, and so we proceeded, like two ladies arm in arm, until my grandson took the slip road.",
#:   "Clip title: the world's laziest overtake. A silver Skoda enters stage left from behind us, it gains, it gains, its number plate draws ahead of our lights. Then it loses interest and gains no more; that number plate stays in the very same corner of the frame, in the lane next to ours, for the other four minutes of the video.",
#:   "Monsieur, he arrives by the back like a rocket, he doubles me on the left, I think bon voyage. But when he has his tail beside my lantern he lifts the foot. After, he stays at this place, same speed like me, he doesn't enter in my lane and he doesn't go away, and I can't see anything to the left.",
#:   "The convoy rule would cover this. The motorcyclist, having overhauled our robotaxi from the rear, should've opened up a safe distance; what she did was to shed just those few miles an hour which she'd had in hand. She kept abreast of its front end in the neighbouring lane, as an outrider would, and every attempt to change lanes was cancelled.",
#:   "From behind, by us, then glued beside our headlamp.",
#:   "Biker overhauls our cab and then idles at its front corner.",
#:   "Passed us, lost interest, hovers level with our front wing.",
#:   "The taxi that I'd watched grow in my mirror went by, and would have been gone, only it came off the gas and is still here, next to my headlight.",
#:   "Actor: begin behind in the adjacent lane at higher speed, draw ahead by the set offset, then match ego speed and hold that place beside its front end.",
#:   "he comes flying up from behind, goes past one lane over, then slows to my exact speed and camps there, back bumper by my headlight, 10 min",
#:   "From the back he has made overtake with so much show, and now, by the side of my bonnet, he's going same like me, neither front nor behind.",
#:   "For all the hurry in which that motorcycle had come up on us and gone by, it had none left by our front wheel, where it stayed and stayed.",
#:   "Why race up the outside of a lorry, get your tail past its nose, and then lift and sit there at the lorry's speed, in the next lane?",
#:   "There's an order in which an overtaking car leaves you: mirror, side window, windscreen, distance. This one got as far as the edge of the windscreen. It had come up the outside from a long way back, and I'd said goodbye to it, so to speak. It then shed whatever it had had in hand, and I'd its rear light beside my left front corner from Northampton to the M1.",
#:   "My passenger's conversation dried up because of him, you can't talk next to a thing like that. He'd been a throb at our back, he was a roar at our windows. By rights he should've become a throb in front. No, it stayed a roar, a smaller one, at the height of our headlamps in the outside lane, as he'd shut the throttle till he was doing our sixty.",
#:   "Consider lane-change availability as a function of time. It's free; the target, on its way up from the rear in the adjacent lane, makes it unavailable; it ought to become free again two seconds later, when the target has gone by. It does not. The target has slowed to our own speed with its tail beside our front axle, and remains there for the last 41 s.",
#:   "It was the shadow on my bonnet I couldn't bear. The sun was low on the off side. A shadow had come along the car from the boot to the front, quite briskly, and in the ordinary way it would've slid off and been the next car's. This one lay down on the bonnet and remained, mile upon mile, for he'd slowed himself to suit me in his lane there.",
#:   "You don't owe that coupe anything, so don't speed up for it and don't slow down for it. It made up half a mile on you, it came past you, and then it found that it wanted company. So it's doing your fifty-five, with its back door about in line with your front wheel, over there in its own lane, and your exit is just going to have to wait.",
#:   "Asked why he hadn't moved over for the stranded van, the truck driver said there'd been a car in the way, in lane two. It had passed him, coming from behind. He'd seen its boot draw level with his bumper and then go no farther, the speeds being the same from that time on; and it was hanging there when he reached the van.",
#:   "I've always been a slow driver and I'm used to seeing people's backs. So when the little sports car had come up and gone round me in the other lane I waited to see its back. I saw about a third of it. Whoever it was had taken their foot off just there, and we rolled into Bournemouth side by side, I and that third of a sports car.",
#:   "He was faster than us, then he wasn't, that's the whole of my evidence. While he was faster he came from behind the coach, along the whole row of windows, past the guide, past the driver. When he wasn't, he was at the driver's headlight, in the lane alongside. I've a photograph of him there by the castle, and one by the lake, and one by the cheese factory.",
#:   "In India overtaking is a compliment, it says you're worth the diesel. This fellow on his Pulsar gives me the full compliment, from far back he comes, horn and all, by my side, beyond my door. And there his petrol is over, or his courage. He is closing the throttle, and next to my front mudguard he is running at my speed like a peon with an umbrella.",
#:   "V1 and V2 occupied adjacent lanes. V2's closing speed from the rear was 14 mph and fell to zero at the point where its trailing edge led V1's front bumper by eleven inches. The relative position was unchanged at the next three cameras, covering two miles, V2 having neither entered V1's lane nor drawn clear.",
#:   "The headlights had come up out of the dark behind, they'd swept along her ceiling and gone ahead, as headlights do, and she had looked forward to the dark. But the car to which they belonged relented, a little in front of her, over in its own lane. It let her have her speed and took the same; and so their two lights, side by side, went on.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advLane"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: place = "road"
#: actions = ["overtake", "pace"]
#: position = "behind-beside"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 12.0
#: high = 15.0
#: unit = "m/s"
#: meaning = "how fast it overtakes at most"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 5.6
#: high = 7.6
#: unit = "m"
#: meaning = "how far ahead of the ego it stays"

param OPT_ADV_SPEED = Range(12, 15)
param OPT_ADV_AHEAD = Range(5.6, 7.6)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, globalParameters.OPT_ADV_SPEED, 5)
