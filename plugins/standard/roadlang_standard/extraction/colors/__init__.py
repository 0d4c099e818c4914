"""The colors of a picture: which, where, how even, how mixed."""
