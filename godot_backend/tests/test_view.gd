extends RefCounted
## What the hand of a human gets hold of.

const Protocol := preload("res://net/protocol.gd")
const Reader := preload("res://net/reader.gd")
const Stage := preload("res://build/stage.gd")
const Dragging := preload("res://view/dragging.gd")


func test_an_object_near_the_hand_goes_before_a_road_point() -> String:
	var stage := _stage()
	var held := Dragging.grasp(stage, Vector2(11.0, 4.0))
	stage.free()
	return "" if held.get("what") == "object" and held.get("id") == 7 else str(held)


func test_a_road_point_is_held_where_no_object_is() -> String:
	var stage := _stage()
	var held := Dragging.grasp(stage, Vector2(41.0, 1.0))
	stage.free()
	var right: bool = held.get("what") == "road" and held.get("index") == 2
	return "" if right else str(held)


func test_nothing_is_held_far_from_everything() -> String:
	var stage := _stage()
	var held := Dragging.grasp(stage, Vector2(20.0, 300.0))
	stage.free()
	return "" if held.is_empty() else str(held)


func test_a_malformed_thing_is_refused_and_leaves_nothing() -> String:
	var stage := Stage.new()
	for kind: int in [Protocol.SEGMENT, Protocol.PATCH, Protocol.TILES, Protocol.OBJECTS]:
		var wrong := stage.put(kind, 1, 1, Reader.new(PackedByteArray([1, 2, 3])))
		if wrong.is_empty() or stage.count() != 0:
			stage.free()
			return "kind %d" % kind
	stage.free()
	return ""


## A box at (10, 5), and a path through (0, 0), (20, 0), (40, 0).
func _stage() -> Stage:
	var stage := Stage.new()
	var box := StreamPeerBuffer.new()
	box.put_u8(0)
	box.put_u16(1)
	box.put_u8(3)
	box.put_data("box".to_ascii_buffer())
	box.put_u8(0)
	for number: float in [10.0, 0.0, -5.0, 0.0, 1.0, 1.0, 1.0]:
		box.put_float(number)
	stage.put(Protocol.OBJECTS, 7, 1, Reader.new(box.data_array))
	var path := StreamPeerBuffer.new()
	path.put_u8(0)
	path.put_u16(1)
	path.put_u16(3)
	for number: float in [0.0, 0.0, 3.5, 20.0, 0.0, 3.5, 40.0, 0.0, 3.5]:
		path.put_float(number)
	stage.put(Protocol.PATH, 1 << 16, 1, Reader.new(path.data_array))
	return stage
