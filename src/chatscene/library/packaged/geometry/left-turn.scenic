#: origin = "own code"
#: [slots]
#: maneuver = "left-turn"
#: [variants]
#: left-turn                                  = { place = "junction", origin = "base scenario turning-obstacle; own code" }
#: left-turn-four-way                         = { place = "four-way", crossed = ["left", "right", "oncoming"] }
#: left-turn-stop-sign                        = { place = "four-way", crossed = ["left", "right", "oncoming"], control = "stop-sign" }
#: left-turn-unsignalised                     = { place = "four-way", crossed = ["left", "right", "oncoming"], control = "none", origin = "base scenario turning-obstacle; own code" }
#: unprotected-left-turn                      = { place = "four-way", crossed = ["left", "right", "oncoming"], control = "signal", origin = "base scenario unprotected-left-turn; own code" }
#: left-turn-junction-signalised              = { place = "junction", crossed = ["left", "oncoming"], control = "signal" }
#: left-turn-junction-stop-sign               = { place = "junction", crossed = ["left", "oncoming"], control = "stop-sign" }
#: left-turn-junction-unsignalised            = { place = "junction", crossed = ["left", "oncoming"], control = "none" }
#: left-turn-three-way                        = { place = "three-way", origin = "base scenario turning-obstacle; own code" }
#: left-turn-three-way-from-stem              = { place = "three-way", crossed = ["left", "right"] }
#: left-turn-three-way-from-stem-signalised   = { place = "three-way", crossed = ["left", "right"], control = "signal" }
#: left-turn-three-way-from-stem-stop-sign    = { place = "three-way", crossed = ["left", "right"], control = "stop-sign" }
#: left-turn-three-way-from-stem-unsignalised = { place = "three-way", crossed = ["left", "right"], control = "none" }
#: left-turn-three-way-into-stem              = { place = "three-way", crossed = ["left", "oncoming"] }
#: left-turn-three-way-into-stem-signalised   = { place = "three-way", crossed = ["left", "oncoming"], control = "signal" }
#: left-turn-three-way-into-stem-stop-sign    = { place = "three-way", crossed = ["left", "oncoming"], control = "stop-sign" }
#: left-turn-three-way-into-stem-unsignalised = { place = "three-way", crossed = ["left", "oncoming"], control = "none" }
#: [descriptions]
#: left-turn                                  = "The ego turns left at an intersection."
#: left-turn-four-way                         = "The ego turns left at a four-way intersection."
#: left-turn-stop-sign                        = "The ego turns left at a four-way intersection with stop signs."
#: left-turn-unsignalised                     = "The ego turns left at a four-way intersection without traffic lights."
#: unprotected-left-turn                      = "The ego makes an unprotected left turn at a signalised intersection while oncoming traffic also has green."
#: left-turn-junction-signalised              = "The ego turns left at an intersection of any kind with traffic lights."
#: left-turn-junction-stop-sign               = "The ego turns left at an intersection of any kind with stop signs."
#: left-turn-junction-unsignalised            = "The ego turns left at an intersection of any kind without traffic lights or signs."
#: left-turn-three-way                        = "The ego turns left at a three-way intersection."
#: left-turn-three-way-from-stem              = "The ego turns left at a three-way intersection, coming from the road that ends there."
#: left-turn-three-way-from-stem-signalised   = "The ego turns left at a three-way intersection with traffic lights, coming from the road that ends there."
#: left-turn-three-way-from-stem-stop-sign    = "The ego turns left at a three-way intersection with stop signs, coming from the road that ends there."
#: left-turn-three-way-from-stem-unsignalised = "The ego turns left at a three-way intersection without traffic lights or signs, coming from the road that ends there."
#: left-turn-three-way-into-stem              = "The ego turns left at a three-way intersection, leaving the through road for the side road."
#: left-turn-three-way-into-stem-signalised   = "The ego turns left at a three-way intersection with traffic lights, leaving the through road for the side road."
#: left-turn-three-way-into-stem-stop-sign    = "The ego turns left at a three-way intersection with stop signs, leaving the through road for the side road."
#: left-turn-three-way-into-stem-unsignalised = "The ego turns left at a three-way intersection without traffic lights or signs, leaving the through road for the side road."

param signals = 'ego-green'  #: if control signal
crossSignal = "red"  #: if control signal
egoRoute = selectRoute(maneuver="left-turn", place="$place")  #: unless crossed
egoRoute = selectRoute(maneuver="left-turn", place="$place", crossed=$crossed)  #: if crossed  #: unless control
egoRoute = selectRoute(maneuver="left-turn", place="$place", control="$control", crossed=$crossed)  #: if control
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")  #: if crossed left
trafficFromRight = trafficFrom(egoRoute, "right")  #: if crossed right
oncomingTraffic = trafficFrom(egoRoute, "oncoming")  #: if crossed oncoming
