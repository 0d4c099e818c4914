"""Drive signals while a scene is driven, and the conditions of controllers."""
