"""The marking of a build as the page Mark has it: what was handed in, what was typed, the rules, the marks."""
