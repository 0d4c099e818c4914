"""Roads that were found in a picture, corrected on a page in the browser."""
