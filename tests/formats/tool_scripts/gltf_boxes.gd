extends SceneTree
# The boxes (low and high corner) of all meshes of glTF files, as Godot opens them.


func _initialize() -> void:
	var answers := {}
	for path in OS.get_cmdline_user_args():
		var document := GLTFDocument.new()
		var state := GLTFState.new()
		var boxes := {"error": document.append_from_file(path, state)}
		if boxes["error"] == OK:
			var root := document.generate_scene(state)
			_collect(root, Transform3D.IDENTITY, boxes)
			root.free()
		answers[path] = boxes
	print("ANSWER " + JSON.stringify(answers))
	quit()


func _collect(node: Node, above: Transform3D, boxes: Dictionary) -> void:
	var place := above
	if node is Node3D:
		place = above * (node as Node3D).transform
	if node is AnimationPlayer:
		boxes["animations"] = (node as AnimationPlayer).get_animation_list().size()
	if node is MeshInstance3D:
		var box: AABB = place * (node as MeshInstance3D).mesh.get_aabb()
		var low := box.position
		var high := box.end
		boxes[str(node.name)] = [low.x, low.y, low.z, high.x, high.y, high.z]
	for child in node.get_children():
		_collect(child, place, boxes)
