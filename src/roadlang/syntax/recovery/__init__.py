"""What is wrong with a file that does not parse, and how reading goes on."""
