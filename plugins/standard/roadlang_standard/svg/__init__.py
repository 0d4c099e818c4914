"""Drawing a scene as SVG: one file per thing drawn. Coordinates are SVG pixels, y down."""
