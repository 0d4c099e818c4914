param width = 7m
param bend = 40m..80m
road street { draw with segments { pieces: [straight(80m), arc(bend, 60deg)] }, width: width }
