"""Pictures, clips, data sets and files of scenes."""
