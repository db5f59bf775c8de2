typed-commands
