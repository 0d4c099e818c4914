extends Node3D
## Something that a client has sent and this engine has built: known by kind and id, at a revision.

const Reader := preload("../net/reader.gd")

var kind := 0
var id := 0
var revision := 0


## What it is called where a human reads it.
func kind_name() -> String:
	return (get_script() as Script).resource_path.get_file().get_basename().capitalize()


## Builds from the message's body; returns "" or what is wrong with it.
func build(_reader: Reader) -> String:
	return "cannot be built"


## The bytes that prove what was built, read back from meshes and nodes, not from the message.
func content() -> PackedByteArray:
	return PackedByteArray()


## Adds a still body with one shape of triangles, three corners each. `surface`: its number in the
## table of the world, for tires.
func add_body(faces: PackedVector3Array, surface: int = 0) -> void:
	var shape := ConcavePolygonShape3D.new()
	shape.set_faces(faces)
	var collision := CollisionShape3D.new()
	collision.shape = shape
	var body := StaticBody3D.new()
	body.add_child(collision)
	body.set_meta(&"surface", surface)
	add_child(body)


static func md5(bytes: PackedByteArray) -> PackedByteArray:
	var context := HashingContext.new()
	context.start(HashingContext.HASH_MD5)
	if not bytes.is_empty():
		context.update(bytes)
	return context.finish()
