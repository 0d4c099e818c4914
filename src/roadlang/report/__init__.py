"""Results of `roadlang run` and `roadlang falsify` as one page: reading, pictures, charts."""
