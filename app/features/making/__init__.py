"""The form in which a lesson is made."""
