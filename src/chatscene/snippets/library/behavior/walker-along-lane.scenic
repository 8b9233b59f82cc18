#: description = "The pedestrian steps into the lane and walks along it in front of the ego, turning its back to it."
#: rephrasings = [
#:   "Some fool is strolling down the middle of our lane with his back to us.",
#:   "The pedestrian was walking in the roadway with traffic.",
#:   "ped walks in lane, same direction as us",
#:   "The adult target walks longitudinally ahead of the VUT in its lane, facing away.",
#:   "The man goes on the street before us in the same direction, he does not see us.",
#:   "A hiker leaves the verge and trudges on in the carriageway itself.",
#:   "A reveller wanders home down the lane we drive in.",
#:   "Somebody with headphones takes to the tarmac and marches along it.",
#:   "Some bloke stepped off the kerb and just ambled along my lane with his back to me.",
#:   "The pedestrian entered the lane and walked in it with traffic, his back to Unit 1.",
#:   "Ped in lane, walking same dir as ego, back turned.",
#:   "The pedestrian target enters the VUT's lane and walks longitudinally ahead of it, facing away.",
#:   "A man goes in my lane and walks there before me, I see only his back.",
#:   "Longitudinal ped: steps in and walks along our lane, same heading, doesn't cross.",
#:   "She stepped down into the road and walked on ahead of him as if it were a footpath, never looking round.",
#:   "There's a man walking up the middle of your lane, facing away, hasn't a clue you're behind him.",
#:   "some guy is literally just walking in the lane in front of us w headphones in",
#:   "A man stepped off the pavement and went along the traffic lane, deaf to the cars at his heels.",
#:   "He did not cross, then; he walked in the lane, away from you, and never looked round?",
#:   "Auntie came down from footpath and walking in the lane only, back side to me, cannot hear horn.",
#:   "Thinks my lane's the promenade, strolling down it in front of me, never once turns round.",
#:   "Same-direction walking pedestrian in ego lane, unaware of traffic at rear.",
#:   "PEDESTRIAN WALKS DOWN THE MIDDLE OF MY LANE",
#:   "A man moseyed along our lane ahead.",
#:   "Hiker stepped in, now ambles down our lane, nothing but rucksack to see.",
#:   "Put somebody in the lane ahead, walking away from the ego.",
#:   "Ped left verge, now hiking up the carriageway, facing away from unit.",
#:   "He comes on the road and walks before us, with his behind to us!",
#:   "Lady with shopping steps in, then trudges ahead of us, never turning.",
#:   "A festival-goer came off the pavement into our lane and tramped on along it in our direction of travel, showing us nothing but his hood.",
#:   "The adult pedestrian target leaves the kerb, takes up the centre of the VUT's lane and proceeds along it with its back to the approaching vehicle.",
#:   "I had the back of an anorak in my headlights: a man had taken to the road and was plodding along my lane the same way as me.",
#:   "V1 came upon a pedestrian who had entered the travel lane and was proceeding on foot in the direction of traffic, facing away from V1.",
#:   "There is no footpath, so what to do, the labourer has come into the lane itself and he is walking on in front, seeing only forward.",
#:   "What's the AV meant to do about a woman with a pram who takes to the lane and wheels it along ahead, her back turned?",
#:   "I'd been hearing about the blocked pavement at the building site, and here was the result. A gentleman stepped down from it into my lane and simply continued his walk there, going my way, so all I could do was follow his flat cap.",
#:   "You can't make eye contact with the back of a head, and that's the danger. She's come off the kerb, she is strolling on along your lane with her earphones in, the same way you're driving, and as far as she's concerned you don't exist.",
#:   "Scenario wish: a person goes from the edge of the road to the middle of our lane, makes a quarter turn away from us and then walks ahead at an easy pace. He does not leave the lane and he does not look behind him.",
#:   "The road was white with frost and the path was worse, so the boy took the road. He went along before their car, in their lane, hands in pockets and shoulders up, and the lamps threw his shadow a long way ahead of him.",
#:   "Forty-four tonnes behind him and he didn't hear a thing. This lad wandered off the lay-by into the carriageway, set off up my lane in the direction I was going, and all I ever saw of him was the soles of his trainers.",
#:   "Dog-walker leaves the path, strolls up our lane, back to us.",
#:   "Ped joins carriageway from kerb, heading as unit, hasn't turned round.",
#:   "got off the pavement to walk IN my lane, hoodie up, facing away",
#:   "An old man with a bucket climbed out of the ditch into our lane and went along it before us, seeing nothing but the road ahead.",
#:   "The adult target enters from the edge, adopts the VUT's direction of travel at the lane centre and proceeds ahead at 1.2 m/s, facing away.",
#:   "I had suddenly a rucksack before the windscreen; its owner came down from the sidewalk, turned my way and marched in my lane without to look behind.",
#:   "Make a woman with a pram step off the kerb, swing it into the ego's direction and push it up that lane, oblivious of what's behind her.",
#:   "Pedestrian 1 left the sidewalk, turned to face north and walked northbound within the northbound lane; V1 approached P1 from the rear.",
#:   "She's stepped down there and she's heading our way along the lane, so hang back while she tramps on before us, hood up, never looking round.",
#:   "The verge was under water, so I can't blame her. She'd hopped from it onto the tarmac in front of us, and being bound for the village, as we were, she simply carried on along our lane. All we had for a mile was a yellow sou'wester seen from behind.",
#:   "Dear insurer, you ask whether the pedestrian saw me. He could not have done. He had left the pavement by the scaffolding, and he was proceeding down my lane on foot, the way that I was going; in all that time I was shown the back of his overcoat and nothing else.",
#:   "I could tell you what was printed on his T-shirt, \"Security\", right between the shoulder blades. That's because the man had wandered off the kerb into our lane and was ambling ahead of the robotaxi in the same direction as it, for so long that I learned the font.",
#:   "The class was told to keep to the footpath. Ben didn't; Ben went down the kerb, and instead of going over to the other side he walked along in the lane where our minibus was, in front of it, going the same way, with his satchel bouncing and his ears full of music.",
#:   "What we see in the lidar is a slow object that first moves towards our lane and then stops getting nearer to the far side of it. It has taken up our heading. Gait is normal, the torso normal vector points away from us, and it stays in our path until the run ends.",
#:   "Lorry drivers call it taking the fat lane. You've a man who doesn't care for the cinders on the path, so he comes across into yours and footslogs up it, and with his back to you and his cap pulled down he wouldn't hear the Last Trump, let alone my horn.",
#:   "Twilight, and the smell of hay. She had stepped from the gate into the lane of the approaching car without a glance, and was going home along it, her basket on her hip; its headlights lit her plait and the heels of her boots, and still she didn't turn her head.",
#:   "If he'd been crossing, he'd have been gone in three seconds. He had only done the first bit of a crossing, as far as the middle of our lane; there he had faced the way we were facing, and off he hiked, so we were behind him for three minutes.",
#:   "The officer found him half a mile farther on. He was still in the traffic lane he'd stepped into outside the club, still walking down it away from the cars that had collected at his back, and he was much surprised, when spoken to, to learn that there were any.",
#:   "I am riding bike since thirty years and this I see daily. From footpath one aunty will get down, she'll not cross, she'll take my lane like it is morning-walk park, same direction, going ahead with her chappals, and behind she has no eyes.",
#:   "You learn patience from the shoulder blades of strangers. Mine today belonged to a tall girl with a cello case, who had abandoned the pavement for the lane I was in, and who was striding along it ahead of my bonnet, in my direction, as if the road were hers.",
#:   "Rucksack in our lane, going our way, no face to it ever.",
#:   "Came off the verge, now leading us down our lane on foot.",
#:   "All I saw of her: ponytail, trolley, heels, same direction as me.",
#:   "The pavement had a skip on it, so the old man used my lane instead, and went on up it ahead of me without once looking over his shoulder.",
#:   "We drove half a mile at four miles an hour with a duffel coat for a leader, which had come out of a gateway and knew nothing of us.",
#:   "Let a woman leave the kerb, stop heading for the other side when she is in front of us, and hike up our lane, her hair towards the camera.",
#:   "See how you can read the back of his shirt and will go on reading it? He's not getting over the road, he's using your lane to get home.",
#:   "The pedestrian, having entered from the shoulder, adopted a heading identical to that of V1 and advanced within its lane, the approaching vehicle being outside his field of view.",
#:   "He descended from the trottoir with his hands on the back, like my grandfather, and made his promenade in my lane before me, and he saw only what was in front.",
#:   "Headlamps make you a sort of spotlight operator. The star came on from the left, out of the lay-by, in a long coat. I waited for him to exit right. He chose the middle of our lane for his stage, and up it he paced, away from us, following his own shadow, and for all I hooted he never took a bow.",
#:   "We had to follow her at her own speed because there was traffic the other way. She was a jogger who'd finished jogging. She'd come off the towpath into our bit of road and was cooling down along it, hands on hips, ponytail swinging, and as she was off to the same place as us we saw no more of her than that.",
#:   "The distance to the person was 18 metres, then 14, then 12, then 12, then 12. It was at 12 that we'd matched him. He had come in from the kerb, had turned through a right angle, and was using our lane as a footpath, in the direction for which the lane is meant, with his back to our sensors.",
#:   "\"Excuse me\", I said out of the window, and again, and I said it in Polish. He'd great white headphones on. They'd stepped down into the lane with him at the shop, and they went on before my bonnet, nodding, at the pace of a man with nowhere to be, the way that I was going, for as long as the street lasted.",
#:   "Now that's awkward, because you'd have an easier time with one who is crossing. She'd be gone. This one came in as if to cross, thought the going was better on the tarmac, and has fallen into line in front of you like a sergeant ahead of his band. And she hasn't heard the band.",
#:   "Snowploughs do the road and nobody does the path, so what can folk do. A chap with a sledge climbed down over the bank into our lane ahead of the lorry. It was his way home and our way to the dairy. I had the kid on that sledge waving at me for a mile, and the father never knew why.",
#:   "The deceased's family may take comfort in this, that nobody was deceased. Mr Gray had left the sidewalk outside the stadium, and he was going home along the northbound lane, northward, at his ease. The taxi was going north in it as well. It followed at his pace, and what it lit up was his scarf and his collar.",
#:   "I knew his boots before I knew him. They were mending boots, one nail flashing each time the left one lifted. They'd come off the grass into our road while we were still far away; and as they were bound where we were bound, heel after heel after heel, they showed me that nail till I could have drawn it.",
#:   "There was a lady with a big hat and the hat was walking in the road. Not over the road, along it, where our car goes! She got down from the pavement with her basket and then the hat went in front of us, wobble, wobble, and you couldn't see if she had a face because it was on the other side.",
#:   "Does your system know the difference between the front and the back of a human being? Ours does now. A man entered its lane from the hard shoulder, rotated until we had his shoulder blades, and moved off along it ahead at 1.3 m/s. The \"eye contact\" field said none, and kept saying none.",
#:   "Near Shirdi thousands are walking. One baba left the side, where stones are, and took my lane, where tar is cool. He was going Shirdi, I was going Shirdi. In front his stick, behind his jhola, and behind the jhola my Tata Sumo, first gear. What is coming at his back, that he has given to God.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "Euro NCAP CPLA; own code"
#: [slots]
#: actions = ["slow", "follow"]
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.8
#: high = 1.4
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 8.0
#: high = 32.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 0.2
#: high = 1.9
#: unit = "m"
#: meaning = "how far from the ego's line it walks"

param OPT_ADV_SPEED = Range(0.8, 1.4)
param OPT_ADV_DISTANCE = Range(8, 32)
param OPT_ADV_REACH = Range(0.2, 1.9)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(1.4) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    # A quarter turn into the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1.57 if offsetFrom(egoRoute, self) > 0 else -1.57)
