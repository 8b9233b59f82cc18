#: description = "The car behind tailgates the ego, weaving from side to side to get past."
#: rephrasings = [
#:   "The hothead behind sits on our bumper and swings left and right looking for a way by.",
#:   "Vehicle 2 followed closely while swerving repeatedly within the lane.",
#:   "Tailgater, snaking, trying to pass.",
#:   "The target follows the VUT at short distance with lateral oscillations.",
#:   "He is near behind us and goes left, right, left, he wants to pass.",
#:   "A motorbike sways in our mirror, now this side, now that.",
#:   "A van dances on our tail, peering round one flank and then the other.",
#:   "Impatient, the taxi to our rear wags to and fro at our bumper.",
#:   "This nutter in a BMW was right up my chuff, dodging left and right looking for a way by.",
#:   "Vehicle 2 was observed following closely and moving repeatedly from one edge of the lane to the other in an attempt to pass.",
#:   "Car at rear, bumper to bumper, zigzagging, wants past.",
#:   "The following vehicle keeps minimal distance and oscillates laterally within the lane, seeking an opportunity to overtake.",
#:   "The motorbike behind me goes left, right, left, very close, because he wants to go before me.",
#:   "Chaser in rear snakes about at tiny headway, peeking out both sides but never actually gets by.",
#:   "She saw its headlights swing from one mirror to the other; it would not settle, it hung on her bumper and hunted for a gap.",
#:   "Chap behind is getting impatient, see him ducking out one side then the other, practically in your boot.",
#:   "this guy behind me is literally slaloming trying to get by, like chill",
#:   "A car rode close behind the family and darted from one side to the other in its hunt for a way through.",
#:   "The defendant, by his own account, hung at the rear of the vehicle and swung out repeatedly, first to one side and then to the other.",
#:   "One bike is behind me only, sometimes left, sometimes right, he is having so much of hurry.",
#:   "Muppet's filling both my mirrors in turn, left one, right one, like he's doing a flipping waltz back there.",
#:   "Close-following vehicle with alternating lateral displacement in search of a passing opportunity",
#:   "IMPATIENT BIKER CAN'T PICK A SIDE, dances behind me for miles",
#:   "The car at our tail jinks to and fro.",
#:   "Idiot glued to my boot, poking out left, then right, won't settle",
#:   "Make the follower crowd the AV and slalom restlessly, itching to overtake.",
#:   "Traffic 51, you've a hatchback on your bumper, wandering side to side, wants by.",
#:   "Close-up in rear stop swaying stop driver evidently seeks to overtake stop",
#:   "Mummy, that car's nearly touching us and it keeps wiggling!",
#:   "I want a scene where a saloon rides inches off the ego's rear and swings back and forth, eager to slip by.",
#:   "For about half a mile the motorcycle kept almost no distance from my tailgate, showing up first in the offside mirror and then in the nearside one.",
#:   "V2 was trailing V1 at less than one car length and made repeated lateral excursions in both directions, apparently searching for an opportunity to go around.",
#:   "An ambulance sits on the robotaxi's heels, grille filling the rear camera, edging out to either side by turns because it can't squeeze through.",
#:   "Don't be rattled by the chap at your back who's nearly in your boot; he's bobbing from one side to the other hoping for a gap, just hold your line.",
#:   "The auto behind is sticking on me and drives in snake lines, always pushing, he searches the hole for overtaking.",
#:   "I was doing a steady fifty when a black coupé came right up to my number plate. It never fell back; it just kept lurching toward the verge and then toward the centre line, the driver craning his neck to see a way round me.",
#:   "My client felt hounded. The other driver hung so near that his headlamps vanished beneath her rear window, and all the while he tacked left and right like a man trying to see past a tall hat at the theatre.",
#:   "Ticket 4471: rear-chaser scenario. Agent locks on at a very small gap, holds it for some seconds, then starts a sinusoidal motion behind us as if probing both flanks for a pass. It stays to our rear throughout; our planner must not panic-brake.",
#:   "At my age you don't like being hurried. This young man on a motorcycle was so near that I could hear his engine over my wireless, and he kept drifting out one side and then the other, fidgeting to go by.",
#:   "The clip shows what pushing looks like: the SUV is practically on the tow bar, and its nose appears on the left, ducks in, appears on the right, ducks in again. You can tell how desperately he wants in front.",
#:   "Hatchback breathing down our neck, snaking about, aching to get in front.",
#:   "Police motorbike shadowing us bumper-close, headlamp swaying kerbside, centreline, kerbside, can't get past.",
#:   "nobody needs you up my exhaust doing S-bends mate, there's no room",
#:   "The following PTW shall maintain a gap below one metre for three seconds and thereafter oscillate about the VUT's lateral position as if seeking a passage.",
#:   "Grandad, the blue car at the back is almost touching us and it's wagging like a fish because it wants to be first!",
#:   "Can you give me an ambulance that crowds the rear of the AV and keeps leaning out, now left, now right, on the lookout for a hole?",
#:   "In the back-glass I have only seen his radiator, and this radiator wandered from one corner of the glass to the other, since he was searching how to overpass me.",
#:   "Unable to find a way round, the motorcyclist rode within arm's length of V1's rear plate while shifting repeatedly from the left wheel track to the right one.",
#:   "Caller reports a white Transit hugging her back end and slewing about from side to side; driver evidently wants the road ahead of her.",
#:   "My mother counted the headlights in the rear window, one, two, one, two, because only one could be seen at a time. Whoever it was drove so close that we dared not touch the brake, and he kept showing himself at one flank and then at the other, desperate to be let by.",
#:   "There were roadworks for six miles and no room for anybody to pass, which most people accepted. The chap in the convertible didn't. He came up until I could read his tax disc backwards, and from then on he swam to and fro behind me like a shark in a tank.",
#:   "The dent in the tow bar was not caused by me braking. The other party had been driving practically under my spare wheel since the bridge, and as he tacked back and forth hunting for a gap he lost count of how near he really was.",
#:   "Ticket 5120, rear-agent aggressiveness. The rear radar shows the gap locked at about a metre, and then the azimuth of the same object swinging plus, minus, plus, minus. It's looking for a way round the ego and never finds one; no lane change, no actual overtake.",
#:   "Don't speed up for him. I know his lamps are filling first one door mirror and then the other, and I know you could shake hands with him through the rear window, but wanting to get by is his problem and not yours.",
#:   "We had a sick child on the back seat and weren't hurrying. A motorcycle arrived at our bumper, stuck there as though on a rope, and tilted over to the verge side, to the middle, to the verge side again, its rider stretching to see what lay in front of us.",
#:   "What struck me from the pavement was the shadow. It was evening, the two cars were running nose to tail, and while the front one's shadow went along straight, the second one's kept swinging out and back on either side like the tail of a kite, for the man plainly wished to be ahead.",
#:   "The claimant says she felt pushed. For the length of Canal Street there was never more than a metre between her boot and the fire officer's car, which lurched towards each edge of the lane in turn; that its driver meant to overtake, and could not, is common ground.",
#:   "Am driving 22 years in Pune, I know this type. He will come till his number plate is kissing your dicky, then he will show his face from left side, show his face from right side, horn horn horn, and still no place for him to go.",
#:   "Every time I glanced up there was a helmet in a different mirror. Not once did it drop back to a sane distance, and not once did it find the opening it was hunting; it merely rocked from edge to edge a foot off my panniers, mile after mile.",
#:   "Title: \"Impatient much?\" The rear cam shows nothing but grille for a good while, then the grille slides out of frame on the left, comes back, slides out on the right, comes back. Spoiler: he never does find the space to pass us.",
#:   "Rear window full of radiator, and the radiator won't hold still sideways.",
#:   "Motorbike inches behind, headlamp in left mirror, right mirror, left mirror again.",
#:   "He's practically aboard us, leaning out kerbside, then middle, desperate to be in front.",
#:   "The scooter stayed so near our tail that its rider's visor reflected our brake lamps, and it wandered from edge to edge of the lane, begging for a hole.",
#:   "Set a police car on the AV's heels with hardly a metre between them, then let it swing restlessly from flank to flank as if hunting for room to get round.",
#:   "The distance to the vehicle at our rear stood at 0.9 m while its lateral offset changed sign every second or so; it never did come out to pass.",
#:   "Don't look so often, dear; yes, he's close enough to kiss the number plate, and yes, he's popping out one side and then the other, but he can't get by and he knows it.",
#:   "V2 maintained a following distance of less than one metre to V1 and was repeatedly steered toward either lane boundary, its driver evidently wishing to go by.",
#:   "Mein Hintermann has no patience: he hangs on my exhaust and swims the whole time left and right, because he searches where he can come past.",
#:   "My daughter was doing her hair in the rear-view mirror, which I'd allowed because nothing was moving in it. Then she said there was a man's face in it, enormous, and that it kept sliding out of the one side and coming back in at the other. He wanted round us, you could feel it.",
#:   "You can hear it on the tape. There's our engine, and there's a second engine hardly farther off than our own boot lid, and that second one pans across the stereo: left speaker, right speaker, left speaker. It's a motorcyclist who'd dearly like to be ahead of us and has nowhere to do it.",
#:   "When I touched the brake for a squirrel the fellow very nearly came in through the tailgate, for he'd left himself no room at all. He had been far too busy peering, now past my offside and now past my nearside, the whole nose of his car going with his neck, to bother about distance.",
#:   "We couldn't open the gap however gently we sped up. Whenever the robotaxi gained a metre the pickup took it back, and all along its lamps threw our shadow first onto the hedge and then onto the centre line, hedge, centre line, like somebody waving a torch for attention. It stayed behind to the end.",
#:   "The stain on the rear screen is tea. I'd turned round to see why the whole cabin kept lighting up, and it was an ambulance off duty, so near that I couldn't see its bumper, lolling out to the left of us, then to the right, trying each side for a passage and finding neither wide enough.",
#:   "Requirement 14: the rear agent shall first settle at a bumper gap of about one metre for three seconds. It shall then oscillate sideways across the width of our lane with a period of some two and a half seconds, as an impatient driver does who probes both flanks. A completed pass is not wanted.",
#:   "It's always the same three miles, no passing place and a wall either side. On Sunday it was a red convertible. I never saw its wheels, it was that near, but I saw its wing come out beyond my left light, go in, come out beyond my right one and go in, till the very last bend.",
#:   "There was, the constable wrote, no room for a cigarette paper between them. The second driver appeared to be seeking a way round by trial and error, showing the nose of the cab to oncoming traffic, withdrawing it, showing it to the ditch, withdrawing it, and so on as far as the toll house.",
#:   "From the top deck I'd a grand view down on the two of them. They might have been coupled, like a tram and its trailer, only that the trailer wouldn't run straight; it slewed to this side, to that side, because the chap driving it was hungry to be the tram.",
#:   "Breaker, you've a bike in your draught so close you'll not find him in one mirror for more than a second. He'll show left, then he'll show right. Wants by, hasn't the road for it, and won't drop back either, so no sudden braking please.",
#:   "Sir, this fellow was not having patience at all. Between his bumper and my dicky one newspaper only could go, and like a snake-charmer's cobra he was shaking behind me, this side, that side, where is the place, where is the place, and place was nowhere.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: place = "road"
#: actions = ["tailgate", "weave"]
#: position = "behind"
#: [[parameters]]
#: name = "OPT_ADV_GAP"
#: low = 0.6
#: high = 3.0
#: unit = "m"
#: meaning = "how much room it leaves between its bumper and the ego's"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.8
#: high = 7.6
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 0.8
#: high = 1.2
#: unit = "m"
#: meaning = "how far it swings to either side"

param OPT_ADV_GAP = Range(0.6, 3)
param OPT_ADV_SPEED = Range(6.8, 7.6)
param OPT_ADV_AMPLITUDE = Range(0.8, 1.2)

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 12) for 3 seconds
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, 2.6) until headway(advTrajectory, self, ego) < (ego.length + self.length) / 2 + 0.3
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 12)
