"""The lanes that statements and files give a road."""
