"""From text to tree: lexer, tables, engine, builder."""
