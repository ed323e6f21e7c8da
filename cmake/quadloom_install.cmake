# Placeholder of the install rules, replaced with the package's own.
