"""The class list as the page Roster has it: a table that was brought, what its columns are said to be, its students."""
