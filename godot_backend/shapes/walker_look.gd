extends Node3D
## Someone on foot, or on four feet: legs move with the path that is walked, not with time.

const Paints := preload("paints.gd")
const Solid := preload("solid.gd")

const ANIMALS: Array[String] = ["animal", "dog"]
## Meters walked for each radian of the legs' swing, of somebody 1.75 m tall.
const STRIDE := 0.24
const SWING := 0.5
const USUAL_HEIGHT := 1.75
## Meters from arm to arm of somebody of that height.
const SHOULDERS := 0.6

var _limbs: Array[Node3D] = []
var _knees: Array[Node3D] = []
var _phase := 0.0
## How far the legs swing: nothing at rest, 1 on the way.
var _swing := 0.0
var _scale := 1.0


func assemble(category: String, size: Vector3, paint: Color) -> void:
	_scale = size.y / USUAL_HEIGHT
	if category in ANIMALS:
		_add_animal(size, paint)
	else:
		_add_person(paint)
		scale = Vector3(minf(_scale, size.z / SHOULDERS), _scale, _scale)
	_pose()


## Walks on by some meters.
func walk(meters: float) -> void:
	_swing = clampf(_swing + 4.0 * meters if meters > 1e-4 else _swing - 0.1, 0.0, 1.0)
	_phase = fposmod(_phase + meters / (STRIDE * maxf(_scale, 0.3)), TAU)
	_pose()


func _pose() -> void:
	for i in _limbs.size():
		var turn := _phase + PI * (i % 2)
		# Arms are the second pair of a person, and swing against the legs.
		var share := 0.7 if i > 1 else -1.0
		_limbs[i].rotation.x = SWING * _swing * share * sin(turn)
		if i < _knees.size():
			_knees[i].rotation.x = 0.7 * _swing * maxf(0.0, cos(turn))


func _add_person(clothes: Color) -> void:
	var jeans := Paints.body(Color(0.1, 0.12, 0.2).lerp(clothes, 0.12))
	jeans.roughness = 0.95
	var shirt := Paints.body(clothes)
	shirt.roughness = 0.95
	var trunk := Solid.new()
	trunk.bar(Vector3(0, 0.9, 0), Vector3(0, 1.42, 0), 0.155, shirt, 12)
	trunk.ball(Vector3(0.2, 0.1, 0.13), Vector3(0, 1.4, 0), shirt, 12)
	trunk.ball(Vector3(0.165, 0.12, 0.14), Vector3(0, 0.9, 0), jeans, 12)
	trunk.bar(Vector3(0, 1.45, 0), Vector3(0, 1.56, 0.01), 0.05, Paints.skin())
	trunk.ball(Vector3(0.095, 0.12, 0.11), Vector3(0, 1.64, 0.02), Paints.skin(), 12)
	trunk.ball(Vector3(0.1, 0.085, 0.115), Vector3(0, 1.69, -0.01), Paints.trim(), 12)
	_show(trunk, self)
	for side: float in [-1.0, 1.0]:
		var thigh := Solid.new()
		thigh.bar(Vector3.ZERO, Vector3(0, -0.44, 0), 0.08, jeans, 8)
		var hip := _joint(Vector3(side * 0.09, 0.9, 0), self)
		_show(thigh, hip)
		var shin := Solid.new()
		shin.bar(Vector3.ZERO, Vector3(0, -0.4, 0), 0.06, jeans, 8)
		shin.box(Vector3(0.1, 0.08, 0.26), Vector3(0, -0.42, 0.05), Paints.trim())
		var knee := _joint(Vector3(0, -0.44, 0), hip)
		_show(shin, knee)
		_limbs.append(hip)
		_knees.append(knee)
	for side: float in [-1.0, 1.0]:
		var arm := Solid.new()
		arm.bar(Vector3.ZERO, Vector3(side * 0.05, -0.3, 0), 0.05, shirt, 8)
		arm.bar(
			Vector3(side * 0.05, -0.3, 0),
			Vector3(side * 0.05, -0.56, 0.05),
			0.042,
			Paints.skin(),
			8
		)
		var shoulder := _joint(Vector3(side * 0.2, 1.42, 0), self)
		_show(arm, shoulder)
		_limbs.append(shoulder)


func _add_animal(size: Vector3, paint: Color) -> void:
	var fur := Paints.body(paint)
	fur.roughness = 1.0
	var trunk := Solid.new()
	var back := 0.72 * size.y
	var thick := 0.19 * size.y
	trunk.ball(Vector3(thick * 0.8, thick, 0.38 * size.x), Vector3(0, back, 0), fur, 12)
	trunk.bar(
		Vector3(0, back, 0.3 * size.x), Vector3(0, 0.9 * size.y, 0.42 * size.x), 0.6 * thick, fur, 8
	)
	trunk.ball(Vector3(0.5, 0.5, 0.95) * thick, Vector3(0, 0.92 * size.y, 0.46 * size.x), fur, 10)
	trunk.bar(
		Vector3(0, back, -0.36 * size.x), Vector3(0, back + 0.08, -0.5 * size.x), 0.2 * thick, fur
	)
	_show(trunk, self)
	for i in 4:
		var leg := Solid.new()
		leg.bar(Vector3.ZERO, Vector3(0, -back, 0), 0.3 * thick, fur, 6)
		var side := 0.5 * thick * (1.0 if i % 2 == 0 else -1.0)
		var hip := _joint(Vector3(side, back, (0.26 if i < 2 else -0.26) * size.x), self)
		_show(leg, hip)
		_limbs.append(hip)


func _joint(at: Vector3, on: Node3D) -> Node3D:
	var joint := Node3D.new()
	joint.position = at
	on.add_child(joint)
	return joint


func _show(solid: Solid, on: Node3D) -> void:
	var instance := MeshInstance3D.new()
	instance.mesh = solid.mesh()
	on.add_child(instance)
