"""Random traffic: contacts, red lights, throughput."""
