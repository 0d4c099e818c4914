@tool
extends EditorPlugin
## Adds `Add a roadlang stage` to the menu Project, Tools of the editor.

const ITEM := "Add a roadlang stage"
const Stage := preload("roadlang_stage.gd")


func _enter_tree() -> void:
	add_tool_menu_item(ITEM, _add_stage)


func _exit_tree() -> void:
	remove_tool_menu_item(ITEM)


## Under the root of the scene that is edited; can be undone.
func _add_stage() -> void:
	var root := get_editor_interface().get_edited_scene_root()
	if root == null:
		push_warning("open or create a scene first: the stage is added to it")
		return
	var stage := Node3D.new()
	stage.name = "RoadlangStage"
	stage.set_script(Stage)
	var history := get_undo_redo()
	history.create_action(ITEM)
	history.add_do_method(root, "add_child", stage, true)
	history.add_do_property(stage, "owner", root)
	history.add_do_reference(stage)
	history.add_undo_method(root, "remove_child", stage)
	history.commit_action()
