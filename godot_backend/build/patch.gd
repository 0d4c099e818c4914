extends "triangles.gd"
## The paved area of a junction: triangles whose outer corners are those of the roads that meet.

const Looks := preload("looks.gd")


func look() -> Material:
	return Looks.road(Looks.PLAIN, 0, 0, surface)


func _add(corners: PackedVector3Array, indices: PackedInt32Array) -> void:
	super._add(corners, indices)
	var faces := PackedVector3Array()
	for index in indices:
		faces.append(corners[index])
	add_body(faces, surface)
