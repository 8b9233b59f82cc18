#: description = "The oncoming car brakes hard and stops in its lane."
#: rephrasings = [
#:   "A vehicle approaching from ahead slams to a standstill.",
#:   "The opposing driver stops abruptly, leaving the way around blocked.",
#:   "The adversary coming toward the ego decelerates sharply.",
#:   "Opposing traffic halts without warning beside the obstacle.",
#:   "The motorbike from the other direction brakes to a stop in front of the ego.",
#:   "the one coming the other way stands on the brakes and just stops",
#:   "Vehicle 2, oncoming, decelerated rapidly and came to rest in its lane.",
#:   "opposing veh, full brake, standstill",
#:   "The car coming the other way stood on his brakes and stopped, still on his own side.",
#:   "Opposing Vehicle 2 braked heavily and came to a stop within its own lane.",
#:   "Opp. bus full brake to 0, own lane.",
#:   "The oncoming target decelerates strongly to standstill without leaving its own lane.",
#:   "The car which comes against me brakes strong and stands in his lane.",
#:   "Opposite-direction actor does a hard stop in its own lane; ego should not overreact.",
#:   "He was coming down to meet her when his nose dived and he pulled up short on his own side of the line.",
#:   "Chap coming the other way's done an emergency stop over there in his lane; stay on ours.",
#:   "car on the other side coming at us just braked to a full stop in its own lane",
#:   "The approaching bus pulled up sharply on its own side of the road, puzzling drivers.",
#:   "The vehicle travelling toward my client braked to a halt, and did so without quitting its own lane?",
#:   "The opposite lorry put full brake and stopped in his side only.",
#:   "Chap coming towards me nails it to a stop over on his side, no idea what he'd seen.",
#:   "Emergency stop of opposing vehicle within its own lane.",
#:   "ONCOMING CAR SLAMS TO A STOP FOR NO REASON",
#:   "The oncoming truck bit into its brakes and froze in its lane.",
#:   "Van heading our way locked up and stopped dead in its own lane.",
#:   "The bus which comes to us makes full brake and remains standing there.",
#:   "Let an approaching motorbike do an emergency halt in the opposite lane.",
#:   "Artic coming at you has anchored up, he's stationary his side.",
#:   "On the far side, a taxi facing us went from fifty to nothing.",
#:   "A hatchback was coming the other way quite normally when its front end dipped, its tyres barked, and there it stood, still on its own side.",
#:   "The oncoming target remains within its own lane, decelerates at 7 m/s² or more and is at rest before the two vehicles would have met.",
#:   "I couldn't tell you what frightened the motorcyclist coming towards us; he hauled on everything he had and finished up motionless on his half of the road.",
#:   "V2, approaching V1 from the opposite direction, applied heavy braking and had come to rest entirely in its lane by the time V1 drew near.",
#:   "From the front was coming one lorry, and without any reason the driver has jammed his brakes and stopped, his side only, smoke was coming also.",
#:   "Don't stare at the coach opposite, please; it has pulled up in a terrible hurry, but it's on its own side and it's no concern of ours.",
#:   "All I saw was the nose of the oncoming estate going down towards the tarmac. It slid a little, quite straight, and then it was standing over there in its lane with the engine stalled and the driver holding on to the wheel.",
#:   "Please build the mirror image of the lead-braking case: the agent that brakes is opposite to us. It travels toward the ego on its side of the centreline, slams to zero when the distance gets short, and remains there as a static obstacle in its own lane.",
#:   "A bus full of pensioners was rumbling down the hill in the direction of the robotaxi when its driver spotted a cat. He trod on the brake so hard that handbags flew, and the bus came to rest without leaving its lane.",
#:   "I drive a wagon, so I'm blamed for everything, but I kept to my line. It was the car coming up the other way that threw out its anchors and stood on its marks over there, and the lady behind me thought I had done something.",
#:   "Question for the forum: does your system get scared when a car on the opposite side does a panic stop? Mine did yesterday. Some guy coming at me slammed it from full speed to a standstill, never left his own lane, and my car hit the brakes as well.",
#:   "Facing van anchors up; stands on its own half, tyres smoking.",
#:   "Motorbike opposite: nose down, rear up, then stock-still, own lane.",
#:   "the Passat coming towards me went full statue on its side??",
#:   "A coach that had been bearing down the hill towards us was hauled up in a few yards and remained at rest where it was, on its proper side.",
#:   "The opposing target, its lateral position unaltered, undergoes strong deceleration to zero velocity within the opposing lane.",
#:   "On the other side of the white line a lorry which was coming in my direction has suddenly blocked its wheels until it was standing.",
#:   "Simulate traffic from ahead, one estate, that hits the brakes as hard as it can and is left standing in the lane that belongs to it.",
#:   "The bus coming at you has just stood on its nose for a football; it's come to rest over there, so leave your steering alone.",
#:   "V2, eastbound, underwent maximum braking and was motionless in the eastbound lane when V1, westbound, came level with its front bumper.",
#:   "I could see the tops of the driver's arms go straight, the way they do. His pickup had been coming the other way at a good fifty; now it was bowing towards us with all its weight on the front wheels, and then it sat back and was still, over on his half of the road.",
#:   "All the shopping bags in the other car flew forward, we saw that, me and Tom, because it was coming towards us and we were in front. It went eeeee and then it didn't go any more. It didn't come onto our bit; it was just standing on its own bit.",
#:   "What had been a pair of headlights getting steadily bigger became a pair of headlights of one size. They'd dipped first, and hard. The lorry they belonged to had pulled up in a screech of rubber on the far side of the centreline, where it had been all along.",
#:   "The defence makes much of the skid. But a skid in one's own lane is no offence, and the motorcyclist who approached my learned friend's client, braked with such vigour and ended stationary never once put a wheel across the line.",
#:   "Funny thing about pensioners' outings, the driver does what the loudest one says. The minibus was coming along opposite us when evidently somebody shouted, for it threw out everything, slid to a stand on its own side, and a hat came out of the window.",
#:   "Our stack slowed for an object that would never have been in its path. It was an approaching car; it went from 14 m/s to nil in two seconds and stayed at nil, its centre 3.4 metres from ours laterally all the while, since it was in the opposite lane and kept to it.",
#:   "In the mirror of my cab I saw the tailback afterwards; at the time I only heard it. A tipper coming the opposite way locked up all eight wheels for a deer, as I suppose, and when I rumbled by him he was parked there in his lane, white as chalk.",
#:   "I'd just said to my pupil that oncoming traffic needs watching even if it's behaving. Then that taxi facing us went from normal speed to none at all in about a cricket pitch, and it's still sitting there on its own side, and we've done the right thing, namely nothing.",
#:   "She was waiting for the gap after the silver van, and the gap never came, since the van didn't. It had been coming on towards her quickly enough; then there was a howl, its bonnet plunged, and it stayed put over there in the opposite lane with a ball rolling out from under it.",
#:   "The recording begins with sky. When it settles you see a two-lane road, and on the other half of it, heading for the camera, a motorcycle whose back wheel is off the ground; it comes down, and the machine is at rest in its lane, and nobody has hit anybody.",
#:   "In my village the goats are having right of way. So when the bus was coming from opposite, and one goat came out, the driver put all his weight on the brake, and bus stood like a temple, in his side, dust everywhere, and we passed smiling.",
#:   "Headlights dipped, tyres shrieked, and it stood there, its own half.",
#:   "Facing coach: sixty to nil, dead straight, far side of the line.",
#:   "Biker coming at us hauled up so hard his back wheel lifted.",
#:   "The lorry that had been rolling towards us was suddenly a lorry that stood, smoke about its wheels, in the lane where it had always been.",
#:   "I'd counted on meeting that bus by the oak; I met it at the mill, where it had stood itself on its nose, on its side.",
#:   "Simulate a car approaching on the other half of the road which kills all its speed in a few metres and remains there, never touching our half.",
#:   "What you hear squealing is him over there, not you; he's come to a complete stand in his lane, and all it means for us is carry on.",
#:   "V1's driver reported that the opposing pickup's front end plunged, after which its lamps ceased to approach; it was found stationary and wholly in the westbound lane.",
#:   "She came against me with normal tempo, that lady, and from one meter to the other she stood, in her row, the hands before her mouth.",
#:   "By rights the two of us should have passed each other with a nod by the war memorial. I was there; he wasn't. He'd shut down everything he had forty yards short of it, in a straight line, on the side of the road he belonged on, and he was looking at a hedgehog over the top of the wheel.",
#:   "On the far side of the white paint there is a second set of marks, black and parallel, and they don't bend. They were made by the tipper that was on its way to meet the claimant. At the end of them it was standing when she came by, and it was standing there still when the police arrived.",
#:   "I saw his tea before I saw anything else. It hit the inside of his windscreen, brown, in a fan. So he must have used all the pedal there was, that cabbie, with us coming the one way and him the other; and there he sat afterwards, not an inch out of his lane, not an inch farther along it.",
#:   "The closing speed fell from twenty-four to twelve metres per second inside two seconds, though the AV hadn't changed a thing. The whole of the difference came from the other direction, where a minibus had gone from its twelve to none. It had kept to its lane. Please suppress the emergency reaction.",
#:   "It got bigger and bigger the way trucks do when they come along the other side, and then it stopped getting bigger. Not slowly, I mean it went WHUMP and all its boxes hit the front. We got bigger for it instead, I suppose, till we'd gone past. It was still just standing there in its own bit.",
#:   "Don't stamp because he's stamped. I know it's catching. There was a motorbike coming down the opposite lane at a good lick, and now there's a motorbike parked in the opposite lane with its back light glowing and the rider's heart going like a drum, and between it and us there's a line, and nobody's over it.",
#:   "The lady in the follow-up car thinks that I made him do it. How, pray? I was on my own half. He was on his and heading for me, a baker's van, brisk enough. I expected to have his wind in my face, and I never got it: he was at rest by then with loaves all over the dashboard.",
#:   "How quiet it was once the noise had left off. For three seconds it had come from the bend, rubber and air and something metal; there'd been a bus behind it, growing, nodding lower and lower over its wheels. And then there was only the bus, in its lane, opposite theirs, and steam, and a child who began to cry.",
#:   "My mates on the CB won't have it that I wasn't the cause. Loaded, forty, dead centre of my own lane. Up the other lane comes an estate with bikes on the roof. Next I know, the bikes are on his bonnet, because the estate has been pulled up as if it had reached the end of a rope.",
#:   "At 02:10 pause it and look at the other lane. There's the taxi, twenty metres away, nose practically on the road, and it's coming towards us. Now at 02:12 it's ten metres away, level, dust blowing past it. It's not coming any more. We were the ones who did the last ten metres.",
#:   "God is driving in our ghats. From upper side one bus came down towards me, its side only, full speed, horn and all. One rock was there, I could not see it, he could. What brake he put, sir! Conductor flew till the front glass. Bus stood in own line, and when I passed I saw all of them praying.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "brake", "stop"]
#: position = "oncoming"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 15.0
#: high = 45.0
#: unit = "m"
#: meaning = "distance to the ego at which it brakes"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_SPEED = Range(5, 10)
param OPT_ADV_DISTANCE = Range(15, 45)
param OPT_BRAKE = Range(0.4, 1)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 4 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
