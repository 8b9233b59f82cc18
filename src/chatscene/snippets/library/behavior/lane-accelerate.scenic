#: description = "The car suddenly accelerates and closes the gap."
#: rephrasings = [
#:   "A vehicle speeds up so that the ego cannot move in.",
#:   "The adversary puts its foot down without warning.",
#:   "The neighbouring car surges forward beside the ego.",
#:   "The driver next door floors it and shuts the opening.",
#:   "The motorbike rushes ahead at full throttle.",
#:   "The moment we want over, he puts the hammer down.",
#:   "Vehicle 2 increased its speed considerably in the adjacent lane.",
#:   "It gives much gas and then there is no more hole for us.",
#:   "I went to move over and the bloke floored it to shut the door on me.",
#:   "Unit 2 sped up without warning, eliminating the space available to Unit 1.",
#:   "Truck in next lane, sudden gas, gap gone.",
#:   "The target vehicle abruptly increases its speed such that the available gap diminishes to zero.",
#:   "The bus goes suddenly faster, and there is no more place for me.",
#:   "Gap-closing actor: a > 0 as soon as we go for the slot, denies the merge.",
#:   "There had been room enough, but the rider opened the throttle and swallowed it up before she could take it.",
#:   "You had your gap there and he's just put his foot down and stolen it, so stay where you are.",
#:   "i had the gap n then he just sped up so i couldnt get in, so petty",
#:   "A driver picked up speed all at once and denied the other car the space it was making for.",
#:   "The opening was there, and you, sir, by quickening your pace, extinguished it.",
#:   "I wanted to filter, then the lorry purposely chiong to close the space.",
#:   "Moment I fancy that slot he perks up and plugs it, never fails.",
#:   "Loss of available gap owing to sudden speed-up of neighbouring vehicle",
#:   "SEES MY BLINKER, SPEEDS UP",
#:   "The bus quickens and squashes the gap.",
#:   "I had a nice space beside me till the van gunned it.",
#:   "Lorry alongside suddenly gets a wriggle on, and the hole's gone.",
#:   "Adjacent vehicle: step in throttle, closes available opening.",
#:   "Get the neighbouring bike to spurt forward and fill the space.",
#:   "Was that really necessary, tearing forward to stop anyone getting in?",
#:   "No sooner had a gap appeared in the next lane than the taxi there leapt forward and left us nothing but its rear door to look at.",
#:   "The adjacent target, until then at matched velocity, shall be commanded to full throttle so that the space ahead of it vanishes.",
#:   "The bus had been keeping company with us, then out of nowhere the driver gave it the beans and there was no room in that lane any more.",
#:   "V2, which had travelled parallel with V1, gained speed rapidly and thereby eliminated the interval between itself and the vehicle preceding it.",
#:   "The lorry on the other lane, when he sees the hole, he pushes the gas and the hole is finished, nobody enters.",
#:   "I'd like a saloon next to the AV that out of the blue quickens its pace hard, so that whatever opening there was is taken away.",
#:   "You could see him clock it. There were two car lengths free in his lane, he glanced over, his chin went down, and then that Audi simply charged up the lane until you couldn't have slid a newspaper into the space that was left.",
#:   "I told the officer it wasn't really an overtake. The motorcycle was running next to the robotaxi, quite peaceful, and then its engine screamed and it hurtled up its own lane to the bumper of the car in front, so nobody could get in.",
#:   "Now, that was a lovely opening, and you did well to look for it. But listen to his engine: he's winding it up, he's racing forward, and the door is closed. Some people can't bear to let anyone else have anything.",
#:   "The lady from number nine doesn't like sharing. We were side by side, with a bit of tarmac free in front of her, and all at once her little car bounded forward and gobbled it up, and she stared straight ahead as if butter wouldn't melt.",
#:   "Podcast listeners keep asking about meanness on the road, so here's mine. A truck beside us, cruising, loads of space before his bumper, and the second that space looked useful to anyone, black smoke came out of the stack and he thundered up to shut it.",
#:   "Neighbouring lorry spurts; the slot in front of it is history.",
#:   "Motorbike beside us winds it on and fills the hole.",
#:   "that space was THERE, then mr bmw next lane found his right foot",
#:   "Had the bus alongside carried on as it was there would've been room, but it picked up its skirts and ran up to the car before it.",
#:   "The agent travelling abreast applies full throttle without preceding indication, whereby the longitudinal clearance ahead of it is reduced to nil.",
#:   "Hear that? The van next to us has dropped a gear and he's charging up to the one in front, so that space no longer exists.",
#:   "The taxi at my side was tranquil until that moment; then he pressed the pedal to the floor, and the free place before him was not free any more.",
#:   "When is a gap not a gap? When the pickup in the next lane lunges forward like a terrier and plants itself in it.",
#:   "Neighbouring-lane vehicle to hold station at first, then, without warning, to go to maximum acceleration and use up the opening ahead of itself.",
#:   "I'd had one eye on that bit of empty lane for a quarter of a mile, and I think she knew it. There was a snarl from beside me, the Mini's back end squatted, and by the time I looked again its front bumper was where the empty bit had been.",
#:   "All we changed in this variant is the throttle. The coach keeps pace in the neighbouring lane, exactly as before, but at the trigger it goes from cruise to everything it's got, and the lane ahead of it, open a moment ago, fills up with coach.",
#:   "Three car lengths there were between the tanker on our left and the one it was following; I could have drawn you a picture. Two, one, none. I could hear the turbo whistling while it happened, and the tanker's driver gave me a little nod as he drew ahead up his lane.",
#:   "It's possible he never noticed us. He might have been late for a train; at all events the motorcyclist, who'd been riding next to the robotaxi with half a street free before him, suddenly screwed his throttle right open and was on the tail of the next car.",
#:   "Neither car left its lane, that's agreed. The defendant had been level with the plaintiff and doing the same speed as she was; and the instant the plaintiff had need of the space ahead of him, he put on such a burst of pace that it vanished.",
#:   "A hand's breadth, that's what was left of it. My dad had said look, there's space over there in front of the black car, and as though the black car had ears it gave a roar and rushed up till its nose nearly touched the next one.",
#:   "Note the change in engine sound at 0:17. Up to then the SUV in the adjacent lane is in step with us and there's air in front of it; after that it pounces, the air's gone, and our planner withdraws its request for the slot.",
#:   "I was on the top deck of the 43, front seat, so I had the full view. Our driver had been dawdling along next to a grey hatchback, loads of clear lane before us. Then my stomach went backwards, and we were tearing up to the cab ahead as if to shut somebody out.",
#:   "Truck drivers have feelings too. I've sat level with somebody, kept my distance to the one in front, and watched them eye it up like it was for sale. So yes, on Tuesday I put my boot right down out of the blue, and that distance went.",
#:   "The tail-lamps of the van in front of him had been far away and were now so near that they reddened his bonnet. All this in the space of a breath, because he, who had ridden along quietly by her side, had suddenly chosen to hurl his motor car forward.",
#:   "Many years I am driving in Shanghai and I know: if there is a place, somebody eats it. The white car next to me had a big place in front. He saw, he stepped the gas very sudden, and the place was eaten.",
#:   "That hole beside us just got filled by a roaring van.",
#:   "Full throttle next door, and the slot is no more.",
#:   "Nice space you had there; listen to him eat it.",
#:   "The pickup alongside dropped two gears, sat back on its haunches, and the free road before it shrank to nothing.",
#:   "Two seconds earlier you could have berthed a bus in front of that bus, but it had lunged up to the car ahead at full power.",
#:   "Let the moped which rides level with us wring its throttle, out of the blue, until there isn't any room left between it and the van in front of it.",
#:   "I'd had a good thirty metres in the next lane to move into; there came a burst of revs beside me, and I had three.",
#:   "The clearance forward of the neighbouring coach declined from 28 m to 4 m within three seconds, the coach having changed from steady cruising to maximum drive.",
#:   "I see a free place right of me, and the man near it, he sees that I see; his motor cries, he jumps forward, finished is the place.",
#:   "Something in the sound of the street changed, and it took me a moment to know what. It was the taxi by my side, which had purred along with me since the bridge. It was purring no longer. It went up its own lane like a thing stung, and when it had done there was no daylight in front of it.",
#:   "He told the policewoman that it was a free country. It is, and he may drive up to the car ahead of him if he likes. But he'd dawdled at my elbow for a mile with a cricket pitch of empty lane before him, and the very second that I had a use for it he rammed his foot to the floor.",
#:   "The merge request was withdrawn at 17:02:11. At :09 there were 31 metres to the front of the neighbour; the neighbour then, with no prior sign, went to a longitudinal acceleration of 3.5, staying in its own lane, and by :11 there was a car length at most. We remained where we were.",
#:   "Black smoke is a message too. It rose from the stack of the lorry that had been ambling abreast of the little grey car, and it meant that the driver had put his boot in. The grey car's blinker was ticking for a space that by the next lamp post had forty tonnes in it.",
#:   "Watch his front wheel and not the gap, since the gap can't tell you what it's about to do. See it lift? He was perfectly level with us, that biker, and now he's off up his lane like a greyhound, and your lovely gap has become his back wheel and somebody else's bumper.",
#:   "It's petty, I know, but I'd like it minuted. We were travelling side by side at one speed. There was space before the other car, of which I make no secret that I was thinking. Its exhaust barked, it shot forward in its lane, and it came up against the bread van with, I'd say, a metre to spare.",
#:   "We kids were cheering. There was a red sports car in the next line, going just as fast as us, and there was a long empty piece in front of it. Dad said he'd pop in there. And the red car went VRRRM, all by itself, and ate the empty piece all up, and Dad said never mind.",
#:   "Would a second earlier have helped? I doubt it; the man was waiting for it. His head had been turned to me as we rolled along door by door. It turned to the front, his shoulders went back into the seat, and the whole car was flung up the lane until you couldn't have parked a pram before it.",
#:   "She was so used to the bus's company that she looked up when it went. It had kept by her window ever since the park, its dull flank steady as a wall; now with a bellow the wall was sliding forward, quicker and quicker, and the opening at its head, her opening, was closing like a drawer.",
#:   "Trucker's diary. Ten past five, slip road traffic about, everyone wanting everyone's slot. The artic on my right had left plenty before his cab. He'd matched me for miles. Some devil got into him and I heard the turbo wind right up, and from my mirror I watched his slot go from four lengths to none.",
#:   "In Delhi the gap is like a sweet kept outside, it cannot remain. On my side one Scorpio was going, same speed like me, and in front of him big space, free of cost. I only looked at it. He saw my looking! Race he gave, full, and that space he finished in two seconds.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: leader = false
#: actions = ["accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_THROTTLE = Range(0.5, 1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE)
