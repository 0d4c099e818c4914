"""Pictures and files that roads and networks come from, and networks corrected by hand."""
