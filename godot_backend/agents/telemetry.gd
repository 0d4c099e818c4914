extends RefCounted
## Packs where agents are, and what they touched, into bytes for the client.

const Member := preload("member.gd")
const Contacts := preload("contacts.gd")

const RECORD_BYTES := 64
const CONTACT_BYTES := 20
const HAND_BYTES := 12
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
## float32 for each, the contacts that were not yet told, and what humans want: world, agent,
## steering angle and acceleration of each agent that is driven by hand.
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
	for member in members:
		if member.agent.driver.is_by_hand:
			out.append_array(_wish(member))
	return out


static func _wish(member: Member) -> PackedByteArray:
	var out := PackedByteArray()
	out.resize(HAND_BYTES)
	out.encode_u16(0, member.world)
	out.encode_u16(2, member.agent.id)
	out.encode_float(4, member.wish.x)
	out.encode_float(8, member.wish.y)
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
