"""Scenes and drives as ASAM OpenSCENARIO XML."""
