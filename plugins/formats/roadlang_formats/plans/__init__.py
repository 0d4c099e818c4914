"""Files of other tools as drawings, seen from above, without a scene."""
