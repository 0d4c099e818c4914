"""Whether requirements and expectations are satisfied, over roads and over drives."""
