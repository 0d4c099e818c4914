extends RefCounted
## What things look like, by the corners of their meshes.

const Looks := preload("../build/looks.gd")
const VehicleShapes := preload("../shapes/vehicle_shapes.gd")
const VehicleLook := preload("../shapes/vehicle_look.gd")
const WalkerLook := preload("../shapes/walker_look.gd")
const Props := preload("../shapes/props.gd")
const StreetFurniture := preload("../shapes/street_furniture.gd")

const SIZES := {
	"car": Vector3(4.5, 1.5, 1.8),
	"van": Vector3(5.9, 2.5, 2.0),
	"truck": Vector3(9.0, 3.5, 2.5),
	"bus": Vector3(12.0, 3.1, 2.55),
	"taxi": Vector3(4.6, 1.5, 1.85),
	"police_car": Vector3(4.8, 1.5, 1.85),
	"ambulance": Vector3(6.2, 2.7, 2.1),
	"fire_truck": Vector3(8.5, 3.3, 2.5),
	"tractor": Vector3(4.6, 2.9, 2.3),
	"scooter": Vector3(1.2, 1.75, 0.6),
	"bicycle": Vector3(1.8, 1.7, 0.6),
	"motorcycle": Vector3(2.2, 1.4, 0.8),
}


func test_huge_houses_have_no_more_corners_than_large_ones() -> String:
	var corners := PackedInt32Array()
	for length: float in [100.0, 900.0]:
		var mesh := Props.mesh("building", "", Vector3(length, length, length), 0)
		var count := 0
		for surface in mesh.get_surface_count():
			count += mesh.surface_get_array_len(surface)
		corners.append(count)
	return "" if corners[0] == corners[1] else "%s corners" % [corners]


func test_vehicles_of_one_size_differ_by_category() -> String:
	var seen := {}
	for category: String in SIZES:
		var mesh := VehicleShapes.hull(category, SIZES["car"], 2.7, Color.RED)
		seen[mesh.surface_get_array_len(0) * 1000 + mesh.get_surface_count()] = category
	return "" if seen.size() == SIZES.size() else "only %s" % [seen]


func test_bodies_lie_in_the_boxes_of_their_agents() -> String:
	for category: String in SIZES:
		var size: Vector3 = SIZES[category]
		var mesh := VehicleShapes.hull(category, size, 0.6 * size.x, Color.RED, true)
		var box := mesh.get_aabb()
		if not _box(Vector3(size.z, size.y, size.x)).encloses(box):
			return "%s: %s" % [category, box]
	return ""


func test_things_lie_in_their_boxes() -> String:
	var sizes := Props.PARKED.merged(StreetFurniture.SIZES)
	sizes.merge({"tree": Vector3.ONE, "bush": Vector3.ONE, "rock": Vector3.ONE})
	sizes["building"] = Vector3(12, 7, 10)
	for sort: String in sizes:
		var size: Vector3 = sizes[sort]
		for variant in Props.variants(sort):
			var box := Props.mesh(sort, "", size, variant).get_aabb()
			if not _box(size).encloses(box):
				return "%s: %s" % [sort, box]
	return ""


## What a thing of this size may cover: a little more than its box, on the ground.
static func _box(size: Vector3) -> AABB:
	var room := 0.05 * size + Vector3.ONE * 0.02
	return AABB(Vector3(-0.5, 0.0, -0.5) * size - room, size + 2.0 * room)


func test_wheels_stand_on_the_ground_and_turn() -> String:
	var look := VehicleLook.new()
	var mounts := PackedVector3Array()
	for place: Vector2 in [
		Vector2(0.8, 1.3), Vector2(-0.8, 1.3), Vector2(0.8, -1.3), Vector2(-0.8, -1.3)
	]:
		mounts.append(Vector3(place.x, 0.5, place.y))
	look.assemble("car", SIZES["car"], mounts, Color.RED, false)
	var lowest := INF
	var hub: Node3D
	for child in look.get_children():
		if child.get_child_count() == 1 and child.get_child(0) is MeshInstance3D:
			hub = child
			var tire := child.get_child(0) as MeshInstance3D
			lowest = minf(lowest, hub.position.y + tire.mesh.get_aabb().position.y)
	var before := (hub.get_child(0) as Node3D).basis
	look.roll(0.3, 0.0)
	var is_turned := not before.is_equal_approx((hub.get_child(0) as Node3D).basis)
	look.free()
	return "" if absf(lowest) < 0.01 and is_turned else "wheels at %f" % lowest


func test_vehicles_shade_the_ground_below_them_and_not_its_labels() -> String:
	var look := VehicleLook.new()
	var mounts: PackedVector3Array = [
		Vector3(0.8, 0, 1.3), Vector3(-0.8, 0, 1.3), Vector3(0.8, 0, -1.3), Vector3(-0.8, 0, -1.3)
	]
	look.assemble("car", SIZES["car"], mounts, Color.RED, false)
	var covered := AABB()
	for child in look.get_children():
		if child.has_meta(Looks.UNLABELED):
			covered = (child as MeshInstance3D).mesh.get_aabb()
	look.free()
	return "" if covered.size.x > 1.8 and covered.size.z > 4.5 else str(covered)


func test_legs_move_with_the_way_and_feet_stay_near_the_ground() -> String:
	var look := WalkerLook.new()
	look.assemble("pedestrian", Vector3(0.4, 1.75, 0.6), Color.RED)
	var thigh := look.get_child(1) as Node3D
	var before := thigh.rotation.x
	for step in 20:
		look.walk(0.02)
	var moved := absf(thigh.rotation.x - before)
	look.walk(0.0)
	var lowest := INF
	for mesh: MeshInstance3D in look.find_children("*", "MeshInstance3D", true, false):
		var place := Transform3D.IDENTITY
		var node: Node3D = mesh
		while node != look:
			place = node.transform * place
			node = node.get_parent() as Node3D
		lowest = minf(lowest, (place * mesh.mesh.get_aabb()).position.y)
	look.free()
	return "" if moved > 0.2 and absf(lowest) < 0.12 else "%f, feet at %f" % [moved, lowest]
