extends Node3D
## The look of four wheels: they roll, the front ones turn, and they stay on the ground.

const Looks := preload("../build/looks.gd")

var _radius := 0.32
var _hubs: Array[Node3D] = []
var _tires: Array[Node3D] = []


## Front left and right, rear left and right, beside and along the body.
func assemble(mounts: PackedVector3Array, radius: float) -> void:
	_radius = radius
	for mount in mounts:
		var hub := Node3D.new()
		hub.position = Vector3(mount.x, radius, mount.z)
		add_child(hub)
		_hubs.append(hub)
		var tire := Node3D.new()
		tire.rotation.z = PI / 2
		hub.add_child(tire)
		_tires.append(tire)
		_add_part(tire, radius, 0.22, 20, Looks.plain(Color(0.03, 0.03, 0.035), 0.8))
		_add_part(tire, radius * 0.62, 0.24, 10, Looks.plain(Color(0.6, 0.61, 0.63), 0.3))


## The ground below a wheel is `height` meters below where it is at rest.
func drop(wheel: int, height: float) -> void:
	_hubs[wheel].position.y = _radius - height


## Rolls on by some meters, the front wheels turned by an angle to the left.
func roll(meters: float, steering: float) -> void:
	for i in _hubs.size():
		_hubs[i].rotation.y = steering if i < 2 else 0.0
		_tires[i].rotate_object_local(Vector3.UP, -meters / _radius)


func _add_part(to: Node3D, radius: float, height: float, segments: int, look: Material) -> void:
	var mesh := CylinderMesh.new()
	mesh.top_radius = radius
	mesh.bottom_radius = radius
	mesh.height = height
	mesh.radial_segments = segments
	mesh.material = look
	var instance := MeshInstance3D.new()
	instance.mesh = mesh
	to.add_child(instance)
