extends RefCounted
## What a person can grab with the mouse.

const Light := preload("../build/light.gd")
const Protocol := preload("../net/protocol.gd")
const Reader := preload("../net/reader.gd")
const Stage := preload("../build/stage.gd")
const Handles := preload("../build/handles.gd")
const Worlds := preload("../build/worlds.gd")
const Hands := preload("../view/hands.gd")
const Detail := preload("../view/detail.gd")
const Cameras := preload("../view/cameras.gd")


func test_handles_are_where_the_client_says() -> String:
	var stage := Stage.new()
	var wrong := stage.put(Protocol.HANDLES, 3, 1, Reader.new(_handles(1, [40.0, 1.0, 80.0, 2.5])))
	var found: Handles = stage.all(Protocol.HANDLES)[0] if wrong.is_empty() else null
	var right := (
		found != null
		and found.title == "main"
		and found.count() == 2
		and found.place(1) == Vector2(80.0, 2.5)
		and found.is_of_road()
	)
	stage.free()
	return "" if right else wrong


func test_handles_of_an_unknown_sort_are_refused() -> String:
	var stage := Stage.new()
	var wrong := stage.put(Protocol.HANDLES, 3, 1, Reader.new(_handles(9, [40.0, 1.0])))
	var left := stage.count()
	stage.free()
	return "" if left == 0 and not wrong.is_empty() else "built"


func test_a_malformed_thing_is_refused_and_leaves_nothing() -> String:
	var stage := Stage.new()
	for kind: int in [Protocol.SEGMENT, Protocol.PATCH, Protocol.OBJECTS, Protocol.HANDLES]:
		var wrong := stage.put(kind, 1, 1, Reader.new(PackedByteArray([1, 2, 3])))
		if wrong.is_empty() or stage.count() != 0:
			stage.free()
			return "kind %d" % kind
	stage.free()
	return ""


func test_slow_frames_are_drawn_with_less_detail_while_something_is_dragged() -> String:
	var viewport := SubViewport.new()
	viewport.msaa_3d = Viewport.MSAA_2X
	var hands := Hands.new()
	var worlds := Worlds.new()
	var detail := Detail.new(worlds, hands, viewport)
	var seen: Array[float] = []
	var wanted: Array[float] = [1.0, 1.0, 0.5, 0.5, 1.0]
	for frame: Array in [[false, 0.2], [true, 0.01], [true, 0.2], [true, 0.01], [false, 0.01]]:
		hands.hold({"id": 3, "index": 0} if frame[0] else Hands.NOTHING)
		detail.look(frame[1])
		seen.append(viewport.scaling_3d_scale)
	var samples := viewport.msaa_3d
	for node: Node in [detail, worlds, hands, viewport]:
		node.free()
	if samples != Viewport.MSAA_2X:
		return "samples %d" % samples
	return "" if seen == wanted else str(seen)


func test_there_are_no_shadows_in_fog_or_under_clouds() -> String:
	var light := Light.new()
	var casts: Array[bool] = [light.casts_shadows()]
	light.visibility = 120.0
	casts.append(light.casts_shadows())
	light.visibility = 20000.0
	light.cloud = 1.0
	casts.append(light.casts_shadows())
	return "" if casts == ([true, false, false] as Array[bool]) else str(casts)


func test_the_chase_camera_sees_past_what_it_follows() -> String:
	for size: Vector3 in [Vector3(4.5, 1.45, 1.8), Vector3(12, 3.2, 2.5), Vector3(9, 3.6, 2.5)]:
		var off := Cameras.chase_offset(size)
		var seen := 2.0 * atan(0.5 * size.y / (off.x - 0.5 * size.x))
		if off.y < size.y or seen > deg_to_rad(30.0):
			return "%s: %s, %d degrees" % [size, off, rad_to_deg(seen)]
	return ""


func test_a_frame_is_as_large_as_the_roads_on_whatever_ground() -> String:
	var stage := Stage.new()
	stage.begin("test", 900.0)
	var bytes := StreamPeerBuffer.new()
	bytes.data_array = PackedByteArray([2, 0, 0, 0, 0, 2, 0])
	bytes.seek(7)
	for number: float in [0, 40, 40, 0, -5, 40, 0, 5, 80, 0, -5, 80, 0, 5]:
		bytes.put_float(number)
	var wrong := stage.put(Protocol.SEGMENT, 1, 1, Reader.new(bytes.data_array))
	var found := Cameras.roads_of(stage)
	stage.free()
	if not wrong.is_empty():
		return wrong
	return "" if found.is_equal_approx(Rect2(40, -5, 40, 10)) else str(found)


func _handles(sort: int, numbers: Array[float]) -> PackedByteArray:
	var out := StreamPeerBuffer.new()
	out.put_u8(sort)
	out.put_u8(4)
	out.put_data("main".to_ascii_buffer())
	out.put_u16(numbers.size() / 2)
	for number in numbers:
		out.put_float(number)
	return out.data_array
