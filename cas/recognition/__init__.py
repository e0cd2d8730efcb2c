"""Recognition of germs: normal forms of the lists, and explicit equivalences to them, exactly."""
