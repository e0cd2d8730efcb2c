"""Speed, measured side by side; no part of the tests."""
