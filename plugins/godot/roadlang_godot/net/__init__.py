"""What goes over the wire: messages, links, sessions, and the proof of what was built."""
