"""Programs that drive agents: started, talked to by lines of JSON, and ended."""
