road broken { draw with segments { pieces: [straight(80s)] } }
param again = again
