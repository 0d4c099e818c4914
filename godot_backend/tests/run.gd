extends SceneTree
## Runs every test of this folder: functions called test_*, which return what is wrong, or "".


func _init() -> void:
	var failed := 0
	var count := 0
	var folder: String = (get_script() as Script).resource_path.get_base_dir()
	for file in DirAccess.get_files_at(folder):
		if not file.begins_with("test_") or not file.ends_with(".gd"):
			continue
		var suite: RefCounted = load(folder.path_join(file)).new()
		for method in suite.get_method_list():
			var name: String = method["name"]
			if not name.begins_with("test_"):
				continue
			var wrong: String = suite.call(name)
			count += 1
			if not wrong.is_empty():
				failed += 1
				print("FAILED %s %s: %s" % [file, name, wrong])
	print("%d tests, %d failed" % [count, failed])
	quit(1 if failed > 0 or count == 0 else 0)
