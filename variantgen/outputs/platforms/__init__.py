"""What the packages for learning platforms share: questions, figures as files, points, numbers, cleaned text."""
