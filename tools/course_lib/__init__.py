"""What the commands of the course script share. Python 3.9 or later, standard library only."""
