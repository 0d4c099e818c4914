extends RefCounted
## Packs where agents are, and what they touched, into bytes for the client.

const Member := preload("member.gd")
const Contacts := preload("contacts.gd")

const RECORD_BYTES := 64
const CONTACT_BYTES := 20
const HEADER_BYTES := 8
const FIELDS := 13
## x, y, heading, speed, steering.
const STATE_FIELDS := 5
## What fits a datagram, with as many contacts as agents.
const MOST_IN_A_STATE := 200


## One record: tick, world, agent, flags, contacts, then 13 float32.
static func record(member: Member, tick: int) -> PackedByteArray:
	var agent := member.agent
	var body := agent.body
	var velocity: Vector2 = body.ground_velocity()
	var spin := 0.0
	if body is RigidBody3D:
		spin = (body as RigidBody3D).angular_velocity.y
	var numbers := PackedFloat32Array(
		[
			agent.x,
			agent.y,
			body.global_position.y,
			agent.heading,
			agent.speed,
			velocity.x,
			velocity.y,
			spin,
			body.steer_angle(),
			member.wanted.y,
			agent.station,
			agent.cross_track_error,
			agent.progress()
		]
	)
	var out := PackedByteArray()
	out.resize(RECORD_BYTES - FIELDS * 4)
	out.encode_u32(0, tick)
	out.encode_u16(4, member.world)
	out.encode_u16(6, agent.id)
	out.encode_u8(8, body.wheels_down())
	out.encode_u8(9, mini(agent.contacts, 255))
	out.encode_s8(10, agent.driver.in_charge)
	out.encode_u8(11, int(agent.at_end()))
	out.append_array(numbers.to_byte_array())
	return out


## All agents in the order of worlds and numbers: tick, how many, how many contacts, then five
## float32 for each, and the contacts that were not yet told.
static func state(
	members: Array[Member], tick: int, touched: Array[Contacts.Contact]
) -> PackedByteArray:
	var some := touched.slice(0, MOST_IN_A_STATE)
	var out := PackedByteArray()
	out.resize(HEADER_BYTES)
	out.encode_u32(0, tick)
	out.encode_u16(4, members.size())
	out.encode_u16(6, some.size())
	var numbers := PackedFloat32Array()
	numbers.resize(members.size() * STATE_FIELDS)
	var at := 0
	for member in members:
		var agent := member.agent
		numbers[at] = agent.x
		numbers[at + 1] = agent.y
		numbers[at + 2] = agent.heading
		numbers[at + 3] = agent.speed
		numbers[at + 4] = agent.body.steer_angle()
		at += STATE_FIELDS
	out.append_array(numbers.to_byte_array())
	out.append_array(contacts(some))
	return out


## Each: tick, world, agent, the other's number, the object's place there (-1: an agent), speed.
static func contacts(touched: Array[Contacts.Contact]) -> PackedByteArray:
	var out := PackedByteArray()
	out.resize(touched.size() * CONTACT_BYTES)
	var at := 0
	for one in touched:
		out.encode_u32(at, one.tick)
		out.encode_u16(at + 4, one.world)
		out.encode_u16(at + 6, one.agent)
		out.encode_u32(at + 8, one.other)
		out.encode_s32(at + 12, one.index)
		out.encode_float(at + 16, one.speed)
		at += CONTACT_BYTES
	return out
