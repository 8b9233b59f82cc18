#: description = "The oncoming emergency vehicle races down the middle of the road."
#: rephrasings = [
#:   "ambulance with the blues on coming right down the centre line at us",
#:   "An emergency vehicle responding to a call approached at high speed, straddling the centreline.",
#:   "oncoming emergency veh, siren, fast, in the middle",
#:   "An oncoming emergency vehicle on duty passes with an offset toward the lane of the VUT at 45 km/h or more.",
#:   "The fire truck with siren is coming fast in the middle of the two lanes.",
#:   "A fire engine thunders toward us, half on our side.",
#:   "A police car forces its way through the traffic opposite, using a slice of our lane.",
#:   "The ambulance tears along between the lanes and expects us to squeeze over.",
#:   "a fire engine came at me straddling the white line, going hell for leather",
#:   "An ambulance responding at high speed traveled toward V1 along the center of the roadway.",
#:   "Oncoming police on centre line, fast, both sides squeezed.",
#:   "An oncoming emergency vehicle travels at high speed astride the centre line.",
#:   "The ambulance comes from front very fast and goes in the middle of the street.",
#:   "Blue-light NPC opposite direction: lateral offset onto the road centre, high v, doesn't swerve.",
#:   "It had taken the crown of the road for itself and came thundering at them, siren going, with a wheel on either side of the line.",
#:   "Engine's coming towards you right up the middle, going like the clappers; get yourself well in to the side.",
#:   "ambulance absolutely flying at us down the middle of the road aaaa",
#:   "A fire engine took the crown of the road at full tilt, scattering those it met",
#:   "The police car was travelling neither on its side nor on yours but along the centre, and very rapidly?",
#:   "Ambulance from opposite coming full speed in centre of road, everybody please move aside",
#:   "Blues and twos, bang down the white line at me, eighty if he's a day",
#:   "High-speed opposing emergency vehicle occupying the road centre",
#:   "Fire truck SPLITS THE ROAD coming at me full speed",
#:   "The police car bisected the road at full pelt against us.",
#:   "Blue lights dead ahead, hammering towards us along the centre line!",
#:   "Fire engine, opposite direction, flat out, riding the white stripe.",
#:   "Send an ambulance hurtling at the ego straddling both lanes.",
#:   "The police is coming against us with big speed exactly over the middle mark.",
#:   "Nee-naw truck zoomed at us right on the dotted line!",
#:   "A paramedic car was bearing down on me from the front with everything flashing, its wheels either side of the centre marking and its foot to the floor.",
#:   "The emergency vehicle target approaches the VUT at elevated speed, its longitudinal axis above the centreline, and keeps this lateral position throughout.",
#:   "Caution, the pump coming from the north is using the centre of the carriageway and he isn't hanging about, so tuck yourselves in as far as possible.",
#:   "V2, a patrol car on an urgent call, closed on V1 from ahead at great speed with half its width in either direction's lane.",
#:   "What's the ego supposed to do when an ambulance comes pelting towards it between the two streams, taking a bite out of both lanes?",
#:   "In the simulation please, one fire brigade vehicle coming from opposite, full speed, neither left side nor right side, just bang on the dividing line.",
#:   "Cars were squeezed against both kerbs, and down the alley between them came the rescue truck, siren howling, going faster than I've ever seen anything that size go. It was coming the other way, and it took a good slice of our side.",
#:   "I pulled my bus over as far as the parked cars allowed. The police car was racing to meet us right along the line in the middle, and its mirror went by mine with perhaps a hand's width to spare, at seventy or more.",
#:   "An ambulance on a mission will not always stay on its own half. Here it storms towards the AV exactly above the lane divider, at high velocity and without deviating, so that each direction of traffic has to surrender part of its lane.",
#:   "Mother gripped my arm when she saw it. Far up the avenue a fire engine was tearing in our direction, and it had chosen neither the one lane nor the other but the painted line itself, as though the road had been built for it alone.",
#:   "In his statement the witness said the squad car was travelling contrary to him, at a speed he put at ninety. It was not in his lane as such, but astride the centre of the highway, and it stayed there as it flew by.",
#:   "Ambulance facing us, flat out, one wheel in each lane.",
#:   "Patrol car tears towards the AV along the spine of the road.",
#:   "fire truck coming head on-ish, cats eyes between its wheels, absolutely gunning it",
#:   "The paramedics were coming the other way at a pace I wouldn't dare, and their van had the white dashes running under the middle of its bumper.",
#:   "Opposing emergency vehicle to travel at no less than 80 km/h with its lateral position centred on the lane divider for the entire approach.",
#:   "Breathe in, everybody: the police are hurtling our way, and they've taken the strip down the middle, half from their side and half from ours.",
#:   "Il venait en face, the red truck of firemen, at a mad speed, and he occupied the centre, so he left for each side only the gutter.",
#:   "What I need is a squad car coming from ahead like a bullet, straddling the divider, so that the ego has only part of its lane left.",
#:   "V3, an ambulance on an emergency run, approached V1 from the front at high speed, occupying the inner portion of both opposing lanes.",
#:   "People had done as they're told, one row tucked in on the right and one on the left, and that left a sort of aisle. Up the aisle, towards us, came the fire brigade, doing sixty if they were doing ten, so that our wing mirror folded itself in the draught.",
#:   "I know how wide my lorry is, to the inch, and I know what was left of my lane once that ambulance had had its share. He was coming against me with his foot right down, bang over the dashes, and he wasn't going to give any of it back.",
#:   "She counted the seconds from the first glint of blue. At one it was at the bridge, at three it was at the church, and at four it went roaring by with its near wheels well on her half of the tarmac and its far ones on the other, still dead over the line.",
#:   "We'd been told in the briefing that emergency vehicles would come past on their own side. This one doesn't: it's opposite in direction, very quick, and its lateral offset puts it above the centre marking, where it stays until it has gone by the ego.",
#:   "Nee-naw, said Billy, and pointed between the front seats. There were lights all over it and it was getting bigger terribly fast, and it wasn't on our side or the other side, it was on the stripe, like when I balance on a kerb.",
#:   "The insured's nearside tyres are scuffed from the kerb, against which he had pressed the car. He did so because a police vehicle was rushing to meet him with its siren on, and because, being in the middle of the carriageway, it needed a yard of his lane to get through.",
#:   "My old instructor used to say they only borrow the middle. Well, here's one borrowing it: a pump, coming at us like the wrath of God, with the broken line going in under its front plate and out under its back. Keep left, keep left, and let it go through.",
#:   "By the time the siren made sense to me the thing was nearly there. It was an ambulance, it was headed my way, the needle must have been past ninety, and it seemed to be threading the road the way you thread a bead, through the exact centre.",
#:   "For the occlusion study we put an emergency vehicle in the opposing direction with a 1.75 metre shift to its left, i.e. onto the line that separates the traffic streams. It keeps that shift, it keeps its 100 km/h, and both streams lose space to it.",
#:   "On my bicycle I felt quite safe in the gutter; it was the robotaxi next to me that I worried for. A rescue car was flying along in the opposite direction, not on its own half, nor wholly on ours, but bestriding the paint, and their mirrors can't have missed by much.",
#:   "Court was shown the footage at half speed. Even so the police van came up the road towards the camera at a fair lick, its wheels an equal distance to each side of the dividing line, and at no point in those six seconds did it depart from that position.",
#:   "Siren ahead, growing fast, dashes running in under its bumper's centre.",
#:   "Everyone hugs a kerb; the fire engine hurtles up the seam towards us.",
#:   "Oncoming patrol car, a hundred plus, line dead under its badge.",
#:   "Neither his lane nor mine would do for that ambulance; it had its wheels in both, its nose to us, and its foot on the floor.",
#:   "We lost our mirror to a police van that went by the other way at racing speed, with as much of it over the line as not.",
#:   "Generate a rescue vehicle in the contrary direction that keeps its long axis on the lane divider and its speed at ninety until it's well behind us.",
#:   "I steered for the gutter as there was nowhere else: half my lane had a fire engine in it, coming on like an express.",
#:   "The lateral position of the approaching ambulance was equidistant from both edges of the roadway, and its velocity was nearly twice that of any other vehicle.",
#:   "The police, he rushed from the front with the blue light, one wheel by me, one wheel by the others, and the white line between like a horse he rides.",
#:   "All I could offer was two wheels on the grass, and it was just enough. He'd been a flicker at the far end of the straight, then a din, then a great red front, and it had no notion of keeping to its half. The broken line vanished into its bumper like spaghetti. Whoosh, and my hat was off.",
#:   "You may have noticed that the cars opposite have gone into their hedge and we've gone into ours. Nobody arranged it. It's on account of the ambulance, you see how quickly it's getting bigger, and you see which part of the road it's left empty on either hand: the edges. So stay in, and let it through the middle.",
#:   "After it had gone past the dust came down in two halves, one on our side of the paint and one on theirs. The thing that had raised it was a paramedic's estate, coming our way at well over a hundred with everything wailing. It had swerved for none of us; it had simply shared itself out between the lanes.",
#:   "I was the one on the motor scooter, sitting out on the line, and I've never left a place faster. That line was spoken for. Down the length of it, head on, flat out, with lights from kerb to kerb as it seemed to me, came the police. I dived behind your van; you'd already got your tyres on the drain.",
#:   "Object 31 has the class \"fire truck, active\". Its heading is opposite to ours; its speed, 27 m/s, is well above the flow. The overlap with our lane is 0.9 m and the overlap with its own is the same. Neither of the figures changes between first detection and the moment when it's abreast.",
#:   "Down at the allotments you hear them early. We put our forks down to watch. Both streams of cars had parted, like a comb had been through them, and up the parting it tore, blue and yellow, straight at the bus that was coming from town and past it, with a bang of air, and never off the line by a foot.",
#:   "I'm no small target with a fifty-foot trailer. I'd have welcomed it if the driver of that appliance had kept to the lane he's paid to keep to. But with the road jammed his side he was taking the ridge of it, at sixty or seventy, nose to nose with me, and I had to fold my mirror in by hand.",
#:   "What remained to the claimant was a strip of one metre eighty, and her car measures one metre seventy-six. The rest of her lane, and a like share of the lane for the other direction, was needed by an oncoming ambulance. As it was doing at least ninety, there was no time to negotiate.",
#:   "Like a zip, Mum says. The road was all shut up with cars, and the nee-naw came from the other end, so quick, and it went right up the join, and all the cars opened one after another on this side and that side. We opened too. Then it was past, and we all closed up again.",
#:   "The old woman crossed herself. Far out on the causeway a light had started up, blue and stammering, and before she'd finished it was upon them, an engine as broad as a barn, thundering against them over the very crown of the road, so that their cart lost its outer wheel in the reeds and somebody on the farther side lost his.",
#:   "For ambulance nobody is giving side in our place, so ambulance takes middle. It was coming opposite to me, full speed, hundred maybe, siren like mother crying. Left tyre in their line, right tyre in my line. I became thin, my car became thin, and it passed with one chapati space.",
#: ]
#: adversaries = ["emergency-vehicle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "fast", "follow"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 12.0
#: high = 17.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.2
#: high = 2.2
#: unit = "m"
#: meaning = "how far towards the ego's side it keeps"

param OPT_ADV_SPEED = Range(12, 17)
param OPT_SWERVE = Range(1.2, 2.2)

behavior AdvBehavior():
    do ThrottleOnPath(advTrajectory, 1, globalParameters.OPT_SWERVE, globalParameters.OPT_ADV_SPEED)
