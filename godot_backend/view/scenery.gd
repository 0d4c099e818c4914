extends Node3D
## Hills on the horizon and trees far from any road: for the eye alone, nothing touches them.

const Worlds := preload("res://build/worlds.gd")

var _worlds: Worlds


func _init(worlds: Worlds) -> void:
	_worlds = worlds


## Makes the scenery anew for what now stands.
func rebuild() -> void:
	pass
