#: description = "The oncoming car turns left across the ego's lane and stops broadside."
#: rephrasings = [
#:   "he swings across for the driveway, can't get in, and stops bang across our lane",
#:   "Vehicle 2, oncoming, began a left turn into a driveway and came to rest across the lane of Vehicle 1.",
#:   "opposing veh turns left, stands broadside in our lane",
#:   "The oncoming target turns left off the carriageway and comes to a standstill across the path of the VUT.",
#:   "The truck wants to enter the yard at the left but it stops on our lane, crosswise.",
#:   "The gate is shut, so the lorry turning in from the opposite side blocks us.",
#:   "A biker facing us hooks left over the lane and halts side-on.",
#:   "A van coming the other way bends left toward the car park and waits, sideways in our path.",
#:   "he came the other way, turned over my side for a driveway and stopped side-on in front of me",
#:   "The oncoming vehicle turned left across V1's lane and stopped perpendicular, blocking it.",
#:   "Opp. truck: L over our lane, halts broadside.",
#:   "The oncoming target turns left into a property access and comes to rest transversely in the VUT's lane.",
#:   "The bus from front turns to the left side and stays cross in my lane, like a wall.",
#:   "Opposite NPC left turn towards an entrance, v=0 midway, full side profile towards SUT.",
#:   "The car had wheeled left towards a gateway and then pulled up with its whole flank turned to them.",
#:   "He's coming over for that driveway on your side and... he's parked himself sideways over your lane. Gate must be shut.",
#:   "he was coming at us, turned left over our lane, and stopped completely sideways",
#:   "A van turning left out of the opposing flow came to rest side-on, walling off the lane",
#:   "You turned left over my client's lane and there stood still, presenting your flank to her?",
#:   "Opposite lorry taking left across us and then stopped in horizontal, full side showing",
#:   "He swings left over me from the other way and then parks it longways across my road, I'm looking at his door handles",
#:   "Left turn of opposing traffic over own lane, transverse standstill",
#:   "Oncoming truck turns left and stops SIDEWAYS in my lane",
#:   "The bus facing us swung left and lay across our lane.",
#:   "Coach facing us swings left for a gateway, ends up parked across us.",
#:   "Lane closed: opposing van turned left into it and sits crossways.",
#:   "Please let the oncoming truck bend left over our lane and halt lengthwise.",
#:   "Side-on and motionless: the motorbike that had turned left before us.",
#:   "From ahead, left over our lane towards a yard, dead stop, full flank.",
#:   "A skip lorry approaching from the far end made a left over the lane of our car, meaning to enter a farm track, and came to a standstill with its flank towards us.",
#:   "There was a dog lying in the driveway, so the oncoming estate, which had started its left turn over my side, stayed put with its doors facing my grille.",
#:   "The opposing vehicle leaves its lane by a left turn towards an access road and, when perpendicular to the VUT's lane, is brought to a stop and kept there.",
#:   "V2 had been eastbound; it turned left across the westbound lane towards a car wash entrance and was at rest, its right side exposed to V1, at impact.",
#:   "I want the bus from the opposite direction to turn to its left across us for some driveway but only get halfway and stand there like a barrier.",
#:   "Tempo came from opposite, took left through my lane for one godown, gate was not open, so he is just standing crosswise and road is jammed.",
#:   "I could see he wanted the pub car park on my side, and fair enough, there was time for him to get in. But having come round to the left he stopped with his front wheels on the pavement and the remainder of that horsebox lying right across my lane.",
#:   "Forty-footer, reporting. I was coming up the hill, took my left for the quarry entrance and some genius had left the chain up. So I had to stop where I was, sideways over the downhill lane, and that electric thing without a driver was headed for my fuel tank.",
#:   "Think of a door being shut in your face. The taxi had been approaching us on its own side; it swept left, over our lane, towards the entry of the hospital, and there it halted, and from one edge of the lane to the other we saw nothing but yellow paint.",
#:   "Test idea for blocked-path handling: an SUV approaches from the front, makes its left turn in the middle of the block to reach a private access, and instead of finishing the move it stops at ninety degrees to our heading and remains a wall.",
#:   "Madam, it is right that the motorcycle was coming in the opposite direction, and that it turned left over the lane you were using, in the direction of a garage? And it was not moving any longer, but standing there side on, when you first braked?",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-left", "stop"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 6.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 45.0
#: unit = "m"
#: meaning = "distance to the ego at which it turns"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.0
#: high = 0.5
#: unit = "s"
#: meaning = "how long it goes on before it stops across the lane"

param OPT_ADV_SPEED = Range(4, 6)
param OPT_ADV_DISTANCE = Range(18, 45)
param OPT_STOP_TIME = Range(0, 0.5)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do TurnOff(1.1, globalParameters.OPT_ADV_SPEED, 5)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_STOP_TIME seconds
    do Halt()
